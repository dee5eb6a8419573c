// Buildings in IFC, by a converter that is a program of its own (installer/ifc.sh installs it).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/io/assimp_reader.hpp"
#include "footfall/text.hpp"

namespace footfall::detail {

/// The converter, ifc_to_obj.mjs with web-ifc beside it: what the variable FOOTFALL_IFC names (empty: none is used), or
/// else in footfall/ifc of the user's data (XDG_DATA_HOME, ~/.local/share), of /usr/local/share, or of /usr/share.
/// Empty where there is none.
std::string findIfcConverter();

/// Fills the environment as readObj() does with what the converter makes of the file: parts with the class of their
/// element as material and "STOREY: NAME (ID)" as mesh, openings cut, doors and what has no body left out. It needs
/// Node.js. Nothing where that or the converter is missing: Assimp reads such files as well, if less well. Throws
/// InputError with what the converter says when it fails, and Cancelled, which ends it.
std::optional<FileFrame> readIfc(const std::string& path, Environment& environment, RunContext* context);

/// For a file that is IFC while there is no converter: what is lost by that, and how to get it. Else empty.
Text missingIfcConverter(const std::string& path);

/// Whether the elements of an IFC class are obstacles that nobody walks on: furniture.
bool isIfcFurniture(const std::string& material);

}  // namespace footfall::detail
