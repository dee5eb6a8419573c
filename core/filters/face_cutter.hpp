// Cuts convex polygons and pieces of line out of one floor triangle, and collects what that leaves (FaceCuts).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/assembly/face_share.hpp"
#include "core/base/poll.hpp"
#include "core/exact/face_cuts.hpp"
#include "core/exact/face_geometry.hpp"
#include "core/exact/face_triangulation.hpp"
#include "core/filters/open_grid.hpp"

namespace footfall::detail {

/// Cuts one face after another; one object for each thread.
class FaceCutter {
 public:
  FaceCutter(const PlanKernel& kernel, Poll poll)
      : mesh_(kernel.mesh()), poll_(poll), geometry_(kernel), triangulation_(geometry_, poll) {}
  FaceCutter(const FaceCutter&) = delete;
  FaceCutter& operator=(const FaceCutter&) = delete;
  ~FaceCutter() = default;

  /// The cuts that convex polygons of the plan make on a face, each given by the plan ids of its corners, at most
  /// twelve, counter-clockwise.
  FaceCuts cut(Index face, std::span<const std::span<const Index>> polygons);

  [[nodiscard]] const ExactFallbacks& cutFallbacks() const { return geometry_.fallbacks; }

 protected:
  struct Corner {
    Index point = -1;
    Index line = -1;          ///< line of the edge to the next corner
    int direction = 0;        ///< +1: that edge runs along the line
    int floor = 0;            ///< sign of the height above the floor
    int ceiling = 0;          ///< sign of the height above floor + clearance
    bool cut = false;         ///< a border of the cell made it
    std::int8_t corner = -1;  ///< corner of the triangle or polygon that is clipped, if it is one
  };
  /// A triangle clipped by two heights and three edges has at most eight corners, twelve corners clipped by three edges
  /// are fifteen.
  static constexpr std::size_t kMostCorners = 16;
  struct Polygon {
    std::array<Corner, kMostCorners> corners;
    int size = 0;
    void push(const Corner& c) { corners[size++] = c; }
  };

  void begin(Index face);
  void startGeometry();
  /// Clips to the face's edge k. `sides`: those of the corners of what is clipped; may be empty.
  void clipToEdge(Polygon& polygon, int k, std::span<const std::int8_t> sides = {});
  /// Keeps the corners at which `signs` is positive or 0. New ones come from `crossingOf(from, to)`, the corners of the
  /// edge; the edges between them lie on the line of `made`, which is also what new corners are like beside that.
  template <class Crossing>
  static void keepPositive(Polygon& polygon, const std::array<int, kMostCorners>& signs, const Corner& made,
                           const Crossing& crossingOf) {
    bool any = false;
    for (int i = 0; i < polygon.size; ++i) any = any || signs[i] > 0;
    if (!any) {
      polygon.size = 0;
      return;
    }
    Polygon result;
    for (int i = 0; i < polygon.size; ++i) {
      const Corner& c = polygon.corners[i];
      const Corner& d = polygon.corners[(i + 1) % polygon.size];
      const int a = signs[i], b = signs[(i + 1) % polygon.size];
      const auto turn = [&](Corner corner) {
        corner.line = made.line;
        corner.direction = made.direction;
        return corner;
      };
      if (a >= 0) result.push(a == 0 && b < 0 ? turn(c) : c);
      if (a * b >= 0) continue;
      Corner corner = c;
      corner.point = crossingOf(c, d);
      corner.cut = made.cut;
      corner.corner = -1;
      result.push(a > 0 ? turn(corner) : corner);
    }
    polygon = result;
  }
  /// True when a polygon is the whole face.
  static bool isWhole(const Polygon& polygon);
  /// `polygon` is clipped to the face.
  void addOutline(const Polygon& polygon);
  [[nodiscard]] std::uint8_t cellBorders(Index point) const;
  /// `cutFrom`, `cutTo`: a border of the cell made that end.
  void addSegment(Index from, Index to, Index line, int direction, int winding, bool wall, bool cutFrom = false,
                  bool cutTo = false);
  /// Adds the segments of FaceCuts or of a FaceShare; `points` and `lines` receive the numbers of its points and lines
  /// in the geometry.
  void addCuts(const FaceCuts& cuts, std::vector<Index>& points, std::vector<Index>& lines);
  void addCuts(const FaceShare& cuts, std::vector<Index>& points, std::vector<Index>& lines);
  void cancelSegments();
  /// Replaces the segments by the outline of all that they enclose, with the walls outside of it; opens in `grid` what
  /// is outside and closes all else. Not for shares of cells. Of what is outside, parts that do not reach `openSquares`
  /// (null: all do) count as enclosed; the segments must part them from the others.
  void keepOutline(OpenGrid& grid, const OpenGrid* openSquares = nullptr);
  [[nodiscard]] std::size_t segmentCount() const { return segments_.size(); }
  /// The rounded places of the points of what collect() gave last.
  [[nodiscard]] std::vector<ApproximatePoint> placesOfPoints() const;
  /// Everything that was cut; of FaceCuts that cover the face nothing but that.
  void collect(FaceCuts& cuts);
  void collect(FaceShare& cuts);

  const SourceMesh& mesh_;
  Poll poll_;
  std::uint32_t polls_ = 0;
  FaceGeometry geometry_;
  Index face_ = -1;
  std::uint8_t edgeWalls_ = 0;
  int startWinding_ = 0;  ///< see FaceCuts

  // The sides of the cell whose share is being cut, and facts about them.
  std::span<const CellSide> sides_;
  std::vector<Index> sideLines_;
  std::vector<std::uint8_t> cellBorders_;  ///< bit i of each point: it lies on side i
  Index obstacle_ = -1;
  std::vector<CutSegment> segments_;

 private:
  bool addPolygon(std::span<const Index> planIds);
  template <class Cuts>
  void addAllCuts(const Cuts& cuts, std::vector<Index>& points, std::vector<Index>& lines);
  template <class Cuts>
  void collectAll(Cuts& cuts);
  void sortSegments();
  [[nodiscard]] OpenGrid::Outline outlineOf(const FaceTriangulation::Facet& facet) const;
  /// One flag per facet of the triangulation: it is outside of the area that keepOutline() encloses.
  [[nodiscard]] std::vector<char> findOpen(const OpenGrid* openSquares) const;
  [[nodiscard]] bool precedes(Index line, Index other) const;

  FaceTriangulation triangulation_;  ///< triangulation that keepOutline() uses
  bool started_ = false;
  std::vector<std::span<const Index>> unsure_;  ///< polygons of which doubles cannot decide how they lie to the face
  std::vector<CutSegment> sorted_;
  std::vector<Index> counts_;
  std::vector<Index> numbers_;  ///< numbers of points, then of lines, in the cuts that are being collected
  std::vector<Index> order_;    ///< order of the points in them
  std::vector<FaceShare::Piece> pieces_;
};

}  // namespace footfall::detail
