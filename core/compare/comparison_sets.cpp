// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/comparison_sets.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/parallel.hpp"
#include "core/base/parallel_sort.hpp"
#include "core/base/sorted_list.hpp"

namespace footfall::detail::comparison {
namespace {

constexpr std::size_t kRange = 1024;
constexpr unsigned kDigits = 160;  // bits; far more than a double has

double toDouble(const mpf_class& number, int exponent) {
  signed long own = 0;
  const double digits = mpf_get_d_2exp(&own, number.get_mpf_t());
  return std::ldexp(digits, static_cast<int>(own) + exponent);
}

/// A plane a x + b y + c z = d in whole numbers without a common divisor of a, b and c, the first that is not 0 of them
/// positive; and the triangle that lies in it.
struct Plane {
  std::array<mpz_class, 4> numbers;
  std::uint32_t set, triangle;
};

bool samePlane(const Plane& a, const Plane& b) { return a.numbers == b.numbers; }

SurfaceArea areasOf(const std::array<mpz_class, 3>& normal, int unit) {
  const mpz_class square = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
  return {toDouble(sqrt(mpf_class(square, kDigits)), 2 * unit - 1),
          toDouble(mpf_class(abs(normal[2]), kDigits), 2 * unit - 1)};
}

Plane planeOf(const std::array<mpz_class, 3>& normal, const std::array<mpz_class, 3>& point) {
  mpz_class divisor = gcd(gcd(normal[0], normal[1]), normal[2]);
  const std::size_t first = normal[0] != 0 ? 0 : normal[1] != 0 ? 1 : 2;
  if (normal[first] < 0) divisor = -divisor;
  Plane plane{};
  for (std::size_t k = 0; k < 3; ++k) {
    plane.numbers[k] = normal[k] / divisor;
    plane.numbers[3] += plane.numbers[k] * point[k];
  }
  return plane;
}

class SetSubtraction {
 public:
  SetSubtraction(const ComparedSurfaces& surfaces, RunContext& context, DifferenceBorders* borders)
      : surfaces_(surfaces), positions_(surfaces.positions), context_(context), borders_(borders) {}

  SetDifference run() {
    findPlanes();
    groupPlanes();
    std::vector<Group> groups = groups_;
    std::vector<Covered> results(groups.size());
    // Largest first, so that no thread is left with them.
    std::vector<std::uint32_t> order(groups.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint32_t>(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return groups[a].size() > groups[b].size(); });
    forRanges(groups.size(), 32, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        context_.checkCancelled();
        results[order[i]] = lookAt(groups[order[i]]);
      }
    });
    addUp(results);
    if (borders_ != nullptr) takeBorders(groups, results);
    return std::move(result_);
  }

 private:
  struct Group {
    std::size_t first, last;  ///< range in planes_
    [[nodiscard]] std::size_t size() const { return last - first; }
  };
  struct Covered {
    std::array<bool, 3> hasArea{};
    std::array<SurfaceArea, 3> areas;
    std::optional<DifferentPlane> different;
  };

  [[nodiscard]] const Triangle& triangleOf(const Plane& plane) const {
    return surfaces_.surfaces[plane.set].triangles[plane.triangle];
  }

  void findPlanes() {
    const std::size_t split = surfaces_.surfaces[0].triangles.size();
    for (std::size_t set = 0; set < 2; ++set) {
      result_.triangleAreas[set].resize(surfaces_.surfaces[set].triangles.size());
      result_.covered[set].assign(surfaces_.surfaces[set].triangles.size(), 0);
    }
    planes_.resize(split + surfaces_.surfaces[1].triangles.size());
    forRanges(planes_.size(), kRange, [&](std::size_t first, std::size_t last) {
      context_.checkCancelled();
      for (std::size_t i = first; i < last; ++i) {
        const std::size_t set = i < split ? 0 : 1;
        const std::size_t number = i - set * split;
        const Triangle& triangle = surfaces_.surfaces[set].triangles[number];
        const auto normal = exactNormal(positions_, triangle);
        result_.triangleAreas[set][number] = areasOf(normal, positions_.unit);
        planes_[i] = planeOf(normal, positions_.integers[triangle[0]]);
        planes_[i].set = static_cast<std::uint32_t>(set);
        planes_[i].triangle = static_cast<std::uint32_t>(number);
      }
    });
  }

  void groupPlanes() {
    context_.checkCancelled();
    parallelSort(planes_.begin(), planes_.end(), [this](const Plane& a, const Plane& b) {
      context_.checkCancelled();
      if (!samePlane(a, b)) return a.numbers < b.numbers;
      return a.set != b.set ? a.set < b.set : a.triangle < b.triangle;
    });
    for (std::size_t i = 0, next = 0; i < planes_.size(); i = next) {
      for (next = i + 1; next < planes_.size() && samePlane(planes_[next], planes_[i]);) ++next;
      groups_.push_back({i, next});
    }
  }

  [[nodiscard]] Covered lookAt(const Group& group) {
    if (group.size() == 1) {
      const Plane& plane = planes_[group.first];
      Covered covered;
      covered.hasArea[plane.set] = true;
      covered.areas[plane.set] = result_.triangleAreas[plane.set][plane.triangle];
      return covered;
    }
    const Covered covered = arrange(group);
    markCovered(group, covered);
    return covered;
  }

