// What a RadiusFilter keeps beside its result, so that a later run need not find it again.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each run makes a generation of its own, whose numbers mean nothing in another one. So what was cut out of a face is
// found by coordinates: of the face's corners, and of the polygons that were cut out, in their order. What comes of it
// follows from these and from the order of the numbers of all these places, by which equal lines are told apart. Both
// are compared; then new numbers take the place of the old ones.
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

/// What was cut out of one face, and what that left.
struct CutFace {
  std::array<Vec3, 3> corners;  ///< scaled
  std::uint8_t obstacleEdges = 0;
  std::vector<Index> sizes;  ///< of the polygons
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
  /// Of a kernel, whose grid decides what doubles know.
  explicit CutFaces(const PlanKernel& kernel)
      : scaleExponent_(kernel.mesh().grid.scaleExponent()), slack_(kernel.sign().slack) {}

  void add(const PlanKernel& kernel, Index face, PlanPolygons polygons, std::shared_ptr<const FaceCuts> cuts,
           std::shared_ptr<const FaceMesh> mesh);
  struct Found {
    std::shared_ptr<const FaceCuts> cuts;
    std::shared_ptr<const FaceMesh> mesh;
  };
  /// In numbers of the kernel, whose generation may be another one; nothing where it is not known.
  [[nodiscard]] std::optional<Found> find(const PlanKernel& kernel, Index face, PlanPolygons polygons) const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  int scaleExponent_;
  double slack_;
  std::unordered_map<std::array<Vec3, 3>, CutFace, CutFaceHash> faces_;
};

struct RadiusMemory {
  explicit RadiusMemory(const PlanKernel& kernel) : cutFaces(kernel) {}
  StatePtr simplified;  ///< what was narrowed
  CoveredParts covered;
  CutFaces cutFaces;
};

/// In bytes, without the simplified state.
std::size_t bytesOf(const RadiusMemory& memory);

}  // namespace footfall::detail
