// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/field_spread.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "core/base/parallel.hpp"
#include "core/exact/source_predicates.hpp"

namespace footfall::detail {
namespace {

constexpr double kHalfPi = std::numbers::pi / 2;
/// Angles are off by less. What is taken in too much is harmless: each ray from a corner is a walk.
constexpr double kAngleError = 1e-7;
constexpr std::size_t kRange = 256;

/// Cuts [lo, hi] to where a function that is linear along an edge, with these values at its ends, is at most `most`.
void cutAtMost(double atBegin, double atEnd, double length, double most, double& lo, double& hi) {
  const double a = atBegin - most, b = atEnd - most;
  if (a <= 0 && b <= 0) return;
  if (a > 0 && b > 0) {
    hi = lo - 1;
    return;
  }
  const double root = length * (a / (a - b));
  if (a > 0)
    lo = std::max(lo, root);
  else
    hi = std::min(hi, root);
}

double turnOf(FieldVector from, FieldVector to) { return std::atan2(cross(from, to), dot(from, to)); }

}  // namespace

FieldSpread::FieldSpread(ClearanceField& field, const FieldOptions& options, Poll poll)
    : field_(field),
      surface_(field.surface()),
      poll_(poll),
      margin_(field.margin()),
      tolerance_(field.tolerance()),
      bound_(options.bound + field.margin()) {}

void FieldSpread::findFeatures() {
  const auto& edges = surface_.edges;
  field_.edgeFeatures_.assign(edges.size(), FieldEdge::kNone);
  field_.fanFeatures_.assign(surface_.topology.fanVertices.size(), FieldEdge::kNone);
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    const FieldEdge& edge = edges[e];
    if (!edge.isBorder()) continue;
    field_.edgeFeatures_[e] = static_cast<std::uint32_t>(field_.features_.size());
    field_.features_.push_back({edge.begin, edge.along, leftOf(edge.along), edge.length, edge.faces[0], edge.sides[0]});
  }
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    if (e % 4096 == 0) poll_();
    if (edges[e].isBorder()) addCorner(e);
  }
}

void FieldSpread::addCorner(std::uint32_t edge) {
  const FieldEdge& first = surface_.edges[edge];
  const std::vector<FieldCorner> fan = fanFrom(surface_, first.faces[0], first.sides[0]);
  const FieldCorner end = fan.back();
  const FieldVector p = surface_.corner(first.faces[0], first.sides[0]);
  double angle = 0;
  for (const FieldCorner& c : fan)
    angle += turnOf(surface_.corner(c.face, c.corner + 1) - p, surface_.corner(c.face, c.corner + 2) - p);
  if (angle < 2 * kHalfPi - kAngleError) return;
  const FieldVector before = surface_.corner(end.face, end.corner + 2);
  const FieldVector behind = surface_.corner(first.faces[0], first.sides[0] + 1);
  if (angle < 2 * kHalfPi + kAngleError && facing({before.x, before.y, 0}, {p.x, p.y, 0}, {behind.x, behind.y, 0}) >= 0)
    return;
  Cone cone;
  cone.from = kHalfPi - kAngleError;
  cone.to = angle - kHalfPi + kAngleError;
  cone.edge = edge;
  cone.feature = static_cast<std::uint32_t>(field_.features_.size());
  field_.fanFeatures_[surface_.topology.fans[first.faces[0]][first.sides[0]]] = cone.feature;
  field_.features_.push_back({p, {}, {}, -1, first.faces[0], first.sides[0]});
  cones_.push_back(cone);
}

void FieldSpread::arrive(std::uint32_t half, std::uint32_t feature, bool spreads, double lo, double hi,
                         Arrivals& out) const {
  if (lo > hi) return;
  const FieldEdge& edge = surface_.edges[half >> 1];
  FieldWindow w = windowOf(field_.features_[feature], feature, edge);
  if (bound_ < std::numeric_limits<double>::infinity()) {
    if (w.isCorner) {
      const double rest = bound_ * bound_ - w.slope;
      if (rest < 0) return;
      lo = std::max(lo, w.offset - std::sqrt(rest));
      hi = std::min(hi, w.offset + std::sqrt(rest));
    } else {
      cutAtMost(w.distance(0), w.distance(edge.length), edge.length, bound_, lo, hi);
    }
    if (lo > hi) return;
  }
  // Rays that pass the end of their own feature on the border, and no other place: others go there as well.
  if (hi - lo <= 4 * tolerance_ && edge.length > margin_ && w.distance(lo) <= 4 * tolerance_) return;
  w.lo = lo;
  w.hi = hi;
  if (spreads) w.into = (half & 1) != 0 ? 0 : 1;
  out.push_back({half >> 1, 0, w});
}

