// Finds where an agent steps over a gap between two borders that lie apart in the plan (model, Gaps).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two borders E and F that face each other are compared along the bisector of their directions: at u on it, p(u) lies
// on E, q(u) on F, and pq is at a right angle to the bisector. A piece, an interval of u, is free when for all its u
// - |pq| <= gap; q is then not the nearest point of F, but the nearest point is nearer;
// - |z(p) - z(q)| <= step;
// - nothing of the environment lies over pq strictly between min z + step and max z + clearance.
// All of this is computed in doubles and tested with a margin of kSlack, which is far above their errors, so every
// piece that is found is free. A piece that is free by a margin of 2^-40 of the largest coordinate is found, with two
// exceptions: |pq| is 1 / cos(a / 2) times the distance from p to F where the borders include an angle a, and an end at
// an obstacle is drawn in by kSlack. Where no piece is free, the direction of the shortest way replaces the right angle
// to the bisector (findAtCorner()), because a corner may be nearer to a border, or to another corner, than the place
// straight across. Horizontal borders and obstacles that touch a limit exactly (a door that is as high as the
// clearance) are compared exactly. Slits that are as wide as the gap, and obstacles that touch the end of a piece, are
// left to the caller, which compares the obstacles with the line there exactly; single points do not count.
//
// A piece that nearly reaches a corner of both borders is extended to them (leadToCorners()). Its ways are then turned
// from end to end: places of E and F that divide the piece in the same ratio are across from each other. All ways lie
// between the outermost places of both borders, and obstacles are tested there.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/exact/source_mesh.hpp"
#include "core/mesh/walkable_mesh.hpp"

namespace footfall::detail {

/// A border, from `from` to `to`, with the walkable area on its left. Scaled (SourceMesh::scaled).
struct GapBorder {
  Vec3 from, to;
  std::optional<double> level;  ///< height of the border, where it is level and known exactly
};

/// Coordinates along a direction in the plan and across it, to its right.
struct GapFrame {
  double originX = 0, originY = 0, alongX = 1, alongY = 0;
  [[nodiscard]] double along(double x, double y) const { return (x - originX) * alongX + (y - originY) * alongY; }
  [[nodiscard]] double across(double x, double y) const { return (x - originX) * alongY - (y - originY) * alongX; }
  [[nodiscard]] Vec3 place(double along, double across) const {
    return {originX + along * alongX + across * alongY, originY + along * alongY - across * alongX, 0};
  }
};

/// A piece of a gap. The second border lies to the right of the first one; ends are low and high along the first one.
struct GapPiece {
  GapFrame frame;
  std::array<double, 2> ends{};
  std::array<std::vector<Index>, 2> touching;  ///< obstacles at each end; a proof that they lie beyond it is needed
  bool isAsWide = false;  ///< about as wide as the gap may be; a proof that it is not wider is needed
  /// A place of the first border, set at a corner where both borders diverge at a large angle, and in the middle of a
  /// piece of at most kShortInGaps gaps. Such a gap gets a link only where the link leads to another floor
  /// (NeedlessGaps).
  std::optional<Vec3> corner = {};
  /// The frame of the second border where ways are not at a right angle to the first one's frame: places with equal
  /// values along both frames are across from each other.
  std::optional<GapFrame> secondFrame = {};
  double skew = 0;  ///< the greatest length of a way along `frame`

  /// The frame of the first border (0) or of the second one (1).
  [[nodiscard]] const GapFrame& frameOf(std::size_t border) const {
    return border == 1 && secondFrame ? *secondFrame : frame;
  }
  /// The place along `frame` of the second border's place with this value along frameOf(1).
  [[nodiscard]] double placeAcross(double along) const {
    if (!secondFrame) return along;
    const double factor = secondFrame->alongX * frame.alongX + secondFrame->alongY * frame.alongY;
    return along / factor - ((frame.originX - secondFrame->originX) * frame.alongX +
                             (frame.originY - secondFrame->originY) * frame.alongY);
  }
  /// Sets the second frame, so that places at `places` along `frame` are across from those at `ends`.
  void setWays(const std::array<double, 2>& places);
};

class GapConditions {
 public:
  /// The distance of neighbouring doubles at the largest coordinate; scaled.
  static constexpr double kUnit = 0x1p-17;
  static constexpr double kSlack = 512 * kUnit;
  /// Places of two borders within this distance along a gap are across from each other. Each is at most that far from
  /// its exact place, so that both together use up the slack.
  static constexpr double kAcross = kSlack / 2;
  /// Places within this distance are taken as one.
  static constexpr double kSnap = 128 * kUnit;
  /// Shorter borders have no direction, and are not linked over gaps.
  static constexpr double kShort = 4096 * kUnit;

