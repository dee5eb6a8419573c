// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/radius/margin_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace footfall::detail {
namespace {

constexpr double kHair = 0x1p-50;  // share of an edge: more than the roundings of a quotient of a sum, and of one more
                                   // sum

/// The distance of p to the left of the line from a to b, times the length of that, to within `error`.
struct Offset {
  double value = 0, error = 0;
};

// Differences, products and the last difference lose at most 4 u (|l| + |r|) together, u = 2^-53, and what is made of
// value and error by one more operation another one.
Offset offsetOf(const PlanVector& a, const PlanVector& b, const PlanVector& p) {
  const double left = (b.x - a.x) * (p.y - a.y), right = (b.y - a.y) * (p.x - a.x);
  return {left - right, (std::fabs(left) + std::fabs(right)) * 0x1p-50 + std::numeric_limits<double>::min()};
}

// The part where a number that goes from `first` to `last` is not negative, a hair less or more.
template <class Stretch>
void keepPositive(Stretch& stretch, double first, double last, double hair) {
  if (first >= 0 && last >= 0) return;
  if (first < 0 && last < 0) {
    stretch.end = stretch.begin;
    return;
  }
  const double there = first / (first - last);
  if (first < 0)
    stretch.begin = std::max(stretch.begin, there + hair);
  else
    stretch.end = std::min(stretch.end, there - hair);
}

}  // namespace

MarginChoice::Bounds::Bounds(Outline places) : low(places.front()), high(places.front()) {
  for (const PlanVector& p : places.subspan(1)) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
}

MarginChoice::Stretch MarginChoice::part(Outline outline, const PlanVector& from, const PlanVector& to, int doubt) {
  Stretch stretch;
  const PlanVector* a = &outline.back();
  for (const PlanVector& b : outline) {
    const Offset first = offsetOf(*a, b, from), last = offsetOf(*a, b, to);
    keepPositive(stretch, first.value + doubt * first.error, last.value + doubt * last.error, -doubt * kHair);
    if (stretch.isEmpty()) break;
    a = &b;
  }
  return stretch;
}

// False where the margin and the face are apart for certain.
bool MarginChoice::add(Index margin, const Bounds& face) {
  const Bounds bounds(margins_[margin].corners);
  if (bounds.isApartFrom(face)) return false;
  Candidate& candidate = candidates_.emplace_back(Candidate{margin, margins_[margin].corners, bounds, true, {}, {}});
  const PlanVector* a = &candidate.outline.back();
  for (const PlanVector& b : candidate.outline) {
    std::array<Offset, 3> at;
    bool isApart = true;
    for (int k = 0; k < 3; ++k) {
      at[k] = offsetOf(*a, b, face_[k]);
      isApart = isApart && at[k].value + at[k].error < 0;
    }
    if (isApart) {
      candidates_.pop_back();
      return false;
    }
    for (int k = 0; k < 3; ++k) {
      const Offset &first = at[k], &last = at[k == 2 ? 0 : k + 1];
      keepPositive(candidate.onEdges[k], first.value - first.error, last.value - last.error, kHair);
      keepPositive(candidate.maybeOnEdges[k], first.value + first.error, last.value + last.error, -kHair);
    }
    a = &b;
  }
  for (int k = 0; k < 3; ++k) {
    const PlanVector &begin = face_[k], &end = face_[k == 2 ? 0 : k + 1];
    if (!std::all_of(candidate.outline.begin(), candidate.outline.end(), [&](const PlanVector& p) {
          const Offset offset = offsetOf(begin, end, p);
          return offset.value + offset.error < 0;
        }))
      continue;
    candidates_.pop_back();
    return false;
  }
  return true;
}

namespace {

// True when stretches of one edge cover one of it.
template <class Stretch>
bool cover(const std::vector<Stretch>& stretches, const Stretch& whole) {
  double covered = whole.begin;
  for (;;) {
    double furthest = covered;
    for (const Stretch& stretch : stretches)
      if (stretch.begin <= covered) furthest = std::max(furthest, stretch.end);
    if (furthest >= whole.end) return true;
    if (furthest <= covered) return false;
    covered = furthest;
  }
}

}  // namespace

