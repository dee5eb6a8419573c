// Reading buildings (IFC) through a separate converter (installer/ifc).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The converter runs web-ifc in Node.js and writes OBJ with a few comments; installer/ifc.sh installs it. It cuts
// openings, reads IFC 2x3 and IFC 4, and keeps classes, storeys and units, all of which Assimp does not.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/child_process.hpp"
#include "core/io/file_frame.hpp"
#include "footfall/environment.hpp"
#include "footfall/run_context.hpp"
#include "footfall/text.hpp"

namespace footfall::detail {

/// The path of the converter: the file that the environment variable FOOTFALL_IFC names, else
/// footfall/ifc/footfall-ifc.mjs in XDG_DATA_HOME (or ~/.local/share) or in one of XDG_DATA_DIRS. Empty when it is not
/// found.
std::optional<std::string> findIfcConverter();

/// The command that installs the converter, as typed in a terminal: the path of ifc.sh of the sources or of an
/// installation, which is looked for beside the program or library. Empty when it is not found.
std::optional<std::string> ifcInstallCommand();

/// The advice that says how the converter is installed: by ifcInstallCommand(), or where to read about it.
Text adviceOnIfcConverter();

/// Fills `vertices`, `triangles`, `parts`, `partOf`, `usualRoles` and `storeys` in the file's own frame. A part is an
/// element's class (`mesh`) with its storey and name (`material`). Throws InputError for an error that the converter
/// reports, and when it cannot be run or passes `limits`. Throws Cancelled, within 50 ms, when `context` (may be null)
/// was cancelled.
FileFrame readWithIfcConverter(const std::string& converter, const std::string& path, Environment& environment,
                               const ChildLimits& limits, RunContext* context);

/// The role of a class of IFC elements. Doors are open. Classes without a solid, such as spaces and annotations, are
/// absent. Furniture, fittings, windows and railings are obstacles that nobody walks on.
PartRole usualRoleOfClass(std::string_view ifcClass);

}  // namespace footfall::detail
