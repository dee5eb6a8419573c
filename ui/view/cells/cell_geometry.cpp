// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/cells/cell_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace footfall::ui {
namespace {

constexpr double kInfinity = CellBounds::kInfinity;
constexpr std::size_t kPollEvery = 256;  // triangles

double component(const Vec3& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

struct FloatBox {
  Vec3 lower{kInfinity, kInfinity, kInfinity};
  Vec3 upper{-kInfinity, -kInfinity, -kInfinity};
  void add(const Vec3& p) {
    lower = {std::min(lower.x, p.x), std::min(lower.y, p.y), std::min(lower.z, p.z)};
    upper = {std::max(upper.x, p.x), std::max(upper.y, p.y), std::max(upper.z, p.z)};
  }
};

/// Finds the cells that may overlap a rectangle: the plan in equal buckets, each with its cells.
class CellLookup {
 public:
  CellLookup(const std::vector<CellBounds>& cells, const FloatBox& box) : cells_(cells), box_(box) {
    // There are about as many buckets as cells, because strategies make no cells that are much longer than the others.
    side_ = std::clamp(static_cast<int>(std::ceil(std::sqrt(static_cast<double>(cells.size())))), 1, 256);
    buckets_.resize(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_));
    for (std::size_t c = 0; c < cells.size(); ++c) {
      visitBuckets({cells[c].lower[0], cells[c].lower[1], 0}, {cells[c].upper[0], cells[c].upper[1], 0},
                   [&](std::vector<std::size_t>& bucket) { bucket.push_back(c); });
    }
  }

  /// The cells whose rectangle overlaps the box's in an area, and whose heights contain the lowest corner of the box.
  void find(const FloatBox& box, std::vector<std::size_t>& found) {
    found.clear();
    visitBuckets(box.lower, box.upper, [&](std::vector<std::size_t>& bucket) {
      for (const std::size_t c : bucket) {
        const CellBounds& cell = cells_[c];
        if (box.upper.x > cell.lower[0] && box.lower.x < cell.upper[0] && box.upper.y > cell.lower[1] &&
            box.lower.y < cell.upper[1] && box.lower.z >= cell.lower[2] && box.lower.z < cell.upper[2])
          found.push_back(c);
      }
    });
    std::ranges::sort(found);
    found.erase(std::ranges::unique(found).begin(), found.end());
  }

 private:
  [[nodiscard]] int bucketOf(double value, double lower, double upper) const {
    const double place = upper > lower ? (value - lower) / (upper - lower) * side_ : 0;
    return static_cast<int>(std::clamp(place, 0.0, side_ - 1.0));
  }
  template <typename Visit>
  void visitBuckets(const Vec3& lower, const Vec3& upper, const Visit& visit) {
    const int left = bucketOf(lower.x, box_.lower.x, box_.upper.x);
    const int right = bucketOf(upper.x, box_.lower.x, box_.upper.x);
    const int front = bucketOf(lower.y, box_.lower.y, box_.upper.y);
    const int back = bucketOf(upper.y, box_.lower.y, box_.upper.y);
    for (int y = front; y <= back; ++y) {
      for (int x = left; x <= right; ++x) visit(buckets_[static_cast<std::size_t>(y * side_ + x)]);
    }
  }

  const std::vector<CellBounds>& cells_;
  FloatBox box_;
  int side_ = 1;
  std::vector<std::vector<std::size_t>> buckets_;
};

/// A convex polygon that is cut at lines x = c and y = c (Sutherland and Hodgman 1974).
class Clipper {
 public:
  std::vector<Vec3> polygon;

  void keep(int axis, double coordinate, bool above) {
    if (std::isinf(coordinate)) return;
    const auto isIn = [&](const Vec3& p) {
      return above ? component(p, axis) >= coordinate : component(p, axis) <= coordinate;
    };
    kept_.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec3& a = polygon[i];
      const Vec3& b = polygon[(i + 1) % polygon.size()];
      if (isIn(a)) kept_.push_back(a);
      if (isIn(a) != isIn(b)) kept_.push_back(cross(a, b, axis, coordinate));
    }
    std::swap(polygon, kept_);
  }

 private:
  static Vec3 cross(const Vec3& a, const Vec3& b, int axis, double coordinate) {
    const double t = (coordinate - component(a, axis)) / (component(b, axis) - component(a, axis));
    Vec3 p{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
    (axis == 0 ? p.x : p.y) = coordinate;  // set exactly, so that borders can be distinguished from other edges
    return p;
  }
  std::vector<Vec3> kept_;
};

/// Collects the drawn geometry of the cells.
class Draper {
 public:
  Draper(const Environment& environment, const Vec3& centre, const std::vector<CellBounds>& cells)
      : environment_(environment), centre_(centre), cells_(cells), pieces_(cells.size()), sources_(cells.size()) {
    for (const Vec3& p : environment.vertices) box_.add(p);
    if (environment.vertices.empty()) box_.add({});
  }

