// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <string_view>

#include "core/io/drop_reading.hpp"
#include "core/io/gltf_navigation_mesh.hpp"
#include "core/io/input_file.hpp"
#include "core/io/obj_reader.hpp"
#include "core/mesh/gap_bridges.hpp"
#include "footfall/io.hpp"
#include "footfall/up_axis.hpp"

namespace footfall {
using namespace detail;
namespace {

constexpr double kLargestCoordinate = 1e100;
constexpr std::uint64_t kMostLayers = 1'000'000;

/// The statements in the comments of an export (core/io/export.cpp writes them).
struct StatedContent {
  bool isExport = false;
  std::optional<UpAxis> up;
  std::optional<double> metresPerUnit;
  std::optional<std::uint64_t> vertices, triangles, layers, connections, obstacleEdges, steps, gaps, drops;
};

template <class Number>
std::optional<Number> leadingNumber(std::string_view text) {
  Number number{};
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() ? std::optional(number) : std::nullopt;
}

bool removePrefix(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

void readFrame(std::string_view line, StatedContent& content) {
  if (const std::size_t space = line.find(" up"); space != std::string_view::npos)
    content.up = upAxisFrom(line.substr(0, space));
  if (const std::size_t comma = line.find(", "); comma != std::string_view::npos)
    content.metresPerUnit = leadingNumber<double>(line.substr(comma + 2));
}

/// Reads "N vertices, N triangles, N layers, N connections, N obstacle edges".
void readCounts(std::string_view line, StatedContent& content) {
  while (!line.empty()) {
    const std::size_t comma = line.find(", ");
    const std::string_view part = line.substr(0, comma);
    const auto count = leadingNumber<std::uint64_t>(part);
    if (part.ends_with(" vertices")) content.vertices = count;
    if (part.ends_with(" triangles")) content.triangles = count;
    if (part.ends_with(" layers")) content.layers = count;
    if (part.ends_with(" connections")) content.connections = count;
    if (part.ends_with(" obstacle edges")) content.obstacleEdges = count;
    if (part.ends_with(" steps")) content.steps = count;
    if (part.ends_with(" gaps")) content.gaps = count;
    if (part.ends_with(" drops")) content.drops = count;
    line = comma == std::string_view::npos ? std::string_view() : line.substr(comma + 2);
  }
}

StatedContent readComments(std::string_view text) {
  StatedContent content;
  while (removePrefix(text, "# ")) {
    const std::size_t stop = text.find('\n');
    std::string_view line = text.substr(0, stop);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.starts_with("Walkable area by Footfall")) content.isExport = true;
    if (!content.isExport) break;
    if (removePrefix(line, "frame: ")) {
      readFrame(line, content);
    } else if (removePrefix(line, "content: ")) {
      readCounts(line, content);
      break;
    }
    if (stop == std::string_view::npos) break;
    text.remove_prefix(stop + 1);
  }
  return content;
}

std::optional<std::uint32_t> layerNumber(std::string_view name) {
  if (!removePrefix(name, "layer_")) return std::nullopt;
  std::uint32_t number = 0;
  const auto [stop, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  const bool whole = error == std::errc() && stop == name.data() + name.size() && number < kMostLayers;
  return whole ? std::optional(number) : std::nullopt;
}

/// Calls take(name, group's range of triangles, group's range of segments); faces before the first group have no name.
template <class Take>
void forGroups(const ObjGroups& all, std::size_t triangles, const Take& take) {
  const auto& groups = all.groups;
  const std::size_t count = groups.size();
  if (count == 0 || groups[0].firstTriangle > 0 || groups[0].firstSegment > 0) {
    take(std::string(), std::array{std::size_t{0}, count == 0 ? triangles : groups[0].firstTriangle},
         std::array{std::size_t{0}, count == 0 ? all.segments.size() : groups[0].firstSegment});
  }
  for (std::size_t i = 0; i < count; ++i) {
    const bool last = i + 1 == count;
    take(groups[i].name, std::array{groups[i].firstTriangle, last ? triangles : groups[i + 1].firstTriangle},
         std::array{groups[i].firstSegment, last ? all.segments.size() : groups[i + 1].firstSegment});
  }
}

/// Layers are read only where every face is in a group of a layer; other tools have groups of their own.
void takeGroups(const ObjGroups& all, NavigationMeshFile& file) {
  NavigationMesh& mesh = file.mesh;
  std::vector<std::uint32_t> layers(mesh.triangles.size(), 0);
  bool layered = !mesh.triangles.empty();
  forGroups(all, mesh.triangles.size(), [&](const std::string& name, const auto& triangles, const auto& segments) {
    const auto layer = layerNumber(name);
    if (triangles[0] < triangles[1] && !layer) layered = false;
    if (layer) mesh.layerCount = std::max(mesh.layerCount, *layer + 1);
    std::fill(layers.begin() + static_cast<std::ptrdiff_t>(triangles[0]),
              layers.begin() + static_cast<std::ptrdiff_t>(triangles[1]), layer.value_or(0));
    auto* lines = name == "connections" ? &mesh.connections : name == "obstacle_edges" ? &mesh.obstacleEdges : nullptr;
    if (lines == nullptr) return;
    lines->insert(lines->end(), all.segments.begin() + static_cast<std::ptrdiff_t>(segments[0]),
                  all.segments.begin() + static_cast<std::ptrdiff_t>(segments[1]));
  });
  if (layered) {
    mesh.layers = std::move(layers);
    for (std::uint32_t i = 0; i < mesh.layerCount; ++i) file.layerNames.push_back("layer_" + std::to_string(i));
  } else {
    mesh.layerCount = 0;
    file.layerNames = {file.isExport ? "walkable" : "all"};
  }
}

/// Returns the lines of an export's group of drops.
std::vector<DropLine> takeDrops(const ObjGroups& all, const Environment& soup, const StatedContent& stated) {
  std::vector<DropLine> lines;
  if (!stated.isExport || !stated.drops) return lines;
  forGroups(all, soup.triangles.size(), [&](const std::string& name, const auto&, const auto& segments) {
    if (name != "drops") return;
    for (std::size_t i = segments[0]; i < segments[1]; ++i)
      lines.push_back({soup.vertices[all.segments[i][0]], soup.vertices[all.segments[i][1]]});
  });
  return lines;
}

/// Removes drops and obstacles that an export shows beside the walkable area; they stand at its end, with vertices of
/// their own.
void removeExtras(ObjGroups& groups, Environment& soup, const StatedContent& stated) {
  const auto first = std::find_if(groups.groups.begin(), groups.groups.end(), [](const auto& group) {
    return group.name == "drops" || group.name.starts_with("placed_");
  });
  if (!stated.isExport || !stated.vertices || first == groups.groups.end()) return;
  if (*stated.vertices > soup.vertices.size()) return;  // the file is cut off; the check of the counts reports it
  const auto isBeyond = [&](std::uint32_t v) { return v >= *stated.vertices; };
  for (std::size_t t = 0; t < first->firstTriangle; ++t)
    // the file was changed by hand; the check of the counts reports it
    if (std::ranges::any_of(soup.triangles[t], isBeyond)) return;
  for (std::size_t i = 0; i < first->firstSegment; ++i)
    if (std::ranges::any_of(groups.segments[i], isBeyond)) return;
  soup.triangles.resize(first->firstTriangle);
  groups.segments.resize(first->firstSegment);
  soup.vertices.resize(*stated.vertices);
  groups.groups.erase(first, groups.groups.end());
}

/// The corners of a face in a group of steps or gaps; the last one is kNone for a triangle.
using StepFace = std::array<std::uint32_t, 4>;
constexpr std::uint32_t kNone = 0xFFFFFFFF;

/// Removes the group of steps, or that of gaps, from the text of an export and returns its faces, which belong to no
/// area. Corners that are no numbers or too large make no link; the check of the counts reports it.
std::vector<StepFace> takeSteps(std::string& text, std::string_view name) {
  std::string line = "\ng ";
  line.append(name).append("\n");
  std::vector<StepFace> faces;
  const std::size_t group = text.find(line);
  if (group == std::string::npos) return faces;
  const std::size_t first = group + line.size();
  std::size_t at = first;
  while (text.compare(at, 2, "f ") == 0) {
    const std::size_t stop = std::min(text.find('\n', at), text.size());
    StepFace corners{kNone, kNone, kNone, kNone};
    const char* next = text.data() + at + 1;
    std::size_t read = 0;
    for (; read < corners.size(); ++read) {
      while (next < text.data() + stop && *next == ' ') ++next;
      std::uint32_t number = 0;
      const auto [end, error] = std::from_chars(next, text.data() + stop, number);
      if (error != std::errc() || number == 0) break;
      corners[read] = number - 1;
      next = end;
    }
    if (read >= 3) faces.push_back(corners);
    at = std::min(stop + 1, text.size());
  }
  text.erase(group + 1, at - group - 1);
  return faces;
}

/// Adds the triangles of the links' edges, their heights and their widths. Faces without such triangles are left out.
void completeSteps(const std::vector<StepFace>& faces, StepKind kind, NavigationMesh& mesh) {
  if (faces.empty()) return;
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> triangleAt;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      triangleAt.try_emplace({mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]}, t);
  for (const auto& [a, b, c, d] : faces) {
    if (std::max({a, b, c}) >= mesh.vertices.size() || (d != kNone && d >= mesh.vertices.size())) continue;
    StepLink link{{a, b}, {c, d}};
    link.kind = kind;
    // Both borders end in one vertex. It is the second corner of a gap, and that end of a step where the third corner
    // does not lie above or below the first two.
    if (d == kNone) {
      const Vec3 &first = mesh.vertices[a], &third = mesh.vertices[c];
      const bool isAtSecond = kind == StepKind::Gap || (first.x == third.x && first.y == third.y);
      link.to = isAtSecond ? std::array{b, c} : std::array{c, a};
      if (kind == StepKind::Gap && link.to < link.from) std::swap(link.from, link.to);
    }
    const auto from = triangleAt.find(link.from), to = triangleAt.find(link.to);
    if (from == triangleAt.end() || to == triangleAt.end()) continue;
    link.fromTriangle = from->second;
    link.toTriangle = to->second;
    for (const std::size_t end : {0, 1}) {
      const double rise = mesh.vertices[link.to[1 - end]].z - mesh.vertices[link.from[end]].z;
      link.height = std::max(link.height, std::fabs(rise));
    }
    link.width = widthOf(link, mesh.vertices);
    mesh.links.push_back(link);
  }
}

/// Both kinds of glTF begin like this, and no OBJ does.
bool isGltf(std::string_view content) {
  const std::size_t first = content.find_first_not_of(" \t\r\n");
  const bool isJson = first != std::string_view::npos && content[first] == '{';
  return content.starts_with("glTF") || (isJson && content.find("\"asset\"") != std::string_view::npos);
}

void checkCount(const std::string& path, std::optional<std::uint64_t> stated, std::size_t found, Pattern counts) {
  if (!stated || *stated == found) return;
  failInput(path, 0, Text(counts, *stated, found), FOOTFALL_TEXT("it was cut off or changed by hand: export it again"));
}

void checkContent(const NavigationMeshFile& file, const StatedContent& stated) {
  const NavigationMesh& mesh = file.mesh;
  checkCount(file.path, stated.vertices, mesh.vertices.size(),
             FOOTFALL_TEXT("vertices: its comments count %1, but it has %2"));
  checkCount(file.path, stated.triangles, mesh.triangles.size(),
             FOOTFALL_TEXT("triangles: its comments count %1, but it has %2"));
  checkCount(file.path, stated.layers, mesh.layerCount, FOOTFALL_TEXT("layers: its comments count %1, but it has %2"));
  checkCount(file.path, stated.connections, mesh.connections.size(),
             FOOTFALL_TEXT("connections: its comments count %1, but it has %2"));
  checkCount(file.path, stated.obstacleEdges, mesh.obstacleEdges.size(),
             FOOTFALL_TEXT("obstacle edges: its comments count %1, but it has %2"));
  const auto gaps = static_cast<std::size_t>(std::ranges::count(mesh.links, StepKind::Gap, &StepLink::kind));
  checkCount(file.path, stated.steps, mesh.links.size() - gaps,
             FOOTFALL_TEXT("steps: its comments count %1, but it has %2"));
  checkCount(file.path, stated.gaps, gaps, FOOTFALL_TEXT("gaps: its comments count %1, but it has %2"));
  checkCount(file.path, stated.drops, mesh.drops.size(), FOOTFALL_TEXT("drops: its comments count %1, but it has %2"));
  if (mesh.triangles.empty() && !(stated.isExport && stated.triangles)) {
    failInput(file.path, 0, FOOTFALL_TEXT("no triangles in it"), FOOTFALL_TEXT("choose a file that has faces"));
  }
  for (const Vec3& v : mesh.vertices) {
    if (std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}) > kLargestCoordinate)
      failInput(file.path, 0, FOOTFALL_TEXT("a coordinate above 1e100"),
                FOOTFALL_TEXT("areas and distances would overflow: choose another unit"));
  }
}

