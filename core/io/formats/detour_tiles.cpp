// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/formats/detour_tiles.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>

#include "core/base/vector.hpp"
#include "core/io/formats/convex_polygons.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

constexpr std::uint16_t kNoCorner = 0xFFFF, kBorder = 0x800F, kPortal = 0x8000;
/// The most triangles of a polygon: a byte numbers its corners and the further vertices of its triangles.
constexpr std::size_t kMaxTriangles = 120;
/// The shortest common edge on the border of two tiles. Detour shortens such edges by 1 cm at either end, and joins
/// edges that still overlap.
constexpr double kShortestPortal = 0.0201;
/// Bits of a reference for the tile and the polygon; the others distinguish versions of a tile.
constexpr int kReferenceBits = 22;
/// With more tiles there are too few bits for the polygons of each.
constexpr std::size_t kMaxTiles = 4096;

struct Grid {
  double x = 0, z = 0;  ///< where the first tile begins
  float width = 1, height = 1;
  int columns = 1, rows = 1;

  [[nodiscard]] float lineX(int i) const { return static_cast<float>(x + static_cast<double>(width) * i); }
  [[nodiscard]] float lineZ(int i) const { return static_cast<float>(z + static_cast<double>(height) * i); }
  [[nodiscard]] int columnOf(double place) const { return numberOf(place, columns, &Grid::lineX); }
  [[nodiscard]] int rowOf(double place) const { return numberOf(place, rows, &Grid::lineZ); }

 private:
  [[nodiscard]] int numberOf(double place, int count, float (Grid::*line)(int) const) const {
    int number = 0;
    while (number + 1 < count && place >= (this->*line)(number + 1)) ++number;
    return number;
  }
};

struct Bounds {
  std::array<double, 3> low{}, high{};  ///< x, height, z
};

Bounds boundsOf(const std::vector<Vec3>& vertices) {
  Bounds bounds;
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  bounds.low.fill(kInfinite);
  bounds.high.fill(-kInfinite);
  for (const Vec3& p : vertices) {
    const std::array turned{p.x, p.z, -p.y};
    for (std::size_t k = 0; k < 3; ++k) {
      bounds.low[k] = std::min(bounds.low[k], turned[k]);
      bounds.high[k] = std::max(bounds.high[k], turned[k]);
    }
  }
  return bounds;
}

/// A margin around the mesh, so that places on its border lie inside the tile.
double marginOf(const Bounds& bounds) {
  double size = 0, largest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    size = std::max(size, bounds.high[k] - bounds.low[k]);
    largest = std::max({largest, std::fabs(bounds.low[k]), std::fabs(bounds.high[k])});
  }
  return std::max({0.1, size * 0x1p-10, largest * 0x1p-20});
}

/// A grid of about `tiles` tiles. Its start moves outwards until none of its inner lines meets a vertex.
Grid gridFor(const std::vector<Vec3>& vertices, const Bounds& bounds, std::size_t tiles) {
  const double margin = marginOf(bounds);
  const double sizeX = bounds.high[0] - bounds.low[0], sizeZ = bounds.high[2] - bounds.low[2];
  Grid grid;
  grid.columns = std::clamp(
      static_cast<int>(std::lround(std::sqrt(static_cast<double>(tiles) * (sizeX + margin) / (sizeZ + margin)))), 1,
      static_cast<int>(tiles));
  grid.rows =
      static_cast<int>((tiles + static_cast<std::size_t>(grid.columns) - 1) / static_cast<std::size_t>(grid.columns));
  for (int attempt = 0;; ++attempt) {
    const double more = margin * (1 + 0.0437 * attempt);
    grid.x = static_cast<float>(bounds.low[0] - more);
    grid.z = static_cast<float>(bounds.low[2] - more);
    grid.width = static_cast<float>((sizeX + 2 * more + margin) / grid.columns);
    grid.height = static_cast<float>((sizeZ + 2 * more + margin) / grid.rows);
    bool isClear = true;
    for (const Vec3& p : vertices) {
      const int column = grid.columnOf(p.x), row = grid.rowOf(-p.y);
      isClear = isClear && !(column > 0 && p.x == grid.lineX(column)) && !(row > 0 && -p.y == grid.lineZ(row));
    }
    if (isClear) return grid;
    if (attempt == 200)
      throw InputError(FOOTFALL_TEXT("no place to cut the mesh into tiles for Detour; export with another scale"));
  }
}

std::uint64_t edgeKey(std::uint32_t from, std::uint32_t to) { return static_cast<std::uint64_t>(from) << 32 | to; }

/// Fills the tiles of one grid.
class TileMaker {
 public:
  TileMaker(EngineMesh mesh, const Grid& grid, const DetourLimits& limits, Poll poll)
      : mesh_(std::move(mesh)), grid_(grid), limits_(limits), poll_(poll) {}

