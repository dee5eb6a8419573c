// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/geometry/level_covers.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/parallel.hpp"
#include "core/base/vector.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {
namespace {

// Lines of sight of each direction along the longer side of the level.
constexpr int kAcross = 96;
// Pieces of the level along its longest side: places in one piece that face the same way are alike.
constexpr std::size_t kPieces = 64;
constexpr float kFloorNormal = 0.7F;
// The share of unobstructed lines of sight through a place: inside places have at most the first, outside places at
// least the second.
constexpr double kInside = 0.03, kOutside = 0.35;
// The share of inside floors among all floors; a level with less is open.
constexpr double kClosed = 0.025;
// The share of lines of sight through a region that lead to inside floors: through a slab or a wall, and through rock.
constexpr double kThroughWall = 0.3, kThroughRock = 0.04;
constexpr float kWall = 0.06F;          // share of the level's longest side: thicker parts are rock
constexpr double kMuchOfInside = 0.04;  // share of one rock region in the lines of sight that lead inside
// The share of unobstructed vertical lines of sight among those that meet a level region; a region with less has a
// storey above most of it, and is a floor.
constexpr double kUnderTheSky = 0.5;
constexpr double kSide = 0.2;  // share of a side of the level's box that a region lies on

using Point = std::array<float, 3>;

struct Direction {
  Point ahead;
  bool steep = false;  ///< the line looks down into the level
};

// Directions from above, all around, at three angles and straight down; slightly rotated, because levels are built
// along their axes.
std::vector<Direction> directions() {
  std::vector<Direction> all{{{0.02F, 0.01F, -0.99975F}, true}};
  for (const auto& [degrees, count] : {std::pair{15, 8}, std::pair{38, 8}, std::pair{60, 4}}) {
    const double pitch = degrees * M_PI / 180;
    for (int k = 0; k < count; ++k) {
      const double turn = 0.1 + (k + (degrees == 38 ? 0 : 0.5)) * 2 * M_PI / count;
      all.push_back({{static_cast<float>(std::cos(pitch) * std::cos(turn)),
                      static_cast<float>(std::cos(pitch) * std::sin(turn)), static_cast<float>(-std::sin(pitch))},
                     degrees > 20});
    }
  }
  return all;
}

struct Shape {
  const std::vector<SurfaceVertex>& surface;
  std::vector<Point> normals;
  std::vector<float> areas;
  Point lower{}, upper{};
  float extent = 0;

  [[nodiscard]] const Point& corner(std::size_t triangle, std::size_t k) const {
    return surface[3 * triangle + k].position;
  }
  [[nodiscard]] std::size_t count() const { return normals.size(); }
};

Shape shapeOf(const std::vector<SurfaceVertex>& surface) {
  Shape shape{surface, {}, {}, surface.front().position, surface.front().position, 0};
  for (const SurfaceVertex& vertex : surface) {
    for (std::size_t k = 0; k < 3; ++k) {
      shape.lower[k] = std::min(shape.lower[k], vertex.position[k]);
      shape.upper[k] = std::max(shape.upper[k], vertex.position[k]);
    }
  }
  const Point size = shape.upper - shape.lower;
  shape.extent = std::max({size[0], size[1], size[2]});
  for (std::size_t t = 0; 3 * t + 2 < surface.size(); ++t) {
    const Point normal = cross(shape.corner(t, 1) - shape.corner(t, 0), shape.corner(t, 2) - shape.corner(t, 0));
    const float length = std::sqrt(dot(normal, normal));
    shape.normals.push_back(length > 0 ? (1 / length) * normal : Point{});
    shape.areas.push_back(length / 2);
  }
  return shape;
}

/// Counts, by place and facing direction, the lines of sight that arrive, and those that are unobstructed.
class Exposure {
 public:
  explicit Exposure(const Shape& shape) : shape_(shape), counts_(kPieces * kPieces * kPieces * 6) {}

  void add(const Point& place, const Point& normal, bool open) {
    auto& count = counts_[indexOf(place, normal)];
    std::atomic_ref(count[0]).fetch_add(1, std::memory_order_relaxed);
    if (open) std::atomic_ref(count[1]).fetch_add(1, std::memory_order_relaxed);
  }
  [[nodiscard]] double at(const Point& place, const Point& normal) const {
    const auto& count = counts_[indexOf(place, normal)];
    return count[0] > 0 ? static_cast<double>(count[1]) / count[0] : 0;
  }

 private:
  [[nodiscard]] std::size_t indexOf(const Point& place, const Point& normal) const {
    std::size_t index = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const float at = (place[k] - shape_.lower[k]) / shape_.extent * static_cast<float>(kPieces);
      index = index * kPieces + static_cast<std::size_t>(std::clamp(at, 0.0F, static_cast<float>(kPieces - 1)));
    }
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (std::abs(normal[k]) > std::abs(normal[axis])) axis = k;
    }
    return index * 6 + 2 * axis + (normal[axis] < 0 ? 1 : 0);
  }

  const Shape& shape_;
  std::vector<std::array<std::uint32_t, 2>> counts_;
};

