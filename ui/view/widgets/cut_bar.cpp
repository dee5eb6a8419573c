// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/widgets/cut_bar.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

namespace footfall::ui {
namespace {

constexpr int kSteps = 1000;

}  // namespace

CutBar::CutBar(LevelView& view) : QFrame(&view), view_(view) {
  setObjectName(QStringLiteral("cutBar"));
  setAttribute(Qt::WA_StyledBackground);
  setCursor(Qt::ArrowCursor);
  auto* title = new QLabel(tr("Cut"), this);
  facing_ = new QComboBox(this);
  facing_->setObjectName(QStringLiteral("cutFacing"));
  facing_->setAccessibleName(tr("Direction of the cut plane"));
  facing_->setToolTip(tr("Which way the plane faces"));
  facing_->addItems({QString(), QString(), tr("Facing the camera")});
  setUnits({});
  slider_ = new QSlider(Qt::Horizontal, this);
  slider_->setObjectName(QStringLiteral("cutPosition"));
  slider_->setAccessibleName(tr("Position of the cut plane"));
  slider_->setToolTip(tr("Move the plane through the level"));
  slider_->setRange(0, kSteps);
  slider_->setPageStep(kSteps / 20);
  slider_->setSingleStep(kSteps / 200);
  slider_->setMinimumWidth(60);
  auto* other = new QToolButton(this);
  other->setObjectName(QStringLiteral("cutFlip"));
  other->setText(QStringLiteral("⇄"));
  other->setAccessibleName(tr("Other side"));
  other->setToolTip(tr("Show what is on the other side of the plane"));
  auto* close = new QToolButton(this);
  close->setObjectName(QStringLiteral("cutClose"));
  close->setText(QStringLiteral("✕"));
  close->setAccessibleName(tr("No cut plane"));
  close->setToolTip(tr("Show the whole level again"));
  for (QToolButton* button : {other, close}) {
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
  }
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 4, 6, 4);
  for (QWidget* widget : std::initializer_list<QWidget*>{title, facing_, slider_, other, close})
    layout->addWidget(widget);
  connect(facing_, &QComboBox::activated, this, [this](int index) { setFacing(static_cast<Facing>(index)); });
  connect(slider_, &QSlider::valueChanged, this, &CutBar::apply);
  connect(other, &QToolButton::clicked, this, &CutBar::flip);
  connect(close, &QToolButton::clicked, this, [this] {
    setOn(false);
    emit closed();
  });
  hide();
}

// The plane is vertical: two of the file's axes lie in the plan.
void CutBar::setUnits(const LevelUnits& units) {
  units_ = units;
  for (const int axis : {0, 1}) facing_->setItemText(axis, tr("Across %1").arg(axisName(units.fileAxis(axis).axis)));
}

// The extent of the level along the plane's normal, in the environment's coordinates.
CutBar::Reach CutBar::reach() const {
  const auto geometry = view_.environmentGeometry();
  if (!geometry) return {};
  const double middle = nx_ * geometry->centre.x + ny_ * geometry->centre.y;
  const double half = std::abs(nx_) * geometry->upper.x + std::abs(ny_) * geometry->upper.y;
  return {middle - half, middle + half};
}

void CutBar::setOn(bool on) {
  if (on == this->on()) return;
  if (!on) {
    setPlane(std::nullopt);
    return;
  }
  {
    const QSignalBlocker quiet(slider_);
    slider_->setValue(kSteps / 2);
  }
  apply();
}

void CutBar::setPlane(const std::optional<CutPlane>& plane) {
  if (plane) {
    nx_ = plane->nx;
    ny_ = plane->ny;
    const Reach all = reach();
    const double part = (plane->at - all.lower) / (all.upper > all.lower ? all.upper - all.lower : 1);
    const QSignalBlocker quiet(slider_);
    slider_->setValue(static_cast<int>(std::lround(std::clamp(part, 0.0, 1.0) * kSteps)));
  }
  view_.setCutPlane(plane);
  describe();
}

void CutBar::setFacing(Facing facing) {
  nx_ = facing == Facing::X ? 1 : 0;
  ny_ = facing == Facing::Y ? 1 : 0;
  if (facing == Facing::Camera) {
    // The side of the eye is removed: the plane's normal points at the eye.
    const auto& q = view_.cameraController().pose().orientation;
    const double x = 2 * (q[0] * q[2] + q[3] * q[1]);
    const double y = 2 * (q[1] * q[2] - q[3] * q[0]);
    const double length = std::hypot(x, y);
    // The upper edge of the view decides when the camera looks straight down.
    nx_ = length > 1e-6 ? x / length : -2 * (q[0] * q[1] - q[3] * q[2]);
    ny_ = length > 1e-6 ? y / length : -(1 - 2 * (q[0] * q[0] + q[2] * q[2]));
    const double norm = std::hypot(nx_, ny_);
    nx_ = norm > 0 ? nx_ / norm : 1;
    ny_ = norm > 0 ? ny_ / norm : 0;
  }
  {
    const QSignalBlocker quiet(facing_);
    facing_->setCurrentIndex(static_cast<int>(facing));
  }
  if (on()) apply();
}

void CutBar::flip() {
  nx_ = -nx_;
  ny_ = -ny_;
  {
    const QSignalBlocker quiet(slider_);
    slider_->setValue(kSteps - slider_->value());
  }
  apply();
}

void CutBar::apply() {
  const Reach all = reach();
  view_.setCutPlane(CutPlane{nx_, ny_, all.lower + (all.upper - all.lower) * slider_->value() / kSteps});
  describe();
}

void CutBar::describe() {
  setVisible(on());
  if (on()) slider_->setAccessibleDescription(units_.length(view_.cutPlane()->at));
  emit changed(on());
}

}  // namespace footfall::ui
