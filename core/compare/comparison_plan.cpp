// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/comparison_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "core/base/parallel.hpp"
#include "core/base/poll.hpp"
#include "core/base/triangle_tree.hpp"

namespace footfall::detail::comparison {
namespace {

constexpr int kWidth = 192;  // bits that coordinates of constructed points have at least

class CoveredPart {
 public:
  CoveredPart(const ComparedSurfaces& surfaces, double height, RunContext& context)
      : positions_(surfaces.positions),
        height_(height),
        heightOnGrid_(onGrid(height, positions_.unit)),
        finer_(static_cast<unsigned>(std::max(0, kWidth - positions_.width))),
        context_(context) {}

  /// Finds the triangles of `other` that may cover the chosen ones.
  void prepare(const Surface& other) {
    other_ = &other;
    std::vector<Box> boxes(other.triangles.size());
    std::vector<std::int32_t> ids(other.triangles.size());
    normals_.assign(other.triangles.size(), {});
    forRanges(ids.size(), 4096, [&](std::size_t first, std::size_t last) {
      context_.checkCancelled();
      for (std::size_t i = first; i < last; ++i) {
        boxes[i] = boxOf(other.triangles[i], 0);
        ids[i] = static_cast<std::int32_t>(i);
        normals_[i] = exactNormal(positions_, other.triangles[i]);
      }
    });
    tree_.build(boxes, ids, context_);
  }

  /// The part of the triangle's area in the plan that is not covered. `parts` (may be null) receives it.
  double uncoveredShare(const Triangle& triangle, std::vector<std::int32_t>& stack,
                        std::vector<CoverTriangle>* parts = nullptr) const {
    const auto normal = exactNormal(positions_, triangle);
    if (normal[2] == 0) return 1;
    Outlines outlines;
    addTriangle(triangle, sgn(normal[2]), 0, outlines);
    bool any = false;
    tree_.visitOverlapping(boxOf(triangle, height_), stack, [&](std::int32_t i) {
      any = addNear(triangle, normal, static_cast<std::size_t>(i), outlines) || any;
      return true;
    });
    if (!any && parts == nullptr) return 1;
    std::vector<CoverPiece> borders;
    const Poll poll(context_);
    const CoverResult result = coverAreas(outlines.points, outlines.edges, poll, parts != nullptr ? &borders : nullptr);
    if (parts != nullptr) *parts = partsOf(outlines, borders);
    if (!result.hasArea[kOnlyFirst]) return 0;
    const mpf_class share = result.twiceArea[kOnlyFirst] / (result.twiceArea[kOnlyFirst] + result.twiceArea[kBoth]);
    return share.get_d();
  }

 private:
  struct Outlines {
    std::vector<CoverPoint> points;
    std::vector<CoverEdge> edges;
    std::unordered_map<std::uint32_t, std::uint32_t> numbers;  ///< number of each position among the points
  };

  /// Lengths are in the meshes' units; corners are numbers of positions.
  [[nodiscard]] std::vector<CoverTriangle> partsOf(const Outlines& outlines, std::vector<CoverPiece> borders) const {
    std::erase_if(borders, [](const CoverPiece& piece) { return piece.part != kOnlyFirst; });
    std::vector<std::uint32_t> positions(outlines.points.size(), CoverCorner::kNoPoint);
    for (const auto& [position, point] : outlines.numbers) positions[point] = position;
    std::vector<CoverTriangle> parts = triangulatePart(borders, context_);
    const int unit = positions_.unit - static_cast<int>(finer_);
    for (CoverTriangle& part : parts) {
      for (CoverCorner& corner : part.corners) {
        corner.x = std::ldexp(corner.x, unit);
        corner.y = std::ldexp(corner.y, unit);
        if (corner.point != CoverCorner::kNoPoint) corner.point = positions[corner.point];
      }
    }
    return parts;
  }

  [[nodiscard]] Box boxOf(const Triangle& triangle, double above) const {
    Box box;
    const auto coordinate = [](const Vec3& p, std::size_t k) { return k == 0 ? p.x : k == 1 ? p.y : p.z; };
    for (std::size_t k = 0; k < 3; ++k) {
      const double a = coordinate(positions_.places[triangle[0]], k), b = coordinate(positions_.places[triangle[1]], k),
                   c = coordinate(positions_.places[triangle[2]], k);
      box.lower[k] = std::min({a, b, c});
      box.upper[k] = std::max({a, b, c});
    }
    if (above > 0) {
      constexpr double kInfinity = std::numeric_limits<double>::infinity();
      box.lower[2] = std::nextafter(box.lower[2] - above, -kInfinity);
      box.upper[2] = std::nextafter(box.upper[2] + above, kInfinity);
    }
    return box;
  }

  std::uint32_t pointOf(std::uint32_t position, Outlines& outlines) const {
    const auto [it, isNew] = outlines.numbers.try_emplace(position, static_cast<std::uint32_t>(outlines.points.size()));
    if (isNew) {
      const auto& p = positions_.integers[position];
      outlines.points.push_back({p[0] << finer_, p[1] << finer_});
    }
    return it->second;
  }

  static void addPolygon(const std::vector<std::uint32_t>& corners, std::uint32_t set, Outlines& outlines) {
    for (std::size_t k = 0; k < corners.size(); ++k)
      outlines.edges.push_back({corners[k], corners[(k + 1) % corners.size()], set});
  }

  void addTriangle(Triangle triangle, int facing, std::uint32_t set, Outlines& outlines) const {
    if (facing < 0) std::swap(triangle[1], triangle[2]);
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t v : triangle) corners.push_back(pointOf(v, outlines));
    addPolygon(corners, set, outlines);
  }