  /// Empty where the tiles exceed the limits.
  std::optional<std::vector<DetourTile>> make() {
    for (int i = 1; i < grid_.columns; ++i) cut(0, grid_.lineX(i));
    for (int i = 1; i < grid_.rows; ++i) cut(1, -static_cast<double>(grid_.lineZ(i)));
    mergeByTiles();
    numberPolygons();
    if (std::ranges::any_of(sizes_, [&](std::size_t size) { return size > limits_.polygons; })) return {};
    addPolygons();
    joinLinks();
    joinShortPortals();
    for (const EngineJump& jump : mesh_.jumps) addJump(jump);
    std::vector<DetourTile> used;
    for (DetourTile& tile : tiles_) {
      if (tile.areas.empty()) continue;
      if (tile.polygonCount() + tile.jumpCount() > limits_.polygons) return {};
      if (tile.vertexCount() + 2 * tile.jumpCount() > limits_.vertices) return {};
      if (tile.detailVertices.size() / 3 - corners_[&tile - tiles_.data()] > limits_.vertices) return {};
      used.push_back(std::move(tile));
    }
    return used;
  }

 private:
  static constexpr std::size_t kPolygonsPerPoll = 1024;

  void cut(int axis, double place) {
    poll_();
    cutAlong(mesh_, axis, place);
  }
  [[nodiscard]] std::size_t tileAt(const Vec3& p) const {
    return static_cast<std::size_t>(grid_.rowOf(-p.y) * grid_.columns + grid_.columnOf(p.x));
  }
  [[nodiscard]] std::size_t tileOf(const Triangle& triangle) const {
    const Vec3 &a = mesh_.vertices[triangle[0]], &b = mesh_.vertices[triangle[1]], &c = mesh_.vertices[triangle[2]];
    // The middle of the triangle's box; no corner lies beyond the tile, and the corners are on both sides of it.
    const auto middle = [](double x, double y, double z) { return std::min({x, y, z}) / 2 + std::max({x, y, z}) / 2; };
    return tileAt({middle(a.x, b.x, c.x), middle(a.y, b.y, c.y), 0});
  }

  void mergeByTiles() {
    std::uint32_t layers = 1;
    for (const std::uint32_t layer : mesh_.layers) layers = std::max(layers, layer + 1);
    std::vector<std::uint32_t> groups;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      groups.push_back(static_cast<std::uint32_t>(tileOf(mesh_.triangles[t])) * layers +
                       (mesh_.layers.empty() ? 0 : mesh_.layers[t]));
    polygons_ = mergeTriangles(mesh_.vertices, mesh_.triangles, groups,
                               {.maxCorners = kDetourCorners, .maxTriangles = kMaxTriangles}, poll_);
  }