  /// A piece of at most this length, in widths of the gap, is seen whole from its middle within twice the gap.
  static constexpr double kShortInGaps = 2;

  /// Lengths are scaled. `removed` has an entry for each source triangle, true where it is out of the environment.
  GapConditions(const SourceMesh& mesh, const std::vector<char>& removed, double step, double clearance, double gap)
      : mesh_(mesh), removed_(removed), step_(step), clearance_(clearance), gap_(gap) {}

  /// See StepConditions; scaled.
  void refuseBetween(double lower, double higher) { atLimit_ = {lower, higher}; }

  /// The least sine of the angle between a way and a border, and of the angle by which two borders miss a right angle:
  /// 7 degrees.
  static constexpr double kLeastSine = 0.125;

  /// The frame of two borders that face each other; its ways are at a right angle to their bisector.
  [[nodiscard]] static std::optional<GapFrame> frameOf(const GapBorder& first, const GapBorder& second);
  /// The distance along a frame by which vertices of a link can be off from being across from each other.
  static constexpr double kMostOff = 2 * kAcross;
  /// The frame of a link between a piece of each. Its ways run from end to end of these pieces where such ways are
  /// parallel and meet the borders at a sufficient angle.
  [[nodiscard]] static std::optional<GapFrame> frameOf(const GapBorder& first, const GapBorder& second,
                                                       const std::array<GapBorder, 2>& pieces);

  /// The pieces of two borders that face each other within the gap and have no obstacle over them, in their order.
  [[nodiscard]] std::vector<GapPiece> find(const GapBorder& first, const GapBorder& second);
  /// The piece where two borders face each other within the gap, whatever obstacles are over it; empty if there is
  /// none.
  [[nodiscard]] std::optional<GapPiece> findNear(const GapBorder& first, const GapBorder& second) const;
  /// The pieces of `near` without obstacles, in their order.
  [[nodiscard]] std::vector<GapPiece> findFree(const GapBorder& first, const GapBorder& second, const GapPiece& near);

 private:
  /// A corner of an obstacle in the frame.
  using Corner = std::array<double, 3>;

  /// Lets the ways at the ends of a piece lead from corner to corner, where the piece nearly reaches a corner of either
  /// border and all ways stay free. Ways at a right angle to the bisector would leave a wedge where the next two
  /// borders go on in another direction (a curved flight of stairs whose risers lean). Nothing is linked in a wedge, so
  /// that a margin would be cut out around it, however small it is.
  void leadToCorners(const GapBorder& first, const GapBorder& second, GapPiece& piece);
  /// The piece with ways between the first border's `places[0]` and the second border's `places[1]`, which are low and
  /// high along its frame; empty where one of the ways is not free.
  [[nodiscard]] std::optional<GapPiece> findBetween(const GapBorder& first, const GapBorder& second,
                                                    const GapPiece& piece,
                                                    const std::array<std::array<double, 2>, 2>& places);

  /// The pieces around the nearest places of both borders, with ways in the direction from one to the other; called
  /// where find() has no others. Where both places are ends, and such ways would meet one border only, the direction is
  /// turned until they meet both, as far as the gap allows and all ways between are free.
  [[nodiscard]] std::vector<GapPiece> findAtCorner(const GapBorder& first, const GapBorder& second);
  [[nodiscard]] std::optional<GapPiece> findNear(const GapBorder& first, const GapBorder& second, const GapFrame& frame,
                                                 double spare) const;
  /// The whole frame where both borders lie beside each other, if all of it is free.
  [[nodiscard]] std::optional<GapPiece> findWhole(const GapBorder& first, const GapBorder& second,
                                                  const GapFrame& frame);

  const SourceMesh& mesh_;
  const std::vector<char>& removed_;
  double step_, clearance_, gap_;
  std::optional<std::array<double, 2>> atLimit_;
  std::vector<std::int32_t> stack_;
};

}  // namespace footfall::detail