  /// Adds the part of the other surface's triangle that lies within the height of the plane of `triangle`; false when
  /// there is none.
  bool addNear(const Triangle& triangle, const std::array<mpz_class, 3>& normal, std::size_t number,
               Outlines& outlines) const {
    const int facing = sgn(normals_[number][2]);
    if (facing == 0) return false;
    Triangle other = other_->triangles[number];
    if (facing < 0) std::swap(other[1], other[2]);
    // Heights of the corners below the plane, times the normal's z.
    const auto& origin = positions_.integers[triangle[0]];
    const mpz_class limit = heightOnGrid_ * abs(normal[2]);
    std::array<mpz_class, 3> heights;
    int above = 0, below = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& p = positions_.integers[other[k]];
      for (std::size_t c = 0; c < 3; ++c) heights[k] += normal[c] * (p[c] - origin[c]);
      if (heights[k] > limit) ++above;
      if (heights[k] < -limit) ++below;
    }
    if (above == 3 || below == 3) return false;
    if (above == 0 && below == 0) {
      addTriangle(other, 1, 1, outlines);
      return true;
    }
    return addClipped(other, heights, limit, outlines);
  }

  struct Corner {
    std::uint32_t point;
    mpz_class height;
  };

  bool addClipped(const Triangle& other, const std::array<mpz_class, 3>& heights, const mpz_class& limit,
                  Outlines& outlines) const {
    std::vector<Corner> polygon;
    for (std::size_t k = 0; k < 3; ++k) polygon.push_back({pointOf(other[k], outlines), heights[k]});
    polygon = clipped(polygon, limit, 1, outlines);
    polygon = clipped(polygon, limit, -1, outlines);
    if (polygon.size() < 3) return false;
    std::vector<std::uint32_t> corners;
    for (const Corner& corner : polygon) corners.push_back(corner.point);
    addPolygon(corners, 1, outlines);
    return true;
  }

  /// The part where sign * height <= limit.
  static std::vector<Corner> clipped(const std::vector<Corner>& polygon, const mpz_class& limit, int sign,
                                     Outlines& outlines) {
    std::vector<Corner> kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Corner &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
      const mpz_class overA = sign * a.height - limit, overB = sign * b.height - limit;
      if (overA <= 0) kept.push_back(a);
      if (sgn(overA) * sgn(overB) >= 0) continue;
      const mpz_class divisor = overA - overB;
      const CoverPoint p = outlines.points[a.point], q = outlines.points[b.point];
      const auto between = [&](const mpz_class& from, const mpz_class& to) {
        return mpz_class(from + (to - from) * overA / divisor);
      };
      outlines.points.push_back({between(p.x, q.x), between(p.y, q.y)});
      kept.push_back({static_cast<std::uint32_t>(outlines.points.size() - 1), sign * limit});
    }
    return kept;
  }

  const Positions& positions_;
  double height_;
  mpz_class heightOnGrid_;
  unsigned finer_;  ///< bits that points in the plan have more than positions
  RunContext& context_;
  const Surface* other_ = nullptr;
  TriangleTree tree_;
  std::vector<std::array<mpz_class, 3>> normals_;
};

/// The parts of all triangles that are not known to be covered by `difference`; with their triangles only if
/// `areDrawn`.
std::array<std::vector<UncoveredPart>, 2> measureParts(const ComparedSurfaces& surfaces,
                                                       const SetDifference& difference, double height, bool areDrawn,
                                                       RunContext& context) {
  std::array<std::vector<UncoveredPart>, 2> uncovered;
  CoveredPart part(surfaces, height, context);
  for (std::size_t set = 0; set < 2; ++set) {
    const Surface& surface = surfaces.surfaces[set];
    std::vector<UncoveredPart>& parts = uncovered[set];
    for (std::size_t i = 0; i < surface.triangles.size(); ++i)
      if (difference.covered[set][i] == 0) parts.push_back({static_cast<std::uint32_t>(i), {}, {}});
    if (parts.empty()) continue;
    part.prepare(surfaces.surfaces[1 - set]);
    forRanges(parts.size(), 16, [&](std::size_t first, std::size_t last) {
      std::vector<std::int32_t> stack;
      for (std::size_t i = first; i < last; ++i) {
        context.checkCancelled();
        const SurfaceArea& all = difference.triangleAreas[set][parts[i].triangle];
        const double share =
            part.uncoveredShare(surface.triangles[parts[i].triangle], stack, areDrawn ? &parts[i].triangles : nullptr);
        parts[i].areas = {share * all.surface, share * all.plan};
      }
    });
  }
  return uncovered;
}

}  // namespace

std::array<std::vector<SurfaceArea>, 2> findUncovered(const ComparedSurfaces& surfaces, const SetDifference& difference,
                                                      double height, RunContext& context) {
  std::array<std::vector<SurfaceArea>, 2> uncovered;
  const auto parts = measureParts(surfaces, difference, height, false, context);
  for (std::size_t set = 0; set < 2; ++set) {
    uncovered[set].resize(surfaces.surfaces[set].triangles.size());
    for (const UncoveredPart& part : parts[set]) uncovered[set][part.triangle] = part.areas;
  }
  return uncovered;
}

std::array<std::vector<UncoveredPart>, 2> findUncoveredParts(const ComparedSurfaces& surfaces,
                                                             const SetDifference& difference, double height,
                                                             RunContext& context) {
  auto uncovered = measureParts(surfaces, difference, height, true, context);
  for (std::vector<UncoveredPart>& parts : uncovered)
    std::erase_if(parts, [](const UncoveredPart& p) { return p.triangles.empty(); });
  return uncovered;
}

}  // namespace footfall::detail::comparison
