// The widget of the 3D view, which forwards events and paints.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGLViewer/qglviewer.h>

#include <QImage>
#include <QPointF>
#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "ui/view/camera/camera_controller.hpp"
#include "ui/view/overlays/overlay_renderer.hpp"
#include "ui/view/overlays/view_overlay.hpp"
#include "ui/view/scene/frame_pacing.hpp"
#include "ui/view/scene/scene_renderer.hpp"
#include "ui/view/scene/view_scene.hpp"
#include "ui/view/tool_mouse.hpp"

namespace footfall::ui {

/// The camera of a picture: that of the view, or that of CameraController::viewFromTop() or
/// CameraController::viewOblique(), fitted to the picture.
enum class PictureCamera { AsSeen, Top, Oblique };

/// A left drag turns about the pivot with Z upright, a right or middle drag (or Shift and left) moves sideways, the
/// wheel (or Ctrl and left drag) zooms; a double click makes the clicked place the pivot; arrow keys move. While cells
/// are shown, a click selects the cell under the mouse, and a double click counts as two clicks. A tool (setTool())
/// gets events first. ViewScene holds the content, ToolMouse distributes mouse events, and FramePacing decides what a
/// frame may omit.
class LevelView : public QGLViewer {
  Q_OBJECT

 public:
  explicit LevelView(QWidget* parent = nullptr);
  ~LevelView() override;

  /// The controller of the camera; its boxes and places are in the environment's coordinates.
  [[nodiscard]] CameraController& cameraController() { return cameraController_; }
  [[nodiscard]] const CameraController& cameraController() const { return cameraController_; }

  /// Shows another environment without content. The camera moves only with `fitCamera`.
  void setEnvironment(std::shared_ptr<const EnvironmentGeometry> geometry, bool fitCamera);
  /// Shows an environment that has changed, with the same centre; content, cells and camera stay.
  void replaceEnvironment(std::shared_ptr<const EnvironmentGeometry> geometry);
  [[nodiscard]] std::shared_ptr<const EnvironmentGeometry> environmentGeometry() const { return scene_.environment(); }
  /// Shows surroundings of the environment, which cannot be clicked and belong to no result; null: none.
  void setBackdrop(BackdropPtr backdrop);
  [[nodiscard]] const BackdropPtr& backdrop() const { return scene_.backdrop(); }
  void setContent(ViewContent content);
  [[nodiscard]] const ViewContent& content() const { return scene_.content(); }

  void setParts(const SceneParts& parts);
  [[nodiscard]] const SceneParts& parts() const { return scene_.parts(); }

  /// Sets the cells of a parallel block, which are shown while SceneParts::cells is set. Null: none.
  void setCells(std::shared_ptr<const CellGeometry> geometry, CellColours colours);
  void setCellColours(CellColours colours);
  void setMarkedCells(const MarkedCells& marked);
  /// Moves the camera until a cell is in view, without turning it.
  void frameCell(std::size_t cell);
  /// The cell at a place of the view; empty where there is no cell, or none are shown.
  [[nodiscard]] std::optional<std::size_t> cellAt(const QPoint& place) const;

  /// Hides everything above or below, in the environment's coordinates, to look under roofs or at one storey. Surfaces
  /// at a limit stay.
  void setHeights(const HeightRange& heights);
  [[nodiscard]] const HeightRange& heights() const { return scene_.heights(); }
  /// Hides everything in front of a vertical plane (environment coordinates). Empty: no plane.
  void setCutPlane(const std::optional<CutPlane>& cut);
  [[nodiscard]] const std::optional<CutPlane>& cutPlane() const { return scene_.cutPlane(); }
  /// Hides layers, by number, with the floors of the environment under them.
  void setHiddenLayers(const std::set<std::uint32_t>& hidden);
  [[nodiscard]] const std::set<std::uint32_t>& hiddenLayers() const { return scene_.hiddenLayers(); }

  void setMode(ViewMode mode);
  [[nodiscard]] ViewMode mode() const { return parts().mode; }
  /// Sets whether closed levels are opened: faces seen from behind are hidden, and while the camera looks down, roofs
  /// and outer walls as well.
  void setInside(bool on);
  [[nodiscard]] bool inside() const { return parts().inside; }
  /// Sets the field of heat maps; null: none yet.
  void setField(std::shared_ptr<const FieldGeometry> field, const FieldScale& scale);
  void setFieldScale(const FieldScale& scale);
  /// The walkable pieces for ViewMode::SourceTriangles, relative to the centre of the environment; null: none yet.
  void setSources(std::shared_ptr<const NavigationMeshGeometry> sources);