/// A line of sight from outside: the first front that it meets, and the first one behind that.
struct Sight {
  std::uint32_t first = 0;
  Point firstAt{};
  std::optional<std::uint32_t> second;
  Point secondAt{};
  float thickness = 0;  ///< distance to the first back behind the first front; 0 without one
};

struct Hit {
  std::int32_t line = 0;
  float depth = 0;
  std::uint32_t triangle = 0;
};

/// Lines of sight along one direction, in rows.
class Sights {
 public:
  Sights(const Shape& shape, const Point& ahead) : shape_(shape), ahead_(ahead) {
    right_ = cross(ahead, Point{0, 0, 1});
    right_ = 1 / std::sqrt(dot(right_, right_)) * right_;
    up_ = cross(right_, ahead);
    Point size{};
    constexpr float kMost = std::numeric_limits<float>::max();
    left_ = bottom_ = kMost;
    for (unsigned i = 0; i < 8; ++i) {
      const Point p{(i & 1U) != 0 ? shape.upper[0] : shape.lower[0], (i & 2U) != 0 ? shape.upper[1] : shape.lower[1],
                    (i & 4U) != 0 ? shape.upper[2] : shape.lower[2]};
      size[0] = i == 0 ? dot(p, right_) : std::max(size[0], dot(p, right_));
      size[1] = i == 0 ? dot(p, up_) : std::max(size[1], dot(p, up_));
      left_ = std::min(left_, dot(p, right_));
      bottom_ = std::min(bottom_, dot(p, up_));
    }
    scale_ = static_cast<float>(kAcross) / std::max(size[0] - left_, size[1] - bottom_);
    for (std::size_t t = 0; t < shape.count(); ++t) meet(static_cast<std::uint32_t>(t));
    std::ranges::sort(hits_, [](const Hit& a, const Hit& b) {
      return a.line != b.line ? a.line < b.line : a.depth != b.depth ? a.depth < b.depth : a.triangle < b.triangle;
    });
  }

  /// Calls visit(first, last) for the hits of each line, from outside in.
  template <typename Visit>
  void forEachLine(Visit visit) const {
    for (auto first = hits_.begin(); first != hits_.end();) {
      auto last = first;
      while (last != hits_.end() && last->line == first->line) ++last;
      visit(first, last);
      first = last;
    }
  }

  [[nodiscard]] Point placeOf(const Hit& hit) const {
    const float x = (static_cast<float>(hit.line % kAcross) + 0.5F) / scale_ + left_;
    const float y = (static_cast<float>(hit.line / kAcross) + 0.5F) / scale_ + bottom_;
    Point place{};
    for (std::size_t k = 0; k < 3; ++k) place[k] = right_[k] * x + up_[k] * y + ahead_[k] * hit.depth;
    return place;
  }

 private:
  void meet(std::uint32_t triangle) {
    std::array<Point, 3> p{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& corner = shape_.corner(triangle, k);
      p[k] = {(dot(corner, right_) - left_) * scale_, (dot(corner, up_) - bottom_) * scale_, dot(corner, ahead_)};
    }
    const auto twice = [](const Point& a, const Point& b, float x, float y) {
      return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
    };
    const float area = twice(p[0], p[1], p[2][0], p[2][1]);
    if (!(std::abs(area) > 1e-9F)) return;
    const auto range = [&](std::size_t axis) {
      const auto [low, high] = std::minmax({p[0][axis], p[1][axis], p[2][axis]});
      return std::pair{static_cast<int>(std::max(0.0F, std::ceil(low - 0.5F))),
                       static_cast<int>(std::min(kAcross - 1.0F, std::floor(high - 0.5F)))};
    };
    const auto [left, right] = range(0);
    const auto [bottom, top] = range(1);
    for (int y = bottom; y <= top; ++y) {
      for (int x = left; x <= right; ++x) {
        const float px = static_cast<float>(x) + 0.5F, py = static_cast<float>(y) + 0.5F;
        const float b1 = twice(p[2], p[0], px, py) / area, b2 = twice(p[0], p[1], px, py) / area;
        if (b1 < 0 || b2 < 0 || b1 + b2 > 1) continue;
        hits_.push_back({y * kAcross + x, p[0][2] + b1 * (p[1][2] - p[0][2]) + b2 * (p[2][2] - p[0][2]), triangle});
      }
    }
  }

  const Shape& shape_;
  Point ahead_, right_{}, up_{};
  float left_ = 0, bottom_ = 0, scale_ = 1;
  std::vector<Hit> hits_;
};

/// The exposure of each triangle.
struct Openness {
  std::vector<std::uint32_t> lines, open;
  explicit Openness(std::size_t triangles) : lines(triangles), open(triangles) {}
};

