// The tool "Measure": distance, height and slope between clicked places.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "ui/base/text/level_units.hpp"
#include "ui/view/level_view.hpp"
#include "ui/view/view_tool.hpp"

namespace footfall::ui {

/// The measures of one straight piece, in the environment's units.
struct Measure {
  double distance = 0;  ///< in space
  double plan = 0;      ///< in the plan
  double height = 0;    ///< height of the end over the start; negative: the end is lower
  double degrees = 0;   ///< positive upwards; 90 where it is vertical
  double percent = 0;   ///< infinite where it is vertical
};

Measure measureBetween(const Vec3& from, const Vec3& to);

/// The text of a measure: "3.2 m (3 m in the plan), height +1 m, 18.4° (33.3 %)".
QString measureSummary(const Measure& measure, const LevelUnits& units);

/// Clicks add places on any surface; a click near a visible vertex of the level adds the vertex. Enter or a double
/// click ends a line, so that the next click begins another; Backspace removes the last place; Ctrl+C copies.
class MeasureTool : public QObject, public ViewTool {
  Q_OBJECT

 public:
  /// `level` returns the environment whose vertices are snapped to; it may return null.
  MeasureTool(LevelView& view, std::function<std::shared_ptr<const Environment>()> level);

  [[nodiscard]] const std::vector<Vec3>& places() const { return places_; }
  void setPlaces(std::vector<Vec3> places);
  void removeLast();
  /// All places and pieces in the shown unit, one a line, separated by tabs. The sum is last where there are several
  /// pieces.
  [[nodiscard]] QString text() const;
  void setShown(bool shown);
  void setUnits(const LevelUnits& units);
  [[nodiscard]] const LevelUnits& units() const { return units_; }

  void mouseMoved(const ViewMouse& mouse) override;
  void clicked(const ViewMouse& mouse) override;
  bool keyPressed(const QKeyEvent& event) override;
  void mouseLeft() override;
  void ended() override;
  [[nodiscard]] QString hint() const override;

 signals:
  void placesChanged();
  void unitsChanged();

 private:
  struct Target {
    Vec3 place;
    bool isVertex = false;
  };
  [[nodiscard]] std::optional<Target> targetAt(const QPoint& place) const;
  [[nodiscard]] std::optional<Vec3> vertexNear(const QPoint& place) const;
  void draw();

  LevelView& view_;
  std::function<std::shared_ptr<const Environment>()> level_;
  LevelUnits units_;
  std::vector<Vec3> places_;
  bool isEnded_ = false;  ///< the next click begins a new line
  std::optional<Target> hovered_;
  bool shown_ = false;
};

}  // namespace footfall::ui
