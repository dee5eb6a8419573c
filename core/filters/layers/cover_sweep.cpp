// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/layers/cover_sweep.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace footfall::detail {
namespace {

constexpr Index kPlacesPerPoll = 1024;

}  // namespace

/// The order of a place and a segment at the sweep line; a place on the segment is neither above nor below it.
struct CoverSweep::IsBelow {
  CoverSweep& sweep;

  bool operator()(const Segment& segment, Index vertex) const {
    return sweep.orientation(segment.left, segment.right, vertex) > 0;
  }
  bool operator()(Index vertex, const Segment& segment) const {
    return sweep.orientation(segment.left, segment.right, vertex) < 0;
  }
};

int CoverSweep::orientation(Index a, Index b, Index c) {
  ++decisions_;
  return geometry_.orientation(a, b, c);
}

bool CoverSweep::coversTwice(const std::vector<Side>& outline, const Poll& poll) {
  status_.clear();
  setUp(outline, poll);
  for (Index place = 0; place < static_cast<Index>(vertexOf_.size()); ++place) {
    if (place % kPlacesPerPoll == 0) poll();
    if (!pass(place)) return true;
  }
  return false;
}

void CoverSweep::setUp(const std::vector<Side>& outline, const Poll& poll) {
  std::vector<Index> ends;  // vertices, from left to right
  for (const Side& side : outline) ends.insert(ends.end(), side.begin(), side.end());
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  const std::vector<Index> numbers = ends;
  const auto compare = [&](Index a, Index b) {
    ++decisions_;
    const int sign = geometry_.compare(a, b, 0);
    return sign != 0 ? sign : geometry_.compare(a, b, 1);
  };
  std::size_t polled = 0;
  std::sort(ends.begin(), ends.end(), [&](Index a, Index b) {
    if (++polled % kPlacesPerPoll == 0) poll();
    return compare(a, b) < 0;
  });
  std::vector<Index> placeOf(ends.size());
  const auto numberOf = [&](Index vertex) {
    return std::lower_bound(numbers.begin(), numbers.end(), vertex) - numbers.begin();
  };
  vertexOf_.clear();
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (i == 0 || compare(ends[i - 1], ends[i]) != 0) vertexOf_.push_back(ends[i]);
    placeOf[numberOf(ends[i])] = static_cast<Index>(vertexOf_.size()) - 1;
  }
  segments_.clear();
  segments_.resize(outline.size());
  firstSegment_.assign(vertexOf_.size() + 1, 0);
  const auto leftPlaceOf = [&](const Side& side) {
    return std::min(placeOf[numberOf(side[0])], placeOf[numberOf(side[1])]);
  };
  for (const Side& side : outline) ++firstSegment_[leftPlaceOf(side) + 1];
  std::partial_sum(firstSegment_.begin(), firstSegment_.end(), firstSegment_.begin());
  std::vector<Index> next(firstSegment_.begin(), firstSegment_.end() - 1);
  for (auto [from, to] : outline) {
    Segment& segment = segments_[next[leftPlaceOf({from, to})]++];
    segment.step = 1;  // the triangle is on the left of its side
    if (placeOf[numberOf(from)] > placeOf[numberOf(to)]) {
      std::swap(from, to);
      segment.step = -1;
    }
    segment.left = from;
    segment.right = to;
    segment.rightPlace = placeOf[numberOf(to)];
  }
}

bool CoverSweep::pass(Index place) {
  auto [first, last] = status_.equal_range(vertexOf_[place], IsBelow{*this});
  leaving_.clear();
  while (first != last) {
    Segment& through = *first;
    first = status_.erase(first);
    if (through.rightPlace > place) leaving_.push_back(&through);
  }
  for (Index s = firstSegment_[place]; s < firstSegment_[place + 1]; ++s) leaving_.push_back(&segments_[s]);
  const auto below = first == status_.begin() ? status_.end() : std::prev(first);
  if (!insertLeaving(vertexOf_[place], first, below == status_.end() ? 0 : below->above)) return false;
  if (leaving_.empty()) return below == status_.end() || first == status_.end() || !crosses(*below, *first);
  return (below == status_.end() || !crosses(*below, *leaving_.front())) &&
         (first == status_.end() || !crosses(*leaving_.back(), *first));
}

bool CoverSweep::insertLeaving(Index vertex, Status::iterator before, int cover) {
  if (leaving_.empty()) return true;
  const auto turn = [&](const Segment* a, const Segment* b) {
    return a->rightPlace == b->rightPlace ? 0 : orientation(vertex, a->right, b->right);
  };
  std::stable_sort(leaving_.begin(), leaving_.end(),
                   [&](const Segment* a, const Segment* b) { return turn(a, b) > 0; });
  for (auto run = leaving_.begin(); run != leaving_.end();) {
    const auto end = std::find_if(run, leaving_.end(), [&](const Segment* s) { return turn(*run, s) != 0; });
    for (auto s = run; s != end; ++s) cover += (*s)->step;
    if (cover > 1) return false;
    for (; run != end; ++run) {
      (*run)->above = cover;
      status_.insert_before(before, **run);
    }
  }
  return true;
}

// The end that comes first lies beyond the other segment, when the lines of both cross before it.
bool CoverSweep::crosses(const Segment& lower, const Segment& upper) {
  if (lower.rightPlace == upper.rightPlace) return false;
  if (lower.rightPlace < upper.rightPlace) return orientation(upper.left, upper.right, lower.right) > 0;
  return orientation(lower.left, lower.right, upper.right) < 0;
}

}  // namespace footfall::detail