void FieldSpread::follow(std::uint32_t face, int side, FieldVector left, FieldVector right, std::uint32_t feature,
                         Arrivals& out) const {
  const FieldFeature& f = field_.features_[feature];
  const FieldVector toLeft = f.isCorner() ? left - f.place : f.inward;
  const FieldVector toRight = f.isCorner() ? right - f.place : f.inward;
  const double leftLength = lengthOf(toLeft), rightLength = lengthOf(toRight);
  for (int k = 1; k <= 2; ++k) {
    const std::uint32_t half = surface_.halves[face][(side + k) % 3];
    const FieldEdge& edge = surface_.edges[half >> 1];
    if (edge.isBorder()) continue;
    FieldVector begin = surface_.corner(face, side + k), end = surface_.corner(face, side + k + 1);
    if ((half & 1) != 0) std::swap(begin, end);
    double lo = 0, hi = edge.length;
    if (leftLength > tolerance_)
      cutAtMost(cross(toLeft, begin - left), cross(toLeft, end - left), edge.length, tolerance_ * leftLength, lo, hi);
    if (rightLength > tolerance_)
      cutAtMost(cross(begin - right, toRight), cross(end - right, toRight), edge.length, tolerance_ * rightLength, lo,
                hi);
    if (!f.isCorner()) {
      const double a = dot(begin - f.place, f.along), b = dot(end - f.place, f.along);
      cutAtMost(-a, -b, edge.length, tolerance_, lo, hi);
      cutAtMost(a, b, edge.length, f.length + tolerance_, lo, hi);
    }
    arrive(half, feature, true, lo, hi, out);
  }
}

void FieldSpread::followWindow(std::uint32_t e, const FieldWindow& window, Arrivals& out) const {
  const FieldEdge& edge = surface_.edges[e];
  const FieldFeature& f = field_.features_[window.feature];
  const bool isFirst = window.into == 0;
  const FieldVector inward = leftOf(edge.along) * (isFirst ? 1 : -1);
  const bool enters =
      f.isCorner() ? dot(f.place - edge.begin, inward) <= 4 * tolerance_ : dot(f.inward, inward) >= -4 * 0x1p-46;
  if (!enters) return;
  const FieldVector lo = edge.at(window.lo), hi = edge.at(window.hi);
  follow(edge.faces[window.into], edge.sides[window.into], isFirst ? lo : hi, isFirst ? hi : lo, window.feature, out);
}

void FieldSpread::beginCone(const Cone& cone, Arrivals& out) const {
  const FieldEdge& first = surface_.edges[cone.edge];
  const std::vector<FieldCorner> fan = fanFrom(surface_, first.faces[0], first.sides[0]);
  const FieldVector p = field_.features_[cone.feature].place;
  const FieldVector last = surface_.corner(fan.back().face, fan.back().corner + 2) - p;
  const FieldVector along = lengthOf(last) > 0 ? last * (1 / lengthOf(last)) : FieldVector{};
  double begin = 0;
  for (const FieldCorner& c : fan) {
    const FieldVector right = surface_.corner(c.face, c.corner + 1), left = surface_.corner(c.face, c.corner + 2);
    const double end = begin + turnOf(right - p, left - p);
    if (end >= cone.from && begin <= cone.to) {
      const std::uint32_t half = surface_.halves[c.face][(c.corner + 1) % 3];
      const FieldEdge& edge = surface_.edges[half >> 1];
      double lo = 0, hi = edge.length;
      const FieldVector a = (half & 1) != 0 ? left : right, b = (half & 1) != 0 ? right : left;
      if (begin < kHalfPi) cutAtMost(dot(a - p, first.along), dot(b - p, first.along), edge.length, tolerance_, lo, hi);
      if (end > cone.to - kAngleError) cutAtMost(dot(a - p, along), dot(b - p, along), edge.length, tolerance_, lo, hi);
      if (!edge.isBorder()) arrive(half, cone.feature, true, lo, hi, out);
    }
    const std::uint32_t spoke = surface_.halves[c.face][c.corner];
    if (begin > 0 && begin >= cone.from && begin <= cone.to)
      arrive(spoke, cone.feature, false, 0, surface_.edges[spoke >> 1].length, out);
    begin = end;
  }
}

