// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/comparison_distances.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.hpp"
#include "core/base/triangle_tree.hpp"
#include "core/base/vector.hpp"

namespace footfall::detail::comparison {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using KernelTriangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, KernelTriangles::const_iterator>;
using NearestTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

constexpr std::size_t kRange = 256;
constexpr std::size_t kMostQueries = std::size_t{1} << 21;

// The error of coordinates that are about 1 at most. Corners of pieces and distances are rounded a few times each, and
// halving ends long before 60 levels.
constexpr double kSlack = 256 * std::numeric_limits<double>::epsilon();
constexpr double kNear = 0x1p-24;  // below this distance, exact numbers decide whether a sample lies on the surface

Vec3 middle(const Vec3& a, const Vec3& b) { return {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2}; }

using Corners = std::array<Vec3, 3>;

/// The distance to a point of the triangle that is nearest by doubles: never less than the true distance but for the
/// rounding of its coordinates, however thin the triangle is.
double distanceTo(const Corners& t, const Vec3& p) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 side = t[(k + 1) % 3] - t[k], arm = p - t[k];
    const double square = dot(side, side);
    const double share = square > 0 ? std::clamp(dot(side, arm) / square, 0.0, 1.0) : 0.0;
    best = std::min(best, length(arm - share * side));
  }
  const Vec3 u = t[1] - t[0], v = t[2] - t[0], arm = p - t[0];
  const Vec3 normal = cross(u, v);
  const double all = dot(normal, normal), second = dot(normal, cross(arm, v)), third = dot(normal, cross(u, arm));
  if (all > 0 && second > 0 && third > 0 && second + third < all)
    best = std::min(best, length(arm - ((second / all) * u + (third / all) * v)));
  return best;
}

struct Nearest {
  double distance = 0;
  std::uint32_t triangle = 0;
};

/// The places of all positions, multiplied by a power of two that scales the largest coordinate to about 1, so that no
/// product of them overflows or loses digits.
struct ScaledPlaces {
  std::vector<Vec3> places;
  int exponent = 0;

  explicit ScaledPlaces(const Positions& positions) {
    double largest = 0;
    for (const Vec3& p : positions.places)
      largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    std::frexp(largest, &exponent);
    places.reserve(positions.size());
    for (const Vec3& p : positions.places) places.push_back({in(p.x), in(p.y), in(p.z)});
  }
  [[nodiscard]] double in(double x) const { return std::ldexp(x, -exponent); }
  [[nodiscard]] double out(double x) const { return std::ldexp(x, exponent); }
};

/// The surface that distances are measured to.
class Target {
 public:
  Target(const ComparedSurfaces& surfaces, const ScaledPlaces& scaled, const Surface& target, RunContext& context)
      : positions_(surfaces.positions), scaled_(scaled), surface_(target), isCorner_(positions_.size(), false) {
    std::vector<Box> boxes;
    std::vector<std::int32_t> ids;
    for (const Triangle& t : target.triangles) {
      const Corners corners = {scaled_.places[t[0]], scaled_.places[t[1]], scaled_.places[t[2]]};
      triangles_.push_back(corners);
      const auto point = [&](std::size_t k) { return Kernel::Point_3(corners[k].x, corners[k].y, corners[k].z); };
      kernelTriangles_.emplace_back(point(0), point(1), point(2));
      const auto [x0, x1] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
      const auto [y0, y1] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
      const auto [z0, z1] = std::minmax({corners[0].z, corners[1].z, corners[2].z});
      boxes.push_back({{x0, y0, z0}, {x1, y1, z1}});
      ids.push_back(static_cast<std::int32_t>(ids.size()));
    }
    for (const std::uint32_t v : target.positions) isCorner_[v] = true;
    boxTree_.build(boxes, ids, context);
    context.checkCancelled();
    tree_.insert(kernelTriangles_.begin(), kernelTriangles_.end());
    tree_.build();
    context.checkCancelled();
    tree_.accelerate_distance_queries();  // Built now, not in the first query of many threads.
  }

  [[nodiscard]] const Corners& corners(std::uint32_t triangle) const { return triangles_[triangle]; }

  [[nodiscard]] Nearest nearest(const Vec3& p) const {
    const auto found = tree_.closest_point_and_primitive(Kernel::Point_3(p.x, p.y, p.z));
    const auto triangle = static_cast<std::uint32_t>(found.second - kernelTriangles_.cbegin());
    return {distanceTo(triangles_[triangle], p), triangle};
  }

