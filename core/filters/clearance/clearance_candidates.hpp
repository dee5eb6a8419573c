// Finds everything that stands in the clearance above one floor triangle.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/base/poll.hpp"
#include "core/exact/plan_kernel.hpp"
#include "core/filters/clearance/clearance_candidate.hpp"
#include "core/filters/clearance/closed_cover.hpp"
#include "core/filters/clearance/crowding.hpp"
#include "core/filters/clearance/needle_fans.hpp"
#include "core/filters/clearance/three_signs.hpp"
#include "core/filters/open_grid.hpp"
#include "footfall/statistics.hpp"

namespace footfall::detail {

/// The box of a face and of the clearance above it.
[[nodiscard]] Box clearanceBox(const SourceMesh& mesh, Index face, double height);

/// Searches above one face after another; one object for each thread.
class ClearanceCandidates {
 public:
  /// `isFloor(t)`: triangle t takes part as a floor (coplanar floors are kept once). `level` is the clearance's level
  /// in the kernel. `poll` is called now and then and may throw to cancel.
  ClearanceCandidates(const PlanKernel& kernel, std::function<bool(Index)> isFloor, Index level, Poll poll);

  /// `fans` are those of the kernel's mesh, or null, and must outlive this object. What is found does not depend on
  /// them.
  void useFans(const NeedleFans* fans) { fans_ = fans; }

  /// All triangles that reach into the clearance and overlap the face in the plan, and of those in its plane the floors
  /// that come before it; in the order of the triangles. Not all when areKnownToCover() or with openSquares(). Good
  /// until the next call.
  std::span<const ClearanceCandidate> find(Index face);

  /// Finds candidates when everything that may stand above the face in the plan within `knownHeight` is known.
  std::span<const ClearanceCandidate> find(Index face, const std::vector<Index>& known, double knownHeight);

  /// The same as the first, of what overlaps `box` in the plan.
  std::span<const ClearanceCandidate> findWithin(Index face, const Box& box);

  /// The candidates among `obstacles` that find() would return if there were no others.
  std::span<const ClearanceCandidate> findAmong(Index face, std::span<const Index> obstacles);

  [[nodiscard]] std::span<const ClearanceCandidate> found() const { return candidates_; }
  /// True when the candidates lie so deep that finding out what covers what pays. Depends on them alone, not on the
  /// search.
  [[nodiscard]] bool areCrowd() const { return crowding_->isCrowd(); }
  [[nodiscard]] const Crowding& crowding() const { return *crowding_; }
  /// True when the candidates were proven to cover the whole face, by one of them, by a closed cover (ClosedCover) or
  /// by a grid. Depends on them alone, not on the search; but a search that has openSquares() may leave out what proves
  /// it.
  [[nodiscard]] bool areKnownToCover() const { return areKnownToCover_; }
  /// The squares that no obstacle covers alone, for a crowd with floors in the face's own plane; else null. All
  /// obstacles that reach an open square were found, and some of the others. The squares depend on the environment
  /// alone.
  [[nodiscard]] const OpenGrid* openSquares() const { return openSquares_ ? &*openSquares_ : nullptr; }
  /// True when some other triangle in the face's plane would be among them if it was a floor, or is because it is one.
  [[nodiscard]] bool dependsOnFloors() const { return dependsOnFloors_; }

  ExactFallbacks fallbacks;