bool MarginChoice::isFaceEdgeCovered(int k, const Stretch& stretch, const Candidate* except) const {
  stretches_.clear();
  for (const Candidate& candidate : candidates_)
    if (candidate.isNeeded && &candidate != except && !candidate.onEdges[k].isEmpty())
      stretches_.push_back(candidate.onEdges[k]);
  return cover(stretches_, stretch);
}

void MarginChoice::addEdges(const Candidate& candidate) {
  constexpr double kMore = 0x1p-40;  // share of an edge: far more than the roundings of stretches and of their ends
  const PlanVector* a = &candidate.outline.back();
  for (const PlanVector& b : candidate.outline) {
    const PlanVector from = *std::exchange(a, &b), along = b - from;
    const Stretch inFace = maybeInsideOf(face_, from, b);
    if (inFace.isEmpty()) continue;
    Bounds bounds(std::array{from + inFace.begin * along, from + inFace.end * along});
    const double more = kMore * (std::fabs(along.x) + std::fabs(along.y)) + MarginSurface::kUnit;
    bounds.low = bounds.low - PlanVector{more, more};
    bounds.high = bounds.high + PlanVector{more, more};
    edges_.push_back({&candidate, from, b, inFace, bounds});
  }
}

bool MarginChoice::isEdgeCovered(const Edge& edge, const Stretch& stretch, const Candidate* except) const {
  stretches_.clear();
  for (const Candidate& candidate : candidates_) {
    if (!candidate.isNeeded || &candidate == except || &candidate == edge.candidate ||
        candidate.bounds.isApartFrom(edge.bounds))
      continue;
    const Stretch inside = insideOf(candidate.outline, edge.from, edge.to);
    if (inside.begin <= stretch.begin && inside.end >= stretch.end) return true;
    if (!inside.isEmpty()) stretches_.push_back(inside);
  }
  return cover(stretches_, stretch);
}

bool MarginChoice::isCovered(const Candidate* except) const {
  for (int k = 0; k < 3; ++k) {
    const Stretch stretch = except != nullptr ? except->maybeOnEdges[k] : Stretch{};
    if (!stretch.isEmpty() && !isFaceEdgeCovered(k, stretch, except)) return false;
  }
  const auto isOwnCovered = [&](const Edge& edge) {
    return edge.candidate != except || isEdgeCovered(edge, edge.inFace, except);
  };
  if (except != nullptr && !std::all_of(edges_.begin(), edges_.end(), isOwnCovered)) return false;
  return std::all_of(edges_.begin(), edges_.end(), [&](const Edge& edge) {
    if (!edge.candidate->isNeeded || edge.candidate == except) return true;
    if (except == nullptr) return isEdgeCovered(edge, edge.inFace, nullptr);
    if (edge.bounds.isApartFrom(except->bounds)) return true;
    const Stretch within = maybeInsideOf(except->outline, edge.from, edge.to);
    const Stretch stretch{std::max(edge.inFace.begin, within.begin), std::min(edge.inFace.end, within.end)};
    return stretch.isEmpty() || isEdgeCovered(edge, stretch, except);
  });
}

MarginChoice::Result MarginChoice::chooseOn(const std::array<PlanVector, 3>& corners, std::span<const Index> numbers) {
  face_ = corners;
  candidates_.clear();
  needed_.clear();
  const Bounds face(face_);
  for (const Index number : numbers)
    if (add(number, face) && holdsFace(candidates_.back())) return {true, {}};
  edges_.clear();
  for (const Candidate& candidate : candidates_) addEdges(candidate);
  if (isCovered(nullptr)) return {true, {}};
  if (candidates_.size() > 1)
    for (Candidate& candidate : candidates_)
      if (isCovered(&candidate)) candidate.isNeeded = false;
  for (const Candidate& candidate : candidates_)
    if (candidate.isNeeded) needed_.push_back(candidate.margin);
  return {false, needed_};
}

}  // namespace footfall::detail
