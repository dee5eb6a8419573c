// Writing the navigation mesh as OBJ (design section 6).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/environment/environment.hpp"
#include "core/environment/navigation_mesh.hpp"

namespace footfall {

/// Comment lines at the top of an export.
struct ExportHeader {
  std::string pipeline;  ///< formatPipeline(), one filter a line
  std::string agent;     ///< e.g. "slope 45 degrees, height 2"
};

/// The OBJ text, in the frame and units of the environment's file. Same input, same bytes.
std::string formatObj(const NavigationMesh& mesh, const Environment& environment, const ExportHeader& header);

/// Writes beside `path` and renames, so that a failure or a kill leaves an earlier file as it was. Throws RunError
/// with what, where and what to do (read-only target, full disk, missing folder, a directory).
void writeObj(const std::string& path, const NavigationMesh& mesh, const Environment& environment,
              const ExportHeader& header);

/// The same safe writing for any text (statistics, sessions, pipelines).
void writeFileSafely(const std::string& path, const std::string& text);

}  // namespace footfall
