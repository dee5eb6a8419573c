// Which faces of a packed environment are a cell each, by what its blocks hold.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/exact/grid.hpp"
#include "core/io/packed/packed_environment.hpp"
#include "core/tiles/cell_faces.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// What looking at each block once tells.
struct BlockSurvey {
  Grid grid;                          ///< of all vertices but those that ignored faces alone have
  std::vector<std::uint32_t> floors;  ///< of each block: faces that may be floors

  /// Puts the blocks of another one behind those of this one.
  void add(const BlockSurvey& other);
};

/// Of the blocks from `first` on that are before `last`. Keeps none of them.
BlockSurvey surveyOf(const PackedEnvironment& environment, const CellCollector& collector, std::size_t first,
                     std::size_t last, RunContext& context);

std::string encodeSurvey(const BlockSurvey& survey);
/// Throws BadBytes.
BlockSurvey decodeSurvey(std::string_view bytes);

/// How much a cell may take.
struct CellLimits {
  std::uint64_t bytes = 0;
  std::uint64_t perFace = 0, perFloor = 0;  ///< bytes while a cell runs
  std::uint64_t perKeptFloor = 0;           ///< bytes, without those of faces, when it ran
  std::uint64_t mostFaces = ~0ULL;
};

/// What a cell of these faces takes while it runs, by the limits. Within a block, floors are taken for evenly spread.
/// `floors` are those of each block of the environment, here and below.
std::uint64_t runningBytes(std::span<const PackedBlock> blocks, std::span<const std::uint32_t> floors,
                           const FaceRange& faces, const CellLimits& limits);

/// Divides the faces into as few cells as the limits let there be, all of them with about as many bytes.
std::vector<FaceRange> planCells(std::span<const PackedBlock> blocks, std::span<const std::uint32_t> floors,
                                 const FaceRange& faces, const CellLimits& limits);

}  // namespace footfall::detail
