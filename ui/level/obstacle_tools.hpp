// The mouse tools of obstacles: placing them, and moving, turning and scaling them by their handles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <optional>

#include "ui/level/obstacle_editor.hpp"
#include "ui/level/obstacle_gizmo.hpp"
#include "ui/level/obstacle_ground.hpp"
#include "ui/view/level_view.hpp"
#include "ui/view/view_tool.hpp"

namespace footfall::ui {

/// The objects that both tools use; all of them outlive the tools.
struct ObstacleContext {
  LevelView& view;
  LevelComposer& composer;
  ObstacleEditor& editor;
  std::function<void(const QString&)> say;  ///< shows a text in the status bar
};

/// A click selects; handles move, turn and scale; the body moves over the ground. Alt drags a copy, Shift snaps, Esc
/// cancels a drag, and arrow and page keys move by steps.
class SelectObstacleTool : public QObject, public ViewTool {
  Q_OBJECT

 public:
  explicit SelectObstacleTool(ObstacleContext context, QObject* parent = nullptr);

  /// Sets whether sideways movements follow the ground up and down.
  void setSticking(bool on) { sticking_ = on; }
  /// The handles of the selected obstacle, as the view shows them; empty when none is selected.
  [[nodiscard]] std::optional<ObstacleGizmo> gizmo() const;

  bool mousePressed(const ViewMouse& mouse) override;
  void mouseMoved(const ViewMouse& mouse) override;
  void mouseReleased(const ViewMouse& mouse) override;
  void clicked(const ViewMouse& mouse) override;
  bool keyPressed(const QKeyEvent& event) override;
  void mouseLeft() override;
  void ended() override;
  [[nodiscard]] QCursor cursor() const override { return Qt::ArrowCursor; }
  [[nodiscard]] QString hint() const override;

 private:
  struct Hold {
    std::optional<ObstacleHandle> handle;  ///< empty: the body
    Ray from;
    double height = 0;  ///< height at which the body was taken
    PlacedObstacle start;
  };

  void beginHold(const ViewMouse& mouse, std::uint32_t id, std::optional<ObstacleHandle> handle, double height);
  [[nodiscard]] std::optional<PlacedObstacle> held(const ViewMouse& mouse) const;
  void stick(PlacedObstacle& obstacle, double from) const;
  bool nudge(int key, bool coarse);
  void refresh();

  ObstacleContext context_;
  ObstacleGround ground_;
  bool sticking_ = true;
  std::optional<ObstacleHandle> hovered_;
  std::optional<Hold> hold_;
};

/// A click places an obstacle of one metre on the surface under the mouse. Pressing and dragging draws its base; the
/// next movement sets its height, which a click ends. Shift snaps; Esc cancels an unfinished obstacle.
class PlaceObstacleTool : public QObject, public ViewTool {
  Q_OBJECT

 public:
  PlaceObstacleTool(PlacedObstacle::Shape shape, ObstacleContext context, QObject* parent = nullptr);

  bool mousePressed(const ViewMouse& mouse) override;
  void mouseMoved(const ViewMouse& mouse) override;
  void mouseReleased(const ViewMouse& mouse) override;
  bool keyPressed(const QKeyEvent& event) override;
  void mouseLeft() override;
  void ended() override;
  [[nodiscard]] QString hint() const override;
  /// The obstacle that a click would place; empty beside all surfaces.
  [[nodiscard]] const std::optional<PlacedObstacle>& preview() const { return preview_; }

 signals:
  /// `more` is true when Ctrl was down, which keeps the tool active.
  void placed(bool more);

 private:
  enum class State { Hover, Base, Height };

  void hover(const ViewMouse& mouse);
  void drawBase(const ViewMouse& mouse);
  void drawHeight(const ViewMouse& mouse);
  void place(bool more);
  void setState(State state);
  void refresh();

  PlacedObstacle::Shape shape_;
  ObstacleContext context_;
  ObstacleGround ground_;
  State state_ = State::Hover;
  QPoint pressed_;
  Vec3 anchor_;
  bool drawn_ = false;  ///< the mouse has moved far enough to draw a base
  std::optional<PlacedObstacle> preview_;
};

}  // namespace footfall::ui
