// Writing a cut environment as OBJ: the cells as groups.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/io/export.hpp"
#include "core/partitioning/cutting.hpp"

namespace footfall::detail {

/// The OBJ text, in the frame and units of the environment's file: the groups `g cell_0`, `g cell_1`, ... of
/// `cellCount` cells, those without triangles included, with vertices shared by index. Same input, same bytes.
std::string formatCutObj(const CutEnvironment& cut, std::size_t cellCount, const Environment& environment,
                         const ExportHeader& header);

/// Writes as writeObj() does.
void writeCutObj(const std::string& path, const CutEnvironment& cut, std::size_t cellCount,
                 const Environment& environment, const ExportHeader& header);

}  // namespace footfall::detail
