// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/folder_reader.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <limits>
#include <system_error>

#include "core/base/number_text.hpp"
#include "core/environment/part_names.hpp"
#include "core/io/input_file.hpp"
#include "footfall/io.hpp"

namespace footfall::detail {
namespace {

namespace fs = std::filesystem;

std::string numberText(double value) {
  std::string text;
  appendNumber(text, value);
  return text;
}

/// Appends environments to each other.
class FolderJoiner {
 public:
  FolderJoiner(const std::string& folder, Environment& whole) : folder_(folder), whole_(whole), parts_(whole.parts) {}

  void add(const std::string& path, Environment file) {
    const std::string name = fs::path(path).filename().string();
    checkFrame(path, file);
    const std::size_t first = whole_.vertices.size();
    if (first + file.vertices.size() > std::numeric_limits<std::uint32_t>::max())
      failInput(folder_, 0, FOOTFALL_TEXT("more than 4294967295 vertices"), FOOTFALL_TEXT("divide it"));
    whole_.vertices.insert(whole_.vertices.end(), file.vertices.begin(), file.vertices.end());
    for (const Triangle& t : file.triangles) {
      Triangle moved = t;
      for (std::uint32_t& corner : moved) corner += static_cast<std::uint32_t>(first);
      whole_.triangles.push_back(moved);
    }
    addParts(name, file);
    addSkipped(name, file.skipped);
    whole_.storeys.insert(whole_.storeys.end(), file.storeys.begin(), file.storeys.end());
    for (Text& note : file.notes)
      if (std::ranges::find(whole_.notes, note) == whole_.notes.end()) whole_.notes.push_back(std::move(note));
  }

  /// Leaves out a packed environment whose original is in the folder.
  void leaveOut(const std::string& path, const std::string& original) {
    whole_.notes.emplace_back(FOOTFALL_TEXT("%1 was left out: %2, of which it was packed, is in the folder, too"),
                              fs::path(path).filename().string(), original);
  }

  void finish() {
    if (std::ranges::all_of(whole_.usualRoles, [](PartRole role) { return role == PartRole::Floor; }))
      whole_.usualRoles.clear();
    std::ranges::stable_sort(whole_.storeys, {}, &Storey::height);
    if (whole_.grid.step == 0) whole_.grid = {};
    whole_.storeys.erase(std::unique(whole_.storeys.begin(), whole_.storeys.end()), whole_.storeys.end());
  }

 private:
  void checkFrame(const std::string& path, const Environment& file) {
    if (first_.empty()) {
      first_ = path;
      whole_.up = file.up;
      whole_.metresPerUnit = file.metresPerUnit;
      whole_.upGuessed = file.upGuessed;
      whole_.scaleGuessed = file.scaleGuessed;
      whole_.bothSides = file.bothSides;
      whole_.grid = file.grid;
      return;
    }
    // Multiples of the coarser step are multiples of the finer one.
    whole_.grid.step = std::min(whole_.grid.step, file.grid.step);
    whole_.grid.bits = std::max(whole_.grid.bits, file.grid.bits);
    whole_.grid.largestMovement = std::max(whole_.grid.largestMovement, file.grid.largestMovement);
    whole_.grid.weldedVertices += file.grid.weldedVertices;
    whole_.grid.degenerateTriangles += file.grid.degenerateTriangles;
    whole_.grid.splitTriangles += file.grid.splitTriangles;
    if (file.metresPerUnit != whole_.metresPerUnit)
      failInput(path, 0,
                Text(FOOTFALL_TEXT("a unit of it is %1 metres, and one of %2 is %3"), numberText(file.metresPerUnit),
                     first_, numberText(whole_.metresPerUnit)),
                FOOTFALL_TEXT("give one scale for all of them, or export them in one unit"));
    // Only packed files state whether faces have two sides.
    if (file.bothSides != whole_.bothSides)
      failInput(path, 0,
                file.bothSides
                    ? Text(FOOTFALL_TEXT("both sides of its triangles count, and not those of %1"), first_)
                    : Text(FOOTFALL_TEXT("both sides of the triangles of %1 count, and not those of this one"), first_),
                FOOTFALL_TEXT("let both sides count for all of them, or pack it again without that"));
    if (file.up != whole_.up) whole_.up = UpAxis::Z;
    whole_.upGuessed = whole_.upGuessed || file.upGuessed;
    whole_.scaleGuessed = whole_.scaleGuessed || file.scaleGuessed;
  }

  void addParts(const std::string& name, const Environment& file) {
    std::vector<std::uint32_t> numbers;
    for (const EnvironmentPart& part : file.parts)
      numbers.push_back(parts_.numberOf(part.mesh.empty() ? name : name + ": " + part.mesh, part.material));
    if (numbers.empty()) numbers.push_back(parts_.numberOf(name, ""));
    whole_.usualRoles.resize(whole_.parts.size(), PartRole::Floor);
    for (std::size_t p = 0; p < file.usualRoles.size(); ++p) whole_.usualRoles[numbers[p]] = file.usualRoles[p];
    for (std::size_t t = 0; t < file.triangles.size(); ++t)
      whole_.partOf.push_back(numbers[file.partOf.empty() ? 0 : file.partOf[t]]);
  }

  void addSkipped(const std::string& name, const SkippedElements& skipped) {
    whole_.skipped.points += skipped.points;
    whole_.skipped.lines += skipped.lines;
    whole_.skipped.polygons += skipped.polygons;
    for (const SkippedPolygon& polygon : skipped.listed) {
      if (whole_.skipped.listed.size() == SkippedElements::kMostListed) return;
      SkippedPolygon& own = whole_.skipped.listed.emplace_back(polygon);
      own.mesh = own.mesh.empty() ? name : name + ": " + own.mesh;
    }
  }

  const std::string& folder_;
  Environment& whole_;
  PartList parts_;
  std::string first_;
};

}  // namespace

std::vector<std::string> meshesInFolder(const std::string& folder) {
  const std::vector<std::string> known = importableExtensions();
  std::vector<std::string> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const fs::path& path = entry->path();
    if (path.filename().string().starts_with('.') || !fs::is_regular_file(path, error)) continue;
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    if (extension.size() > 1 && std::ranges::binary_search(known, extension.substr(1))) files.push_back(path.string());
  }
  std::ranges::sort(files);
  return files;
}

Environment readFolder(const std::string& folder, const std::function<Environment(const std::string& path)>& read) {
  const std::vector<std::string> files = meshesInFolder(folder);
  if (files.empty())
    failInput(folder, 0, FOOTFALL_TEXT("a folder without meshes"),
              FOOTFALL_TEXT("choose a file, or a folder with OBJ, glTF or other meshes directly in it"));
  Environment whole;
  FolderJoiner joiner(folder, whole);
  for (const std::string& path : files) {
    Environment file = read(path);
    const std::string original = fs::path(file.origin).filename().string();
    // A different name marks it as an environment of its own, though it was packed from a file with that name.
    const bool isNamedAlike = fs::path(original).stem() == fs::path(path).stem();
    if (!original.empty() && isNamedAlike &&
        std::ranges::binary_search(files, (fs::path(path).parent_path() / original).string())) {
      joiner.leaveOut(path, original);
      continue;
    }
    joiner.add(path, std::move(file));
  }
  joiner.finish();
  whole.source = folder;
  return whole;
}

}  // namespace footfall::detail
