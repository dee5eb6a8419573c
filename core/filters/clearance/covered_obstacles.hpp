// Where obstacles lie many deep above a floor, most of their outlines lie inside what others take away anyway, and
// where outlines cross nobody needs to know.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/base/poll.hpp"
#include "core/filters/clearance/clearance_candidates.hpp"

namespace footfall::detail {

/// How deep the boxes of obstacles lie above a floor, as a measure: sums up only.
class Crowding {
 public:
  Crowding(const SourceMesh& mesh, Index face);
  void add(Index obstacle);
  /// Deep enough for findCovered() to pay. More obstacles never make a crowd less of one.
  [[nodiscard]] bool isCrowd() const { return count_ >= kFewest && area_ >= kDeepest * faceArea_; }

 private:
  static constexpr std::size_t kFewest = 64;
  static constexpr double kDeepest = 24;

  const SourceMesh& mesh_;
  Box box_;
  double faceArea_ = 0, area_ = 0;
  std::size_t count_ = 0;
};

/// For each candidate whether it can be left out: it lies, above the face, where others that stay cover the floor. What
/// all of them take from the floor is the same without. A function of face and candidates alone; never wrong, because
/// cells of a quadtree count as covered only where rounded coordinates prove it.
std::vector<char> findCovered(const PlanKernel& kernel, Index face, std::span<const ClearanceCandidate> candidates,
                              Poll poll);

}  // namespace footfall::detail
