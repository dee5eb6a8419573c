// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspect/side_by_side/linked_view.hpp"

namespace footfall::ui {
namespace {

CameraPose poseNow(LevelView& view) {
  const auto scene = view.environmentGeometry();
  return poseOf(*view.camera(), scene ? scene->centre : Vec3{});
}

}  // namespace

LinkedView::LinkedView(LevelView& first, LevelView& second, QObject* parent)
    : QObject(parent), first_(first), second_(second) {
  second_.setEnvironment(first_.environmentGeometry(), false);
  connect(&first_, &LevelView::environmentChanged, this, [this] {
    second_.setEnvironment(first_.environmentGeometry(), false);
    second_.setContent({});
    follow(first_, second_);
  });
  connect(&first_.cameraController(), &CameraController::moved, this, [this] { follow(first_, second_); });
  connect(&second_.cameraController(), &CameraController::moved, this, [this] { follow(second_, first_); });
  // Switches have no signals; whatever they change is drawn.
  connect(&first_, &QOpenGLWidget::frameSwapped, this, &LinkedView::mirror);
  mirror();
  follow(first_, second_);
}

void LinkedView::follow(LevelView& from, LevelView& to) {
  if (isMoving_) return;
  isMoving_ = true;
  to.cameraController().setPose(poseNow(from));
  emit to.cameraController().moved();  // what lies over that view follows its camera
  isMoving_ = false;
}

void LinkedView::mirror() {
  if (second_.environmentGeometry() != first_.environmentGeometry())
    second_.replaceEnvironment(first_.environmentGeometry());
  if (second_.backdrop() != first_.backdrop()) second_.setBackdrop(first_.backdrop());
  if (second_.inside() != first_.inside()) second_.setInside(first_.inside());
  const ViewMode mode =
      isHeatMap(first_.mode()) || first_.mode() == ViewMode::SourceTriangles ? ViewMode::Result : first_.mode();
  if (second_.mode() != mode) second_.setMode(mode);
  SceneParts parts = first_.parts();
  parts.cells = false;
  parts.inside = second_.inside();
  parts.mode = second_.mode();
  if (!(second_.parts() == parts)) second_.setParts(parts);
  if (!(second_.heights() == first_.heights())) second_.setHeights(first_.heights());
  if (second_.cutPlane() != first_.cutPlane()) second_.setCutPlane(first_.cutPlane());
  // Jumps of the first camera that were no moves: sessions, pictures.
  if (!(poseNow(first_) == poseNow(second_))) follow(first_, second_);
}

}  // namespace footfall::ui
