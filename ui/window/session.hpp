// Sessions as JSON: an environment, its import options, its pipeline and the camera position.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/environment/part_rules.hpp"
#include "core/environment/placed_obstacle.hpp"
#include "footfall/environment.hpp"
#include "footfall/pipeline.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/cells/cells_shown.hpp"
#include "ui/document/named_agent.hpp"
#include "ui/view/camera/camera_pose.hpp"

namespace footfall::ui {

struct Session {
  std::string environment;  ///< path; empty when nothing is loaded
  ImportOptions import;
  Pipeline pipeline;
  std::optional<CameraPose> camera;
  CellsShown cells;
  std::vector<NamedAgent> agents;
  int agent = 0;
  std::vector<PartRule> partRules;
  std::vector<PlacedObstacle> obstacles;
  /// Sections of features (SessionSection), as JSON texts by name.
  std::map<std::string, std::string> sections;
};

/// Extension of session files, without the dot.
inline constexpr const char* kSessionExtension = "footfall";

/// The environment is named relative to the folder of `path`, the target file, when it lies in or below that folder's
/// parent, so that both can be moved together.
std::string formatSession(const Session& session, const std::string& path);

/// Throws InputError "FILE: what; what to do"; a session with an error anywhere is not returned in part.
Session readSession(const std::string& path);

/// Parses the text of a session. Its environment is relative to `path`, which messages do not name.
Session parseSession(const std::string& text, const std::string& path);

/// Returns whether the content of the file is a session, whatever its name; false when it cannot be read.
bool isSessionFile(const std::string& path);

}  // namespace footfall::ui
