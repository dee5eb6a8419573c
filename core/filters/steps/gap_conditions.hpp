// Where an agent steps over a gap between two borders that lie apart in the plan (design section 7, StepFilter).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two borders E and F that face each other are looked at along the bisector of their directions: at u on it, p(u) lies
// on E, q(u) on F, and pq is at a right angle to the bisector. A piece, an interval of u, is free when for all its u
// - |pq| <= gap; q is then no nearest point of F, but the nearest one is nearer;
// - |z(p) - z(q)| <= step;
// - nothing of the environment lies over pq strictly between min z + step and max z + clearance.
// All of this is computed in doubles and asked with kSlack to spare, against which their errors are nothing: what is
// found is so. What holds with 2^-40 of the largest coordinate to spare is found, except that |pq| is 1 / cos(a / 2)
// times the distance from p to F where the borders include an angle a, and that an end is drawn in by kSlack where an
// obstacle makes it. Where nothing is free so, the direction of the shortest way takes the place of a right angle to
// the bisector (findAtCorner()): a corner may be nearer to a border, or to another corner, than what lies straight
// across. Horizontal borders and obstacles that touch a limit exactly (a door that is as high as the
// clearance) are compared exactly. Slits that are as wide as the gap, and obstacles that touch the end of a piece, are
// left to the caller, who compares exactly, the obstacles with the line there: single points do not count.
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
  std::optional<double> level;  ///< its height, where that is one and known exactly
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

/// The second border lies to the right of the first one; ends are low and high along the first one.
struct GapPiece {
  GapFrame frame;
  std::array<double, 2> ends{};
  std::array<std::vector<Index>, 2> touching;  ///< obstacles at each end that must be proven to lie beyond it
  bool isAsWide = false;                       ///< as wide as the gap may be, within rounding: must be proven not wider
  /// A place of the first border at a corner, where both run apart at a large angle, or in the middle of a piece of at
  /// most kShortInGaps gaps: a link is needed only where it leads somewhere (NeedlessGaps).
  std::optional<Vec3> corner = {};
};

class GapConditions {
 public:
  /// Doubles at the largest coordinate are so far apart; scaled.
  static constexpr double kUnit = 0x1p-17;
  static constexpr double kSlack = 512 * kUnit;
  /// Places of two borders that are nearer along a gap are across from each other. Each is that near to where it is
  /// due, so together they use up the slack, and no more.
  static constexpr double kAcross = kSlack / 2;
  /// Places so near to each other are taken as one.
  static constexpr double kSnap = 128 * kUnit;
  /// Shorter borders have no direction, and are not linked over gaps.
  static constexpr double kShort = 4096 * kUnit;

  /// A piece that is no longer, in widths of the gap, is seen whole from its middle within twice the gap.
  static constexpr double kShortInGaps = 2;

  /// Lengths are scaled. `removed`: for each source triangle, it is out of the environment.
  GapConditions(const SourceMesh& mesh, const std::vector<char>& removed, double step, double clearance, double gap)
      : mesh_(mesh), removed_(removed), step_(step), clearance_(clearance), gap_(gap) {}

  /// Least sine of the angle at which a way leaves a border or comes to one, and of the angle that is missing to a
  /// right one between two borders: 7 degrees.
  static constexpr double kLeastSine = 0.125;

  /// The frame of two borders that face each other: its ways are at a right angle to their bisector.
  [[nodiscard]] static std::optional<GapFrame> frameOf(const GapBorder& first, const GapBorder& second);
  /// The same for a link between a piece of each: its ways are those from end to end of these.
  [[nodiscard]] static std::optional<GapFrame> frameOf(const GapBorder& first, const GapBorder& second,
                                                       const std::array<GapBorder, 2>& pieces);

  /// The pieces of two borders that face each other, near enough, over which nothing stands, in their order.
  [[nodiscard]] std::vector<GapPiece> find(const GapBorder& first, const GapBorder& second);
  /// Where two borders face each other near enough, whatever stands between them; or nothing.
  [[nodiscard]] std::optional<GapPiece> findNear(const GapBorder& first, const GapBorder& second) const;
  /// The pieces of `near` over which nothing stands, in their order.
  [[nodiscard]] std::vector<GapPiece> findFree(const GapBorder& first, const GapBorder& second, const GapPiece& near);

 private:
  /// A corner of an obstacle in the frame.
  using Corner = std::array<double, 3>;

  /// Where nothing is found so: pieces about the nearest places of both, with ways in the direction from one to the
  /// other. Where both are ends and lie so that such ways meet one border only, the direction is turned until they meet
  /// both, as far as the gap allows and all ways between are free.
  [[nodiscard]] std::vector<GapPiece> findAtCorner(const GapBorder& first, const GapBorder& second);
  [[nodiscard]] std::optional<GapPiece> findNear(const GapBorder& first, const GapBorder& second, const GapFrame& frame,
                                                 double spare) const;
  /// All of a frame where both borders lie beside each other, if all of it is free.
  [[nodiscard]] std::optional<GapPiece> findWhole(const GapBorder& first, const GapBorder& second,
                                                  const GapFrame& frame);

  const SourceMesh& mesh_;
  const std::vector<char>& removed_;
  double step_, clearance_, gap_;
  std::vector<std::int32_t> stack_;
};

}  // namespace footfall::detail
