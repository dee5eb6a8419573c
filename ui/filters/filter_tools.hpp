// What belongs to the filter list in the window: commands, the history of edits, agents, and running by hand.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace footfall::ui {

class EditorWindow;

void addFilterTools(EditorWindow& window);

}  // namespace footfall::ui