std::vector<Sight> look(const Shape& shape, const Direction& direction, Exposure& exposure, Openness& openness,
                        Openness* fromAbove) {
  const Sights sights(shape, direction.ahead);
  const float same = 1e-4F * shape.extent;
  std::vector<Sight> found;
  sights.forEachLine([&](auto begin, auto end) {
    std::optional<Sight> sight;
    float depth = 0;
    for (auto hit = begin; hit != end; ++hit) {
      const Point& normal = shape.normals[hit->triangle];
      const bool behind = sight && hit->depth > depth + same;
      if (dot(normal, direction.ahead) >= 0) {
        if (behind && !sight->second && sight->thickness == 0) sight->thickness = hit->depth - depth;
        continue;
      }
      const Point place = sights.placeOf(*hit);
      const bool open = hit->depth <= begin->depth + same;
      exposure.add(place, normal, open);
      std::atomic_ref(openness.lines[hit->triangle]).fetch_add(1, std::memory_order_relaxed);
      if (open) std::atomic_ref(openness.open[hit->triangle]).fetch_add(1, std::memory_order_relaxed);
      if (fromAbove) {
        ++fromAbove->lines[hit->triangle];
        fromAbove->open[hit->triangle] += open ? 1 : 0;
      }
      if (!sight) {
        sight = Sight{hit->triangle, place, std::nullopt, {}, 0};
        depth = hit->depth;
      } else if (behind && !sight->second) {
        sight->second = hit->triangle;
        sight->secondAt = place;
      }
    }
    if (direction.steep && sight) found.push_back(*sight);
  });
  return found;
}

bool isClosed(const Shape& shape, const Openness& openness) {
  double all = 0;
  double inside = 0;
  for (std::size_t t = 0; t < shape.count(); ++t) {
    if (shape.normals[t][2] < kFloorNormal || openness.lines[t] == 0) continue;
    const double area = static_cast<double>(shape.areas[t]);
    all += area;
    if (openness.open[t] <= kInside * openness.lines[t]) inside += area;
  }
  return inside > 0 && inside >= kClosed * all;
}

/// Lines of sight through one region.
struct Votes {
  std::uint32_t all = 0, wall = 0, inside = 0;
  /// vertical lines of sight that meet it, and those of them that are unobstructed
  std::uint32_t fromAbove = 0, underTheSky = 0;
  double area = 0;
};

// Upright sides of the level's box, which a block of rock has, hide its inside from all places outside.
bool isSideOfBox(const Shape& shape, std::size_t triangle, double area) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const float normal = shape.normals[triangle][axis];
    if (std::abs(normal) < 0.999F) continue;
    const float at = shape.corner(triangle, 0)[axis] - (normal > 0 ? shape.upper : shape.lower)[axis];
    const Point size = shape.upper - shape.lower;
    return std::abs(at) < 0.003F * shape.extent && area > kSide * static_cast<double>(size[1 - axis] * size[2]);
  }
  return false;
}

}  // namespace

std::vector<bool> findCovers(const std::vector<SurfaceVertex>& surface, const std::vector<std::uint32_t>& regions) {
  std::vector<bool> covers(surface.size() / 3);
  if (covers.empty()) return covers;
  const Shape shape = shapeOf(surface);
  if (!(shape.extent > 0) || !std::isfinite(shape.extent)) return covers;
  const std::vector<Direction> all = directions();
  std::vector<std::vector<Sight>> sights(all.size());
  Exposure exposure(shape);
  Openness openness(shape.count()), fromAbove(shape.count());
  forRanges(all.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      sights[i] = look(shape, all[i], exposure, openness, i == 0 ? &fromAbove : nullptr);
  });
  if (!isClosed(shape, openness)) return covers;

  std::vector<Votes> votes(shape.count());
  std::uint64_t inside = 0;
  for (const auto& list : sights) {
    for (const Sight& sight : list) {
      Votes& region = votes[regions[sight.first]];
      ++region.all;
      if (!sight.second || shape.normals[*sight.second][2] < kFloorNormal) continue;
      if (exposure.at(sight.firstAt, shape.normals[sight.first]) < kOutside) continue;
      if (exposure.at(sight.secondAt, shape.normals[*sight.second]) > kInside) continue;
      ++region.inside;
      ++inside;
      if (sight.thickness > 0 && sight.thickness < kWall * shape.extent) ++region.wall;
    }
  }
  for (std::size_t t = 0; t < shape.count(); ++t) {
    votes[regions[t]].fromAbove += fromAbove.lines[t];
    votes[regions[t]].underTheSky += fromAbove.open[t];
  }
  bool roof = false;
  for (std::size_t t = 0; t < shape.count(); ++t) {
    Votes& region = votes[regions[t]];
    region.area += static_cast<double>(shape.areas[t]);
    const bool rock = region.inside > 0 && region.inside >= kThroughRock * region.all &&
                      static_cast<double>(region.inside) >= kMuchOfInside * static_cast<double>(inside);
    const bool isFloor = shape.normals[t][2] > kFloorNormal && region.fromAbove > 0 &&
                         region.underTheSky < kUnderTheSky * region.fromAbove;
    if (isFloor) continue;
    covers[t] = rock || (region.wall > 0 && region.wall >= kThroughWall * region.all);
    roof = roof || (rock && shape.normals[t][2] > kFloorNormal);
  }
  for (std::size_t t = 0; roof && t < shape.count(); ++t) {
    if (isSideOfBox(shape, t, votes[regions[t]].area)) covers[t] = true;
  }
  return covers;
}

}  // namespace footfall::ui
