// Sessions: an environment, how it is read, its pipeline and where one looks from, as JSON.
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
#include "ui/document/agent.hpp"
#include "ui/view/camera_pose.hpp"

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
  /// What features keep (SessionSection), as JSON texts by name.
  std::map<std::string, std::string> sections;
};

/// Extension of session files, without the dot.
inline constexpr const char* kSessionExtension = "footfall";

/// The environment is named relative to the folder of `path`, the file to be, when it lies in or below that folder's
/// parent: the two can be moved together.
std::string formatSession(const Session& session, const std::string& path);

/// Throws InputError "FILE: what; what to do"; no part of a session that is wrong somewhere is given back.
Session readSession(const std::string& path);

/// The same of a session's text; `path`, which its environment is relative to, is not in messages.
Session parseSession(const std::string& text, const std::string& path);

/// Whether the file says that it is a session, whatever its name; false when it cannot be read.
bool isSessionFile(const std::string& path);

}  // namespace footfall::ui
