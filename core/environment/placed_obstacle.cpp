// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environment/placed_obstacle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

constexpr int kSides = 24;          // sides of a cylinder; a multiple of 4, so that it touches its extents
constexpr double kMostInside = 64;  // faces within one obstacle
constexpr int kDigits = 24;         // binary, of the smaller extent that turned corners keep

struct PlanVector {
  double x = 0, y = 0;
};

void check(const PlacedObstacle& obstacle) {
  const auto& [id, shape, name, base, size, turn] = obstacle;
  for (const double number : {base.x, base.y, base.z, size.x, size.y, size.z, turn})
    if (!std::isfinite(number)) throw InputError(FOOTFALL_TEXT("obstacle '%1' has a number that is not finite"), name);
  if (!(size.x > 0 && size.y > 0 && size.z > 0))
    throw InputError(FOOTFALL_TEXT("obstacle '%1' has an extent that is not above 0; give a larger one"), name);
  for (const double reach : {base.x, base.y, base.z})
    if (!std::isfinite(std::abs(reach) + size.x + size.y + size.z))
      throw InputError(FOOTFALL_TEXT("obstacle '%1' reaches too far; make it smaller"), name);
}

/// The extents from the middle of the bottom: half of each, along its own axes, turned.
class Footprint {
 public:
  explicit Footprint(const PlacedObstacle& obstacle) : base_(obstacle.base) {
    const auto [c, s] = directionOf(obstacle.turn);
    const double halfX = obstacle.size.x / 2, halfY = obstacle.size.y / 2;
    const auto exponent = [](double extent) {
      return std::ilogb(std::max(extent, std::numeric_limits<double>::min()));
    };
    // The quantum is not finer than the last digit of the larger side.
    quantum_ =
        std::ldexp(1.0, std::max(exponent(std::min(halfX, halfY)) - kDigits, exponent(std::max(halfX, halfY)) - 52));
    const bool parallel = c == 0 || s == 0;
    const auto component = [&](double v) { return parallel ? v : rounded(v); };
    along_ = {component(halfX * c), component(halfX * s)};
    across_ = {component(-halfY * s), component(halfY * c)};
  }

  /// `x` and `y` from -1 to 1, along the obstacle's own axes.
  [[nodiscard]] PlanVector at(double x, double y) const {
    return {base_.x + (along_.x * x + across_.x * y), base_.y + (along_.y * x + across_.y * y)};
  }
  [[nodiscard]] PlanVector onCircle(int side) const {
    const auto [c, s] = directionOf(360.0 / kSides * side);
    if (c == 0 || s == 0) return at(c, s);
    return {base_.x + rounded(along_.x * c + across_.x * s), base_.y + rounded(along_.y * c + across_.y * s)};
  }

 private:
  [[nodiscard]] double rounded(double v) const { return std::round(v / quantum_) * quantum_; }

  Vec3 base_;
  PlanVector along_, across_;
  double quantum_ = 0;
};

std::vector<PlanVector> outline(const PlacedObstacle& obstacle) {
  const Footprint footprint(obstacle);
  if (obstacle.shape != PlacedObstacle::Shape::Cylinder)
    return {footprint.at(-1, -1), footprint.at(1, -1), footprint.at(1, 1), footprint.at(-1, 1)};
  std::vector<PlanVector> corners;
  for (int side = 0; side < kSides; ++side) corners.push_back(footprint.onCircle(side));
  return corners;
}

/// A convex polygon at one height.
void addFlat(TriangleSoup& soup, const std::vector<PlanVector>& corners, double z, bool up) {
  const auto first = static_cast<std::uint32_t>(soup.vertices.size());
  for (const PlanVector& corner : corners) soup.vertices.push_back({corner.x, corner.y, z});
  for (std::uint32_t i = 2; i < corners.size(); ++i) {
    if (up) {
      soup.triangles.push_back({first, first + i - 1, first + i});
    } else {
      soup.triangles.push_back({first, first + i, first + i - 1});
    }
  }
}

TriangleSoup prism(const std::vector<PlanVector>& corners, double bottom, double top) {
  TriangleSoup soup;
  addFlat(soup, corners, bottom, false);
  addFlat(soup, corners, top, true);
  const auto count = static_cast<std::uint32_t>(corners.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    soup.triangles.push_back({i, next, count + next});
    soup.triangles.push_back({i, count + next, count + i});
  }
  return soup;
}

TriangleSoup wedge(const std::vector<PlanVector>& c, double bottom, double top) {
  TriangleSoup soup;
  for (const PlanVector& corner : c) soup.vertices.push_back({corner.x, corner.y, bottom});
  for (const std::size_t high : {1U, 2U}) soup.vertices.push_back({c[high].x, c[high].y, top});
  soup.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 4, 5}, {0, 5, 3}, {1, 2, 5}, {1, 5, 4}, {0, 1, 4}, {3, 5, 2}};
  return soup;
}

}  // namespace

std::array<double, 2> directionOf(double degrees) {
  const double turn = std::remainder(degrees, 360.0);  // exact
  if (std::fmod(turn, 90.0) == 0) {
    if (turn == 0) return {1, 0};
    if (std::abs(turn) == 180) return {-1, 0};
    return {0, turn > 0 ? 1.0 : -1.0};
  }
  const double radians = turn * std::numbers::pi / 180;
  return {std::cos(radians), std::sin(radians)};
}

Vec3 placeOn(const PlacedObstacle& obstacle, const Vec3& local) {
  const auto [c, s] = directionOf(obstacle.turn);
  return {obstacle.base.x + (c * local.x - s * local.y), obstacle.base.y + (s * local.x + c * local.y),
          obstacle.base.z + local.z};
}

TriangleSoup soupOf(const PlacedObstacle& obstacle) {
  check(obstacle);
  const double bottom = obstacle.base.z;
  const double top = bottom + obstacle.size.z;
  const std::vector<PlanVector> corners = outline(obstacle);
  return obstacle.shape == PlacedObstacle::Shape::Ramp ? wedge(corners, bottom, top) : prism(corners, bottom, top);
}

TriangleSoup solidSoupOf(const PlacedObstacle& obstacle, double spacing) {
  TriangleSoup soup = soupOf(obstacle);
  const double count = std::min(std::floor(obstacle.size.z / spacing), kMostInside);
  const double step = obstacle.size.z / (count + 1);
  const bool ramp = obstacle.shape == PlacedObstacle::Shape::Ramp;
  for (double i = 1; i <= count; ++i) {
    const double z = obstacle.base.z + i * step;
    std::vector<PlanVector> corners = outline(obstacle);
    if (ramp) {
      // The cylinder begins where the slope is a step higher, so that rounding moves no inner place outside.
      if (i == count) break;
      const Footprint footprint(obstacle);
      const double x = 2 * (i + 1) / (count + 1) - 1;
      corners[0] = footprint.at(x, -1);
      corners[3] = footprint.at(x, 1);
    }
    addFlat(soup, corners, z, false);
  }
  return soup;
}

}  // namespace footfall::detail
