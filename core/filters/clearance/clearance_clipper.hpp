// Clips everything that stands in the clearance above one floor triangle (design section 2).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/assembly/face_share.hpp"
#include "core/base/poll.hpp"
#include "core/exact/face_cuts.hpp"
#include "core/exact/face_geometry.hpp"
#include "core/filters/clearance/clearance_candidates.hpp"

namespace footfall::detail {

/// One for each thread; reused from face to face.
class ClearanceClipper {
 public:
  /// As ClearanceCandidates.
  ClearanceClipper(const PlanKernel& kernel, std::function<bool(Index)> isFloor, Index level, Poll poll);

  /// The cuts on a walkable face, together with those that it has from an earlier clearance (may be null).
  FaceCuts clip(Index face, const FaceCuts* earlier);

  /// The same without earlier cuts, when all that may stand above the face in the plan within `knownHeight` is known.
  FaceCuts clip(Index face, const std::vector<Index>& known, double knownHeight);

  /// The cuts on the part of a face that lies on the cell's sides, for a kernel that has their borders.
  FaceShare clipShare(Index face, std::span<const CellSide> sides);

  /// The cuts on a face of which the shares of all cells that it has a part in are given: those that clip() finds.
  FaceCuts joinShares(Index face, std::span<const FaceShare> shares);

  /// What the last clip() or clipShare() found in the clearance, ascending.
  [[nodiscard]] std::vector<Index> candidates() const;

  [[nodiscard]] ExactFallbacks fallbacks() const;

 private:
  struct Corner {
    Index point = -1;
    Index line = -1;    ///< of the edge to the next corner
    int direction = 0;  ///< +1: that edge runs along the line
    int floor = 0;      ///< sign of the height above the floor
    int ceiling = 0;    ///< sign of the height above floor + clearance
    bool cut = false;   ///< a border of the cell made it
  };
  /// A triangle clipped by two heights and three edges has at most eight corners.
  struct Polygon {
    std::array<Corner, 12> corners;
    int size = 0;
    void push(const Corner& c) { corners[size++] = c; }
  };

  void begin(Index face);
  void startGeometry();
  /// False when one obstacle covers the whole face. `leftOut` marks those that change nothing; empty: none.
  bool clipAll(std::span<const ClearanceCandidate> candidates, const std::vector<char>& leftOut);
  FaceCuts cut(std::span<const ClearanceCandidate> candidates);
  bool addArea(const ClearanceCandidate& candidate);
  bool isWallOfEdge(const ClearanceCandidate& candidate);
  void addWall(const ClearanceCandidate& candidate);
  void clipToLevel(Polygon& polygon, Index obstacle, bool ceiling);
  void clipToEdge(Polygon& polygon, int k);
  void clipToSide(Polygon& polygon, std::size_t side);
  /// Keeps the corners at which `signs` is positive or 0. New ones come from `crossingOf(line)`; the edges between them
  /// lie on the line of `made`, which is also what new corners are like beside that.
  template <class Crossing>
  static void keepPositive(Polygon& polygon, const std::array<int, 12>& signs, const Corner& made,
                           const Crossing& crossingOf);
  /// Whether the whole triangle lies beyond the border, strictly.
  [[nodiscard]] bool isInside(std::size_t side, Index triangle) const;
  int sideOfCell(std::size_t side, Index point);
  [[nodiscard]] std::uint8_t cellBorders(Index point) const;
  /// `cutFrom`, `cutTo`: a border of the cell made that end.
  void addSegment(Index from, Index to, Index line, int direction, int winding, bool wall, bool cutFrom = false,
                  bool cutTo = false);
  template <class Cuts>
  void addCuts(const Cuts& cuts, std::vector<Index>& points, std::vector<Index>& lines);
  void cancelSegments();
  void sortSegments();
  template <class Cuts>
  void collect(Cuts& cuts);
  [[nodiscard]] bool precedes(Index line, Index other) const;

  const SourceMesh& mesh_;
  Index level_;
  Poll poll_;
  std::uint32_t polls_ = 0;

  FaceGeometry geometry_;
  ClearanceCandidates candidates_;
  Index face_ = -1;
  bool started_ = false;
  std::uint8_t edgeWalls_ = 0;
  std::vector<CutSegment> segments_, sorted_;
  std::vector<Index> counts_;
  std::vector<Index> numbers_;  ///< of points, then of lines, in the cuts that are being collected

  // Of the cell whose share is being cut.
  std::span<const CellSide> sides_;
  std::vector<Index> sideLines_;
  std::vector<std::uint8_t> cellBorders_;  ///< for each point, bit i: it lies on side i
  Index obstacle_ = -1;
  std::vector<FaceShare::Piece> pieces_;
};

}  // namespace footfall::detail
