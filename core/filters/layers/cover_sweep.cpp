// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/layers/cover_sweep.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace footfall::detail {
namespace {

constexpr std::size_t kPlacesPerPoll = 1024;

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

bool CoverSweep::coversTwice(std::span<const Side> outline, const Poll& poll) {
  status_.clear();
  setUp(outline);
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (i % kPlacesPerPoll == 0) poll();
    if (!pass(places_[i])) return true;
  }
  return false;
}

void CoverSweep::setUp(std::span<const Side> outline) {
  segments_.clear();
  segments_.resize(outline.size());
  next_ = 0;
  places_.clear();
  std::vector<Index> rights;
  rights.reserve(outline.size());
  for (std::size_t i = 0; i < outline.size(); ++i) {
    Segment& segment = segments_[i];
    segment.left = outline[i][0];
    segment.right = outline[i][1];
    segment.step = 1;  // the triangle is on the left of its side
    if (order_.placeOf[segment.left] > order_.placeOf[segment.right]) {
      std::swap(segment.left, segment.right);
      segment.step = -1;
    }
    segment.leftPlace = order_.placeOf[segment.left];
    segment.rightPlace = order_.placeOf[segment.right];
    rights.push_back(segment.rightPlace);
  }
  std::sort(rights.begin(), rights.end());
  places_.reserve(outline.size() + 1);
  const auto add = [&](Index place) {
    if (places_.empty() || places_.back() != place) places_.push_back(place);
  };
  auto right = rights.begin();
  for (const Segment& segment : segments_) {
    for (; *right < segment.leftPlace; ++right) add(*right);
    add(segment.leftPlace);
  }
  for (; right != rights.end(); ++right) add(*right);
}

bool CoverSweep::pass(Index place) {
  const Index vertex = order_.vertexAt[place];
  auto [first, last] = status_.equal_range(vertex, IsBelow{*this});
  leaving_.clear();
  while (first != last) {
    Segment& through = *first;
    first = status_.erase(first);
    if (through.rightPlace > place) leaving_.push_back(&through);
  }
  for (; next_ < segments_.size() && segments_[next_].leftPlace == place; ++next_)
    leaving_.push_back(&segments_[next_]);
  const auto below = first == status_.begin() ? status_.end() : std::prev(first);
  if (!insertLeaving(vertex, first, below == status_.end() ? 0 : below->above)) return false;
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