  void drape(Poll poll) {
    CellLookup lookup(cells_, box_);
    const bool heights = std::ranges::any_of(
        cells_, [](const CellBounds& cell) { return std::isfinite(cell.lower[2]) || std::isfinite(cell.upper[2]); });
    for (std::size_t t = 0; t < environment_.triangles.size(); ++t) {
      if (t % kPollEvery == 0) poll();
      const Triangle& triangle = environment_.triangles[t];
      std::array<Vec3, 3> corners{};
      for (std::size_t i = 0; i < 3; ++i) corners[i] = environment_.vertices[triangle[i]];
      if (!facesUp(corners)) continue;
      FloatBox box;
      for (const Vec3& p : corners) box.add(p);
      lookup.find(box, found_);
      for (const std::size_t c : found_) addPiece(corners, box, c, static_cast<std::uint32_t>(t));
      if (heights) addHeightBorders(lookup, t, box.lower.z);
    }
  }

  std::shared_ptr<const CellGeometry> finish() {
    auto geometry = std::make_shared<CellGeometry>();
    for (std::vector<CellVertex>& piece : pieces_) {
      geometry->firstVertex.push_back(geometry->surface.size());
      geometry->surface.insert(geometry->surface.end(), piece.begin(), piece.end());
      piece = {};
    }
    for (const auto& sources : sources_)
      geometry->sources.insert(geometry->sources.end(), sources.begin(), sources.end());
    geometry->firstVertex.push_back(geometry->surface.size());
    geometry->borders = std::move(borders_);
    for (std::size_t c = 0; c < cells_.size(); ++c) addBox(*geometry, c);
    return geometry;
  }

 private:
  [[nodiscard]] bool facesUp(const std::array<Vec3, 3>& p) const {
    const double area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
    return environment_.bothSides ? area != 0 : area > 0;
  }

  [[nodiscard]] std::array<float, 3> place(const Vec3& p) const {
    return {static_cast<float>(p.x - centre_.x), static_cast<float>(p.y - centre_.y),
            static_cast<float>(p.z - centre_.z)};
  }

  void addPiece(const std::array<Vec3, 3>& corners, const FloatBox& box, std::size_t c, std::uint32_t source) {
    const CellBounds& cell = cells_[c];
    clipper_.polygon.assign(corners.begin(), corners.end());
    for (int axis = 0; axis < 2; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      if (component(box.lower, axis) < cell.lower[a]) clipper_.keep(axis, cell.lower[a], true);
      if (component(box.upper, axis) > cell.upper[a]) clipper_.keep(axis, cell.upper[a], false);
    }
    const std::vector<Vec3>& polygon = clipper_.polygon;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      sources_[c].push_back(source);
      for (const std::size_t k : {std::size_t{0}, i - 1, i})
        pieces_[c].push_back({place(polygon[k]), static_cast<std::uint32_t>(c)});
    }
    // The cell below a border draws it for both.
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec3& a = polygon[i];
      const Vec3& b = polygon[(i + 1) % polygon.size()];
      if ((a.x == cell.upper[0] && b.x == cell.upper[0]) || (a.y == cell.upper[1] && b.y == cell.upper[1]))
        borders_.push_back({place(a), place(b)});
    }
  }

  // Heights cut no floor: the border runs along the edges of floors that lie in different cells.
  void addHeightBorders(CellLookup& lookup, std::size_t t, double lowest) {
    const Triangle& triangle = environment_.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [from, to] = std::minmax(triangle[i], triangle[(i + 1) % 3]);
      const auto [known, added] = lowestAtEdge_.try_emplace(std::uint64_t{from} << 32U | to, lowest);
      if (added || known->second == lowest) continue;
      const Vec3& a = environment_.vertices[from];
      const Vec3& b = environment_.vertices[to];
      const auto cellsAt = [&](double height) {
        FloatBox middle;
        middle.add({(a.x + b.x) / 2, (a.y + b.y) / 2, height});
        lookup.find(middle, found_);
        return found_;
      };
      if (cellsAt(lowest) != cellsAt(known->second)) borders_.push_back({place(a), place(b)});
    }
  }

  void addBox(CellGeometry& geometry, std::size_t c) {
    const CellBounds& cell = cells_[c];
    Vec3 lower, upper;
    const auto side = [&](int axis, double low, double high) {
      const double from = std::max(cell.lower[static_cast<std::size_t>(axis)], low);
      const double to = std::min(cell.upper[static_cast<std::size_t>(axis)], high);
      return std::pair{std::min(from, high), std::max(to, low)};
    };
    std::tie(lower.x, upper.x) = side(0, box_.lower.x, box_.upper.x);
    std::tie(lower.y, upper.y) = side(1, box_.lower.y, box_.upper.y);
    std::tie(lower.z, upper.z) = side(2, box_.lower.z, box_.upper.z);
    geometry.boxes.push_back({place(lower), place(upper)});
    const std::array<Vec3, 4> corners = {{{lower.x, lower.y, lower.z},
                                          {upper.x, lower.y, lower.z},
                                          {upper.x, upper.y, lower.z},
                                          {lower.x, upper.y, lower.z}}};
    for (std::size_t i = 0; i < 4; ++i) geometry.borders.push_back({place(corners[i]), place(corners[(i + 1) % 4])});
  }

  const Environment& environment_;
  Vec3 centre_;
  const std::vector<CellBounds>& cells_;
  FloatBox box_;
  Clipper clipper_;
  std::vector<std::size_t> found_;
  std::vector<std::vector<CellVertex>> pieces_;
  std::vector<std::vector<std::uint32_t>> sources_;
  std::vector<LineSegment> borders_;
  std::unordered_map<std::uint64_t, double> lowestAtEdge_;  // for the first triangle at each edge
};

