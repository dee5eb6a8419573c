// Decides whether obstacles lie so deep above a floor that most of their outlines lie inside the area that others
// remove anyway.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/exact/source_mesh.hpp"

namespace footfall::detail {

/// A measure of the crossings of obstacle outlines over a floor: the squares of the depths in which their boxes lie
/// above parts of it. In whole numbers, which are the same sum in any order.
class Crowding {
 public:
  static constexpr std::size_t kParts = 8;  ///< along each axis
  /// The depth of obstacles over each part of a face.
  using Depths = std::array<std::uint64_t, kParts * kParts>;

  Crowding(const SourceMesh& mesh, Index face);
  /// Starts again above another face.
  void restart(Index face);
  /// Starts again above another face with obstacles whose depths are known; `areas` is the number of those that are no
  /// walls.
  void restart(Index face, const Depths& depths, std::size_t areas);
  void add(Index obstacle);
  /// Removes an obstacle that is no wall, where depths() are known.
  void remove(const Box& obstacle);
  /// Known of many obstacles that are no crowd; else null.
  [[nodiscard]] const Depths* depths() const { return areas_ >= kFewest && !isCrowd() ? &depths_ : nullptr; }
  /// The number of added obstacles that are no walls.
  [[nodiscard]] std::size_t areas() const { return areas_; }
  /// Deep enough for looking what covers what to pay: 24 deep everywhere, or deeper in some part. More obstacles never
  /// make a crowd less of one.
  [[nodiscard]] bool isCrowd() const { return areas_ >= kFewest && squares_ >= kMostSquares; }
  /// The common area of the boxes of face and obstacle in the plan.
  [[nodiscard]] double commonArea(Index obstacle) const;

 private:
  static constexpr std::size_t kFewest = 64;
  static constexpr std::uint64_t kUnits = 1 << 10;  ///< units of depth
  static constexpr std::uint64_t kMostSquares = kParts * kParts * (24 * kUnits) * (24 * kUnits);

  void count(const Box& obstacle, bool isRemoved = false);

  const SourceMesh& mesh_;
  Box box_;
  std::vector<Index> few_;  ///< the first; they are counted when there are enough of them
  std::size_t areas_ = 0;
  Depths depths_{};
  std::uint64_t squares_ = 0;
};

}  // namespace footfall::detail