void FieldSpread::addTo(Arrivals& all, const Arrivals& more) {
  const std::scoped_lock lock(mutex_);
  all.insert(all.end(), more.begin(), more.end());
}

void FieldSpread::beginRays() {
  const std::size_t edgeFeatures = field_.features_.size() - cones_.size();
  forRanges(field_.features_.size(), kRange, [this, edgeFeatures](std::size_t begin, std::size_t end) {
    poll_();
    Arrivals out;
    for (std::size_t i = begin; i < end; ++i) {
      const FieldFeature& f = field_.features_[i];
      if (i >= edgeFeatures)
        beginCone(cones_[i - edgeFeatures], out);
      else
        follow(f.face, f.side, f.place, surface_.corner(f.face, f.side + 1), static_cast<std::uint32_t>(i), out);
    }
    addTo(arrivals_, out);
  });
}

void FieldSpread::takeArrivals() {
  reached_.clear();
  for (std::uint32_t i = 0; i < arrivals_.size(); ++i) {
    std::uint32_t& first = firstArrival_[arrivals_[i].edge];
    if (first == FieldEdge::kNone) reached_.push_back(arrivals_[i].edge);
    arrivals_[i].nextOfEdge = first;
    first = i;
  }
  forRanges(reached_.size(), kRange, [this](std::size_t begin, std::size_t end) {
    poll_();
    Arrivals mine;
    for (std::size_t k = begin; k < end; ++k) {
      const std::uint32_t e = reached_[k];
      mine.clear();
      for (std::uint32_t i = firstArrival_[e]; i != FieldEdge::kNone; i = arrivals_[i].nextOfEdge)
        mine.push_back(arrivals_[i]);
      firstArrival_[e] = FieldEdge::kNone;
      std::sort(mine.begin(), mine.end(), [](const FieldArrival& a, const FieldArrival& b) {
        return std::tie(a.window.feature, a.window.into, a.window.lo, a.window.hi) <
               std::tie(b.window.feature, b.window.into, b.window.lo, b.window.hi);
      });
      bool isFresh = false;
      windows_[e].reserve(4);
      for (const FieldArrival& a : mine) isFresh |= addWindow(windows_[e], a.window, margin_);
      if (!isFresh) reached_[k] = FieldEdge::kNone;
    }
  });
  arrivals_.clear();
}

void FieldSpread::followFresh() {
  forRanges(reached_.size(), kRange, [this](std::size_t begin, std::size_t end) {
    poll_();
    Arrivals out;
    for (std::size_t k = begin; k < end; ++k) {
      if (reached_[k] == FieldEdge::kNone) continue;
      for (FieldWindow& window : windows_[reached_[k]]) {
        if (!window.isFresh) continue;
        window.isFresh = false;
        followWindow(reached_[k], window, out);
      }
    }
    addTo(arrivals_, out);
  });
}

void FieldSpread::finish() {
  forRanges(windows_.size(), kRange, [this](std::size_t begin, std::size_t end) {
    poll_();
    for (std::size_t e = begin; e < end; ++e) windows_[e] = nearestWindows(windows_[e], margin_ / 2);
  });
  field_.starts_.reserve(windows_.size() + 1);
  field_.starts_.push_back(0);
  for (const auto& windows : windows_) {
    field_.windows_.insert(field_.windows_.end(), windows.begin(), windows.end());
    field_.starts_.push_back(field_.windows_.size());
  }
}

void FieldSpread::run() {
  findFeatures();
  windows_.resize(surface_.edges.size());
  firstArrival_.assign(surface_.edges.size(), FieldEdge::kNone);
  beginRays();
  while (!arrivals_.empty()) {
    takeArrivals();
    followFresh();
  }
  finish();
}

}  // namespace footfall::detail
