// The figures of a run into tiles, as JSON and as a line of text.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "core/tiles/tile_run.hpp"

namespace footfall::detail {

/// The largest peak of memory among this process and all ranks, in bytes.
std::uint64_t peakOf(const TileRunResult& result);

/// The statistics as JSON. `source` is the path of the environment; `memory` is the bound, in bytes.
std::string formatTileStatistics(const std::string& source, std::uint64_t memory, const TileRunResult& result);

/// One line with the numbers of tiles and triangles in `folder`, and the peak of memory.
std::string tileSummary(const std::string& folder, const TileRunResult& result);

}  // namespace footfall::detail
