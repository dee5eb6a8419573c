// Divides a face among the pieces of the border that are nearest to its places.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/base/poll.hpp"
#include "core/mesh/clearance_field.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/previews/convex_cutter.hpp"

namespace footfall::ui {

/// A part of a face, relative to the field's origin, from each of whose places a straight way leads to a piece of the
/// border.
struct FacePart {
  ConvexPolygon polygon;
  const detail::FieldFeature* feature = nullptr;
  /// The range in which other parts of the face have a share of its places and are farther from their pieces: the least
  /// distance of such places from its own piece, and the largest from the others'. The first is larger where there are
  /// none.
  double sharedFrom = 1, sharedTo = 0;
};

/// Finds the parts of faces. Each place of a face is in a part of its nearest piece of the border (up to rounding), if
/// the field has one; it may be in others as well.
class FaceDivider {
 public:
  /// The field must outlive it.
  FaceDivider(const detail::ClearanceField& field, double bound, Poll poll)
      : field_(field), bound_(bound), poll_(std::move(poll)) {}

  /// `corners`: of the face, relative to the field's origin. Good until the next call. Empty for a face with too many
  /// parts.
  const std::vector<FacePart>& divide(std::uint32_t face, const ConvexPolygon& corners);
  /// Returns whether the last face had too many parts.
  [[nodiscard]] bool hasTooMany() const { return whole_.size() > kMostOfFace; }

 private:
  /// Each part of a face is compared with all others.
  static constexpr std::size_t kMostOfFace = 1000;

  /// A linear function of places in the plan.
  struct Linear {
    detail::FieldVector slope;
    double offset = 0;
    [[nodiscard]] double at(const Vec3& p) const { return slope.x * p.x + slope.y * p.y + offset; }
  };

  void addWindow(const ConvexPolygon& corners, const detail::FieldFeature& feature, detail::FieldVector lo,
                 detail::FieldVector hi);
  /// Adds the places of a face at a corner of the border that are before none of the two edges there: before an edge,
  /// the edge is nearer.
  void addCone(const ConvexPolygon& corners, const detail::FieldCorner& at, const detail::FieldFeature& feature);
  void add(const ConvexPolygon& polygon, const detail::FieldFeature& feature);
  /// Takes out of a part what is in another part and certainly nearer to its piece of the border.
  void takeOut(FacePart& part, const FacePart& other);
  /// Finds a linear function that is above the slack only where the part's piece is farther than the other one.
  [[nodiscard]] bool findFarther(const FacePart& part, const FacePart& other, Linear& farther) const;
  [[nodiscard]] bool contains(const ConvexPolygon& polygon, const Vec3& p) const;
  /// Sets the range of a part's places that another part has as well.
  void addShare(FacePart& part, const FacePart& other);
  [[nodiscard]] double slack() const { return 1e-9 * bound_; }

  const detail::ClearanceField& field_;
  double bound_;
  Poll poll_;
  /// The turns of the faces around a corner of the border, from its first edge.
  struct Fan {
    std::map<std::array<std::uint32_t, 2>, std::array<double, 2>> turns;  ///< before each face, and of it
    double whole = 0;
    detail::FieldVector last;  ///< direction of the last edge
  };
  const Fan& fanAt(const detail::FieldFeature& feature);
  std::unordered_map<const detail::FieldFeature*, Fan> fans_;
  ConvexCutter cutter_;
  std::vector<FacePart> whole_, parts_;
};

/// The least and the largest distance of a polygon's places from a piece of the border before which it lies.
std::array<double, 2> distancesOf(const ConvexPolygon& polygon, const detail::FieldFeature& feature);

}  // namespace footfall::ui
