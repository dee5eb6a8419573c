// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/formats/geojson_export.hpp"

#include <algorithm>
#include <array>

#include "core/base/index_and_box.hpp"
#include "core/base/number_text.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kPlacesPerPoll = 4096;

class GeoJsonWriter {
 public:
  GeoJsonWriter(const NavigationMesh& mesh, const PlanPolygons& polygons, const ExportOptions& options, Poll poll)
      : mesh_(mesh),
        polygons_(polygons),
        options_(options),
        metres_(mesh.frame.metresPerUnit * options.scale),
        poll_(poll) {}

  std::string write() {
    text_ = "{\"type\": \"FeatureCollection\",\n";
    const std::string& name = options_.coordinateSystem;
    if (!name.empty())
      text_ += "\"crs\": {\"type\": \"name\", \"properties\": {\"name\": \"urn:ogc:def:crs:EPSG::" + name.substr(5) +
               "\"}},\n";
    text_ += "\"features\": [";
    for (const PlanPolygon& polygon : polygons_.polygons)
      if (isChosen(polygon.part)) addPolygon(polygon);
    addLines();
    text_ += "\n]}\n";
    return std::move(text_);
  }

 private:
  [[nodiscard]] bool isChosen(std::uint32_t part) const { return part == options_.part.value_or(part); }
  [[nodiscard]] std::uint32_t partOf(std::uint32_t triangle) const { return polygons_.parts.ofTriangle[triangle]; }
  [[nodiscard]] std::uint32_t layerOf(std::uint32_t triangle) const {
    return mesh_.layers.empty() ? 0 : mesh_.layers[triangle];
  }

  void begin(const char* geometry) {
    text_ += isFirst_ ? "\n" : ",\n";
    isFirst_ = false;
    text_.append("{\"type\": \"Feature\", \"geometry\": {\"type\": \"")
        .append(geometry)
        .append("\", \"coordinates\": [");
  }
  void beginProperties(const char* kind) {
    text_.append("]}, \"properties\": {\"kind\": \"").append(kind).append("\"");
  }
  template <class Number>
  void property(const char* name, Number value) {
    text_.append(", \"").append(name).append("\": ");
    appendNumber(text_, value);
  }
  void end() { text_ += "}}"; }

  void place(const Vec3& p) {
    if (++places_ % kPlacesPerPoll == 0) poll_();
    text_ += '[';
    appendNumber(text_, p.x * metres_);
    text_ += ", ";
    appendNumber(text_, p.y * metres_);
    text_ += ", ";
    appendNumber(text_, p.z * metres_);
    text_ += ']';
  }

  void ring(const PlanRing& vertices) {
    text_ += '[';
    for (const std::uint32_t v : vertices) {
      place(mesh_.vertices[v]);
      text_ += ", ";
    }
    place(mesh_.vertices[vertices.front()]);
    text_ += ']';
  }

  void addPolygon(const PlanPolygon& polygon) {
    begin("Polygon");
    ring(polygon.outline.outer);
    double planArea = doubleAreaOf(mesh_, polygon.outline.outer);
    for (const PlanRing& hole : polygon.outline.holes) {
      text_ += ", ";
      ring(hole);
      planArea += doubleAreaOf(mesh_, hole);
    }
    beginProperties("walkable");
    if (options_.layers) property("layer", polygon.layer);
    property("part", polygon.part + 1);
    property("area", polygon.area * metres_ * metres_);
    property("plan_area", planArea / 2 * metres_ * metres_);
    end();
  }

  /// Begins a line and returns true where it has a length in the plan.
  bool beginLine(const Vec3& a, const Vec3& b, const char* kind) {
    if (a.x == b.x && a.y == b.y) return false;
    begin("LineString");
    place(a);
    text_ += ", ";
    place(b);
    beginProperties(kind);
    return true;
  }

  void addLink(const std::array<Vec3, 2>& edge, const char* kind, std::uint32_t from, std::uint32_t to, double height,
               double width) {
    if (!isChosen(partOf(from)) && !isChosen(partOf(to))) return;
    if (!beginLine(edge[0], edge[1], kind)) return;
    property("height", height * metres_);
    property("width", width * metres_);
    if (options_.layers) {
      property("from_layer", layerOf(from));
      property("to_layer", layerOf(to));
    }
    property("from_part", partOf(from) + 1);
    property("to_part", partOf(to) + 1);
    end();
  }

  void addLines() {
    // Connections and barriers are identified by their vertices only; a vertex may be in several parts.
    std::vector<std::array<std::uint32_t, 3>> sides;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
      for (int k = 0; k < 3; ++k) sides.push_back({mesh_.triangles[t][k], mesh_.triangles[t][next(k)], t});
    std::sort(sides.begin(), sides.end());
    const auto partOfEdge = [&](const std::array<std::uint32_t, 2>& edge) {
      const auto from = [&sides](std::uint32_t a, std::uint32_t b) {
        return std::lower_bound(sides.begin(), sides.end(), std::array{a, b, 0U});
      };
      auto side = from(edge[0], edge[1]);
      if (side == sides.end() || (*side)[0] != edge[0] || (*side)[1] != edge[1]) side = from(edge[1], edge[0]);
      return partOf((*side)[2]);
    };
    const auto addEdges = [&](const auto& edges, const char* kind) {
      for (const auto& edge : edges) {
        const std::uint32_t part = partOfEdge(edge);
        if (!isChosen(part) || !beginLine(mesh_.vertices[edge[0]], mesh_.vertices[edge[1]], kind)) continue;
        property("part", part + 1);
        end();
      }
    };
    if (options_.connections) addEdges(mesh_.connections, "connection");
    if (options_.steps)
      for (const StepLink& link : mesh_.links)
        addLink({mesh_.vertices[link.from[0]], mesh_.vertices[link.from[1]]},
                link.kind == StepKind::Gap ? "gap" : "step", link.fromTriangle, link.toTriangle, link.height,
                link.width);
    if (options_.drops)
      for (const DropLink& drop : mesh_.drops)
        addLink(drop.start, "drop", drop.fromTriangle, drop.toTriangle, drop.depth, 0);
    if (options_.obstacleEdges) addEdges(polygons_.barriers, "barrier");
  }

  const NavigationMesh& mesh_;
  const PlanPolygons& polygons_;
  const ExportOptions& options_;
  double metres_;
  Poll poll_;
  std::size_t places_ = 0;
  std::string text_;
  bool isFirst_ = true;
};

}  // namespace

void checkCoordinateSystem(const std::string& name) {
  constexpr std::string_view kAuthority = "EPSG:";
  const bool isOne =
      name.starts_with(kAuthority) && name.size() > kAuthority.size() && name.size() < 15 &&
      std::all_of(name.begin() + kAuthority.size(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (!isOne)
    throw InputError(FOOTFALL_TEXT("%1: not the name of a coordinate system; give one such as EPSG:25832"), name);
}

std::string formatGeoJson(const NavigationMesh& mesh, const ExportOptions& options, Poll poll) {
  if (!options.coordinateSystem.empty()) checkCoordinateSystem(options.coordinateSystem);
  const PlanPolygons polygons = makePlanPolygons(mesh, poll);
  checkPolygonOptions(mesh, polygons, options);
  poll();
  return GeoJsonWriter(mesh, polygons, options, poll).write();
}

}  // namespace footfall::detail
