// Paths as OBJ, and what separates places as text (footfall/report.hpp has the rest).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "footfall/report.hpp"

namespace footfall::detail {

/// Why no way leads from start to target, a line for each place: what is missing least, what else is on the same way,
/// other ways; with the triangles that stand there. Places in the frame of the environment's file.
std::string formatSeparation(const Environment& environment, const PathResult& path);

/// The path as one polyline (`g path`, one `l` element), in the frame and units of a file.
std::string formatPathObj(const SourceFrame& frame, const ExportHeader& header, const PathResult& path);

}  // namespace footfall::detail
