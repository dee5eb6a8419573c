// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/export.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/io/obj_text.hpp"
#include "core/mesh/storey_names.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

std::string countsOf(const NavigationMesh& mesh, const ExportOptions& options) {
  std::string counts;
  appendNumber(counts, mesh.vertices.size());
  counts += " vertices, ";
  appendNumber(counts, mesh.triangles.size());
  counts += " triangles, ";
  appendNumber(counts, options.layers ? mesh.layerCount : 0);
  counts += " layers, ";
  appendNumber(counts, options.connections ? mesh.connections.size() : 0);
  counts += " connections, ";
  appendNumber(counts, options.obstacleEdges ? mesh.obstacleEdges.size() : 0);
  counts += " obstacle edges";
  const auto gaps = static_cast<std::size_t>(std::ranges::count(mesh.links, StepKind::Gap, &StepLink::kind));
  const auto add = [&](std::size_t count, bool isWritten, const char* name) {
    if (count == 0 || !isWritten) return;
    counts += ", ";
    appendNumber(counts, count);
    counts += name;
  };
  add(mesh.links.size() - gaps, options.steps, " steps");
  add(gaps, options.steps, " gaps");
  add(mesh.drops.size(), options.drops, " drops");
  return counts;
}

/// The frame of the written file. Coordinates that are multiplied by s have a unit that is 1/s of the former one.
SourceFrame frameOf(const SourceFrame& source, const ExportOptions& options) {
  return {source.source, options.up.value_or(source.up),
          options.scale == 1 ? source.metresPerUnit : source.metresPerUnit / options.scale, source.storeys};
}

/// Number of lines that one task writes between two polls.
constexpr std::size_t kLinesPerTask = 8192;
/// Number of tasks whose texts are held at a time.
constexpr std::size_t kTasksAtOnce = 64;

/// Calls append(text, i) on all threads for each i below count, and appends the texts in the order of i.
template <class Append>
void appendAll(std::string& text, std::size_t count, const Poll& poll, const Append& append) {
  const auto appendRange = [&](std::string& part, std::size_t first, std::size_t last) {
    poll();
    for (std::size_t i = first; i < last; ++i) append(part, i);
  };
  if (count <= kLinesPerTask) return appendRange(text, 0, count);
  for (std::size_t begin = 0; begin < count; begin += kLinesPerTask * kTasksAtOnce) {
    const std::size_t end = std::min(begin + kLinesPerTask * kTasksAtOnce, count);
    std::vector<std::string> parts((end - begin + kLinesPerTask - 1) / kLinesPerTask);
    forRanges(parts.size(), 1, [&](std::size_t part, std::size_t) {
      const std::size_t first = begin + part * kLinesPerTask;
      appendRange(parts[part], first, std::min(first + kLinesPerTask, end));
    });
    for (const std::string& part : parts) text += part;
  }
}

void appendVertices(std::string& text, std::span<const Vec3> vertices, UpAxis up, double scale, const Poll& poll = {}) {
  appendAll(text, vertices.size(), poll, [&](std::string& part, std::size_t i) {
    const Vec3& p = vertices[i];
    appendVertex(part, scale == 1 ? p : Vec3{p.x * scale, p.y * scale, p.z * scale}, up);
  });
}

void appendTriangles(std::string& text, const NavigationMesh& mesh, bool byLayers, const Poll& poll) {
  if (mesh.layers.empty() || !byLayers) {
    text += "g walkable\n";
    appendAll(text, mesh.triangles.size(), poll,
              [&](std::string& part, std::size_t i) { appendElement(part, 'f', mesh.triangles[i]); });
    return;
  }
  std::vector<std::vector<std::uint32_t>> members(mesh.layerCount);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    members.at(mesh.layers[i]).push_back(static_cast<std::uint32_t>(i));
  for (std::size_t layer = 0; layer < members.size(); ++layer) {
    text += "g layer_";
    appendNumber(text, layer);
    text += '\n';
    appendAll(text, members[layer].size(), poll,
              [&](std::string& part, std::size_t i) { appendElement(part, 'f', mesh.triangles[members[layer][i]]); });
  }
}

void appendLines(std::string& text, const char* group, const std::vector<std::array<std::uint32_t, 2>>& lines) {
  if (lines.empty()) return;
  text.append("g ").append(group).append("\n");
  for (const auto& line : lines) appendElement(text, 'l', line);
}

