// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/path/walk/walker_view.hpp"

#include <utility>

#include "core/base/vector.hpp"
#include "ui/view/steering/eye_pose.hpp"

namespace footfall::ui {
namespace {

const QString kWalkerOverlay = QStringLiteral("walker");
constexpr double kLooksDown = 5;  // degrees: ground before the feet is in sight
constexpr double kAround = 2.5;   // heights to each side of a walker that is brought into sight

}  // namespace

WalkerView::WalkerView(Walker& walker, LevelView& view, QObject* parent)
    : QObject(parent), walker_(walker), view_(view) {
  connect(&walker_, &Walker::changed, this, &WalkerView::update);
  connect(&view_.cameraController(), &CameraController::moved, this, [this] {
    if (!isMoving_) draw();
  });
  // Places of the level before are nothing to go back to.
  connect(&view_, &LevelView::environmentChanged, this, [this] {
    beforeEyes_.reset();
    followed_.reset();
  });
}

void WalkerView::setBody(const WalkBody& body) {
  body_ = body;
  update();
}

void WalkerView::setShown(bool shown) {
  if (std::exchange(shown_, shown) == shown) return;
  update();
}

void WalkerView::setCamera(WalkCamera camera) {
  if (std::exchange(camera_, camera) == camera) return;
  leaveEyes();
  followed_.reset();
  update();
}

void WalkerView::update() {
  if (!isShown()) {
    leaveEyes();
    followed_.reset();
  } else {
    moveCamera();
  }
  draw();
}

void WalkerView::leaveEyes() {
  if (const auto before = std::exchange(beforeEyes_, std::nullopt)) view_.cameraController().glideTo(*before);
}

void WalkerView::moveCamera() {
  CameraController& camera = view_.cameraController();
  const Vec3 feet = walker_.track().feetAt(walker_.time());
  if (camera_ == WalkCamera::Eyes) {
    if (!beforeEyes_) beforeEyes_ = camera.pose();
    Vec3 eye = feet;
    eye.z = walker_.track().smoothHeightAt(walker_.time()) + body_.eyeHeight();
    isMoving_ = true;
    camera.setPose(poseOfEye(eye, {walker_.track().turnAt(walker_.time()), -kLooksDown}, kEyeReach * metre_));
    emit camera.moved();
    isMoving_ = false;
  } else if (camera_ == WalkCamera::Follows) {
    const Vec3 middle{feet.x, feet.y, feet.z + body_.height / 2};
    const auto last = std::exchange(followed_, middle);
    isMoving_ = true;
    if (last) {
      CameraPose pose = camera.pose();
      const Vec3 way = middle - *last;
      pose.position = pose.position + way;
      pose.pivot = pose.pivot + way;
      camera.setPose(pose);
      emit camera.moved();
    } else {
      const Vec3 around{kAround * body_.height, kAround * body_.height, kAround * body_.height};
      camera.frame(middle - around, middle + around);
    }
    isMoving_ = false;
  }
}

void WalkerView::draw() {
  if (!isShown() || camera_ == WalkCamera::Eyes) {
    view_.removeOverlay(kWalkerOverlay);
    return;
  }
  const auto scene = view_.environmentGeometry();
  const CameraPose from = poseOf(*view_.camera(), scene ? scene->centre : Vec3{});
  view_.setOverlay(kWalkerOverlay, drawFigure(body_, walker_.track().feetAt(walker_.time()),
                                              walker_.track().turnAt(walker_.time()), from));
}

}  // namespace footfall::ui
