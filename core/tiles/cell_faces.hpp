// The part of a packed environment that the floors of one cell need.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/io/packed/packed_environment.hpp"

namespace footfall::detail {

/// Faces of a packed environment in the order of its blocks: those from `first` on that are before `last`.
struct FaceRange {
  std::uint64_t first = 0, last = 0;
  [[nodiscard]] std::uint64_t size() const { return last - first; }
};

/// The rule for faces that may be floors when they are first joined, and for how high above them triangles matter.
struct FloorRule {
  std::vector<double> slopes;   ///< degrees, all of which hold
  double height = 0;            ///< the largest clearance, or the step where that is larger
  double step = 0;              ///< largest difference in height of linked borders; 0: no links
  double gap = 0;               ///< largest distance in the plan of linked borders
  std::vector<PartRole> roles;  ///< one role per Environment::parts; empty: all are floors
};

/// Floors whose borders gaps change.
struct FloorsAtGaps {
  /// A link at a corner of a border. Everything within two gaps decides whether it is needed, at any height.
  struct Corner {
    std::uint32_t floor = 0;  ///< a floor that it links
    double x = 0, y = 0;
    auto operator<=>(const Corner&) const = default;
  };
  /// A box in the plan around the side of a gap.
  struct Side {
    std::uint32_t floor = 0;  ///< a floor at the gap
    std::array<double, 2> lower{}, upper{};
  };

  std::vector<std::uint32_t> floors;                 ///< numbers in the environment
  std::vector<std::array<std::uint32_t, 2>> joined;  ///< pairs of floors whose borders get vertices together
  std::vector<Corner> corners;
  std::vector<Side> sides;

  void add(const FloorsAtGaps& others) {
    const auto append = [](auto& all, const auto& more) { all.insert(all.end(), more.begin(), more.end()); };
    append(floors, others.floors);
    append(joined, others.joined);
    append(corners, others.corners);
    append(sides, others.sides);
  }
  [[nodiscard]] std::uint64_t bytes() const {
    return floors.size() * sizeof(floors[0]) + joined.size() * sizeof(joined[0]) + corners.size() * sizeof(corners[0]) +
           sides.size() * sizeof(sides[0]);
  }
};

/// Floors in no range, ascending, and the corners at their gaps.
struct ListedFloors {
  std::vector<std::uint32_t> floors;
  std::vector<FloorsAtGaps::Corner> corners;
  [[nodiscard]] std::uint64_t bytes() const {
    return floors.size() * sizeof(floors[0]) + corners.size() * sizeof(corners[0]);
  }
};

/// The floors of a cell.
struct OwnFloors {
  FaceRange range;
  const ListedFloors* listed = nullptr;  ///< in place of the range
};

/// The role of a face for a cell. A cell sees the floors that steps lead to from its own ones; those that touch them
/// are whole where they do.
enum class CellKind : std::uint8_t { Other, Near, Seen, Own };

/// Everything that decides what is left of the cell's own floors: they, those that it sees, the floors that touch
/// them, and all that stands in the clearance above any of these.
struct CellFaces {
  PackedFaces faces;
  std::vector<CellKind> kinds;  ///< one kind per face
  std::uint64_t floors = 0;     ///< number of faces of all kinds but Other
  int reach = 0;                ///< steps, over its own floors and under them, that it sees
  bool isListed = false;        ///< OwnFloors::listed
  /// One flag per face: its part is an obstacle only; or empty.
  std::vector<std::uint8_t> obstacleOnly;
};

/// The number of steps that a cell sees at first, from its floors to others and from those on.
inline constexpr int kUsualReach = 2;

/// The size of a cell.
struct CellSize {
  std::uint64_t faces = 0, floors = 0;
};

/// Collects cells of one environment. Not for several threads at once.
class CellCollector {
 public:
  CellCollector(const PackedEnvironment& environment, FloorRule rule);

  [[nodiscard]] std::uint64_t faceCount() const { return first_.back(); }
  [[nodiscard]] bool hasRoles() const { return !rule_.roles.empty(); }
  [[nodiscard]] PartRole roleOf(std::uint32_t part) const {
    return rule_.roles.empty() ? PartRole::Floor : rule_.roles[part];
  }
  /// True when a face may be a floor when floors are first joined.
  [[nodiscard]] bool isFloor(const BlockFace& face) const;

  /// Returns true when a cell may have the given size; called while it is collected.
  using Fits = std::function<bool(const CellSize&)>;
  /// Empty where it does not fit; `size` (may be null) is then how much of it was found, and all of it when `fits` is
  /// always true.
  std::optional<CellFaces> collect(const OwnFloors& own, const Fits& fits, RunContext& context, CellSize* size,
                                   int reach = kUsualReach) const;
  /// The size of a cell, without holding it.
  [[nodiscard]] CellSize measure(const OwnFloors& own, RunContext& context, int reach = kUsualReach) const;

 private:
  struct Floors;
  [[nodiscard]] bool isOwn(const OwnFloors& own, const BlockFace& face) const;
  [[nodiscard]] std::vector<std::size_t> ownBlocks(const OwnFloors& own) const;
  [[nodiscard]] Floors findFloors(const OwnFloors& own, const Fits& fits, RunContext& context, int reach) const;
  void addTouching(std::vector<Box> boxes, const Fits& fits, RunContext& context, Floors& floors,
                   std::vector<std::uint32_t>& found) const;

  const PackedEnvironment& environment_;
  FloorRule rule_;
  std::vector<std::uint64_t> first_;  ///< number of each block's first face in their order; then the number of all
};

}  // namespace footfall::detail
