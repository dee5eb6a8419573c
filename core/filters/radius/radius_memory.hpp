// The data that a RadiusFilter keeps beside its result, so that a later run need not compute it again.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each run makes a generation of its own, whose numbers are meaningless in another one. So cuts of a face are found by
// coordinates: of the face's corners, and of the polygons that were cut out, in their order. The result depends on
// these and on the order of the numbers of all these places, by which equal lines are distinguished. Both are compared;
// then new numbers take the place of the old ones.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/assembly/face_mesh.hpp"
#include "core/assembly/recall.hpp"
#include "core/exact/face_cuts.hpp"
#include "core/filters/rounding/generation.hpp"

namespace footfall::detail {

/// Polygons of the plan as spans of plan ids.
using PlanPolygons = std::span<const std::span<const Index>>;

/// The polygons that were cut out of one face, and the remainder.
struct CutFace {
  std::array<Vec3, 3> corners;  ///< scaled
  std::uint8_t obstacleEdges = 0;
  std::vector<Index> sizes;  ///< sizes of the polygons
  std::vector<Vec3> places;  ///< scaled: the corners of all polygons
  std::vector<Index> ids;    ///< plan ids: of the face's corners, then of the places
  std::shared_ptr<const FaceCuts> cuts;
  std::shared_ptr<const FaceMesh> mesh;  ///< null where nothing or all is cut away
};

struct CutFaceHash {
  std::size_t operator()(const std::array<Vec3, 3>& corners) const;
};

/// Faces of one generation.
class CutFaces {
 public:
  /// Made for a kernel, whose grid decides what doubles resolve.
  explicit CutFaces(const PlanKernel& kernel)
      : scaleExponent_(kernel.mesh().grid.scaleExponent()), slack_(kernel.sign().slack) {}

  void add(const PlanKernel& kernel, Index face, PlanPolygons polygons, std::shared_ptr<const FaceCuts> cuts,
           std::shared_ptr<const FaceMesh> mesh);
  struct Found {
    std::shared_ptr<const FaceCuts> cuts;
    std::shared_ptr<const FaceMesh> mesh;
  };
  /// The cuts in numbers of the kernel, whose generation may be another one; nothing if they are unknown.
  [[nodiscard]] std::optional<Found> find(const PlanKernel& kernel, Index face, PlanPolygons polygons) const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  int scaleExponent_;
  double slack_;
  std::unordered_map<std::array<Vec3, 3>, CutFace, CutFaceHash> faces_;
};

struct RadiusMemory {
  explicit RadiusMemory(const PlanKernel& kernel) : cutFaces(kernel) {}
  StatePtr simplified;  ///< area that was narrowed
  CoveredParts covered;
  CutFaces cutFaces;
};

/// The size in bytes, without the simplified state.
std::size_t bytesOf(const RadiusMemory& memory);

}  // namespace footfall::detail
