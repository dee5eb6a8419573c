// The widget of the 3D view: passes events on and paints.
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

#include "ui/view/camera_controller.hpp"
#include "ui/view/frame_pacing.hpp"
#include "ui/view/overlay_renderer.hpp"
#include "ui/view/scene_renderer.hpp"
#include "ui/view/tool_mouse.hpp"
#include "ui/view/view_overlay.hpp"
#include "ui/view/view_scene.hpp"

namespace footfall::ui {

/// Where a picture looks from: as the view does, or as CameraController::viewFromTop() and
/// CameraController::viewOblique() do, fitted to the picture.
enum class PictureCamera { AsSeen, Top, Oblique };

/// Left drag turns about the pivot with Z upright, right or middle drag (or Shift and left) moves sideways, the wheel
/// (or Ctrl and left drag) zooms; a double click makes the clicked place the pivot; arrow keys move. While cells are
/// shown, a click selects the one it hit, and a double click is no more than two of them. A tool (setTool()) comes
/// before all this. What is shown is ViewScene's, who gets the mouse ToolMouse's, what a frame may leave out
/// FramePacing's.
class LevelView : public QGLViewer {
  Q_OBJECT

 public:
  explicit LevelView(QWidget* parent = nullptr);
  ~LevelView() override;

  /// What moves the camera; its boxes and places are in the environment's coordinates.
  [[nodiscard]] CameraController& cameraController() { return cameraController_; }
  [[nodiscard]] const CameraController& cameraController() const { return cameraController_; }

  /// Shows another environment without content. Moves the camera only when `fitCamera`.
  void setEnvironment(std::shared_ptr<const EnvironmentGeometry> geometry, bool fitCamera);
  /// Shows an environment that has changed, with the same centre; content, cells and camera stay.
  void replaceEnvironment(std::shared_ptr<const EnvironmentGeometry> geometry);
  [[nodiscard]] std::shared_ptr<const EnvironmentGeometry> environmentGeometry() const { return scene_.environment(); }
  /// Shows something around the environment, which is neither clicked nor part of any result; null: nothing.
  void setBackdrop(BackdropPtr backdrop);
  [[nodiscard]] const BackdropPtr& backdrop() const { return scene_.backdrop(); }
  void setContent(ViewContent content);
  [[nodiscard]] const ViewContent& content() const { return scene_.content(); }

  void setParts(const SceneParts& parts);
  [[nodiscard]] const SceneParts& parts() const { return scene_.parts(); }

  /// The cells of a parallel block; they are seen while SceneParts::cells is set. Null: none.
  void setCells(std::shared_ptr<const CellGeometry> geometry, CellColours colours);
  void setCellColours(CellColours colours);
  void setMarkedCells(const MarkedCells& marked);
  /// Moves the camera until a cell is in sight, looking the same way.
  void frameCell(std::size_t cell);
  /// What one sees at a place of the view; nothing where there is no cell, or none are shown.
  [[nodiscard]] std::optional<std::size_t> cellAt(const QPoint& place) const;

  /// Leaves out what is above or below, in the environment's coordinates: a look under roofs, or at one storey. What
  /// lies at a limit stays.
  void setHeights(const HeightRange& heights);
  [[nodiscard]] const HeightRange& heights() const { return scene_.heights(); }
  /// Leaves out what lies before a vertical plane (environment coordinates). Nothing: no plane.
  void setCutPlane(const std::optional<CutPlane>& cut);
  [[nodiscard]] const std::optional<CutPlane>& cutPlane() const { return scene_.cutPlane(); }
  /// Leaves out layers, by number, with the floors of the environment under them.
  void setHiddenLayers(const std::set<std::uint32_t>& hidden);
  [[nodiscard]] const std::set<std::uint32_t>& hiddenLayers() const { return scene_.hiddenLayers(); }