  /// Sets the active tool, which must live until it has ended; null: only the camera is active.
  void setTool(ViewTool* tool);
  [[nodiscard]] ViewTool* tool() const { return mouse_.tool(); }
  /// Sets the handles in the view, which get the mouse while no tool is active; null: none. They end when a tool
  /// becomes active.
  void setHandles(ViewTool* handles) { mouse_.setHandles(handles); }
  /// Draws an overlay over the scene until it is removed; each name has one overlay.
  void setOverlay(const QString& name, ViewOverlay overlay);
  void removeOverlay(const QString& name);
  /// The line of sight through a place of the view, in the environment's coordinates.
  [[nodiscard]] Ray rayAt(const QPoint& place) const;
  /// The visible surface of the environment at a place, in the environment's coordinates; cut-away parts are ignored.
  [[nodiscard]] std::optional<SurfacePoint> pick(const QPoint& place) const;
  /// The place in the view of a place of the environment; empty when it is behind the eye.
  [[nodiscard]] std::optional<QPointF> project(const Vec3& place) const;
  /// The camera of the drawn scene, and the visible part of the scene.
  [[nodiscard]] SceneCamera sceneCamera() const;
  /// The visible place in the middle of the view, or else the camera's pivot; in the environment's coordinates.
  [[nodiscard]] Vec3 placeInTheMiddle() const;
  /// The space between the heights and the cut plane, in the scene's coordinates.
  [[nodiscard]] ShownSpace shown() const { return scene_.shown(); }

  /// A picture of the view's content, `pixels` large. Lines and texts are `ratio` times as large as at one device pixel
  /// for one logical pixel. Null before the view has been on the screen, and for sizes that OpenGL cannot draw. A
  /// gliding camera is drawn at its target; the view keeps its own camera.
  [[nodiscard]] QImage picture(const QSize& pixels, double ratio, PictureCamera from = PictureCamera::AsSeen);

  /// The content of the view after the camera has arrived and all of it has been drawn, however long that takes.
  /// (QWidget::grab() returns the present picture.)
  QImage grabFramebuffer();
  /// Returns whether the last frame showed everything. Large scenes take several events to draw; until they are
  /// complete, the view shows the previous picture, and while the camera moves, it omits outlines, creases and small
  /// objects.
  [[nodiscard]] bool isWhole() const { return pacing_.isWhole(); }

  /// Time of the last frame until OpenGL had finished it; 0 before the first.
  [[nodiscard]] double lastFrameMs() const { return pacing_.lastMs(); }
  /// Sets whether a run is under way; large pictures wait for it (FramePacing::setComputing()).
  void setComputing(bool on) { pacing_.setComputing(on); }
  /// Time to draw everything anew; 0 while that is not known.
  [[nodiscard]] double wholeFrameMs() const { return pacing_.wholeMs(); }
  /// Time at which OpenGL got the first command of the last frame.
  [[nodiscard]] std::chrono::steady_clock::time_point lastFrameBegun() const { return pacing_.lastBegun(); }

 signals:
  /// Emitted when setEnvironment() has shown another environment.
  void environmentChanged();
  /// Emitted once when OpenGL cannot show the scene.
  void failed(const QString& message);
  /// Emitted when the mouse moves over a cell, or off all cells; only while cells are shown and no button is down.
  void cellHovered(std::optional<std::size_t> cell);
  /// Emitted for a click, not for a drag; empty when it hit no cell.
  void cellClicked(std::optional<std::size_t> cell);
  /// Emitted when another tool, or none, is active.
  void toolChanged();

 protected:
  void init() override;
  void draw() override;
  void paintGL() override;
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  bool event(QEvent* event) override;
  void resizeGL(int width, int height) override;

 private:
  void bindMouse();
  static ViewMouse toolMouse(const QMouseEvent& event);
  [[nodiscard]] QVector3D viewDirection() const;
  void drawSlice();
  [[nodiscard]] OverlayRenderer::Look overlayLook() const;
  [[nodiscard]] qreal pixelRatio() const;
  void hover(std::optional<std::size_t> cell);

  SceneRenderer renderer_;
  ViewScene scene_{renderer_};
  CameraController cameraController_;
  FramePacing pacing_;
  ToolMouse mouse_;
  OverlayRenderer overlayRenderer_;
  std::map<QString, ViewOverlay> overlays_;
  std::optional<std::size_t> hovered_;
  bool ready_ = false;
  double pictureRatio_ = 0;  ///< set while picture() draws
};

}  // namespace footfall::ui
