// The commands of the filter list, the history of edits, agents, and running by hand.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace footfall::ui {

class Document;
class FilterList;
class LevelView;
class RunController;
struct FeatureHost;

void addFilterTools(const FeatureHost& host, LevelView& view, Document& document, RunController& controller,
                    FilterList& list);

}  // namespace footfall::ui