  void setMode(ViewMode mode);
  [[nodiscard]] ViewMode mode() const { return parts().mode; }
  /// Whether one looks into closed levels: faces seen from behind are left out, and while the camera looks down, roofs
  /// and outer walls are, too.
  void setInside(bool on);
  [[nodiscard]] bool inside() const { return parts().inside; }
  /// What heat maps show; null: nothing yet.
  void setField(std::shared_ptr<const FieldGeometry> field, const FieldScale& scale);
  void setFieldScale(const FieldScale& scale);
  /// The walkable pieces for ViewMode::SourceTriangles, relative to the centre of the environment; null: none yet.
  void setSources(std::shared_ptr<const NavigationMeshGeometry> sources);

  /// Gives the mouse to a tool, which must live until it has ended; null: back to the camera alone.
  void setTool(ViewTool* tool);
  [[nodiscard]] ViewTool* tool() const { return mouse_.tool(); }
  /// Gives the mouse to handles that lie in the view, while no tool has it; null: there are none. They end when a tool
  /// comes.
  void setHandles(ViewTool* handles) { mouse_.setHandles(handles); }
  /// Drawn over the scene until it is removed; each name has one.
  void setOverlay(const QString& name, ViewOverlay overlay);
  void removeOverlay(const QString& name);
  /// The line of sight through a place of the view, in the environment's coordinates.
  [[nodiscard]] Ray rayAt(const QPoint& place) const;
  /// The surface of the environment that is seen there, in the environment's coordinates; what is cut away is not.
  [[nodiscard]] std::optional<SurfacePoint> pick(const QPoint& place) const;
  /// Where a place of the environment is in the view; nothing when it is behind the eye.
  [[nodiscard]] std::optional<QPointF> project(const Vec3& place) const;
  /// From where the scene is drawn, and what is left of it.
  [[nodiscard]] SceneCamera sceneCamera() const;
  /// The place that is seen in the middle of the view, or else the camera's pivot; in the environment's coordinates.
  [[nodiscard]] Vec3 placeInTheMiddle() const;
  /// What heights and cut plane leave, in the scene's coordinates.
  [[nodiscard]] ShownSpace shown() const { return scene_.shown(); }

  /// What the view shows, `pixels` large, with lines and words `ratio` times as large as at one device pixel for one
  /// logical; before the view has been on the screen, or for sizes that OpenGL cannot draw, a null image. A camera on
  /// its way is where it is going; afterwards the view looks from where it did.
  [[nodiscard]] QImage picture(const QSize& pixels, double ratio, PictureCamera from = PictureCamera::AsSeen);

  /// What the view shows, as it is once the camera has arrived and all of it has been drawn, however long that takes.
  /// (QWidget::grab() takes what there is.)
  QImage grabFramebuffer();
  /// The last frame showed everything. Large scenes take several events to draw: until they are complete, the view
  /// shows what it showed before, and while the camera moves, it leaves out outlines, creases and small things.
  [[nodiscard]] bool isWhole() const { return pacing_.isWhole(); }

  /// How long the last frame took until OpenGL had finished it; 0 before the first.
  [[nodiscard]] double lastFrameMs() const { return pacing_.lastMs(); }
  /// Whether a run is under way, for which large pictures wait (FramePacing::setComputing()).
  void setComputing(bool on) { pacing_.setComputing(on); }
  /// How long it takes to draw everything anew; 0 while that is not known.
  [[nodiscard]] double wholeFrameMs() const { return pacing_.wholeMs(); }
  /// When OpenGL got the first command of the last frame.
  [[nodiscard]] std::chrono::steady_clock::time_point lastFrameBegun() const { return pacing_.lastBegun(); }

 signals:
  /// setEnvironment() has shown another environment.
  void environmentChanged();
  /// OpenGL cannot show the scene; once.
  void failed(const QString& message);
  /// The mouse has moved over a cell, or off all of them. Only while cells are shown and no button is down.
  void cellHovered(std::optional<std::size_t> cell);
  /// A click, not a drag; nothing when it hit no cell.
  void cellClicked(std::optional<std::size_t> cell);
  /// Another tool has the mouse, or none.
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
  double pictureRatio_ = 0;  ///< while picture() draws
};

}  // namespace footfall::ui
