// Whether obstacles lie so deep above a floor that most of their outlines lie inside what others take away anyway.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/exact/source_mesh.hpp"

namespace footfall::detail {

/// How deep the boxes of obstacles lie above a floor, as a measure: sums up only.
class Crowding {
 public:
  Crowding(const SourceMesh& mesh, Index face);
  void add(Index obstacle);
  /// Deep enough for looking what covers what to pay. More obstacles never make a crowd less of one.
  [[nodiscard]] bool isCrowd() const { return count_ >= kFewest && depth_ >= kDeepest * kWhole; }
  /// What the boxes of face and obstacle have in common in the plan.
  [[nodiscard]] double commonArea(Index obstacle) const;

 private:
  static constexpr std::size_t kFewest = 64;
  static constexpr std::uint64_t kDeepest = 24;
  static constexpr std::uint64_t kWhole = 1 << 20;  ///< whole numbers are the same sum in any order

  const SourceMesh& mesh_;
  Box box_;
  double faceArea_ = 0;
  std::uint64_t depth_ = 0;
  std::size_t count_ = 0;
};

}  // namespace footfall::detail
