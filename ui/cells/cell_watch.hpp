// Keeps the cells in the view, the legend and the load panel consistent with runs and edits.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>

#include "ui/base/work/latest_work.hpp"
#include "ui/cells/cell_legend.hpp"
#include "ui/cells/cell_model.hpp"
#include "ui/cells/cell_preview.hpp"
#include "ui/cells/load_panel.hpp"
#include "ui/document/document.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/view/level_view.hpp"

namespace footfall::ui {

/// SceneParts::cells decides whether the view shows cells; their geometry is made in the background, and only then.
class CellWatch : public QObject {
  Q_OBJECT

 public:
  CellWatch(Document& document, RunController& controller, LevelView& view, CellModel& model,
            QObject* parent = nullptr);

  void setEnvironment(std::shared_ptr<const Environment> environment, const Vec3& centre);
  /// Sets the same level with a change; the visible cells stay until the next run has its own.
  void editEnvironment(std::shared_ptr<const Environment> environment);
  /// Shows the cells that the strategy of a filter entry would make, without a run, until the next run has cells.
  void preview(int id);
  /// The strategy that a preview shows by default: the first one; -1 when there is none.
  [[nodiscard]] int firstStrategy() const;
  /// Returns whether the view's geometry belongs to the model's cells.
  [[nodiscard]] bool upToDate() const { return !draping_.busy() && !preview_.busy(); }
  /// Called when the view, or the load panel, begins or ends to show cells. Hidden cells are not previewed unless a
  /// preview is requested.
  void showCells(bool on);
  void showLoad(bool on) { loadShown_ = on; }

 signals:
  void previewFailed(const QString& message);
  /// Emitted with whether the filter list has an enabled strategy.
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
  CellModel::Shapes draped_;          ///< shapes that the view has, or gets when they are ready
  std::vector<FilterEntry> filters_;  ///< filters at the last check
  int edited_ = -1;                   ///< strategy that an edit has changed
  QTimer editTimer_;
  CellPreview preview_;
  LatestWork draping_;  // declared last: its thread ends before the other members are destroyed
};

}  // namespace footfall::ui
