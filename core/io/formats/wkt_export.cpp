// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/formats/wkt_export.hpp"

#include <vector>

#include "core/base/number_text.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kPlacesPerPoll = 4096;

class WktWriter {
 public:
  explicit WktWriter(const NavigationMesh& mesh, const ExportOptions& options = {}, Poll poll = {})
      : mesh_(mesh), options_(options), metres_(mesh.frame.metresPerUnit * options.scale), poll_(poll) {}

  void layer(const PlanPolygons& polygons, std::optional<std::uint32_t> layer, std::optional<std::uint32_t> part) {
    std::vector<const PlanPart*> chosen;
    for (const PlanPolygon& polygon : polygons.polygons)
      if (polygon.layer == layer.value_or(polygon.layer) && polygon.part == part.value_or(polygon.part))
        chosen.push_back(&polygon.outline);
    if (chosen.empty()) text += "POLYGON EMPTY";
    if (chosen.size() == 1) polygon(*chosen.front());
    if (chosen.size() < 2) return;
    text += "GEOMETRYCOLLECTION (";
    list(chosen, [this](const PlanPart* outline) { polygon(*outline); });
    text += ')';
  }

  /// Writes lines, without those that have no length in the plan.
  void lines(const std::vector<std::array<Vec3, 2>>& all) {
    std::vector<std::array<Vec3, 2>> some;
    for (const auto& line : all)
      if (line[0].x != line[1].x || line[0].y != line[1].y) some.push_back(line);
    text += some.empty() ? "MULTILINESTRING EMPTY" : "MULTILINESTRING (";
    list(some, [this](const std::array<Vec3, 2>& line) {
      text += '(';
      list(line, [this](const Vec3& p) { place(p); });
      text += ')';
    });
    if (!some.empty()) text += ')';
  }

  void links(const PlanPolygons& polygons) {
    const auto edgesOf = [this](const auto& edges) {
      std::vector<std::array<Vec3, 2>> found;
      for (const auto& edge : edges) found.push_back({mesh_.vertices[edge[0]], mesh_.vertices[edge[1]]});
      return found;
    };
    std::vector<std::array<Vec3, 2>> steps, gaps, drops;
    if (options_.steps)
      for (const StepLink& link : mesh_.links)
        (link.kind == StepKind::Gap ? gaps : steps)
            .push_back({mesh_.vertices[link.from[0]], mesh_.vertices[link.from[1]]});
    if (options_.drops)
      for (const DropLink& drop : mesh_.drops) drops.push_back(drop.start);
    const std::vector<std::array<std::uint32_t, 2>> none;
    list(std::array{edgesOf(options_.connections ? mesh_.connections : none), steps, gaps, drops,
                    edgesOf(options_.obstacleEdges ? polygons.barriers : none)},
         [this](const auto& kind) { lines(kind); });
  }

  std::string text;

 private:
  template <class List, class Write>
  void list(const List& all, Write write) {
    bool isFirst = true;
    for (const auto& one : all) {
      if (!isFirst) text += ", ";
      isFirst = false;
      write(one);
    }
  }

  void place(const Vec3& p) {
    if (++places_ % kPlacesPerPoll == 0) poll_();
    appendNumber(text, p.x * metres_);
    text += ' ';
    appendNumber(text, p.y * metres_);
  }

  void ring(const PlanRing& vertices) {
    text += '(';
    list(vertices, [this](std::uint32_t v) { place(mesh_.vertices[v]); });
    text += ", ";
    place(mesh_.vertices[vertices.front()]);
    text += ')';
  }

  void polygon(const PlanPart& outline) {
    text += "POLYGON (";
    ring(outline.outer);
    for (const PlanRing& hole : outline.holes) {
      text += ", ";
      ring(hole);
    }
    text += ')';
  }

  const NavigationMesh& mesh_;
  const ExportOptions options_;
  double metres_;
  Poll poll_;
  std::size_t places_ = 0;
};

}  // namespace

std::string formatLayerWkt(const NavigationMesh& mesh, const PlanPolygons& polygons, std::optional<std::uint32_t> layer,
                           const ExportOptions& options, Poll poll) {
  WktWriter writer(mesh, options, poll);
  writer.layer(polygons, layer, options.part);
  return writer.text + '\n';
}

std::string formatLinksWkt(const NavigationMesh& mesh, const PlanPolygons& polygons, const ExportOptions& options,
                           Poll poll) {
  WktWriter writer(mesh, options, poll);
  writer.text = "GEOMETRYCOLLECTION (";
  writer.links(polygons);
  return writer.text + ")\n";
}

std::vector<OutputFile> makeWktFiles(const NavigationMesh& mesh, const std::string& path, const ExportOptions& options,
                                     Poll poll) {
  const PlanPolygons polygons = makePlanPolygons(mesh, poll);
  checkPolygonOptions(mesh, polygons, options);
  std::vector<OutputFile> files;
  if (polygons.layerCount == 1 || !options.layers) {
    files.push_back({path, formatLayerWkt(mesh, polygons, std::nullopt, options, poll)});
  } else {
    for (std::uint32_t layer = 0; layer < polygons.layerCount; ++layer) {
      poll();
      files.push_back({besideName(path, std::to_string(layer)),
                       formatLayerWkt(mesh, polygons, std::optional(layer), options, poll)});
    }
  }
  poll();
  files.push_back({besideName(path, std::string(kLinksSuffix)), formatLinksWkt(mesh, polygons, options, poll)});
  return files;
}

}  // namespace footfall::detail
