// Finds and clips everything that stands in the clearance above one floor triangle (design section 2).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/exact/face_geometry.hpp"
#include "core/filters/face_cuts.hpp"

namespace footfall {

/// The box of a face and of the clearance above it.
[[nodiscard]] Box clearanceBox(const SourceMesh& mesh, Index face, double height);

/// One for each thread; reused from face to face.
class ClearanceClipper {
 public:
  /// `walkable[t]`: triangle t takes part as a floor (coplanar walkable triangles are kept once). `level` is the
  /// clearance's level in the kernel. `poll` is called now and then and may throw to cancel.
  ClearanceClipper(const PlanKernel& kernel, const std::vector<char>& walkable, Index level,
                   std::function<void()> poll);

  /// The cuts on a walkable face, together with those that it has from an earlier clearance (may be null).
  FaceCuts clip(Index face, const FaceCuts* earlier);

  /// The same without earlier cuts, when all that may stand above the face in the plan within `knownHeight` is known.
  FaceCuts clip(Index face, const std::vector<Index>& known, double knownHeight);

  /// What the last clip() found in the clearance, ascending.
  [[nodiscard]] std::vector<Index> candidates() const;

  [[nodiscard]] const ExactFallbacks& fallbacks() const { return geometry_.fallbacks; }

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
  /// A triangle that stands in the clearance, and what was found out about it.
  struct Candidate {
    using Signs = std::array<std::int8_t, 3>;
    Index obstacle = -1;
    Signs floor{}, ceiling{};      ///< for each corner of the obstacle: its height against the floor and the clearance
    std::array<Signs, 3> sides{};  ///< [edge of the face][corner of the obstacle]: +1 inside
    bool coplanar = false;
  };

  void prepareFloor(Index face);
  /// Everything that stands in the clearance and may overlap the face in the plan, in the order of the triangles.
  void findCandidates();
  void findCandidates(const std::vector<Index>& known, double knownHeight);
  void consider(Index obstacle);
  void search(const Box& box);
  void sortCandidates();
  FaceCuts cut();
  /// False when nothing of the obstacle is strictly within the clearance, nor coplanar.
  bool findHeights(Candidate& candidate);
  [[nodiscard]] int compareToCeiling(double z) const;
  /// Side of the line from a to b on which p lies in the plan; source vertices.
  [[nodiscard]] int sideOf(Index a, Index b, Index p);
  /// False when obstacle and face do not overlap in the plan; finds the sides.
  bool findOverlap(Candidate& candidate);
  [[nodiscard]] bool onlyTouchesBox(Index obstacle) const;
  bool isSeparated(Index obstacle);
  bool addArea(const Candidate& candidate);
  bool isWallOfEdge(const Candidate& candidate);
  void addWall(const Candidate& candidate);
  void clipToLevel(Polygon& polygon, Index obstacle, bool ceiling);
  void clipToEdge(Polygon& polygon, int k);
  void addSegment(Index from, Index to, Index line, int direction, int winding, bool wall);
  void addEarlier(const FaceCuts& earlier);
  void cancelSegments();
  void sortSegments();
  FaceCuts collect();

  const PlanKernel& kernel_;
  const SourceMesh& mesh_;
  const std::vector<char>& walkable_;
  Index level_;
  double height_;
  double scaledHeight_;
  std::function<void()> poll_;
  std::uint32_t polls_ = 0;

  FaceGeometry geometry_;
  Index face_ = -1;
  bool started_ = false;
  Box box_;  ///< of the face and the clearance above it
  std::uint8_t edgeWalls_ = 0;
  std::vector<CutSegment> segments_, sorted_;
  std::vector<std::int32_t> stack_;
  std::vector<Candidate> candidates_;
  std::vector<Index> numbers_;  ///< of points, then of lines, in the cuts that are being collected
  // the floor's plane in doubles
  double nx_ = 0, ny_ = 0, nz_ = 0, ex_ = 0, ey_ = 0, ez_ = 0;
  bool isLevel_ = false;  ///< all corners of the floor have the same z
  double floorZ_ = 0;     ///< ... which is this one
  bool dependsOnFloors_ = false;
  bool exactOrientations_ = false, exactHeights_ = false;
};

}  // namespace footfall
