// Keeps cells in the view, in the legend and in the load panel in step with runs, edits and each other.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>

#include "ui/base/latest_work.hpp"
#include "ui/cells/cell_legend.hpp"
#include "ui/cells/cell_model.hpp"
#include "ui/cells/cell_preview.hpp"
#include "ui/cells/load_panel.hpp"
#include "ui/document/document.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/view/level_view.hpp"

namespace footfall::ui {

/// Whether cells are in the view is SceneParts::cells; their geometry is made in the background, and only then.
class CellWatch : public QObject {
  Q_OBJECT

 public:
  CellWatch(Document& document, RunController& controller, LevelView& view, CellModel& model,
            QObject* parent = nullptr);

  void setEnvironment(std::shared_ptr<const Environment> environment, const Vec3& centre);
  /// The same level with something changed: the cells in sight stay until the next run has its own.
  void editEnvironment(std::shared_ptr<const Environment> environment);
  /// Shows the cells that the strategy of a filter entry would make, without a run; until the next run has cells.
  void preview(int id);
  /// The strategy whose cells a preview would show when nothing else is said: the first one; -1 when there is none.
  [[nodiscard]] int firstStrategy() const;
  /// The view's geometry belongs to the model's cells.
  [[nodiscard]] bool upToDate() const { return !draping_.busy() && !preview_.busy(); }
  /// The caller says when the view shows cells or does not any more, and the same of the load panel. What is not shown
  /// is not previewed unless it is asked for.
  void showCells(bool on);
  void showLoad(bool on) { loadShown_ = on; }

  [[nodiscard]] CellPreview& cellPreview() { return preview_; }

 signals:
  void previewFailed(const QString& message);
  /// Whether the filter list has an enabled strategy.
  void blockChanged(bool hasBlock);

 private:
  void takeFilters();
  void drape();
  void mark();
  [[nodiscard]] CellColours colours() const;

  Document& document_;
  RunController& controller_;
  LevelView& view_;
  CellModel& model_;
  std::shared_ptr<const Environment> environment_;
  Vec3 centre_;
  bool shown_ = false, loadShown_ = false;
  CellModel::Shapes draped_;          ///< what the view has, or will have when it is there
  std::vector<FilterEntry> filters_;  ///< as they were when they were last looked at
  int edited_ = -1;                   ///< the strategy that an edit has changed
  QTimer editTimer_;
  CellPreview preview_;
  LatestWork draping_;  // last: its thread ends before the rest goes
};

}  // namespace footfall::ui
