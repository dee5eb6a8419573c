// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/link_difference.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace footfall::detail::comparison {
namespace {

constexpr std::size_t kPolled = 1024;

/// A place on the grid of the positions. A step has x, y, lower height, upper height; a gap has both places, six
/// numbers.
template <std::size_t D>
using Point = std::array<mpz_class, D>;

/// A line in D dimensions: its direction without a common divisor, the first number that is not 0 positive, and its
/// moment, the products p[i] d[j] - p[j] d[i], which are the same for all of its points p.
template <std::size_t D>
struct Line {
  Point<D> direction;
  std::array<mpz_class, D*(D - 1) / 2> moment;
  bool operator<(const Line& other) const {
    if (direction != other.direction) return direction < other.direction;
    return moment < other.moment;
  }
};

/// A place where a step of a mesh begins or ends along a line, by the coordinate that is first in its direction.
struct Event {
  mpz_class at;
  std::size_t mesh;
  int change;  ///< 1 or -1
};

/// All links of a kind, as segments in D dimensions.
template <std::size_t D>
class LinkLines {
 public:
  LinkLines(int unit, StepKind kind) : unit_(unit), kind_(kind) {}

  void add(const NavigationMesh& mesh, std::size_t number, RunContext& context) {
    for (std::size_t i = 0; i < mesh.links.size(); ++i) {
      if (i % kPolled == 0) context.checkCancelled();
      const StepLink& link = mesh.links[i];
      if (link.kind != kind_) continue;
      const bool isFirst = isAlongFirstEdge(mesh, link);
      const auto &from = isFirst ? link.from : link.to, &to = isFirst ? link.to : link.from;
      addSegment(pointOf(mesh, from[0], to[1]), pointOf(mesh, from[1], to[0]), number);
    }
  }

  void subtractInto(LinkDifference& result) {
    std::array<long double, 3> sums{};
    for (auto& [line, events] : lines_) {
      const std::array<mpz_class, 3> lengths = subtractOn(events);
      for (std::size_t part = 0; part < 3; ++part) {
        if (lengths[part] == 0) continue;
        result.hasLength[part] = true;
        sums[part] += planLength(line, lengths[part]);
      }
    }
    for (std::size_t part = 0; part < 3; ++part) result.lengths[part] += static_cast<double>(sums[part]);
  }

 private:
  [[nodiscard]] Point<D> pointOf(const NavigationMesh& mesh, std::uint32_t first, std::uint32_t second) const {
    if constexpr (D == 6) {
      const Vec3 &p = mesh.vertices[first], &q = mesh.vertices[second];
      return {onGrid(p.x, unit_), onGrid(p.y, unit_), onGrid(q.x, unit_),
              onGrid(q.y, unit_), onGrid(p.z, unit_), onGrid(q.z, unit_)};
    } else {
      return stepAt(mesh, first, second);
    }
  }
  /// The step at the place in the plan of the lower vertex: both vertices have the same, unless rounding moved them
  /// apart.
  [[nodiscard]] Point<4> stepAt(const NavigationMesh& mesh, std::uint32_t first, std::uint32_t second) const {
    const bool isRising = mesh.vertices[first].z <= mesh.vertices[second].z;
    const Vec3 &low = mesh.vertices[isRising ? first : second], &high = mesh.vertices[isRising ? second : first];
    return {onGrid(low.x, unit_), onGrid(low.y, unit_), onGrid(low.z, unit_), onGrid(high.z, unit_)};
  }

  void addSegment(const Point<D>& p, const Point<D>& q, std::size_t mesh) {
    Line<D> line;
    mpz_class divisor = 0;
    for (std::size_t k = 0; k < D; ++k) {
      line.direction[k] = q[k] - p[k];
      divisor = gcd(divisor, line.direction[k]);
    }
    if (line.direction[0] == 0 && line.direction[1] == 0) return;  // a point of the plan is no step
    const std::size_t first = leading(line);
    if (line.direction[first] < 0) divisor = -divisor;
    for (mpz_class& number : line.direction) number /= divisor;
    std::size_t next = 0;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = i + 1; j < D; ++j) line.moment[next++] = p[i] * line.direction[j] - p[j] * line.direction[i];
    const bool isRising = p[first] < q[first];
    std::vector<Event>& events = lines_[line];
    events.push_back({p[first], mesh, isRising ? 1 : -1});
    events.push_back({q[first], mesh, isRising ? -1 : 1});
  }

  static std::size_t leading(const Line<D>& line) { return line.direction[0] != 0 ? 0 : 1; }

  /// The lengths that only the first mesh, only the second and both have, along the leading coordinate.
  static std::array<mpz_class, 3> subtractOn(std::vector<Event>& events) {
    std::ranges::sort(events, {}, &Event::at);
    std::array<mpz_class, 3> lengths{};
    std::array<int, 2> open{};
    for (std::size_t i = 0; i < events.size(); ++i) {
      if (i > 0 && open[0] + open[1] > 0) {
        const std::size_t part = open[1] == 0 ? 0 : open[0] == 0 ? 1 : 2;
        lengths[part] += events[i].at - events[i - 1].at;
      }
      open[events[i].mesh] += events[i].change;
    }
    return lengths;
  }

  [[nodiscard]] long double planLength(const Line<D>& line, const mpz_class& alongLeading) const {
    const double x = line.direction[0].get_d(), y = line.direction[1].get_d();
    const long double steepness =
        std::hypot(static_cast<long double>(x), static_cast<long double>(y)) / std::fabs(leading(line) == 0 ? x : y);
    return std::ldexp(alongLeading.get_d(), unit_) * steepness;
  }

  int unit_;
  StepKind kind_;
  std::map<Line<D>, std::vector<Event>> lines_;
};

}  // namespace

bool isAlongFirstEdge(const NavigationMesh& mesh, const StepLink& link) {
  if (link.kind != StepKind::Gap) return true;
  const Vec3 &a = mesh.vertices[link.from[0]], &b = mesh.vertices[link.from[1]];
  return a.x != b.x ? a.x < b.x : a.y < b.y;
}

LinkDifference subtractLinks(const ComparedSurfaces& surfaces, const NavigationMesh& a, const NavigationMesh& b,
                             RunContext& context) {
  LinkDifference result;
  const auto subtract = [&](auto lines) {
    lines.add(a, 0, context);
    lines.add(b, 1, context);
    lines.subtractInto(result);
  };
  subtract(LinkLines<4>(surfaces.positions.unit, StepKind::Step));
  subtract(LinkLines<6>(surfaces.positions.unit, StepKind::Gap));
  return result;
}

}  // namespace footfall::detail::comparison
