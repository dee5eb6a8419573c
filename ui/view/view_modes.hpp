// The modes of the view as commands, and what they show, made in the background.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QObject>
#include <array>
#include <memory>
#include <optional>

#include "footfall/run_context.hpp"
#include "ui/base/background_queue.hpp"
#include "ui/view/field_geometry.hpp"
#include "ui/view/view_mode.hpp"
#include "ui/window/editor_window.hpp"

namespace footfall::ui {

/// Follows the level and its results. A mode that is shown is computed again when they change; the old picture stays
/// until the new one is there.
class ViewModes : public QObject {
  Q_OBJECT

 public:
  explicit ViewModes(EditorWindow& window);
  ~ViewModes() override;

  /// Shown as soon as there is something to show.
  void setMode(ViewMode mode);
  [[nodiscard]] ViewMode mode() const { return mode_; }
  /// What the mode shows is that of the level and the result as they are.
  [[nodiscard]] bool upToDate() const { return !context_; }
  [[nodiscard]] QComboBox& box() { return *box_; }

 signals:
  void modeChanged(footfall::ui::ViewMode mode);
  /// upToDate() has become true.
  void ready();

 private:
  void addCommands();
  void enable();
  void refresh();
  void forget();
  void describe();
  void compute();
  [[nodiscard]] FieldScale scale() const;
  [[nodiscard]] std::optional<double> limitOf(FilterType filter) const;
  [[nodiscard]] double cap() const;

  EditorWindow& window_;
  ViewMode mode_ = ViewMode::Result;
  std::array<QAction*, kViewModes.size()> actions_{};
  QComboBox* box_ = nullptr;
  /// What the view has: of which level, result, mode and, for free heights, up to what height.
  struct Made {
    std::shared_ptr<const Environment> level;
    std::shared_ptr<const FinishedRun> run;
    ViewMode mode = ViewMode::Result;
    double cap = 0;
    bool operator==(const Made&) const = default;
  };
  Made made_, making_;
  [[nodiscard]] Made wanted() const;
  std::shared_ptr<RunContext> context_;
  BackgroundQueue queue_;  // last: its thread ends before the rest goes
};

}  // namespace footfall::ui
