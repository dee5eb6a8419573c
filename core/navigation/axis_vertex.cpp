// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/navigation/axis_vertex.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace footfall::detail {
namespace {

/// x a + y b + r c = d for a place (x, y) that is r from the border.
struct AxisEquation {
  double a = 0, b = 0, c = 0, d = 0;
};
using Three = std::array<double, 3>;

Three normalOf(const AxisEquation& e) { return {e.a, e.b, e.c}; }
Three crossed(const Three& a, const Three& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double product(const Three& a, const Three& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

AxisEquation normalized(AxisEquation e) {
  const double length = std::sqrt(e.a * e.a + e.b * e.b + e.c * e.c);
  if (length > 0) e = {e.a / length, e.b / length, e.c / length, e.d / length};
  return e;
}

/// Equations about a place near at hand, so that little is lost in differences.
class AxisSystem {
 public:
  explicit AxisSystem(FieldVector origin) : origin_(origin) {}

  [[nodiscard]] FieldVector at(const FieldFeature& f) const { return f.place - origin_; }
  [[nodiscard]] AxisEquation onEdge(const FieldFeature& f) const {
    return normalized({f.inward.x, f.inward.y, -1, dot(f.inward, at(f))});
  }
  [[nodiscard]] AxisEquation between(const FieldFeature& p, const FieldFeature& q) const {
    const FieldVector a = at(p), b = at(q), way = (b - a) * 2;
    return normalized({way.x, way.y, 0, dot(b, b) - dot(a, a)});
  }
  /// The axis of two features that share a corner.
  [[nodiscard]] static std::optional<FieldVector> sharedAxis(const FieldFeature& a, const FieldFeature& b) {
    if (a.isCorner() && b.isCorner()) return std::nullopt;
    if (a.isCorner()) return b.along;
    if (b.isCorner()) return a.along;
    const FieldVector sum = a.along + b.along, difference = leftOf(b.along - a.along);
    return dot(sum, sum) >= dot(difference, difference) ? sum : difference;
  }
  [[nodiscard]] std::optional<AxisEquation> shared(const AxisFeature& a, const AxisFeature& b) const {
    const auto axis = sharedAxis(*a.feature, *b.feature);
    if (!axis) return std::nullopt;
    FieldVector corner = at(*a.feature);
    if (!a.feature->isCorner() && b.beginFan != a.beginFan && b.endFan != a.beginFan)
      corner = corner + a.feature->along * a.feature->length;
    return normalized({axis->x, axis->y, 0, dot(*axis, corner)});
  }

  int solve(const AxisEquation& e, const AxisEquation& f, const AxisEquation& g,
            std::array<FieldVector, 2>& places) const {
    const Three u = crossed(normalOf(e), normalOf(f)), v = crossed(normalOf(f), normalOf(g)),
                w = crossed(normalOf(g), normalOf(e));
    const double determinant = product(u, normalOf(g));
    if (std::fabs(determinant) < 1e-13) return 0;
    places[0] = FieldVector{(e.d * v[0] + f.d * w[0] + g.d * u[0]) / determinant,
                            (e.d * v[1] + f.d * w[1] + g.d * u[1]) / determinant} +
                origin_;
    return 1;
  }
  /// Two equations, and a corner as far: the origin.
  int solve(const AxisEquation& e, const AxisEquation& f, std::array<FieldVector, 2>& places) const {
    const Three u = crossed(normalOf(e), normalOf(f));
    const double squared = product(u, u);
    if (squared < 1e-26) return 0;
    const Three p = crossed(normalOf(f), u), q = crossed(u, normalOf(e));
    Three start{};
    for (int i = 0; i < 3; ++i) start[i] = (e.d * p[i] + f.d * q[i]) / squared;
    const double a = u[0] * u[0] + u[1] * u[1] - u[2] * u[2];
    const double b = start[0] * u[0] + start[1] * u[1] - start[2] * u[2];
    const double c = start[0] * start[0] + start[1] * start[1] - start[2] * start[2];
    const double root = std::sqrt(std::max(0.0, b * b - a * c)), sum = b > 0 ? -(b + root) : -(b - root);
    std::array<double, 2> steps{};
    int count = 0;
    if (std::fabs(a) > 1e-14 * squared) steps[count++] = sum / a;
    if (sum != 0) steps[count++] = c / sum;
    for (int i = 0; i < count; ++i)
      places[i] = FieldVector{start[0] + steps[i] * u[0], start[1] + steps[i] * u[1]} + origin_;
    return count;
  }

 private:
  FieldVector origin_;
};

bool shareFan(const AxisFeature& a, const AxisFeature& b) {
  return a.beginFan == b.beginFan || a.beginFan == b.endFan || a.endFan == b.beginFan || a.endFan == b.endFan;
}

int ofEdges(const std::array<AxisFeature, 3>& f, std::array<FieldVector, 2>& places) {
  const AxisSystem system(f[0].feature->place);
  std::vector<AxisEquation> equations;
  for (int i = 0; i < 3 && equations.size() < 2; ++i)
    if (shareFan(f[i], f[(i + 1) % 3]))
      if (const auto e = system.shared(f[i], f[(i + 1) % 3])) equations.push_back(*e);
  // Edges that share a corner are given by it and by one of them; the third one is the one that shares least.
  if (equations.size() == 2) return system.solve(equations[0], equations[1], system.onEdge(*f[1].feature), places);
  if (equations.empty())
    return system.solve(system.onEdge(*f[0].feature), system.onEdge(*f[1].feature), system.onEdge(*f[2].feature),
                        places);
  for (int i = 0; i < 3; ++i)
    if (shareFan(f[i], f[(i + 1) % 3]))
      return system.solve(equations[0], system.onEdge(*f[i].feature), system.onEdge(*f[(i + 2) % 3].feature), places);
  return 0;
}

/// `p` is a corner.
int ofTwoEdges(const AxisFeature& a, const AxisFeature& b, const AxisFeature& p, std::array<FieldVector, 2>& places) {
  const AxisSystem system(p.feature->place);
  const bool isOfA = shareFan(a, p), isOfB = shareFan(b, p);
  if (isOfA && isOfB) return 0;
  const AxisEquation onA = system.onEdge(*a.feature), onB = system.onEdge(*b.feature);
  if (isOfA || isOfB) {
    const auto shared = system.shared(isOfA ? a : b, p);
    return shared ? system.solve(*shared, onA, onB, places) : 0;
  }
  if (shareFan(a, b))
    if (const auto shared = system.shared(a, b)) return system.solve(*shared, onA, places);
  return system.solve(onA, onB, places);
}

/// `p` and `q` are corners.
int ofOneEdge(const AxisFeature& a, const AxisFeature& p, const AxisFeature& q, std::array<FieldVector, 2>& places) {
  const AxisSystem system(p.feature->place);
  const AxisEquation on = system.onEdge(*a.feature), between = system.between(*p.feature, *q.feature);
  const bool isOfP = shareFan(a, p);
  if (isOfP || shareFan(a, q)) {
    const auto shared = system.shared(a, isOfP ? p : q);
    return shared ? system.solve(*shared, on, between, places) : 0;
  }
  return system.solve(on, between, places);
}

}  // namespace

AxisFeature axisFeature(const ClearanceField& field, std::uint32_t feature) {
  const FieldFeature& f = field.features()[feature];
  const auto& fans = field.surface().topology.fans[f.face];
  return {&f, fans[f.side], f.isCorner() ? fans[f.side] : fans[(f.side + 1) % 3]};
}

int equallyFar(const std::array<AxisFeature, 3>& features, std::array<FieldVector, 2>& places) {
  std::array<AxisFeature, 3> f = features;
  const auto edges =
      std::stable_partition(f.begin(), f.end(), [](const AxisFeature& x) { return !x.feature->isCorner(); });
  switch (edges - f.begin()) {
    case 3:
      return ofEdges(f, places);
    case 2:
      return ofTwoEdges(f[0], f[1], f[2], places);
    case 1:
      return ofOneEdge(f[0], f[1], f[2], places);
    default: {
      const AxisSystem system(f[0].feature->place);
      return system.solve(system.between(*f[0].feature, *f[1].feature), system.between(*f[0].feature, *f[2].feature),
                          places);
    }
  }
}

}  // namespace footfall::detail
