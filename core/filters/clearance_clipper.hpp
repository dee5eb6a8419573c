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

/// One for each thread; reused from face to face.
class ClearanceClipper {
 public:
  /// `walkable[t]`: triangle t takes part as a floor (coplanar walkable triangles are kept once). `level` is the
  /// clearance's level in the kernel. `poll` is called now and then and may throw to cancel.
  ClearanceClipper(const PlanKernel& kernel, const std::vector<char>& walkable, Index level,
                   std::function<void()> poll);

  /// The cuts on a walkable face, together with those that it has from an earlier clearance (may be null).
  FaceCuts clip(Index face, const FaceCuts* earlier);

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
  struct Heights {
    std::array<int, 3> floor{}, ceiling{};
    bool coplanar = false;
    bool reaches = false;  ///< some of the obstacle is strictly within the clearance
  };

  void prepareFloor(Index face);
  [[nodiscard]] Heights heightsOf(Index obstacle);
  /// False when obstacle and face cannot overlap in the plan; fills sides_.
  bool mayOverlap(Index obstacle);
  bool addArea(Index obstacle, const Heights& heights);
  void addWall(Index obstacle, const Heights& heights);
  void clipToLevel(Polygon& polygon, Index obstacle, bool ceiling);
  void clipToEdge(Polygon& polygon, int k);
  void addSegment(Index from, Index to, Index line, int direction, int winding, bool wall);
  void addEarlier(const FaceCuts& earlier);
  void cancelSegments();
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
  std::array<std::array<int, 3>, 3> sides_{};  ///< [edge of the face][corner of the obstacle]
  std::uint8_t edgeWalls_ = 0;
  std::vector<CutSegment> segments_;
  std::vector<std::int32_t> stack_;
  // the floor's plane in doubles
  double nx_ = 0, ny_ = 0, nz_ = 0, ex_ = 0, ey_ = 0, ez_ = 0;
};

}  // namespace footfall
