// Divides a packed environment into cells, ranges of faces, by the content of its blocks.
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

/// The findings of one pass over each block.
struct BlockSurvey {
  Grid grid;                          ///< grid of all vertices but those of ignored faces alone
  std::vector<std::uint32_t> floors;  ///< number of faces of each block that may be floors

  /// Puts the blocks of another one behind those of this one.
  void add(const BlockSurvey& other);
};

/// Surveys the blocks from `first` up to, not including, `last`. Keeps none of them.
BlockSurvey surveyOf(const PackedEnvironment& environment, const CellCollector& collector, std::size_t first,
                     std::size_t last, RunContext& context);

std::string encodeSurvey(const BlockSurvey& survey);
/// Throws BadBytes.
BlockSurvey decodeSurvey(std::string_view bytes);

/// The limits of a cell's size.
struct CellLimits {
  std::uint64_t bytes = 0;
  std::uint64_t perFace = 0, perFloor = 0;  ///< bytes while a cell runs
  std::uint64_t perKeptFloor = 0;           ///< bytes, without those of faces, when it ran
  std::uint64_t mostFaces = ~0ULL;
};

/// The memory that a cell of these faces takes while it runs, by the limits. Floors count as evenly spread within a
/// block. `floors` are those of each block of the environment, here and below.
std::uint64_t runningBytes(std::span<const PackedBlock> blocks, std::span<const std::uint32_t> floors,
                           const FaceRange& faces, const CellLimits& limits);

/// Divides the faces into as few cells as the limits let there be, all of them with about as many bytes.
std::vector<FaceRange> planCells(std::span<const PackedBlock> blocks, std::span<const std::uint32_t> floors,
                                 const FaceRange& faces, const CellLimits& limits);

}  // namespace footfall::detail
