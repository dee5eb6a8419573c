// Where the window takes in features.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/base/commands.hpp"
#include "ui/base/message_bar.hpp"
#include "ui/base/panels.hpp"
#include "ui/base/session_sections.hpp"
#include "ui/base/status_line.hpp"
#include "ui/base/unit_choice.hpp"
#include "ui/view/view_tools.hpp"

namespace footfall::ui {

/// What every feature may use: places for its commands, panels, tools, texts and what it keeps, and the unit that
/// lengths are written in. What a feature works on (document, level, runs, view), its constructor asks for by name.
struct FeatureHost {
  QWidget& window;  ///< parent of features and their dialogs
  CommandRegistry& commands;
  Panels& panels;
  ViewTools& tools;
  StatusLine& status;
  MessageBar& messages;
  SessionSections& sections;
  UnitChoice& units;
};

}  // namespace footfall::ui