NavigationMeshFile fileOf(GltfNavigationMesh&& gltf, const std::string& path, std::optional<UpAxis> up) {
  StatedContent stated;
  stated.isExport = true;
  stated.triangles = gltf.mesh.triangles.size();
  stated.steps = gltf.statedSteps;
  stated.gaps = gltf.statedGaps;  // drops are not compared: floats may put a landing beside its triangle
  NavigationMeshFile file;
  file.path = path;
  file.isExport = true;
  file.statedUp = UpAxis::Y;
  file.up = up.value_or(UpAxis::Y);
  file.metresPerUnit = 1;
  file.mesh = std::move(gltf.mesh);
  file.layerNames = std::move(gltf.layerNames);
  if (file.layerNames.empty()) file.layerNames = {"walkable"};
  for (Vec3& p : file.mesh.vertices) p = fromFileFrame(p, file.up);
  completeSteps(gltf.steps, StepKind::Step, file.mesh);
  completeSteps(gltf.gaps, StepKind::Gap, file.mesh);
  for (DropLine& line : gltf.drops)
    for (Vec3& p : line) p = fromFileFrame(p, file.up);
  completeDrops(gltf.drops, file.mesh);
  checkContent(file, stated);
  file.mesh.frame = {path, file.up, 1};
  return file;
}

}  // namespace