void appendSteps(std::string& text, const std::vector<StepLink>& links, StepKind kind, const char* group) {
  if (std::ranges::find(links, kind, &StepLink::kind) == links.end()) return;
  text.append("g ").append(group).append("\n");
  for (const StepLink& link : links) {
    if (link.kind != kind) continue;
    const auto &from = link.from, &to = link.to;
    if (from[1] == to[0])
      appendElement(text, 'f', std::array{from[0], from[1], to[1]});
    else if (to[1] == from[0])
      // The second vertex of a gap is where both of its edges end, since heights do not show which one it is.
      appendElement(text, 'f',
                    kind == StepKind::Gap ? std::array{to[0], to[1], from[1]} : std::array{from[0], from[1], to[0]});
    else
      appendElement(text, 'f', std::array{from[0], from[1], to[0], to[1]});
  }
}

/// Each drop has two lines from the start of the drop to its landing, over vertices of their own.
std::uint32_t appendDrops(std::string& text, const std::vector<DropLink>& drops, std::uint32_t vertex, UpAxis up,
                          double scale) {
  if (drops.empty()) return vertex;
  text += "g drops\n";
  for (const DropLink& drop : drops)
    appendVertices(text, std::array{drop.start[0], drop.landing[0], drop.start[1], drop.landing[1]}, up, scale);
  for (std::size_t line = 0; line < 2 * drops.size(); ++line, vertex += 2)
    appendElement(text, 'l', std::array{vertex, vertex + 1});
  return vertex;
}

/// A name that every reader takes for one word.
std::string groupName(const std::string& name) {
  std::string word = "placed_";
  for (const char c : name) word += static_cast<unsigned char>(c) <= 0x20 || c == '\\' ? '_' : c;
  return word;
}

/// Extras follow everything else and have vertices of their own.
void appendExtras(std::string& text, std::span<const ExportExtra> extras, std::uint32_t vertex, UpAxis up,
                  double scale) {
  for (const ExportExtra& extra : extras) {
    text += "g " + groupName(extra.name) + '\n';
    appendVertices(text, extra.soup.vertices, up, scale);
    for (const Triangle& t : extra.soup.triangles)
      appendElement(text, 'f', Triangle{t[0] + vertex, t[1] + vertex, t[2] + vertex});
    vertex += static_cast<std::uint32_t>(extra.soup.vertices.size());
  }
}

}  // namespace

void checkScale(const ExportOptions& options, const NavigationMesh& mesh) {
  if (!(options.scale > 0 && std::isfinite(options.scale)))
    throw InputError(FOOTFALL_TEXT("the scale of the export must be a number above 0; 1 keeps the file's units"));
  for (const Vec3& p : mesh.vertices)
    for (const double x : {p.x, p.y, p.z})
      if (!std::isfinite(x * options.scale))
        throw InputError(FOOTFALL_TEXT("the scale of the export makes coordinates infinite; choose a smaller one"));
}

std::string formatObj(const NavigationMesh& mesh, const ExportHeader& header, const ExportOptions& options,
                      std::span<const ExportExtra> extras, Poll poll) {
  checkScale(options, mesh);
  const SourceFrame frame = frameOf(mesh.frame, options);
  std::string text;
  text.reserve(1024 + 64 * mesh.vertices.size() + 28 * mesh.triangles.size() +
               20 * (mesh.connections.size() + mesh.obstacleEdges.size()));
  ExportHeader head = header;
  const auto beginNote = [&head] {
    if (!head.note.empty()) head.note += '\n';
  };
  const std::vector<std::string> storeys = options.layers ? storeyNames(mesh) : std::vector<std::string>();
  for (std::size_t layer = 0; layer < storeys.size(); ++layer) {
    beginNote();
    head.note += "layer_";
    appendNumber(head.note, layer);
    head.note += " lies on " + storeys[layer];
  }
  if (options.scale != 1) {
    beginNote();
    head.note += "coordinates are those of the source times ";
    appendNumber(head.note, options.scale);
    head.note += "; pipeline and agent are in units of the source";
  }
  appendHeader(text, "Walkable area", frame, head, countsOf(mesh, options));
  appendVertices(text, mesh.vertices, frame.up, options.scale, poll);
  appendTriangles(text, mesh, options.layers, poll);
  poll();
  if (options.connections) appendLines(text, "connections", mesh.connections);
  if (options.obstacleEdges) appendLines(text, "obstacle_edges", mesh.obstacleEdges);
  if (options.steps) {
    appendSteps(text, mesh.links, StepKind::Step, "steps");
    appendSteps(text, mesh.links, StepKind::Gap, "gaps");
  }
  auto vertex = static_cast<std::uint32_t>(mesh.vertices.size());
  if (options.drops) vertex = appendDrops(text, mesh.drops, vertex, frame.up, options.scale);
  appendExtras(text, extras, vertex, frame.up, options.scale);
  return text;
}

}  // namespace footfall::detail
