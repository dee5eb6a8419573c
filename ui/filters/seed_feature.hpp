// The seeds of the filter list in the view, and the command that places them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QObject>

#include "ui/filters/filter_list.hpp"
#include "ui/filters/seed_tool.hpp"
#include "ui/view/feature_host.hpp"

namespace footfall::ui {

/// The filter is the current row, if it has seeds, else the last one that has. Its seeds are drawn while the tool is
/// active and while its row is the current one.
class SeedFeature : public QObject {
  Q_OBJECT

 public:
  SeedFeature(const FeatureHost& host, LevelView& view, Document& document, RunController& controller,
              FilterList& list);

  [[nodiscard]] const SeedTool& tool() const { return tool_; }

 private:
  void follow();

  Document& document_;
  LevelView& view_;
  FilterList& list_;
  SeedTool tool_;
  QAction* place_;
};

}  // namespace footfall::ui