struct CellHit {
  double distance = kInfinity;
  double lowest = 0;  // lowest corner of the triangle
};

}  // namespace

std::shared_ptr<const CellGeometry> makeCellGeometry(const Environment& environment, const Vec3& centre,
                                                     const std::vector<CellBounds>& cells, Poll poll) {
  Draper draper(environment, centre, cells);
  draper.drape(poll);
  return draper.finish();
}

std::optional<SceneBox> boundsOfCell(const CellGeometry& cells, std::size_t cell, const Vec3& centre) {
  if (cell >= cells.boxes.size()) return std::nullopt;
  const CellBox& box = cells.boxes[cell];
  float lowest = std::numeric_limits<float>::max();
  float highest = std::numeric_limits<float>::lowest();
  for (std::size_t v = cells.firstVertex[cell]; v < cells.firstVertex[cell + 1]; ++v) {
    lowest = std::min(lowest, cells.surface[v].position[2]);
    highest = std::max(highest, cells.surface[v].position[2]);
  }
  if (lowest > highest) lowest = highest = box.lower[2];
  return SceneBox{{box.lower[0] + centre.x, box.lower[1] + centre.y, lowest + centre.z},
                  {box.upper[0] + centre.x, box.upper[1] + centre.y, highest + centre.z}};
}

std::vector<LineSegment> edgesOf(const CellBox& box) {
  std::vector<LineSegment> edges;
  const auto corner = [&](unsigned bits) {
    std::array<float, 3> p{};
    for (unsigned axis = 0; axis < 3; ++axis) p[axis] = (bits >> axis & 1U) != 0 ? box.upper[axis] : box.lower[axis];
    return p;
  };
  for (unsigned from = 0; from < 8; ++from) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      if ((from >> axis & 1U) == 0) edges.push_back({corner(from), corner(from | 1U << axis)});
    }
  }
  return edges;
}

std::optional<std::size_t> pickCell(const Ray& ray, const EnvironmentGeometry& environment,
                                    const CellGeometry& geometry, const ShownSpace& shown) {
  CellHit nearest;
  const auto corner = [&](std::size_t vertex) {
    const auto& p = environment.surface[vertex].position;
    return Vec3{p[0], p[1], p[2]};
  };
  for (std::size_t v = 0; v + 2 < environment.surface.size(); v += 3) {
    const std::array<Vec3, 3> triangle = {corner(v), corner(v + 1), corner(v + 2)};
    const std::optional<double> distance = meet(ray, triangle);
    if (!distance || *distance >= nearest.distance || !shown.contains(pointOn(ray, *distance))) continue;
    if (shown.shows && !shown.shows(static_cast<std::uint32_t>(v / 3), meetsFront(ray, triangle))) continue;
    nearest = {*distance, std::min({triangle[0].z, triangle[1].z, triangle[2].z})};
  }
  if (std::isinf(nearest.distance)) {
    const double bottom = environment.lower.z;
    if (ray.direction.z >= 0) return std::nullopt;
    nearest = {(bottom - ray.origin.z) / ray.direction.z, bottom};
    if (nearest.distance <= 0) return std::nullopt;
  }
  const Vec3 place = pointOn(ray, nearest.distance);
  const auto inside = [](double value, float lower, float upper) { return value >= lower && value <= upper; };
  for (std::size_t c = 0; c < geometry.boxes.size(); ++c) {
    const CellBox& box = geometry.boxes[c];
    // Heights are half-open, as in the assignment of floors to cells, and the topmost cell includes its top.
    const bool high = nearest.lowest < box.upper[2] || box.upper[2] >= static_cast<float>(environment.upper.z);
    if (inside(place.x, box.lower[0], box.upper[0]) && inside(place.y, box.lower[1], box.upper[1]) &&
        nearest.lowest >= box.lower[2] && high)
      return c;
  }
  return std::nullopt;
}

}  // namespace footfall::ui
