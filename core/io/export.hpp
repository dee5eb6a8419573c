// Writing the navigation mesh as OBJ (design section 6); other formats: gltf_export.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>

#include "footfall/edit.hpp"
#include "footfall/environment.hpp"
#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

/// Comment lines at the top of an export.
struct ExportHeader {
  std::string pipeline;   ///< formatPipeline(), one filter a line
  std::string agent;      ///< e.g. "slope 45 degrees, height 2"
  std::string note = {};  ///< anything else, such as that coordinates are scaled
};

/// What is written, and in which frame. As it stands here, an OBJ lies exactly on the file that it came from.
struct ExportOptions {
  bool layers = true;         ///< false: one group "walkable"
  bool connections = true;    ///< the lines; what is connected stays so by its indices
  bool obstacleEdges = true;  ///< the lines; what is apart stays so by its indices
  std::optional<UpAxis> up;   ///< empty: the file's
  /// Coordinates are multiplied with it. They are rounded once more then, unless it is a power of two: triangles much
  /// smaller than their coordinates can collapse.
  double scale = 1;
};

/// Something else to be seen beside the walkable area, such as an obstacle that was placed: a group of its own,
/// "placed_NAME", behind everything.
struct ExportExtra {
  std::string name;
  TriangleSoup soup;
};

/// Throws InputError for a scale that is not above 0 or not finite, or makes coordinates infinite.
void checkScale(const ExportOptions& options, const NavigationMesh& mesh);

/// The OBJ text, in the frame and units of the environment's file unless `options` say otherwise; then its comments
/// state the frame and the units that it is in. Same input, same bytes.
std::string formatObj(const NavigationMesh& mesh, const Environment& environment, const ExportHeader& header,
                      const ExportOptions& options = {}, std::span<const ExportExtra> extras = {});

/// Writes beside `path` and renames, so that a failure or a kill leaves an earlier file as it was. Throws RunError
/// with what, where and what to do (read-only target, full disk, missing folder, a directory).
void writeObj(const std::string& path, const NavigationMesh& mesh, const Environment& environment,
              const ExportHeader& header, const ExportOptions& options = {}, std::span<const ExportExtra> extras = {});

/// Throws RunError where writeFileSafely() would, as far as that is known without writing: a folder, a missing folder,
/// no permission, a name that is too long.
void checkWritable(const std::string& path);

/// The same safe writing for any text (statistics, sessions, pipelines).
void writeFileSafely(const std::string& path, const std::string& text);

}  // namespace footfall::detail
