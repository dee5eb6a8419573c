// The legend of the view's colours and lines; each entry can be switched off.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>
#include <QLabel>
#include <cstdint>
#include <functional>
#include <vector>

#include "ui/base/text/level_units.hpp"
#include "ui/view/geometry/field_geometry.hpp"
#include "ui/view/geometry/render_geometry.hpp"
#include "ui/view/scene/scene_renderer.hpp"
#include "ui/view/view_mode.hpp"
#include "ui/view/widgets/overlay_frame.hpp"

namespace footfall::ui {

/// Lies in a corner of the view at first.
class Legend : public OverlayFrame {
  Q_OBJECT

 public:
  explicit Legend(QWidget* parent);

  /// Adds the entries of `content`.
  void describe(const ViewContent& content);
  /// Cells have a legend of their own; this one only forwards whether they are shown.
  void showCells(bool on);
  [[nodiscard]] const SceneParts& parts() const { return parts_; }
  /// Shows the colours of the mode. `ready`: its content has been computed.
  void showMode(ViewMode mode, const FieldScale& scale, bool ready);
  /// A line below all others, with a swatch of the colour where it is valid.
  struct Note {
    QColor colour;
    QString text;
  };
  void setNotes(const std::vector<Note>& notes);
  void setUnits(const LevelUnits& units);

  /// The scale of a heat map on the legend's background, for reports.
  [[nodiscard]] QImage scaleImage() const;

 signals:
  void partsChanged(const footfall::ui::SceneParts& parts);

 private:
  void describeReasons(const std::vector<const RemovalStyle*>& reasons);
  void fit();
  void setSwitch(QCheckBox* box, bool on, const std::function<void(bool)>& set);
  QCheckBox* addEntry(const QString& label, bool SceneParts::*part, const QString& help);

  SceneParts parts_;
  QCheckBox *walkable_, *obstacleEdges_, *connections_, *steps_, *gaps_, *drops_, *removed_, *environment_;
  QWidget* reasons_;
  QLabel *mode_, *scale_, *notes_;
  std::vector<const RemovalStyle*> shownReasons_;
  bool shownVivid_ = false;
  ViewMode shownMode_ = ViewMode::Result;
  FieldScale shownScale_;
  bool modeReady_ = true;
  LevelUnits units_;
  std::uint32_t layers_ = 0;
  bool anyWalkable_ = false;
};

}  // namespace footfall::ui
