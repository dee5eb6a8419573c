// What the floors of one cell need of a packed environment, and nothing else of it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/io/packed/packed_environment.hpp"

namespace footfall::detail {

/// Faces of a packed environment in the order of its blocks: those from `first` on that are before `last`.
struct FaceRange {
  std::uint64_t first = 0, last = 0;
  [[nodiscard]] std::uint64_t size() const { return last - first; }
};

/// Which faces may be floors when they are first joined, and how high above them things matter.
struct FloorRule {
  std::vector<double> slopes;   ///< degrees, all of which hold
  double height = 0;            ///< the largest clearance
  std::vector<PartRole> roles;  ///< of Environment::parts; empty: all are floors
};

/// Everything that decides what is left of the cell's own floors: they, the floors that touch them, and all that
/// stands in the clearance above either.
struct CellFaces {
  PackedFaces faces;
  /// For each face: 1, a floor that touches one of the cell; 2, a floor of the cell; 0, all others.
  std::vector<std::uint8_t> kinds;
  std::uint64_t floors = 0;  ///< of the kinds 1 and 2
  /// For each face 1 where its part is an obstacle only, or empty.
  std::vector<std::uint8_t> obstacleOnly;
};

/// How much a cell holds.
struct CellSize {
  std::uint64_t faces = 0, floors = 0;
};

/// Collects cells of one environment. Not for several threads at once.
class CellCollector {
 public:
  CellCollector(const PackedEnvironment& environment, FloorRule rule);

  [[nodiscard]] std::uint64_t faceCount() const { return first_.back(); }

  /// Whether a cell may be as large as that; to be asked while it is collected.
  using Fits = std::function<bool(const CellSize&)>;
  /// Empty where it does not fit; `size` (may be null) is then how much of it was found, and all of it when `fits` is
  /// always true.
  std::optional<CellFaces> collect(const FaceRange& range, const Fits& fits, RunContext& context, CellSize* size) const;
  /// How much a cell holds, without holding it.
  [[nodiscard]] CellSize measure(const FaceRange& range, RunContext& context) const;

 private:
  struct Floors;
  [[nodiscard]] PartRole roleOf(std::uint32_t part) const {
    return rule_.roles.empty() ? PartRole::Floor : rule_.roles[part];
  }
  [[nodiscard]] bool isFloor(const BlockFace& face) const;
  [[nodiscard]] bool isOwn(const FaceRange& range, const BlockFace& face) const;
  [[nodiscard]] std::vector<std::size_t> ownBlocks(const FaceRange& range) const;
  [[nodiscard]] Floors findFloors(const FaceRange& range, const Fits& fits, RunContext& context) const;

  const PackedEnvironment& environment_;
  FloorRule rule_;
  std::vector<std::uint64_t> first_;  ///< of each block the number of its first face in their order; then how many
};

}  // namespace footfall::detail
