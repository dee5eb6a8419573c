// Clips everything that stands in the clearance above one floor triangle (model, Vertical clearance).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/assembly/assembly_memory.hpp"
#include "core/filters/clearance/clearance_candidates.hpp"
#include "core/filters/face_cutter.hpp"

namespace footfall::detail {

/// The data of a face from before an edit, in numbers of the present mesh, and the changes of the edit.
struct EarlierCuts {
  const FaceCuts& cuts;  ///< may name what went, within `changed`
  const LargeFace& memory;
  const std::vector<Index>& standing;  ///< obstacles that stood above it and still exist, ascending
  const std::vector<Index>& added;     ///< the triangles that came, ascending
  std::vector<Box> gone;               ///< boxes of the obstacles that stood above it and went, without walls
  std::array<Box, 2> changed;          ///< around all that went or came and may reach into the clearance above it
};

/// The result of an update.
struct UpdatedCuts {
  FaceCuts cuts;
  LargeFace memory;
  std::vector<Index> standing;  ///< ascending
};

/// The obstacles that all shares of a face found, ascending.
[[nodiscard]] std::vector<Index> candidatesOf(std::span<const FaceShare> shares);

/// Clips one face after another; one object for each thread.
class ClearanceClipper : private FaceCutter {
 public:
  /// Takes what ClearanceCandidates takes.
  ClearanceClipper(const PlanKernel& kernel, std::function<bool(Index)> isFloor, Index level, Poll poll);

  /// See ClearanceCandidates.
  void useFans(const NeedleFans* fans) { candidates_.useFans(fans); }

  /// The cuts on a walkable face, together with those that it has from an earlier clearance (may be null). Good until
  /// the next call, and as long as `earlier`.
  const FaceCuts& clip(Index face, const FaceCuts* earlier);

  /// Clips without earlier cuts, when everything that may stand above the face in the plan within `knownHeight` is
  /// known.
  const FaceCuts& clip(Index face, const std::vector<Index>& known, double knownHeight);

  /// Updates known earlier cuts, only a part of which can have changed. Empty where the face has to be clipped as a
  /// whole.
  std::optional<UpdatedCuts> update(Index face, const EarlierCuts& earlier);

  /// The data of the last clip() that update() needs; null when there is little to gain.
  [[nodiscard]] std::shared_ptr<const LargeFace> largeFace(const FaceCuts& cuts) const;

  /// The cuts on the part of a face that lies on the cell's sides, for a kernel that has their borders.
  FaceShare clipShare(Index face, std::span<const CellSide> sides);

  /// The cuts on a face of which the shares of all cells that it has a part in are given: those that clip() finds.
  FaceCuts joinShares(Index face, std::span<const FaceShare> shares);

  /// The obstacles that the last clip() or clipShare() found in the clearance, ascending.
  [[nodiscard]] std::vector<Index> candidates() const;

  [[nodiscard]] ExactFallbacks fallbacks() const;

  /// Called with the share of a crowd above a face that clip() has looked at, from 0 to 1; may be empty.
  std::function<void(double)> crowdProgress;

 private:
  [[nodiscard]] std::vector<Index> standingNear(const EarlierCuts& earlier, const std::array<Box, 2>& around) const;
  [[nodiscard]] std::optional<LargeFace> depthsNow(const EarlierCuts& earlier) const;
  void mergeSegments(const EarlierCuts& earlier, const std::function<bool(Index)>& isHeld, FaceCuts& cuts,
                     std::vector<ApproximatePoint>& points);
  /// False when one obstacle covers the whole face.
  bool clipAll(std::span<const ClearanceCandidate> candidates);
  bool clipOne(const ClearanceCandidate& candidate);
  /// Adds what is left of the edges that wait.
  void clipEdges();
  /// False when obstacles cover the whole face. What is left open is the same as after clipAll().
  bool clipCrowd(std::span<const ClearanceCandidate> candidates);
  const FaceCuts& cut(std::span<const ClearanceCandidate> candidates);
  bool addArea(const ClearanceCandidate& candidate);
  void addWholeArea(const ClearanceCandidate& candidate);
  bool isWallOfEdge(const ClearanceCandidate& candidate);
  /// True when a wall reaches into the clearance at the place of its corner j.
  [[nodiscard]] bool reachesAt(const ClearanceCandidate& candidate, int j) const;
  void addWall(const ClearanceCandidate& candidate);
  void addWallPiece(Index line, Index first, Index last);
  /// A place on an edge of the obstacle that is being clipped.
  struct Place {
    Index point = -1;
    int from = -1, to = -1;  ///< corners between which it lies, or the same one twice; -1: an edge of the face made it
  };
  /// The first and the last place along its line at which a wall reaches into the clearance; the same point twice where
  /// it does so at one only.
  std::pair<Place, Place> endsOfWall(const ClearanceCandidate& candidate, Index line);
  int sideOfEdge(int k, const Place& place, const ClearanceCandidate& candidate);
  /// Clips a piece of `line` to the face; false when nothing is left.
  bool clipToFace(Index line, Place& first, Place& last, const ClearanceCandidate& candidate);
  void clipToLevel(Polygon& polygon, Index obstacle, bool ceiling);
  void clipToSide(Polygon& polygon, std::size_t side);
  /// True when the whole triangle lies beyond the border, strictly.
  [[nodiscard]] bool isInside(std::size_t side, Index triangle) const;
  int sideOfCell(std::size_t side, Index point);

  Index level_;
  ClearanceCandidates candidates_;
  FaceCuts cuts_;

  /// An edge of an obstacle that takes all under it, from the smaller plan id to the larger one.
  struct PlanEdge {
    std::uint64_t ends = 0;          ///< both plan ids
    int winding = 0;                 ///< +1: the obstacle lies on its left
    std::int8_t from = -1, to = -1;  ///< corners of the obstacle
    const ClearanceCandidate* candidate = nullptr;
  };
  std::vector<PlanEdge> edges_;  ///< those that wait to be clipped
};

}  // namespace footfall::detail
