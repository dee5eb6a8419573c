// Clips everything that stands in the clearance above one floor triangle (design section 2).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/exact/face_geometry.hpp"
#include "core/filters/clearance_candidates.hpp"
#include "core/filters/face_cuts.hpp"

namespace footfall {

/// One for each thread; reused from face to face.
class ClearanceClipper {
 public:
  /// As ClearanceCandidates.
  ClearanceClipper(const PlanKernel& kernel, const std::vector<char>& walkable, Index level,
                   std::function<void()> poll);

  /// The cuts on a walkable face, together with those that it has from an earlier clearance (may be null).
  FaceCuts clip(Index face, const FaceCuts* earlier);

  /// The same without earlier cuts, when all that may stand above the face in the plan within `knownHeight` is known.
  FaceCuts clip(Index face, const std::vector<Index>& known, double knownHeight);

  /// What the last clip() found in the clearance, ascending.
  [[nodiscard]] std::vector<Index> candidates() const;

  [[nodiscard]] ExactFallbacks fallbacks() const;

 private:
  struct Corner {
    Index point = -1;
    Index line = -1;    ///< of the edge to the next corner
    int direction = 0;  ///< +1: that edge runs along the line
    int floor = 0;      ///< sign of the height above the floor
    int ceiling = 0;    ///< sign of the height above floor + clearance
  };
  /// A triangle clipped by two heights and three edges has at most eight corners.
  struct Polygon {
    std::array<Corner, 12> corners;
    int size = 0;
    void push(const Corner& c) { corners[size++] = c; }
  };

  void begin(Index face);
  FaceCuts cut(std::span<const ClearanceCandidate> candidates);
  bool addArea(const ClearanceCandidate& candidate);
  bool isWallOfEdge(const ClearanceCandidate& candidate);
  void addWall(const ClearanceCandidate& candidate);
  void clipToLevel(Polygon& polygon, Index obstacle, bool ceiling);
  void clipToEdge(Polygon& polygon, int k);
  void addSegment(Index from, Index to, Index line, int direction, int winding, bool wall);
  void addEarlier(const FaceCuts& earlier);
  void cancelSegments();
  void sortSegments();
  FaceCuts collect();

  const SourceMesh& mesh_;
  Index level_;
  std::function<void()> poll_;
  std::uint32_t polls_ = 0;

  FaceGeometry geometry_;
  ClearanceCandidates candidates_;
  Index face_ = -1;
  bool started_ = false;
  std::uint8_t edgeWalls_ = 0;
  std::vector<CutSegment> segments_, sorted_;
  std::vector<Index> numbers_;  ///< of points, then of lines, in the cuts that are being collected
};

}  // namespace footfall
