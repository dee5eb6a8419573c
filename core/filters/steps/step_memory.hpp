// Data that a StepFilter keeps with its result, so that a later run need not try the same pairs of borders again.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "core/filters/steps/border_splits.hpp"
#include "core/filters/steps/gap_linker.hpp"
#include "core/mesh/walkable_mesh.hpp"

namespace footfall::detail {

/// Two borders, and the stretch over which an agent steps, in the direction of the first one.
struct StepStretch {
  Index first = -1, second = -1;
  MeshVertex begin, end;
};

/// All findings between pairs of borders, before anything was split.
struct StepFindings {
  std::vector<StepStretch> stretches;           ///< sorted by their borders
  std::vector<GapStretch> gaps;                 ///< sorted by their borders
  std::vector<std::array<Index, 2>> undecided;  ///< pairs, once for each occurrence, sorted
};

struct StepMemory {
  std::shared_ptr<const WalkableMesh> given;  ///< the mesh that was linked
  double step = 0, height = 0, gap = 0;
  std::vector<MeshBorder> borders;
  StepFindings found;
};

/// The size in bytes, without the mesh.
std::size_t bytesOf(const StepMemory& memory);

}  // namespace footfall::detail
