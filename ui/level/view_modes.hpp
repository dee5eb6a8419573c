// The modes of the view as commands, and their geometry, made in the background.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QObject>
#include <array>
#include <memory>
#include <optional>

#include "ui/base/work/latest_work.hpp"
#include "ui/document/document.hpp"
#include "ui/level/level_composer.hpp"
#include "ui/level/level_file.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/view/feature_host.hpp"
#include "ui/view/geometry/field_geometry.hpp"
#include "ui/view/view_mode.hpp"
#include "ui/view/widgets/view_layout.hpp"

namespace footfall::ui {

/// Follows the level and its results. The geometry of the present mode is computed again when they change; the old
/// picture stays until it is ready.
class ViewModes : public QObject {
  Q_OBJECT

 public:
  ViewModes(const FeatureHost& host, LevelView& view, ViewLayout& layout, const Document& document, LevelFile& file,
            LevelComposer& composer, RunController& controller);

  /// Sets the mode; it is shown as soon as its geometry is ready.
  void setMode(ViewMode mode);
  [[nodiscard]] ViewMode mode() const { return mode_; }
  /// Returns whether the shown geometry belongs to the present level and result.
  [[nodiscard]] bool upToDate() const { return !work_.busy(); }
  /// The box that chooses a mode; the tool bar becomes its owner.
  [[nodiscard]] QComboBox& box() { return *box_; }

 signals:
  void modeChanged(footfall::ui::ViewMode mode);
  /// Emitted when upToDate() has become true.
  void ready();

 private:
  void addCommands(CommandRegistry& commands);
  void enable();
  void refresh();
  void forget();
  void describe();
  void compute();
  [[nodiscard]] FieldScale scale() const;
  [[nodiscard]] std::optional<double> limitOf(FilterType filter) const;
  [[nodiscard]] double cap() const;

  LevelView& view_;
  ViewLayout& layout_;
  const Document& document_;
  LevelComposer& composer_;
  RunController& controller_;
  MessageBar& messages_;
  ViewMode mode_ = ViewMode::Result;
  std::array<QAction*, kViewModes.size()> actions_{};
  QComboBox* box_ = nullptr;
  /// The input of a picture: level, result, mode and, for free heights, the largest height.
  struct Made {
    std::shared_ptr<const Environment> level;
    std::shared_ptr<const FinishedRun> run;
    ViewMode mode = ViewMode::Result;
    double cap = 0;
    bool operator==(const Made&) const = default;
  };
  struct Pictures {
    std::shared_ptr<const FieldGeometry> field;
    std::shared_ptr<const NavigationMeshGeometry> sources;
  };
  void take(const Made& made, const Pictures& pictures, const QString& error);

  Made made_, making_;
  [[nodiscard]] Made wanted() const;
  LatestWork work_;  // declared last: its thread ends before the other members are destroyed
};

}  // namespace footfall::ui
