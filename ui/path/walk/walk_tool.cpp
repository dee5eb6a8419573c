// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/path/walk/walk_tool.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/vector.hpp"
#include "ui/base/text/core_text.hpp"
#include "ui/path/walk/walk_track.hpp"

namespace footfall::ui {
namespace {

const QString kBodyOverlay = QStringLiteral("walkBody");
constexpr double kFaster = 3;
constexpr double kMargin = 0.12;       // metres off borders: what is nearer than 0.05 m to the eyes is not drawn
constexpr double kClimbSeconds = 0.1;  // in which the eyes have followed most of a step
constexpr double kSteepest = 85;       // degrees up and down
constexpr double kSettled = 1e-3;      // metres by which the eyes may be off at rest

}  // namespace

WalkTool::WalkTool(LevelView& view, QObject* parent)
    : QObject(parent),
      view_(view),
      input_(view, {Qt::Key_W, Qt::Key_A, Qt::Key_S, Qt::Key_D, Qt::Key_Up, Qt::Key_Left, Qt::Key_Down, Qt::Key_Right},
             nullptr) {
  connect(&input_, &SteeringInput::advanced, this, &WalkTool::advance);
  connect(&input_, &SteeringInput::looked, this, [this](double right, double up) {
    sight_.turn -= right;
    sight_.pitch = std::clamp(sight_.pitch + up, -kSteepest, kSteepest);
    placeCamera();
  });
  connect(&view_, &LevelView::toolChanged, this, [this] {
    if (view_.tool() == this) prepare();
  });
}

void WalkTool::setGround(const PathModel::Ground& ground, const WalkBody& body, double metresPerUnit) {
  const bool isAnother = !(ground == ground_);
  ground_ = ground;
  body_ = body;
  metresPerUnit_ = metresPerUnit;
  if (!isAnother) return;
  if (finder_) earlier_ = std::move(finder_);
  finder_.reset();
  if (!ground_.mesh) earlier_.reset();
  work_.stop();
  if (view_.tool() != this) return;
  if (!ground_.mesh && isWalking()) {
    before_.reset();  // it belongs to the level before
    view_.setTool(nullptr);
  }
  prepare();
  emit hintChanged(hint());
}

void WalkTool::prepare() {
  if (finder_ || work_.busy() || !ground_.mesh) return;
  work_.start(
      *this,
      [mesh = ground_.mesh, earlier = earlier_](const RunContext& context) {
        return std::shared_ptr<const PathFinder>(earlier ? std::make_shared<PathFinder>(mesh, *earlier, &context)
                                                         : std::make_shared<PathFinder>(mesh, &context));
      },
      [this](const std::shared_ptr<const PathFinder>& finder) { takeFinder(finder); },
      [this](const std::exception& error) { emit failed(coreText(error)); });
}

void WalkTool::takeFinder(std::shared_ptr<const PathFinder> finder) {
  finder_ = std::move(finder);
  earlier_.reset();
  if (isWalking()) {
    standAt(feet());  // on the new result
  } else if (wanted_) {
    standAt(*wanted_);
  }
}

void WalkTool::standAt(const Vec3& place) {
  wanted_ = place;
  if (!finder_) return;  // once it is prepared
  wanted_.reset();
  const bool isFirst = !isWalking();
  walk_.emplace(finder_, kMargin / metresPerUnit_, ground_.agentGap);
  if (!walk_->standAt(place, ground_.reach)) {
    walk_.reset();
    if (!isFirst) view_.setTool(nullptr);
    emit hintChanged(hint());
    return;
  }
  isFalling_ = false;
  if (isFirst) {
    before_ = view_.cameraController().pose();
    sight_ = {sightOf(*before_).turn, 0};
    height_ = feet().z;
    showBody(std::nullopt);
    view_.setCursor(Qt::BlankCursor);
    input_.begin();
    emit hintChanged(hint());
  }
  input_.setAlwaysAdvancing(std::fabs(feet().z - height_) * metresPerUnit_ > kSettled);
  placeCamera();
}

void WalkTool::advance(double seconds) {
  if (!isWalking()) return;
  const auto sign = [this](int plus, int alsoPlus, int minus, int alsoMinus) {
    return static_cast<double>(input_.isHeld(plus) || input_.isHeld(alsoPlus)) -
           static_cast<double>(input_.isHeld(minus) || input_.isHeld(alsoMinus));
  };
  const double ahead = sign(Qt::Key_W, Qt::Key_Up, Qt::Key_S, Qt::Key_Down);
  const double right = sign(Qt::Key_D, Qt::Key_Right, Qt::Key_A, Qt::Key_Left);
  if (!isFalling_ && (ahead != 0 || right != 0)) {
    const double way = seconds * speed_ * (input_.isFast() ? kFaster : 1) / metresPerUnit_ / std::hypot(ahead, right);
    const double turn = sight_.turn * M_PI / 180;
    const Vec3 along{ahead * std::cos(turn) + right * std::sin(turn), ahead * std::sin(turn) - right * std::cos(turn),
                     0};
    if (walk_->go(way * along.x, way * along.y)) {
      isFalling_ = true;
      fallSpeed_ = 0;
    }
  }
  const double target = feet().z;
  if (isFalling_) {
    fallSpeed_ += kGravity / metresPerUnit_ * seconds;
    height_ = std::max(target, height_ - fallSpeed_ * seconds);
    isFalling_ = height_ > target;
  } else {
    height_ += (target - height_) * (1 - std::exp(-seconds / kClimbSeconds));
  }
  if (std::fabs(target - height_) * metresPerUnit_ <= kSettled) height_ = target;
  input_.setAlwaysAdvancing(height_ != target);
  placeCamera();
}

void WalkTool::placeCamera() {
  if (!isWalking()) return;
  const Vec3 place = feet();
  CameraController& camera = view_.cameraController();
  camera.setPose(poseOfEye({place.x, place.y, height_ + body_.eyeHeight()}, sight_, kEyeReach / metresPerUnit_));
  emit camera.moved();
}

void WalkTool::showBody(const std::optional<Vec3>& at) {
  if (!at) {
    view_.removeOverlay(kBodyOverlay);
    return;
  }
  const auto scene = view_.environmentGeometry();
  const CameraPose from = poseOf(*view_.camera(), scene ? scene->centre : Vec3{});
  view_.setOverlay(kBodyOverlay, drawFigure(body_, *at, sightOf(from).turn, from));
}

void WalkTool::mouseMoved(const ViewMouse& mouse) {
  if (isWalking() || !finder_) return;
  const auto found = view_.pick(mouse.place);
  const auto place = found ? finder_->locate(found->point, ground_.reach) : std::nullopt;
  showBody(place ? std::optional(place->position) : std::nullopt);
}

void WalkTool::clicked(const ViewMouse& mouse) {
  if (isWalking()) return;
  if (const auto found = view_.pick(mouse.place)) standAt(found->point);
}

bool WalkTool::keyPressed(const QKeyEvent& event) {
  if (isWalking() || (event.key() != Qt::Key_Return && event.key() != Qt::Key_Enter)) return false;
  standAt(view_.placeInTheMiddle());
  return true;
}

void WalkTool::mouseLeft() { showBody(std::nullopt); }

void WalkTool::ended() {
  input_.end();
  showBody(std::nullopt);
  walk_.reset();
  wanted_.reset();
  if (const auto before = std::exchange(before_, std::nullopt)) view_.cameraController().glideTo(*before);
}

QString WalkTool::hint() const {
  if (!ground_.mesh || ground_.mesh->triangles.empty()) return tr("Walk: nothing is walkable here. Esc ends.");
  if (isWalking()) return tr("Walk: W A S D or the arrows walk, the mouse looks, Shift is faster, Esc leaves.");
  return tr("Walk: click where to stand, or press Enter for the middle of the view. Esc ends.");
}

}  // namespace footfall::ui
