// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/formats/godot_export.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/base/vector.hpp"
#include "core/io/formats/convex_polygons.hpp"
#include "core/io/formats/engine_mesh.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

/// The error of heights, in metres, that is allowed where Godot divides a polygon into other triangles than its own.
constexpr double kFlatness = 0.001;
constexpr std::size_t kPolygonsPerPoll = 1024;

using Place = std::array<double, 3>;
using Polygon = std::vector<std::uint32_t>;

Place placeOf(const Vec3& p) { return {p.x, p.y, p.z}; }

/// The polygons of the surface and of the steps, over the vertices of `mesh` and further ones.
class GodotPolygons {
 public:
  GodotPolygons(EngineMesh& mesh, Poll poll) : mesh_(mesh) {
    const ConvexPolygons merged =
        mergeTriangles(mesh.vertices, mesh.triangles, {}, {.maxCorners = 1000, .maxHeight = kFlatness}, poll);
    for (const EngineLink& link : mesh.links) {
      if (isOnePlace(link)) joined_.insert(key(link.from[0], link.from[1]));
      for (const Edge& edge : {link.from, link.to}) ++pieces_[edge].count;
    }
    for (auto& [edge, pieces] : pieces_) divide(edge, pieces);
    countInnerEdges(merged);
    for (std::size_t i = 0; i < merged.size(); ++i) {
      if (i % kPolygonsPerPoll == 0) poll();
      addSurface(merged, i);
    }
    for (const EngineLink& link : mesh.links) addStep(link);
  }

  [[nodiscard]] const std::vector<Polygon>& polygons() const { return polygons_; }

 private:
  using Key = std::pair<Place, Place>;
  using Edge = std::array<std::uint32_t, 2>;
  /// The pieces of an edge, one for each link, because Godot joins at most two polygons on an edge.
  struct Pieces {
    std::size_t count = 0, used = 0;
    std::vector<std::uint32_t> vertices;  ///< count + 1 vertices from end to end
  };

  /// Counts the edges between two polygons. An edge of the border may lie on such an edge (another surface begins in a
  /// fold); Godot would join a third polygon there.
  void countInnerEdges(const ConvexPolygons& merged) {
    std::set<Key> borders, inner;
    const auto each = [&](const auto& use) {
      for (std::size_t polygon = 0; polygon < merged.size(); ++polygon) {
        const std::span<const std::uint32_t> corners = merged.cornersOf(polygon);
        for (std::size_t k = 0; k < corners.size(); ++k)
          use(merged.neighbours[merged.first[polygon] + k] == kNoPolygon,
              key(corners[k], corners[(k + 1) % corners.size()]));
      }
    };
    each([&](bool isBorder, const Key& place) {
      if (isBorder) borders.insert(place);
    });
    each([&](bool isBorder, const Key& place) {
      if (!isBorder && borders.contains(place)) borders_[place] = 1;
    });
  }

  void divide(const Edge& edge, Pieces& pieces) {
    pieces.vertices.push_back(edge[0]);
    for (std::size_t i = 1; i < pieces.count; ++i)
      pieces.vertices.push_back(placeOn(edge, static_cast<double>(i) / static_cast<double>(pieces.count)));
    pieces.vertices.push_back(edge[1]);
  }
  /// Adds a vertex on the edge.
  std::uint32_t placeOn(const Edge& edge, double t) {
    const Vec3 a = mesh_.vertices[edge[0]], b = mesh_.vertices[edge[1]];
    mesh_.vertices.push_back(a + t * (b - a));
    return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
  }
  Edge nextPiece(const Edge& edge) {
    Pieces& pieces = pieces_.at(edge);
    const std::size_t i = pieces.used++;
    return {pieces.vertices[i], pieces.vertices[i + 1]};
  }

  [[nodiscard]] Key key(std::uint32_t a, std::uint32_t b) const {
    const Place p = placeOf(mesh_.vertices[a]), q = placeOf(mesh_.vertices[b]);
    return p < q ? Key{p, q} : Key{q, p};
  }
  [[nodiscard]] bool isSamePlace(std::uint32_t a, std::uint32_t b) const {
    return mesh_.vertices[a] == mesh_.vertices[b];
  }
  [[nodiscard]] bool isOnePlace(const EngineLink& link) const {
    return isSamePlace(link.from[0], link.to[1]) && isSamePlace(link.from[1], link.to[0]);
  }

  /// Adds a polygon of the surface. A border edge at the place of an earlier one is the other side of an obstacle edge,
  /// unless a link crosses it.
  void addSurface(const ConvexPolygons& merged, std::size_t polygon) {
    Polygon corners;
    const std::span<const std::uint32_t> given = merged.cornersOf(polygon);
    for (std::size_t k = 0; k < given.size(); ++k) {
      const std::uint32_t a = given[k], b = given[(k + 1) % given.size()];
      corners.push_back(a);
      if (merged.neighbours[merged.first[polygon] + k] != kNoPolygon) continue;
      const auto pieces = pieces_.find({a, b});
      if (pieces != pieces_.end() && pieces->second.count > 1) {
        const std::vector<std::uint32_t>& parts = pieces->second.vertices;
        for (std::size_t i = 0; i + 1 < parts.size(); ++i) ++borders_[key(parts[i], parts[i + 1])];
        corners.insert(corners.end(), parts.begin() + 1, parts.end() - 1);
        continue;
      }
      if (joined_.contains(key(a, b))) {
        ++borders_[key(a, b)];
        continue;
      }
      keepApart(corners, {a, b});
    }
    addPolygon(corners);
  }

