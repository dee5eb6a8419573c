// The distance of every place of a walkable mesh from the border, computed once (docs/how-to/corridors.md).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/base/poll.hpp"
#include "core/mesh/field_surface.hpp"
#include "core/mesh/field_window.hpp"
#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

struct FieldOptions {
  /// Distances beyond it are not looked for.
  double bound = std::numeric_limits<double>::infinity();
};

/// For each walkable face, the features of the border that are nearest to some place of it, and through which stretches
/// of its sides they are.
///
/// D(p) is the least length, in the plan, of a straight walk over joined faces, steps and gaps from p to the border.
/// (The shortest walk to the border is straight: where it bent, there would be a border.)
///
/// How it is found: a feature is an edge of the border, or a corner of it that is not convex. Its rays spread from face
/// to face as windows, stretches of mesh edges on which no other feature is known to be nearer by a margin. Along an
/// edge, distances are linear or roots of quadratics, whose differences are linear or convex; so stretches are cut by
/// what holds at their ends alone.
///
/// What is proven. Let S be the larger extent of the mesh in x and y. Distances along an edge are computed with errors
/// below 2^-48 S. A window loses only what another feature is nearer at by margin() = 2^-40 S, less the error of a
/// root, which is looked at: where the difference at the end is not a quarter of the margin, nothing is cut. If F is
/// nearest at p, it is nearest at each place of the ray from p to F; so no window of F that the ray crosses is cut
/// there, and the face of p has F. Hence D(p) is never given too large by more than 2^-38 S. What doubles cannot decide
/// (a ray that touches a corner or runs along an edge) lets rays pass within 2^-46 S beside where they may: D(p) is
/// given too small by at most that for each face that a ray crosses. tests/reference/clearance.hpp has the same in
/// rational numbers.
///
/// The windows spread in rounds. In a round each edge takes what arrives in the order of features, on any thread; so
/// the result does not depend on threads. At the end, the envelope of each edge is computed anew with half the margin:
/// whatever is nearest up to that has arrived in any order of rounds.
class ClearanceField {
 public:
  /// Throws what `poll` throws; it is called every few milliseconds, from any thread. Takes time in proportion to the
  /// windows, about two for each mesh edge.
  explicit ClearanceField(const NavigationMesh& mesh, const FieldOptions& options = {}, Poll poll = {});

  struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    std::uint32_t feature = FieldEdge::kNone;
    FieldVector border;  ///< the feature's place that is nearest
  };
  /// The nearest feature to a place on a face, relative to the surface's origin. There is none where the border is
  /// farther than the bound.
  [[nodiscard]] Nearest at(std::uint32_t face, FieldVector p) const;
  /// The same for coordinates of the mesh.
  [[nodiscard]] Nearest at(std::uint32_t face, double x, double y) const {
    return at(face, FieldVector{x, y} - surface_.origin);
  }

  [[nodiscard]] const FieldSurface& surface() const { return surface_; }
  [[nodiscard]] const std::vector<FieldFeature>& features() const { return features_; }
  /// Ascending by `lo`. They overlap by what is as near up to the margin.
  [[nodiscard]] std::span<const FieldWindow> windowsOf(std::uint32_t edge) const {
    return std::span(windows_).subspan(starts_[edge], starts_[edge + 1] - starts_[edge]);
  }
  /// The feature that an edge of the border is, or FieldEdge::kNone.
  [[nodiscard]] std::uint32_t featureOfEdge(std::uint32_t edge) const { return edgeFeatures_[edge]; }
  /// The feature that the corner of a fan of the topology is, or FieldEdge::kNone.
  [[nodiscard]] std::uint32_t featureOfFan(std::uint32_t fan) const { return fanFeatures_[fan]; }
  [[nodiscard]] double margin() const { return 0x1p-40 * surface_.scale; }
  /// The distance from its place at which a ray may pass.
  [[nodiscard]] double tolerance() const { return 0x1p-46 * surface_.scale; }

 private:
  friend class FieldSpread;

  FieldSurface surface_;
  std::vector<FieldFeature> features_;
  std::vector<std::uint32_t> edgeFeatures_, fanFeatures_;
  std::vector<FieldWindow> windows_;
  std::vector<std::size_t> starts_;
};

}  // namespace footfall::detail
