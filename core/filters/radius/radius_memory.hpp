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
#include <utility>
#include <vector>

#include "core/assembly/face_mesh.hpp"
#include "core/assembly/recall.hpp"
#include "core/base/copy_memory.hpp"
#include "core/exact/face_cuts.hpp"
#include "core/filters/rounding/generation.hpp"
#include "core/filters/rounding/known_places.hpp"

namespace footfall::detail {

/// Polygons of the plan as spans of plan ids.
using PlanPolygons = std::span<const std::span<const Index>>;

/// The polygons that were cut out of one face, and the remainder.
struct CutFace {
  std::array<Vec3, 3> corners;  ///< scaled
  std::uint8_t obstacleEdges = 0;
  std::shared_ptr<const FaceCuts> cuts;
  std::shared_ptr<const FaceMesh> mesh;  ///< null where nothing or all is cut away
  // Starts in the lists of CutFaces, which end where those of the next face begin.
  std::size_t firstSize = 0, firstPlace = 0, firstId = 0;
};

/// The memory that one thread needs to renumber cuts.
struct CutCopies {
  CopyMemory memory = makeCopyMemory();
  std::vector<Index> ids;
  std::vector<std::pair<Index, Index>> numbers;
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
  [[nodiscard]] std::optional<Found> find(const PlanKernel& kernel, Index face, PlanPolygons polygons,
                                          CutCopies& copies) const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  [[nodiscard]] std::size_t slotOf(const std::array<Vec3, 3>& corners) const;
  void growTable();
  /// True when the polygons are those of a face. `ids` receives the present ids of its corners and of all places.
  [[nodiscard]] bool hasPolygons(std::size_t number, const SourceMesh& source, Index face, PlanPolygons polygons,
                                 std::vector<Index>& ids) const;

  int scaleExponent_;
  double slack_;
  std::vector<CutFace> faces_;
  std::vector<Index> sizes_;  ///< of polygons
  std::vector<Vec3> places_;  ///< scaled: the corners of polygons
  std::vector<Index> ids_;    ///< plan ids: of a face's corners, then of its places
  std::vector<Index> slots_;  ///< numbers of faces by the hash of their corners, or -1; a power of two
  std::size_t ofParts_ = 0;   ///< bytes of cuts and meshes
};

struct RadiusMemory {
  explicit RadiusMemory(const PlanKernel& kernel) : cutFaces(kernel) {}
  StatePtr simplified;                           ///< area that was narrowed
  std::shared_ptr<const RoundedPlaces> places;   ///< of its vertices
  std::shared_ptr<const SourceMesh> generation;  ///< without the margins
  CoveredParts covered;
  CutFaces cutFaces;
};

/// The size in bytes, without the simplified state.
std::size_t bytesOf(const RadiusMemory& memory);

}  // namespace footfall::detail