NavigationMeshFile readNavigationMesh(const std::string& path, std::optional<UpAxis> up, UpAxis usualUp,
                                      RunContext* context) {
  std::string text = readInputFile(path, context);
  if (isGltf(text)) {
    if (auto gltf = readGltfNavigationMesh(path, text, Poll(context))) return fileOf(std::move(*gltf), path, up);
    failInput(path, 0,
              FOOTFALL_TEXT("glTF has numbers of 24 bits and no exact surfaces, and its steps and drops are not read"),
              FOOTFALL_TEXT("export as OBJ, which holds all of it"));
  }
  const StatedContent stated = readComments(text);
  std::vector<StepFace> steps, gaps;
  if (stated.isExport) {
    steps = takeSteps(text, "steps");
    gaps = takeSteps(text, "gaps");
  }
  Environment soup;
  ObjGroups groups;
  readObj(path, std::move(text), soup, context, &groups);
  std::vector<DropLine> drops = takeDrops(groups, soup, stated);
  removeExtras(groups, soup, stated);

  NavigationMeshFile file;
  file.path = path;
  file.isExport = stated.isExport;
  file.statedUp = stated.up;
  file.up = up.value_or(stated.up.value_or(usualUp));
  file.metresPerUnit = stated.metresPerUnit;
  file.skipped = soup.skipped;
  file.mesh.vertices = std::move(soup.vertices);
  file.mesh.triangles = std::move(soup.triangles);
  takeGroups(groups, file);
  for (Vec3& p : file.mesh.vertices) p = fromFileFrame(p, file.up);
  completeSteps(steps, StepKind::Step, file.mesh);
  completeSteps(gaps, StepKind::Gap, file.mesh);
  for (DropLine& line : drops)
    for (Vec3& p : line) p = fromFileFrame(p, file.up);
  completeDrops(drops, file.mesh);
  checkContent(file, stated);
  file.mesh.frame = {path, file.up, file.metresPerUnit.value_or(1)};
  return file;
}

}  // namespace footfall
