// The part of ClearanceCandidates that compares corners of obstacles with a floor and the clearance above it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/base/index_and_box.hpp"
#include "core/filters/clearance/clearance_candidates.hpp"

namespace footfall::detail {
namespace {

// A difference of numbers of `bits` bits has bits + 1, and so on: while the largest sum of a predicate keeps within the
// 53 bits of a double, every step of it is exact, whatever the order, and so is its sign.
constexpr int kDoubleBits = 53;
// A component of a normal has 2 (bits + 1) + 1 bits; three products with a difference and one with the height are
// added.
constexpr int bitsOfHeight(int bits) { return 3 * (bits + 1) + 3; }

/// Up to this width of the grid, components of normals are below 2^62.
constexpr int kIntegerGrid = 29;
static_assert(2 * (kIntegerGrid + 1) + 1 < 62 && bitsOfHeight(kIntegerGrid) < 127);

}  // namespace

void ClearanceCandidates::chooseHeights() {
  Grid grid = mesh_.grid;
  grid.include(height_);
  if (!kernel_.sign().zeroValid) return;
  if (bitsOfHeight(grid.width()) <= kDoubleBits) {
    heights_ = Heights::Doubles;
  } else if (grid.width() <= kIntegerGrid) {
    heights_ = Heights::Integers;
    unitsPerScaled_ = std::ldexp(1.0, -(grid.low + mesh_.grid.scaleExponent()));
    integerHeight_ = static_cast<std::int64_t>(scaledHeight_ * unitsPerScaled_);
  }
}

// Differences of scaled coordinates on the grid are exact in doubles, and whole numbers in units of the grid.
std::array<std::int64_t, 3> ClearanceCandidates::unitsBetween(const Vec3& from, const Vec3& to) const {
  const auto units = [&](double difference) { return static_cast<std::int64_t>(difference * unitsPerScaled_); };
  return {units(to.x - from.x), units(to.y - from.y), units(to.z - from.z)};
}

void ClearanceCandidates::beginIntegers() {
  const auto& f = mesh_.triangles[face_];
  const Vec3& base = mesh_.scaled[f[0]];
  const auto u = unitsBetween(base, mesh_.scaled[f[1]]), v = unitsBetween(base, mesh_.scaled[f[2]]);
  integerNormal_ = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

ClearanceCandidates::HeightBits ClearanceCandidates::integerHeights(const std::array<Index, 3>& obstacle) const {
  __extension__ using Int128 = __int128;
  const auto& [nx, ny, nz] = integerNormal_;
  const Vec3& base = mesh_.scaled[mesh_.triangles[face_][0]];
  const Int128 ceiling = Int128{nz} * integerHeight_;
  HeightBits heights;
  for (unsigned j = 0; j < 3; ++j) {
    const auto [x, y, z] = unitsBetween(base, mesh_.scaled[obstacle[j]]);
    const Int128 value = Int128{nx} * x + Int128{ny} * y + Int128{nz} * z;
    heights.floor.set(j, (value > 0) - (value < 0));
    heights.ceiling.set(j, (value > ceiling) - (value < ceiling));
  }
  return heights;
}

// Exact: a rounded difference on one side of the clearance is on that side before rounding, as the clearance is a
// double; when they are equal, the residual decides.
int ClearanceCandidates::compareToCeiling(double z) const {
  const double difference = z - floorZ_;
  if (difference != height_) return difference > height_ ? 1 : -1;
  const double part = difference - z;
  const double residual = (z - (difference - part)) - (floorZ_ + part);
  return residual > 0 ? 1 : residual < 0 ? -1 : 0;
}

ClearanceCandidates::HeightBits ClearanceCandidates::levelHeights(const std::array<Index, 3>& obstacle) const {
  const std::array<double, 3> z{mesh_.vertices[obstacle[0]].z, mesh_.vertices[obstacle[1]].z,
                                mesh_.vertices[obstacle[2]].z};
  const Three three{Double2{z[0], z[1]}, z[2]};
  HeightBits heights{ThreeSigns::above(three, floorZ_), {}};
  heights.ceiling = ThreeSigns::above({three.first - floorZ_, three.last - floorZ_}, height_);
  for (unsigned rest = heights.floor.positive & ~(heights.ceiling.positive | heights.ceiling.negative); rest != 0;
       rest &= rest - 1) {
    const int corner = std::countr_zero(rest);
    heights.ceiling.set(static_cast<unsigned>(corner), compareToCeiling(z[corner]));
  }
  return heights;
}

ClearanceCandidates::HeightBits ClearanceCandidates::exactHeights(const std::array<Index, 3>& obstacle) const {
  const Vec3& base = mesh_.scaled[mesh_.triangles[face_][0]];
  const Vec3 &a = mesh_.scaled[obstacle[0]], &b = mesh_.scaled[obstacle[1]], &c = mesh_.scaled[obstacle[2]];
  const Three value{
      nx_ * (Double2{a.x, b.x} - base.x) + ny_ * (Double2{a.y, b.y} - base.y) + nz_ * (Double2{a.z, b.z} - base.z),
      nx_ * (c.x - base.x) + ny_ * (c.y - base.y) + nz_ * (c.z - base.z)};
  return {ThreeSigns::above(value, 0), ThreeSigns::above(value, nz_ * scaledHeight_)};
}

ClearanceCandidates::HeightBits ClearanceCandidates::filteredHeights(const std::array<Index, 3>& obstacle) {
  HeightBits heights;
  const auto& f = mesh_.triangles[face_];
  const Vec3& base = mesh_.scaled[f[0]];
  const double slack = kernel_.sign().slack;
  for (unsigned j = 0; j < 3; ++j) {
    const Index v = obstacle[j];
    int floor = 0, ceiling = -1;
    if (v != f[0] && v != f[1] && v != f[2]) {
      const Vec3& p = mesh_.scaled[v];
      const double dx = p.x - base.x, dy = p.y - base.y, dz = p.z - base.z;
      const double tx = nx_ * dx, ty = ny_ * dy, tz = nz_ * dz, th = nz_ * scaledHeight_;
      const double value = tx + ty + tz;
      // The bound: at most five roundings on each term, then the normal's own error; 9 u and kInflate cover the bound's
      // rounding.
      const double bound = ((std::fabs(tx) + std::fabs(ty) + std::fabs(tz) + std::fabs(th)) * (9 * 0x1p-53) +
                            ex_ * std::fabs(dx) + ey_ * std::fabs(dy) + ez_ * (std::fabs(dz) + scaledHeight_)) *
                               kInflate +
                           slack;
      floor = value > bound ? 1 : value < -bound ? -1 : kernel_.heightSign(face_, v, 0, fallbacks);
      if (floor > 0)
        ceiling = value - th > bound ? 1 : value - th < -bound ? -1 : kernel_.heightSign(face_, v, level_, fallbacks);
    }
    heights.floor.set(j, floor);
    heights.ceiling.set(j, ceiling);
  }
  return heights;
}

ClearanceCandidates::HeightBits ClearanceCandidates::heightsOf(const std::array<Index, 3>& obstacle) {
  if (isLevel_) return levelHeights(obstacle);
  if (heights_ == Heights::Doubles) return exactHeights(obstacle);
  return heights_ == Heights::Integers ? integerHeights(obstacle) : filteredHeights(obstacle);
}

bool ClearanceCandidates::findHeights(ClearanceCandidate& candidate) {
  const auto& o = mesh_.triangles[candidate.obstacle];
  const HeightBits heights = heightsOf(o);
  candidate.coplanar = (heights.floor.positive | heights.floor.negative) == 0;
  if (!candidate.coplanar && (heights.floor.positive == 0 || heights.ceiling.negative == 0)) return false;
  candidate.floor = heights.floor.each();
  candidate.ceiling = heights.ceiling.each();
  return true;
}

}  // namespace footfall::detail