  void numberPolygons() {
    tiles_.resize(static_cast<std::size_t>(grid_.columns * grid_.rows));
    sizes_.resize(tiles_.size());
    corners_.resize(tiles_.size());
    tile_.resize(polygons_.size());
    number_.resize(polygons_.size());
    members_.resize(polygons_.size());
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      const std::uint32_t polygon = polygons_.polygonOf[t];
      if (members_[polygon].empty()) {
        tile_[polygon] = tileOf(mesh_.triangles[t]);
        number_[polygon] = sizes_[tile_[polygon]]++;
      }
      members_[polygon].push_back(t);
    }
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
      tiles_[i].column = static_cast<int>(i) % grid_.columns;
      tiles_[i].row = static_cast<int>(i) / grid_.columns;
    }
  }

  void addPolygons() {
    std::vector<std::unordered_map<std::uint32_t, std::size_t>> numberOf(tiles_.size());
    opposite_ = oppositeEdges(mesh_.triangles);
    slot_.assign(polygons_.corners.size(), 0);
    for (std::size_t polygon = 0; polygon < polygons_.size(); ++polygon) {
      if (polygon % kPolygonsPerPoll == 0) poll_();
      DetourTile& tile = tiles_[tile_[polygon]];
      const std::size_t first = polygons_.first[polygon], count = polygons_.first[polygon + 1] - first;
      const std::size_t start = tile.polygons.size();
      tile.polygons.resize(start + 2 * kDetourCorners, kNoCorner);
      for (std::size_t j = 0; j < count; ++j) {
        const std::size_t corner = first + j;
        const std::uint32_t v = polygons_.corners[corner];
        const auto [place, isNew] = numberOf[tile_[polygon]].try_emplace(v, tile.vertexCount());
        if (isNew) appendPlace(tile.vertices, mesh_.vertices[v]);
        tile.polygons[start + j] = static_cast<std::uint16_t>(place->second);
        slot_[corner] = start + kDetourCorners + j;
        tile.polygons[slot_[corner]] = neighbour(polygon, polygons_.neighbours[corner]);
        if (polygons_.neighbours[corner] == kNoPolygon) {
          const std::uint32_t to = polygons_.corners[first + (j + 1) % count];
          border_[edgeKey(v, to)] = static_cast<std::uint32_t>(corner);
        }
      }
      const std::uint32_t triangle = members_[polygon].front();
      tile.areas.push_back(mesh_.layers.empty() ? kGroundArea : areaOf(mesh_.layers[triangle]));
      tile.flags.push_back(kWalkFlag);
      addDetail(tile, polygon);
    }
  }

  static std::uint8_t areaOf(std::uint32_t layer) {
    return static_cast<std::uint8_t>(std::min<std::uint32_t>(kFirstLayerArea + layer, kLastArea));
  }

  static void appendPlace(std::vector<float>& list, const Vec3& p) {
    list.insert(list.end(), {static_cast<float>(p.x), static_cast<float>(p.z), static_cast<float>(-p.y + 0.0)});
  }

  [[nodiscard]] std::uint16_t neighbour(std::size_t polygon, std::uint32_t other) const {
    if (other == kNoPolygon) return kBorder;
    if (tile_[other] == tile_[polygon]) return static_cast<std::uint16_t>(number_[other]);
    const DetourTile &here = tiles_[tile_[polygon]], &there = tiles_[tile_[other]];
    if (there.column != here.column) return kPortal | (there.column < here.column ? 0 : 2);
    return kPortal | (there.row > here.row ? 1 : 3);
  }

  void addDetail(DetourTile& tile, std::size_t polygon) {
    const std::span<const std::uint32_t> corners = polygons_.cornersOf(polygon);
    std::vector<std::uint32_t> vertices(corners.begin(), corners.end());
    const std::size_t firstTriangle = tile.detailTriangles.size() / 4;
    for (const std::uint32_t t : members_[polygon]) {
      const Triangle& triangle = mesh_.triangles[t];
      std::uint8_t flags = 0;
      for (unsigned k = 0; k < 3; ++k) {
        const std::uint32_t beyond = opposite_[3 * t + k];
        const bool isBorder = beyond == kNoPolygon || polygons_.polygonOf[beyond / 3] != polygon;
        if (isBorder) flags = static_cast<std::uint8_t>(flags | 1u << 2 * k);
        auto found = std::find(vertices.begin(), vertices.end(), triangle[k]);
        if (found == vertices.end()) found = vertices.insert(found, triangle[k]);
        tile.detailTriangles.push_back(static_cast<std::uint8_t>(found - vertices.begin()));
      }
      tile.detailTriangles.push_back(flags);
    }
    corners_[tile_[polygon]] += corners.size();
    const auto number = [](std::size_t n) { return static_cast<unsigned>(n); };
    tile.detailMeshes.insert(tile.detailMeshes.end(), {number(tile.detailVertices.size() / 3), number(vertices.size()),
                                                       number(firstTriangle), number(members_[polygon].size())});
    for (const std::uint32_t v : vertices) appendPlace(tile.detailVertices, mesh_.vertices[v]);
  }

  std::uint16_t& neighbourAt(std::uint32_t edge) { return tiles_[tile_[polygonAt(edge)]].polygons[slot_[edge]]; }

  [[nodiscard]] std::size_t polygonAt(std::uint32_t edge) const {
    const auto after = std::upper_bound(polygons_.first.begin(), polygons_.first.end(), edge);
    return static_cast<std::size_t>(after - polygons_.first.begin()) - 1;
  }

  void joinLinks() {
    for (const EngineLink& link : mesh_.links) {
      const auto from = border_.find(edgeKey(link.from[0], link.from[1]));
      const auto to = border_.find(edgeKey(link.to[0], link.to[1]));
      if (from == border_.end() || to == border_.end()) continue;  // an edge without a triangle has no link
      const std::size_t a = polygonAt(from->second), b = polygonAt(to->second);
      if (a == b) continue;
      std::uint16_t &aBeyond = neighbourAt(from->second), &bBeyond = neighbourAt(to->second);
      if (tile_[a] == tile_[b] && aBeyond == kBorder && bBeyond == kBorder) {
        aBeyond = static_cast<std::uint16_t>(number_[b]);
        bBeyond = static_cast<std::uint16_t>(number_[a]);
      } else {
        addJump({middleOf(link.from, a), middleOf(link.to, b), false});
      }
    }
  }

  void joinShortPortals() {
    if (tiles_.size() == 1) return;
    for (std::size_t polygon = 0; polygon < polygons_.size(); ++polygon) {
      const std::span<const std::uint32_t> corners = polygons_.cornersOf(polygon);
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const std::uint32_t other = polygons_.neighbours[polygons_.first[polygon] + k];
        if (other == kNoPolygon || other < polygon || tile_[other] == tile_[polygon]) continue;
        const std::array edge{corners[k], corners[(k + 1) % corners.size()]};
        const Vec3 d = mesh_.vertices[edge[1]] - mesh_.vertices[edge[0]];
        if (std::max(std::fabs(d.x), std::fabs(d.y)) <= kShortestPortal)
          addJump({middleOf(edge, polygon), middleOf(edge, other), false});
      }
    }
  }

  /// A place on an edge of the polygon, moved a little into the polygon's triangle at that edge.
  [[nodiscard]] Vec3 middleOf(const std::array<std::uint32_t, 2>& edge, std::size_t polygon) const {
    const Vec3 middle = 0.5 * (mesh_.vertices[edge[0]] + mesh_.vertices[edge[1]]);
    const auto hasBoth = [&](std::uint32_t t) {
      const Triangle& triangle = mesh_.triangles[t];
      return std::ranges::count(triangle, edge[0]) + std::ranges::count(triangle, edge[1]) == 2;
    };
    const auto& members = members_[polygon];
    const auto found = std::ranges::find_if(members, hasBoth);
    return insetPlace(mesh_, mesh_.triangles[found == members.end() ? members.front() : *found], middle);
  }

  void addJump(const EngineJump& jump) {
    DetourTile& tile = tiles_[tileAt(jump.from)];
    appendPlace(tile.jumpPlaces, jump.from);
    appendPlace(tile.jumpPlaces, jump.to);
    tile.jumpAreas.push_back(jump.isDrop ? kJumpArea : kGroundArea);
    tile.jumpFlags.push_back(jump.isDrop ? kJumpFlag : kWalkFlag);
    tile.jumpBothWays.push_back(jump.isDrop ? 0 : 1);
  }

  EngineMesh mesh_;
  const Grid& grid_;
  const DetourLimits& limits_;
  Poll poll_;
  ConvexPolygons polygons_;
  std::vector<DetourTile> tiles_;
  std::vector<std::size_t> sizes_;                   ///< number of polygons in each tile
  std::vector<std::size_t> corners_;                 ///< number of their corners, all together
  std::vector<std::size_t> tile_, number_;           ///< the tile of each polygon, and its number there
  std::vector<std::vector<std::uint32_t>> members_;  ///< triangles of each polygon
  std::vector<std::uint32_t> opposite_;
  std::vector<std::size_t> slot_;  ///< index of each edge's neighbour in its tile
  std::unordered_map<std::uint64_t, std::uint32_t> border_;
};