  /// Adds a different extra corner to each edge at one place except the first, so that Godot does not join them.
  void keepApart(Polygon& corners, const Edge& edge) {
    if (isSamePlace(edge[0], edge[1])) return;
    const int earlier = borders_[key(edge[0], edge[1])]++;
    if (earlier > 0) corners.push_back(placeOn(edge, 1.0 / (1 + earlier)));
  }

  /// Adds a polygon without corners that are equal as floats. A polygon that has two corners left is dropped, because
  /// its neighbours have edges at one place.
  void addPolygon(const Polygon& corners) {
    Polygon apart;
    for (const std::uint32_t v : corners)
      if (apart.empty() || !(isSamePlace(apart.back(), v) || isSamePlace(apart.front(), v))) apart.push_back(v);
    if (apart.size() >= 3) polygons_.push_back(std::move(apart));
  }

  /// Adds the polygon of a step: beyond the edge of the first border, and back along the second one.
  void addStep(const EngineLink& link) {
    const Edge from = nextPiece(link.from), to = nextPiece(link.to);
    if (isSamePlace(from[0], from[1]) || isSamePlace(to[0], to[1])) return;  // shorter than floats can express
    Polygon corners{from[1], from[0]};
    keepApart(corners, {from[0], to[1]});
    corners.insert(corners.end(), {to[1], to[0]});
    keepApart(corners, {to[0], from[1]});
    addPolygon(corners);
  }

  EngineMesh& mesh_;
  std::map<Edge, Pieces> pieces_;  ///< by edge with links
  std::set<Key> joined_;
  std::map<Key, int> borders_;  ///< number of edges at a place
  std::vector<Polygon> polygons_;
};

void appendFloat(std::string& text, double value) {
  std::array<char, 32> digits;
  const auto number = static_cast<float>(value + 0.0);
  text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
}

std::string quoted(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') text += '\\';
    text += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return text + '"';
}

}  // namespace

GodotFile formatGodot(const NavigationMesh& mesh, const ExportHeader& header, const ExportOptions& options, Poll poll) {
  if (options.godot != 3 && options.godot != 4)
    throw InputError(FOOTFALL_TEXT("there is no format for Godot %1; choose 3 or 4"), options.godot);
  const bool isThree = options.godot == 3;
  EngineMesh engine = engineMesh(mesh, options);
  const GodotPolygons made(engine, poll);
  GodotFile file;
  file.largestError = engine.largestError;
  file.polygons = made.polygons().size();

  std::string& text = file.text;
  text = isThree ? "[gd_resource type=\"NavigationMesh\" format=2]\n\n[resource]\n"
                 : "[gd_resource type=\"NavigationMesh\" format=3]\n\n[resource]\n";
  const std::string name = std::filesystem::path(mesh.frame.source).stem().string();
  if (!name.empty()) text += "resource_name = " + quoted(name) + '\n';
  text += isThree ? "vertices = PoolVector3Array(" : "vertices = PackedVector3Array(";
  const char* separator = " ";
  poll();
  for (const Vec3& p : engine.vertices)
    for (const double x : {p.x, p.z, -p.y}) {
      text += std::exchange(separator, ", ");
      appendFloat(text, x);
    }
  text += " )\npolygons = [";
  separator = " ";
  for (const Polygon& polygon : made.polygons()) {
    text += std::exchange(separator, ", ");
    text += isThree ? "PoolIntArray(" : "PackedInt32Array(";
    const char* comma = " ";
    for (auto corner = polygon.rbegin(); corner != polygon.rend(); ++corner)
      text.append(std::exchange(comma, ", ")).append(std::to_string(*corner));
    text += " )";
  }
  text += " ]\n";
  const double scale = mesh.frame.metresPerUnit * options.scale;
  const auto addNumber = [&](const char* part, double value) {
    text.append(isThree ? "agent/" : "agent_").append(part).append(" = ");
    const std::size_t start = text.size();
    appendFloat(text, value);
    if (text.find_first_of(".e", start) == std::string::npos) text += ".0";
    text += '\n';
  };
  const AgentNumbers& agent = header.numbers;
  if (agent.height) addNumber("height", *agent.height * scale);
  addNumber("radius", agent.radius * scale);
  addNumber("max_climb", agent.step * scale);
  if (agent.maxSlope) addNumber("max_slope", *agent.maxSlope);
  return file;
}

}  // namespace footfall::detail