  /// The same for a position of either mesh; 0 exactly where it lies on the surface.
  [[nodiscard]] Nearest nearest(std::uint32_t position, double near, std::vector<std::int32_t>& stack) const {
    Nearest result = nearest(scaled_.places[position]);
    if (isCorner_[position] || (result.distance <= near && isOn(position, stack))) result.distance = 0;
    return result;
  }

 private:
  [[nodiscard]] bool isOn(std::uint32_t position, std::vector<std::int32_t>& stack) const {
    const Vec3& p = scaled_.places[position];
    bool found = false;
    boxTree_.visitOverlapping({{p.x, p.y, p.z}, {p.x, p.y, p.z}}, stack, [&](std::int32_t i) {
      found = isOn(position, surface_.triangles[static_cast<std::size_t>(i)]);
      return !found;
    });
    return found;
  }

  [[nodiscard]] bool isOn(std::uint32_t position, const Triangle& t) const {
    const auto normal = exactNormal(positions_, t);
    mpz_class height = 0;
    for (std::size_t k = 0; k < 3; ++k)
      height += normal[k] * (positions_.integers[position][k] - positions_.integers[t[0]][k]);
    if (height != 0) return false;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto side = exactNormal(positions_, {t[k], t[(k + 1) % 3], position});
      if (side[0] * normal[0] + side[1] * normal[1] + side[2] * normal[2] < 0) return false;
    }
    return true;
  }

  const Positions& positions_;
  const ScaledPlaces& scaled_;
  const Surface& surface_;
  std::vector<bool> isCorner_;
  std::vector<Corners> triangles_;
  KernelTriangles kernelTriangles_;
  NearestTree tree_;
  TriangleTree boxTree_;
};

/// Part of a triangle that distances are measured from.
struct Piece {
  Corners corners;
  std::array<Nearest, 3> nearest;
  double upper;  ///< no point of it is farther
};

class OneSided {
 public:
  OneSided(const ComparedSurfaces& surfaces, const ScaledPlaces& scaled, std::size_t from, double error,
           RunContext& context)
      : positions_(surfaces.positions),
        scaled_(scaled),
        surface_(surfaces.surfaces[from]),
        target_(surfaces, scaled, surfaces.surfaces[1 - from], context),
        error_(scaled.in(error)),
        context_(context) {}

  SurfaceDistances measure(const std::vector<double>& known) {
    sample();
    bound(known);
    for (double* d : {&result_.min, &result_.max, &result_.mean, &result_.rms, &result_.lower, &result_.upper})
      *d = scaled_.out(*d);
    return result_;
  }

 private:
  void sample() {
    const std::vector<std::uint32_t>& samples = surface_.positions;
    nearest_.resize(positions_.size());
    forRanges(samples.size(), kRange, [&](std::size_t first, std::size_t last) {
      context_.checkCancelled();
      std::vector<std::int32_t> stack;
      for (std::size_t i = first; i < last; ++i) nearest_[samples[i]] = target_.nearest(samples[i], kNear, stack);
    });
    result_.samples = samples.size();
    result_.min = std::numeric_limits<double>::infinity();
    result_.max = -1;
    long double sum = 0, squares = 0;
    for (const std::uint32_t v : samples) {
      const double d = nearest_[v].distance;
      result_.min = std::min(result_.min, d);
      if (d > result_.max) {
        result_.max = d;
        result_.farthest = positions_.places[v];
      }
      sum += d;
      squares += static_cast<long double>(d) * d;
    }
    const auto count = static_cast<long double>(samples.size());
    result_.mean = static_cast<double>(sum / count);
    result_.rms = static_cast<double>(std::sqrt(squares / count));
  }

