// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/path/body_fields.hpp"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

#include "ui/base/widgets/positive_number.hpp"

namespace footfall::ui {
namespace {

constexpr double kStepMetres = 0.01, kLargestMetres = 1.5;  // of the slider

ParameterDescriptor radiusNumber() {
  ParameterDescriptor number = positiveNumber("radius", "Radius", 0);
  number.minimumOpen = false;
  number.unit = Unit::Length;
  return number;
}

/// The largest of 1, 2 and 5 times a power of ten that is at most `length`.
double roundStep(double length) {
  const double power = std::pow(10, std::floor(std::log10(length) + 1e-9));
  for (const double digit : {5.0, 2.0})
    if (digit * power <= length * (1 + 1e-9)) return digit * power;
  return power;
}

}  // namespace

BodyFields::BodyFields(PathModel& model, QWidget* parent)
    : QObject(parent),
      model_(model),
      radius_(new NumberField(radiusNumber(), parent)),
      unit_(new QLabel(parent)),
      slider_(new QSlider(Qt::Horizontal, parent)),
      way_(new QComboBox(parent)) {
  radius_->setObjectName(QStringLiteral("pathRadius"));
  radius_->setAccessibleName(tr("Radius of the body"));
  radius_->setToolTip(tr("Radius of the body that walks, half of its width. 0: a point, on the result as it is"));
  radius_->setFixedWidth(72);
  slider_->setObjectName(QStringLiteral("pathRadiusSlider"));
  slider_->setAccessibleName(tr("Radius of the body"));
  slider_->setToolTip(tr("Drag to see where a wider body fits"));
  way_->setObjectName(QStringLiteral("pathWay"));
  way_->setAccessibleName(tr("Which way the body takes"));
  way_->setToolTip(
      tr("Which of several ways the body takes. Passages that are twice as wide as the body, or wider, count as wide"));
  way_->addItem(tr("Shortest way"), static_cast<int>(BodyWay::Shortest));
  way_->addItem(tr("Prefer wide passages"), static_cast<int>(BodyWay::PrefersWide));
  way_->addItem(tr("Widest way"), static_cast<int>(BodyWay::Widest));
  connect(radius_, &NumberField::valueEdited, this, &BodyFields::take);
  connect(radius_, &NumberField::problemChanged, this, &BodyFields::problemChanged);
  connect(slider_, &QSlider::valueChanged, this, [this](int value) { take(units_.stored(value * step_)); });
  connect(way_, &QComboBox::currentIndexChanged, this, [this] {
    WalkingBody body = model_.body();
    body.way = static_cast<BodyWay>(way_->currentData().toInt());
    model_.setBody(body);
  });
  connect(&model_, &PathModel::bodyChanged, this, &BodyFields::showBody);
  setUnits({});
}

void BodyFields::addTo(QFormLayout& form) {
  auto* row = new QHBoxLayout;
  row->setSpacing(6);
  row->addWidget(radius_);
  row->addWidget(unit_);
  row->addWidget(slider_, 1);
  auto* label = new QLabel(tr("Radius"), way_->parentWidget());
  radius_->takeDragsOf(label);
  form.addRow(label, row);
  form.addRow(tr("Way"), way_);
}

void BodyFields::setUnits(const LevelUnits& units) {
  units_ = units;
  radius_->setUnits(units);
  unit_->setText(units.name());
  const double shownInMetre = units.factor() / units.metresPerUnit;
  step_ = roundStep(kStepMetres * shownInMetre);
  const QSignalBlocker blocked(slider_);
  slider_->setRange(0, static_cast<int>(std::ceil(kLargestMetres * shownInMetre / step_ - 1e-9)));
  slider_->setPageStep(std::max(1, slider_->maximum() / 15));
  showBody();
}

void BodyFields::take(double radius) {
  WalkingBody body = model_.body();
  body.radius = radius;
  model_.setBody(body);
}

void BodyFields::showBody() {
  const WalkingBody& body = model_.body();
  radius_->setValue(body.radius);
  const QSignalBlocker sliderBlocked(slider_), wayBlocked(way_);
  const double steps = units_.shown(body.radius) / step_;
  slider_->setValue(static_cast<int>(std::lround(std::min(steps, static_cast<double>(slider_->maximum())))));
  way_->setCurrentIndex(way_->findData(static_cast<int>(body.way)));
  way_->setEnabled(!body.isPoint());
}

}  // namespace footfall::ui
