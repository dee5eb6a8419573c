// The services of the window that features use.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/base/commands/commands.hpp"
#include "ui/base/files/session_sections.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/base/messages/status_line.hpp"
#include "ui/base/text/unit_choice.hpp"
#include "ui/base/widgets/panels.hpp"
#include "ui/view/view_tools.hpp"

namespace footfall::ui {

/// The services for every feature: its commands, panels, tools, texts and session sections, and the unit of lengths. A
/// feature's constructor names the objects that it works on (document, level, runs, view).
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