  [[nodiscard]] double upperBound(const Piece& piece) const {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
      // The distance to one triangle is convex; and no distance changes faster than one moves.
      double convex = 0;
      for (const Vec3& corner : piece.corners)
        convex = std::max(convex, distanceTo(target_.corners(piece.nearest[k].triangle), corner));
      const double reach = std::max(length(piece.corners[(k + 1) % 3] - piece.corners[k]),
                                    length(piece.corners[(k + 2) % 3] - piece.corners[k]));
      best = std::min({best, convex, piece.nearest[k].distance + reach});
    }
    return best;
  }

  /// Both halves beside the middle of the longest side, and the distance there.
  std::array<Piece, 2> halves(const Piece& piece, double& distance) const {
    std::size_t longest = 0;
    std::array<double, 3> lengths;
    for (std::size_t k = 0; k < 3; ++k) {
      lengths[k] = length(piece.corners[(k + 1) % 3] - piece.corners[k]);
      if (lengths[k] > lengths[longest]) longest = k;
    }
    const Vec3 point = middle(piece.corners[longest], piece.corners[(longest + 1) % 3]);
    const Nearest nearest = target_.nearest(point);
    distance = nearest.distance;
    std::array<Piece, 2> result = {piece, piece};
    for (std::size_t half = 0; half < 2; ++half) {
      result[half].corners[(longest + half) % 3] = point;
      result[half].nearest[(longest + half) % 3] = nearest;
      result[half].upper = std::min(piece.upper, upperBound(result[half]));
    }
    return result;
  }

  [[nodiscard]] std::vector<Piece> wholeTriangles(const std::vector<double>& known) const {
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < surface_.triangles.size(); ++i) {
      if (known[i] == 0) continue;
      Piece piece{};
      piece.upper = scaled_.in(known[i]);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = surface_.triangles[i][k];
        piece.corners[k] = scaled_.places[v];
        piece.nearest[k] = nearest_[v];
      }
      pieces.push_back(piece);
    }
    forRanges(pieces.size(), kRange, [&](std::size_t first, std::size_t last) {
      context_.checkCancelled();
      for (std::size_t i = first; i < last; ++i) pieces[i].upper = std::min(pieces[i].upper, upperBound(pieces[i]));
    });
    return pieces;
  }

  // Level by level, so that nothing depends on which thread is first.
  void bound(const std::vector<double>& known) {
    double lower = std::max(0.0, result_.max - kSlack), settled = result_.max;
    std::vector<Piece> pieces = wholeTriangles(known);
    if (pieces.empty()) return;  // nothing was rounded: both bounds are 0
    for (std::size_t queries = 0;;) {
      std::erase_if(pieces, [&](const Piece& piece) {
        const bool done = piece.upper <= lower + error_;
        if (done) settled = std::max(settled, piece.upper);
        return done;
      });
      queries += pieces.size();
      if (pieces.empty() || queries > kMostQueries) break;
      std::vector<Piece> next(2 * pieces.size());
      std::vector<double> distances(pieces.size());
      forRanges(pieces.size(), kRange, [&](std::size_t first, std::size_t last) {
        context_.checkCancelled();
        for (std::size_t i = first; i < last; ++i) {
          const auto both = halves(pieces[i], distances[i]);
          next[2 * i] = both[0];
          next[2 * i + 1] = both[1];
        }
      });
      for (const double d : distances) lower = std::max(lower, d - kSlack);
      pieces = std::move(next);
    }
    result_.boundReached = pieces.empty();
    for (const Piece& piece : pieces) settled = std::max(settled, piece.upper);
    result_.lower = lower;
    result_.upper = std::max(lower, settled) + kSlack;
  }

  const Positions& positions_;
  const ScaledPlaces& scaled_;
  const Surface& surface_;
  const Target target_;
  double error_;
  RunContext& context_;
  std::vector<Nearest> nearest_;  ///< nearest triangle of each position in use
  SurfaceDistances result_;
};

}  // namespace

std::array<SurfaceDistances, 2> measureDistances(const ComparedSurfaces& surfaces,
                                                 const std::array<std::vector<double>, 2>& known, double error,
                                                 RunContext& context) {
  const ScaledPlaces scaled(surfaces.positions);
  std::array<SurfaceDistances, 2> result;
  for (std::size_t from = 0; from < 2; ++from)
    result[from] = OneSided(surfaces, scaled, from, error, context).measure(known[from]);
  return result;
}

std::vector<double> distancesOfPositions(const ComparedSurfaces& surfaces, RunContext& context) {
  const ScaledPlaces scaled(surfaces.positions);
  const Target target(surfaces, scaled, surfaces.surfaces[1], context);
  const std::vector<std::uint32_t>& samples = surfaces.surfaces[0].positions;
  std::vector<double> distances(surfaces.positions.size(), 0);
  forRanges(samples.size(), kRange, [&](std::size_t first, std::size_t last) {
    context.checkCancelled();
    std::vector<std::int32_t> stack;
    for (std::size_t i = first; i < last; ++i)
      distances[samples[i]] = scaled.out(target.nearest(samples[i], kNear, stack).distance);
  });
  return distances;
}

}  // namespace footfall::detail::comparison