void setBounds(DetourTile& tile, const Grid& grid, double margin) {
  float low = std::numeric_limits<float>::infinity(), high = -low;
  for (std::size_t i = 1; i < tile.detailVertices.size(); i += 3) {
    low = std::min(low, tile.detailVertices[i]);
    high = std::max(high, tile.detailVertices[i]);
  }
  tile.low = {grid.lineX(tile.column), static_cast<float>(low - margin), grid.lineZ(tile.row)};
  tile.high = {grid.lineX(tile.column + 1), static_cast<float>(high + margin), grid.lineZ(tile.row + 1)};
}

}  // namespace

DetourTiles detourTiles(const EngineMesh& mesh, const DetourLimits& limits, Poll poll) {
  DetourTiles result;
  if (mesh.triangles.empty()) return result;
  const Bounds bounds = boundsOf(mesh.vertices);
  for (std::size_t count = 1; count <= kMaxTiles; count *= 2) {
    poll();
    const Grid grid = gridFor(mesh.vertices, bounds, count);
    if (mesh.triangles.size() > 6 * limits.polygons * count) continue;  // polygons rarely have more triangles
    std::optional<std::vector<DetourTile>> tiles = TileMaker(mesh, grid, limits, poll).make();
    if (!tiles) continue;
    std::size_t largest = 1;
    for (DetourTile& tile : *tiles) {
      setBounds(tile, grid, marginOf(bounds));
      largest = std::max(largest, tile.polygonCount() + tile.jumpCount());
    }
    if (std::bit_width(tiles->size() - 1) + std::bit_width(largest - 1) > kReferenceBits) continue;
    result.origin = {grid.lineX(0), static_cast<float>(bounds.low[1]), grid.lineZ(0)};
    result.width = grid.width;
    result.height = grid.height;
    result.tiles = std::move(*tiles);
    return result;
  }
  throw InputError(
      FOOTFALL_TEXT("the mesh has too many polygons for one file of Detour; simplify it, or export parts of it"));
}

}  // namespace footfall::detail
