// Draws measures of the selected filter in the view, with handles that change its values.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <optional>
#include <vector>

#include "ui/base/text/level_units.hpp"
#include "ui/filters/filter_list.hpp"
#include "ui/filters/parameter_measure.hpp"
#include "ui/view/feature_host.hpp"
#include "ui/view/view_tool.hpp"

namespace footfall::ui {

/// Shows the values of the current row, or the value under the mouse in the list. They appear in the middle of the view
/// at first, and then where the user clicks; steps and gaps appear at a link of the result near there, where one is
/// visible. Dragging a handle edits the value (Shift: finer, Esc: cancels). There are no handles while a tool is
/// active.
class ParameterHandles : public QObject, public ViewTool {
  Q_OBJECT

 public:
  ParameterHandles(const FeatureHost& host, LevelView& view, Document& document, RunController& controller,
                   FilterList& list);

  /// The measures that are shown; empty while there are none.
  [[nodiscard]] const std::vector<ParameterMeasure>& measures() const { return measures_; }

  bool mousePressed(const ViewMouse& mouse) override;
  void mouseMoved(const ViewMouse& mouse) override;
  void mouseReleased(const ViewMouse& mouse) override;
  void clicked(const ViewMouse& mouse) override;
  void mouseLeft() override;
  /// A tool has become active.
  void ended() override;

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Pointed {
    int filter = 0;
    std::size_t parameter = 0;
  };
  struct Hold {
    ParameterMeasure start;
    Ray from;
    QPoint pressed;
    int session = 0;
    bool moved = false;  ///< a click alone edits nothing
  };

  void update();
  void draw();
  void findPlace();
  [[nodiscard]] bool isInView(const Vec3& place) const;
  [[nodiscard]] std::optional<Vec3> floorAt(const QPoint& place) const;
  void addMeasure(const FilterEntry& entry, std::size_t parameter);
  [[nodiscard]] double unitsPerPixelAt(const Vec3& place) const;
  [[nodiscard]] std::optional<std::size_t> handleAt(const QPoint& place) const;
  void hover(std::optional<std::size_t> measure);
  void drag(const ViewMouse& mouse);
  void setValue(double value);
  void endHold();

  LevelView& view_;
  Document& document_;
  RunController& controller_;
  FilterList& list_;
  StatusLine& status_;
  LevelUnits units_;
  std::optional<Pointed> pointed_;  ///< value under the mouse in the list
  std::optional<Vec3> place_;
  bool searched_ = false;  ///< a place has been searched for in the present view
  std::vector<ParameterMeasure> measures_;
  std::optional<std::size_t> hovered_;
  std::optional<Hold> hold_;
  int session_;
  QTimer resting_;  ///< runs while the camera moves
};

}  // namespace footfall::ui