  /// Arranges in the plan, or seen along another axis when the plane is vertical.
  [[nodiscard]] Covered arrange(const Group& group) const {
    const auto& normal = planes_[group.first].numbers;
    const std::size_t axis = normal[2] != 0 ? 2 : normal[0] != 0 ? 0 : 1;
    const std::size_t x = (axis + 1) % 3, y = (axis + 2) % 3;
    std::vector<std::uint32_t> used;
    for (std::size_t i = group.first; i < group.last; ++i)
      used.insert(used.end(), triangleOf(planes_[i]).begin(), triangleOf(planes_[i]).end());
    sortOnce(used);
    std::vector<CoverPoint> points;
    points.reserve(used.size());
    for (const std::uint32_t v : used) points.push_back({positions_.integers[v][x], positions_.integers[v][y]});
    std::vector<CoverEdge> edges;
    edges.reserve(3 * group.size());
    for (std::size_t i = group.first; i < group.last; ++i) {
      const Plane& plane = planes_[i];
      std::array<std::uint32_t, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto found = std::lower_bound(used.begin(), used.end(), triangleOf(plane)[k]);
        corners[k] = static_cast<std::uint32_t>(found - used.begin());
      }
      const CoverPoint &a = points[corners[0]], &b = points[corners[1]], &c = points[corners[2]];
      if ((b.x - a.x) * (c.y - a.y) < (b.y - a.y) * (c.x - a.x)) std::swap(corners[1], corners[2]);
      for (std::size_t k = 0; k < 3; ++k) edges.push_back({corners[k], corners[(k + 1) % 3], plane.set});
    }
    DifferentPlane different;
    const CoverResult result = coverAreas(points, edges, context_, borders_ != nullptr ? &different.borders : nullptr);
    Covered covered = inSpace(result, normal, axis);
    if (different.borders.empty()) return covered;
    for (std::size_t k = 0; k < 4; ++k) different.numbers[k] = normal[k].get_d();
    different.axis = axis;
    different.positions = std::move(used);
    covered.different = std::move(different);
    return covered;
  }

  [[nodiscard]] Covered inSpace(const CoverResult& result, const std::array<mpz_class, 4>& normal,
                                std::size_t axis) const {
    const mpz_class square = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
    const mpf_class stretch = sqrt(mpf_class(square, kDigits)) / mpf_class(abs(normal[axis]), kDigits);
    Covered covered;
    covered.hasArea = result.hasArea;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!result.hasArea[k]) continue;
      const int exponent = 2 * positions_.unit - 1;
      covered.areas[k].surface = toDouble(mpf_class(result.twiceArea[k] * stretch, kDigits), exponent);
      if (axis == 2) covered.areas[k].plan = toDouble(result.twiceArea[k], exponent);
    }
    return covered;
  }

  /// Triangles of a set that the other leaves nothing of, and those that are in both.
  void markCovered(const Group& group, const Covered& covered) {
    std::vector<std::array<std::uint32_t, 5>> corners;  // sorted, then set and triangle
    for (std::size_t i = group.first; i < group.last; ++i) {
      const Plane& plane = planes_[i];
      if (!covered.hasArea[plane.set]) result_.covered[plane.set][plane.triangle] = 1;
      Triangle t = triangleOf(plane);
      std::sort(t.begin(), t.end());
      corners.push_back({t[0], t[1], t[2], plane.set, plane.triangle});
    }
    if (!covered.hasArea[kOnlyFirst] && !covered.hasArea[kOnlySecond]) return;
    std::sort(corners.begin(), corners.end());
    for (std::size_t i = 0, next = 0; i < corners.size(); i = next) {
      const auto same = [&](std::size_t k) { return std::equal(&corners[k][0], &corners[k][3], &corners[i][0]); };
      for (next = i + 1; next < corners.size() && same(next);) ++next;
      if (corners[i][3] == corners[next - 1][3]) continue;
      for (std::size_t k = i; k < next; ++k) result_.covered[corners[k][3]][corners[k][4]] = 1;
    }
  }

  void addUp(const std::vector<Covered>& results) {
    for (std::size_t k = 0; k < 3; ++k) {
      long double surface = 0, plan = 0;
      for (const Covered& covered : results) {
        result_.hasArea[k] = result_.hasArea[k] || covered.hasArea[k];
        surface += covered.areas[k].surface;
        plan += covered.areas[k].plan;
      }
      result_.areas[k] = {static_cast<double>(surface), static_cast<double>(plan)};
    }
  }

  void takeBorders(const std::vector<Group>& groups, std::vector<Covered>& results) {
    for (std::size_t i = 0; i < groups.size(); ++i) {
      if (results[i].different) borders_->planes.push_back(std::move(*results[i].different));
      if (groups[i].size() > 1) continue;
      const Plane& plane = planes_[groups[i].first];
      borders_->triangles[plane.set].push_back(plane.triangle);
    }
    for (std::vector<std::uint32_t>& triangles : borders_->triangles) std::sort(triangles.begin(), triangles.end());
  }

  const ComparedSurfaces& surfaces_;
  const Positions& positions_;
  RunContext& context_;
  DifferenceBorders* borders_;
  SetDifference result_;
  std::vector<Plane> planes_;
  std::vector<Group> groups_;
};

}  // namespace

SetDifference subtractSets(const ComparedSurfaces& surfaces, RunContext& context, DifferenceBorders* borders) {
  return SetSubtraction(surfaces, context, borders).run();
}

}  // namespace footfall::detail::comparison
