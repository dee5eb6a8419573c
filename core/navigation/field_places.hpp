// Places of the clearance field in space: heights on its faces and along the border.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "core/mesh/clearance_field.hpp"
#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

/// Made from a mesh, the same mesh with bridges over its gaps, and its field. All three must outlive it.
class FieldPlaces {
 public:
  FieldPlaces(const NavigationMesh& mesh, const NavigationMesh& bridged, const ClearanceField& field)
      : mesh_(mesh), bridged_(bridged), field_(field) {}

  /// A place of the plan on a face, or just beside it.
  [[nodiscard]] Vec3 onFace(std::uint32_t face, FieldVector p) const;
  /// The triangle of the mesh itself that is a face, or one beside a bridge.
  [[nodiscard]] std::uint32_t underFace(std::uint32_t face) const;
  /// The place of a feature that is nearest to `p` in the plan.
  [[nodiscard]] Vec3 onBorder(std::uint32_t feature, FieldVector p) const;
  /// The face in which a place lies, or the one that it is least outside of; `faces` has one at least.
  [[nodiscard]] std::uint32_t faceAt(std::span<const std::uint32_t> faces, FieldVector p) const;

 private:
  const NavigationMesh& mesh_;
  const NavigationMesh& bridged_;
  const ClearanceField& field_;
};

}  // namespace footfall::detail
