// Packing environments and comparing what comes back.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <algorithm>
#include <bit>
#include <filesystem>
#include <string>
#include <vector>

#include "core/io/packed/pack.hpp"
#include "tests/unit/environment_files.hpp"

namespace footfall::test {

/// The bounds are so small that everything goes through the disk.
inline const PackingMemory kLittle{.scratch = 4096, .cachedPages = 3, .sortedFaces = 500, .merged = 8192};
/// More than one block.
inline constexpr int kSide = 150;

inline bool sameBits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

inline bool sameBits(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](const Vec3& p, const Vec3& q) {
           return sameBits(p.x, q.x) && sameBits(p.y, q.y) && sameBits(p.z, q.z);
         });
}

/// Everything that a run and its reports can see of an environment, but its path.
inline QString differenceOf(const Environment& a, const Environment& b) {
  if (!sameBits(a.vertices, b.vertices)) return "vertices";
  if (a.triangles != b.triangles) return "triangles";
  if (a.parts != b.parts || a.partOf != b.partOf || a.usualRoles != b.usualRoles) return "parts";
  if (a.up != b.up || a.upGuessed != b.upGuessed || a.bothSides != b.bothSides) return "frame";
  if (a.metresPerUnit != b.metresPerUnit || a.scaleGuessed != b.scaleGuessed) return "scale";
  if (a.storeys != b.storeys || a.notes != b.notes || a.obstacleOnly != b.obstacleOnly) return "storeys or notes";
  if (a.skipped.points != b.skipped.points || a.skipped.lines != b.skipped.lines ||
      a.skipped.polygons != b.skipped.polygons || a.skipped.listed != b.skipped.listed)
    return "what was left out";
  if (std::filesystem::path(a.frame().source).filename() != std::filesystem::path(b.frame().source).filename())
    return "the name of the file";
  return {};
}

/// Packs and opens again, with little memory and with the usual; empty when both are the file as it is imported.
inline QString roundTrip(const std::string& path, bool isStreamed, const ImportOptions& packing = {},
                         const ImportOptions& opening = {}) {
  const TemporaryFolder folder;
  const std::string target = folder.path("level.ffenv"), again = folder.path("again.ffenv");
  const PackResult result = packEnvironment(path, target, packing, nullptr, kLittle);
  packEnvironment(path, again, packing, nullptr);
  if (readAll(target) != readAll(again)) return "the bytes depend on the memory";
  if (result.isStreamed != isStreamed) return isStreamed ? "was read as a whole" : "was streamed";
  if (folder.files().size() != 2) return "something is left beside it";
  ImportOptions both = packing;
  if (opening.up) both.up = opening.up;
  if (opening.metresPerUnit) both.metresPerUnit = opening.metresPerUnit;
  both.bothSides = packing.bothSides || opening.bothSides;
  const auto before = importEnvironment(path, both), after = importEnvironment(target, opening);
  Environment expected = *before;
  if (packing.up && !opening.up) expected.upGuessed = false;
  return differenceOf(expected, *after);
}

/// A floor with waves of `kSide` times `kSide` squares, in several parts, with all kinds of faces.
inline QByteArray waves() {
  QByteArray text = "# waves\n";
  for (int y = 0; y <= kSide; ++y)
    for (int x = 0; x <= kSide; ++x)
      text += "v " + QByteArray::number(x * 0.1) + ' ' + QByteArray::number((x * 7 + y * 3) % 5 * 0.01) + ' ' +
              QByteArray::number(y * 0.1) + '\n';
  text += "v 1 2 3\np 1 2\nl 1 2\n";
  const auto number = [](int x, int y) { return QByteArray::number(y * (kSide + 1) + x + 1); };
  for (int y = 0; y < kSide; ++y) {
    if (y % 50 == 0) text += "o strip" + QByteArray::number(y) + "\nusemtl m" + QByteArray::number(y % 3) + '\n';
    for (int x = 0; x < kSide; ++x) {
      const QByteArray a = number(x, y), b = number(x + 1, y), c = number(x + 1, y + 1), d = number(x, y + 1);
      if ((x + y) % 3 == 0)
        text += "f " + a + ' ' + d + ' ' + c + ' ' + b + '\n';
      else
        text += "f " + a + "/1/2 " + d + ' ' + c + "\nf " + a + ' ' + c + ' ' + b + '\n';
    }
    text += "f " + number(0, y) + ' ' + number(1, y) + ' ' + number(0, y) + '\n';
  }
  return text;
}

}  // namespace footfall::test
