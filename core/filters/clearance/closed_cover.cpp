// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/clearance/closed_cover.hpp"

#include <algorithm>

#include "core/base/index_and_box.hpp"

namespace footfall::detail {

// An edge does not pass over the inside of the face when an edge of the face has both its ends outside, or its own line
// has all of the face on one side.
void ClosedCover::addEdges(const ClearanceCandidate& candidate, std::uint32_t owner) {
  using Signs = ClearanceCandidate::Signs;
  const auto& o = mesh_.triangles[candidate.obstacle];
  const bool up = mesh_.facing[candidate.obstacle] > 0;
  for (int k = 0; k < 3; ++k) {
    const Signs& face = candidate.corners[k];
    if (face[0] >= 0 && face[1] >= 0 && face[2] >= 0) continue;
    const auto isOutside = [&](const Signs& sides) { return sides[k] <= 0 && sides[next(k)] <= 0; };
    if (std::any_of(candidate.sides.begin(), candidate.sides.end(), isOutside)) continue;
    const Index from = mesh_.planIds[o[k]], to = mesh_.planIds[o[next(k)]];
    const auto low = static_cast<std::uint64_t>(std::min(from, to)),
               high = static_cast<std::uint64_t>(std::max(from, to));
    edges_.push_back({low << 32U | high, owner, static_cast<std::uint8_t>((from < to) == up ? 1 : 0)});
  }
}

bool ClosedCover::covers(std::span<const ClearanceCandidate> candidates) {
  edges_.clear();
  std::uint32_t left = 0;
  for (const ClearanceCandidate& candidate : candidates) {
    if (candidate.coplanar || mesh_.facing[candidate.obstacle] == 0 || !candidate.takesAll()) continue;
    const std::size_t before = edges_.size();
    addEdges(candidate, left++);
    if (edges_.size() == before) return true;  // it covers the face alone
  }
  if (left < 2) return false;
  std::sort(edges_.begin(), edges_.end(), [](const Edge& x, const Edge& y) { return x.ends < y.ends; });
  counts_.clear();
  firsts_.clear();
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    if (i == 0 || edges_[i].ends != edges_[i - 1].ends) {
      counts_.push_back({});
      firsts_.push_back(static_cast<std::uint32_t>(i));
    }
    edges_[i].group = static_cast<std::uint32_t>(counts_.size() - 1);
    ++counts_.back()[edges_[i].side];
  }
  firsts_.push_back(static_cast<std::uint32_t>(edges_.size()));
  // The edges of an owner, wherever they were sorted to.
  byOwner_.assign(3 * static_cast<std::size_t>(left), kNone);
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    std::uint32_t* place = &byOwner_[3 * static_cast<std::size_t>(edges_[i].owner)];
    while (*place != kNone) ++place;
    *place = static_cast<std::uint32_t>(i);
  }
  isLeft_.assign(left, 1);
  waiting_.clear();
  const auto takeAway = [&](std::uint32_t owner) {
    if (isLeft_[owner] == 0) return;
    isLeft_[owner] = 0;
    --left;
    waiting_.push_back(owner);
  };
  for (const Edge& edge : edges_)
    if (counts_[edge.group][1 - edge.side] == 0) takeAway(edge.owner);
  while (!waiting_.empty() && left > 0) {
    const std::uint32_t owner = waiting_.back();
    waiting_.pop_back();
    for (std::size_t i = 3 * static_cast<std::size_t>(owner); i < 3 * static_cast<std::size_t>(owner) + 3; ++i) {
      if (byOwner_[i] == kNone) break;
      const Edge& edge = edges_[byOwner_[i]];
      if (--counts_[edge.group][edge.side] > 0) continue;
      for (std::uint32_t j = firsts_[edge.group]; j < firsts_[edge.group + 1]; ++j) takeAway(edges_[j].owner);
    }
  }
  return left > 0;
}

}  // namespace footfall::detail