 private:
  void begin(Index face);
  /// True when the triangle before is equal and a floor; then it is the only candidate.
  bool isTwin();
  /// Considers what overlaps the box, which is that of the face or, where `isPart`, less of it in the plan.
  void search(const Box& box, bool isPart = false);
  /// Sorts what was found, and decides whether it is known to cover the face.
  void finish();
  void consider(Index obstacle);
  /// False when nothing of the obstacle is strictly within the clearance, nor coplanar.
  bool findHeights(ClearanceCandidate& candidate);
  [[nodiscard]] int compareToCeiling(double z) const;
  /// False when obstacle and face do not overlap in the plan; finds the sides.
  bool findOverlap(ClearanceCandidate& candidate);
  /// The signs of the heights of the obstacle's corners above the floor, and of those above the clearance (-1 where the
  /// first is not 1).
  struct HeightBits {
    ThreeSigns floor, ceiling;
  };
  [[nodiscard]] HeightBits heightsOf(const std::array<Index, 3>& obstacle);
  [[nodiscard]] HeightBits levelHeights(const std::array<Index, 3>& obstacle) const;
  [[nodiscard]] HeightBits exactHeights(const std::array<Index, 3>& obstacle) const;
  [[nodiscard]] HeightBits integerHeights(const std::array<Index, 3>& obstacle) const;
  [[nodiscard]] HeightBits filteredHeights(const std::array<Index, 3>& obstacle);
  void chooseHeights();
  /// Prepares integerHeights() above the face.
  void beginIntegers();
  /// The difference in units of the grid of the mesh and the clearance.
  [[nodiscard]] std::array<std::int64_t, 3> unitsBetween(const Vec3& from, const Vec3& to) const;
  /// A line of the plan through two source vertices, as doubles compute with it.
  struct Line {
    Index from, to;
    double x, y, dx, dy;  ///< scaled
  };
  [[nodiscard]] Line lineThrough(Index from, Index to) const;
  /// Side of the line on which the source vertex lies in the plan: +1 left.
  [[nodiscard]] int sideOf(const Line& line, Index vertex);
  /// Returns true when the boxes of face and obstacle share, in the plan, at most a border on which no part of the
  /// obstacle can stand on the face. False has no meaning.
  [[nodiscard]] bool onlyTouches(Index obstacle) const;
  [[nodiscard]] PlanCorners cornersOf(Index triangle) const;
  /// The sides of a line on which the corners of a triangle lie.
  [[nodiscard]] ThreeSigns filteredSides(const Line& line, Index triangle);
  void findEdgesInBox();
  /// True when an edge of the obstacle, which is no wall, has the face outside; finds the corners if not.
  bool isSeparated(ClearanceCandidate& candidate);
  [[nodiscard]] bool isWallApart(Index wall);
  /// True when each square of a grid over the face lies under one obstacle that covers all of it.
  bool proveCover();
  /// Looks whether a new candidate covers the face, and now and then whether all so far do.
  void findCover(const ClearanceCandidate& candidate);
  void findClosedCover();
  void setCovered();
  /// Makes openSquares() of the candidates when that is due.
  void findOpenSquares();
  void closeSquares(const ClearanceCandidate& candidate);
  /// Returns true when a search need not test the obstacle any further.
  [[nodiscard]] bool isLeftOut(Index obstacle) const;

  const PlanKernel& kernel_;
  const SourceMesh& mesh_;
  std::function<bool(Index)> isFloor_;
  Index level_;
  double height_;
  double scaledHeight_;
  Poll poll_;
  const NeedleFans* fans_ = nullptr;
  std::uint32_t polls_ = 0;
  bool exactOrientations_ = false, exactTree_ = false;
  /// How heights above a floor that is not level are compared; on wide grids doubles with a bound and exact numbers.
  enum class Heights : std::uint8_t { Doubles, Integers, Filtered };
  Heights heights_ = Heights::Filtered;
  double unitsPerScaled_ = 0;  ///< with Heights::Integers
  std::int64_t integerHeight_ = 0;

  Index face_ = -1;
  Box box_;  ///< box of the face and the clearance above it
  // the face's edges in the plan, from corner k to k + 1
  PlanEdges planEdges_{};        ///< used with exactOrientations_
  std::array<Line, 3> edges_{};  ///< otherwise
  /// [axis][lower, upper]: from where to where, along the other axis, an edge of the face lies in that side of box_; of
  /// a side with no edge the first is the larger.
  std::array<std::array<std::array<double, 2>, 2>, 2> edgesInBox_{};
  // the floor's plane in doubles
  double nx_ = 0, ny_ = 0, nz_ = 0, ex_ = 0, ey_ = 0, ez_ = 0;
  bool isLevel_ = false;  ///< all corners of the floor have the same z
  double floorZ_ = 0;     ///< ... which is this one
  std::array<std::int64_t, 3> integerNormal_{};
  bool dependsOnFloors_ = false;
  std::vector<ClearanceCandidate> candidates_;
  std::optional<Crowding> crowding_;
  bool isCoverSought_ = false, areKnownToCover_ = false;
  ClosedCover closedCover_;
  unsigned coveredCorners_ = 0;                ///< the face's corners that lie under a candidate that takes all
  std::size_t whole_ = 0, wholeWhenLast_ = 0;  ///< number of those, and what it was when closedCover_ was used
  bool overlapInPlane_ = false;                ///< some triangle in the face's plane comes before it and overlaps it
  bool mayLeaveOut_ = true;
  std::optional<OpenGrid> openSquares_;
  std::vector<std::int32_t> stack_;
};

}  // namespace footfall::detail
