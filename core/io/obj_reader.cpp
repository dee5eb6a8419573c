// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/obj_reader.hpp"

#include <algorithm>
#include <atomic>
#include <limits>
#include <memory>
#include <string_view>

#include "core/base/parallel.hpp"
#include "core/io/obj_parser.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kStretchBytes = 1 << 17;

/// Cuts a text into stretches of whole lines; the last one extends to the end of the text.
std::vector<std::string_view> cutIntoStretches(std::string_view text) {
  std::vector<std::string_view> stretches;
  while (text.size() > kStretchBytes) {
    const std::size_t end = text.find('\n', kStretchBytes);
    if (end == std::string_view::npos) break;
    stretches.push_back(text.substr(0, end + 1));
    text.remove_prefix(end + 1);
  }
  if (!text.empty()) stretches.push_back(text);
  return stretches;
}

struct Stretch {
  Stretch(const std::string& path, std::string_view text, RunContext* context)
      : parser(path, text, ObjParser::Extent::Stretch, found, context) {
    found.vertices.reserve(text.size() / 64);
    found.triangles.reserve(text.size() / 64);
  }
  Environment found;
  ObjParser parser;
};

/// Reads stretches of the text on all threads. Returns false, with nothing read, where that is impossible or the text
/// has an error. One pass over the whole text then reads it, or reports the first error and its line.
bool readInStretches(const std::string& path, std::string_view text, Environment& environment, RunContext* context) {
  std::vector<std::unique_ptr<Stretch>> stretches;
  for (const std::string_view lines : cutIntoStretches(text))
    stretches.push_back(std::make_unique<Stretch>(path, lines, context));
  if (stretches.size() < 2) return false;
  std::atomic<bool> isReadable{true};
  std::atomic<std::size_t> done{0};
  forRanges(stretches.size(), 1, [&](std::size_t i, std::size_t) {
    if (!isReadable) return;
    try {
      stretches[i]->parser.parseStatements();
    } catch (const NotAlone&) {
      isReadable = false;
    } catch (const InputError&) {
      isReadable = false;
    }
    if (context == nullptr) return;
    context->checkCancelled();
    context->progress(static_cast<double>(done.fetch_add(1) + 1) / static_cast<double>(stretches.size()));
  });
  if (!isReadable) return false;
  std::size_t vertexCount = 0, triangleCount = 0;
  std::uint64_t largestForward = 0;
  for (const auto& stretch : stretches) {
    vertexCount += stretch->found.vertices.size();
    largestForward = std::max(largestForward, stretch->parser.largestForward());
  }
  if (largestForward > vertexCount || vertexCount > std::numeric_limits<std::uint32_t>::max()) return false;
  std::vector<Vec3>& vertices = environment.vertices;
  vertices.reserve(vertexCount);
  for (const auto& stretch : stretches)
    vertices.insert(vertices.end(), stretch->found.vertices.begin(), stretch->found.vertices.end());
  forRanges(stretches.size(), 1, [&](std::size_t i, std::size_t) { stretches[i]->parser.splitPolygons(vertices); });
  for (const auto& stretch : stretches) triangleCount += stretch->found.triangles.size();
  std::vector<Triangle>& triangles = environment.triangles;
  triangles.reserve(triangleCount);
  ObjPartAssigner parts(environment, triangleCount);
  std::uint64_t linesBefore = 0;
  for (const auto& stretch : stretches) {
    parts.add(stretch->parser.parts(), stretch->found.triangles.size());
    triangles.insert(triangles.end(), stretch->found.triangles.begin(), stretch->found.triangles.end());
    environment.skipped.points += stretch->found.skipped.points;
    environment.skipped.lines += stretch->found.skipped.lines;
    appendSkippedPolygons(environment.skipped, stretch->found.skipped, linesBefore);
    linesBefore += stretch->parser.lineCount();
  }
  parts.finish();
  return true;
}

}  // namespace

void readObj(const std::string& path, std::string text, Environment& environment, RunContext* context,
             ObjGroups* groups) {
  rejectBinary(path, text);
  // Files of old Macintosh programs end their lines with a lone carriage return.
  if (text.find('\n') == std::string::npos) std::replace(text.begin(), text.end(), '\r', '\n');
  std::string_view statements(text);
  if (statements.starts_with(kByteOrderMark)) statements.remove_prefix(kByteOrderMark.size());
  if (groups == nullptr && readInStretches(path, statements, environment, context)) return;
  ObjParser(path, statements, ObjParser::Extent::Whole, environment, context, groups).parse();
}

}  // namespace footfall::detail
