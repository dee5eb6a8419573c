// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/path/path_panel.hpp"

#include <QApplication>
#include <QClipboard>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "ui/base/widgets/flow_layout.hpp"
#include "ui/base/widgets/positive_number.hpp"
#include "ui/path/path_text.hpp"

namespace footfall::ui {
namespace {

constexpr double kUsualSpeed = 1.4;  // metres a second: an adult who is not in a hurry

QPushButton* makeButton(QLayout* row, const QString& id, const QString& text, const QString& help) {
  auto* button = new QPushButton(text);
  button->setObjectName(id);
  button->setToolTip(help);
  row->addWidget(button);
  return button;
}

}  // namespace

PathPanel::PathPanel(PathModel& model, QWidget* parent) : QWidget(parent), model_(model) {
  setObjectName(QStringLiteral("pathPanel"));
  start_ = new PlaceFields(tr("Start"), QStringLiteral("pathStart"), this);
  target_ = new PlaceFields(tr("Target"), QStringLiteral("pathTarget"), this);
  body_ = new BodyFields(model_, this);
  speed_ = new NumberField(positiveNumber("speed", "Walking speed", kUsualSpeed), this);
  speed_->setObjectName(QStringLiteral("pathSpeed"));
  speed_->setAccessibleName(tr("Walking speed in metres a second"));
  speed_->setToolTip(tr("Walking speed in metres a second, for the time that the path takes"));
  speed_->setFixedWidth(72);
  speed_->setValue(kUsualSpeed);
  auto* speedRow = new QHBoxLayout;
  speedRow->setSpacing(6);
  speedRow->addWidget(speed_);
  speedRow->addWidget(new QLabel(tr("m/s"), this), 1);

  auto* form = new QFormLayout;
  form->setVerticalSpacing(4);
  form->addRow(tr("Start"), start_);
  form->addRow(tr("Target"), target_);
  body_->addTo(*form);
  form->addRow(tr("Speed"), speedRow);

  failure_ = new QLabel(this);
  failure_->setObjectName(QStringLiteral("rowError"));
  failure_->setWordWrap(true);
  failure_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  text_ = new QLabel(this);
  text_->setObjectName(QStringLiteral("pathText"));
  text_->setWordWrap(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);

  frame_ = new QLabel(this);
  frame_->setObjectName(QStringLiteral("pathFrame"));
  frame_->setWordWrap(true);
  frame_->setEnabled(false);
  frame_->setText(units_.frameText());

  buttons_ = new FlowLayout(6);
  swap_ = makeButton(buttons_, QStringLiteral("pathSwap"), tr("Swap"), tr("Swap start and target"));
  copy_ = makeButton(buttons_, QStringLiteral("pathCopy"), tr("Copy"), tr("Copy places and figures as text"));
  clear_ = makeButton(buttons_, QStringLiteral("pathClear"), tr("Clear"), tr("Remove both places"));

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(10, 6, 8, 8);
  layout->setSpacing(6);
  layout->addLayout(form);
  layout->addWidget(frame_);
  layout->addWidget(failure_);
  layout->addWidget(text_);
  layout->addLayout(buttons_);
  layout->addStretch(1);

  connect(start_, &PlaceFields::edited, this, [this](const Vec3& place) { model_.setStart(place); });
  connect(target_, &PlaceFields::edited, this, [this](const Vec3& place) { model_.setTarget(place); });
  connect(speed_, &NumberField::valueEdited, this, [this] {
    showResult();
    emit speedEdited();
  });
  connect(swap_, &QPushButton::clicked, this, [this] { model_.setPlaces(model_.target(), model_.start()); });
  connect(clear_, &QPushButton::clicked, this, [this] { model_.setPlaces(std::nullopt, std::nullopt); });
  connect(copy_, &QPushButton::clicked, this, [this] {
    QStringList lines{tr("Start %1").arg(units_.place(*model_.start())),
                      tr("Target %1").arg(units_.place(*model_.target()))};
    lines << frame_->text();
    for (const QLabel* label : {failure_, text_})
      if (!label->text().isEmpty()) lines << label->text();
    QApplication::clipboard()->setText(lines.join(QLatin1Char('\n')) + QLatin1Char('\n'));
  });
  connect(body_, &BodyFields::problemChanged, this, &PathPanel::showResult);
  connect(&model_, &PathModel::placesChanged, this, [this] {
    start_->setPlace(model_.start());
    target_->setPlace(model_.target());
    showResult();
  });
  for (const auto changed : {&PathModel::resultChanged, &PathModel::preparingChanged})
    connect(&model_, changed, this, &PathPanel::showResult);
  showResult();
}

void PathPanel::setUnits(const LevelUnits& units) {
  units_ = units;
  start_->setUnits(units);
  target_->setUnits(units);
  body_->setUnits(units);
  frame_->setText(units.frameText());
  showResult();
}

void PathPanel::addBelowFailure(QWidget* widget) {
  auto* rows = static_cast<QVBoxLayout*>(layout());
  rows->insertWidget(rows->indexOf(failure_) + 1, widget);
}

void PathPanel::addBelowText(QWidget* widget) {
  auto* rows = static_cast<QVBoxLayout*>(layout());
  rows->insertWidget(rows->indexOf(text_) + 1, widget);
}

void PathPanel::addButton(QPushButton* button) { buttons_->addWidget(button); }

void PathPanel::setNotice(const QString& notice) {
  notice_ = notice;
  showResult();
}

void PathPanel::setMargins(bool margins) {
  hasMargins_ = margins;
  showResult();
}

void PathPanel::setSpeed(double metresPerSecond) {
  speed_->setValue(metresPerSecond);
  showResult();
}

void PathPanel::showResult() {
  const auto& result = model_.result();
  const auto& body = model_.bodyPath();
  QString failure, text;
  if (!notice_.isEmpty()) {
    text = notice_;
  } else if (model_.isPreparing()) {
    text = tr("Measuring the passages …");
  } else if (result || body) {
    failure = result ? failureText(*result, units_) : bodyFailureText(*body, units_);
    QStringList lines;
    if (result) lines << pathText(*result, units_, speed_->value());
    if (body) lines << narrowestText(*body, units_);
    if (body && hasMargins_) lines << tr("The filter Radius is left out: the body has a radius of its own.");
    lines.removeAll(QString());
    text = lines.join(QLatin1Char('\n'));
  } else if (!model_.start() || !model_.target()) {
    text = tr("Click two places in the view, or enter them here.");
  }
  if (!body_->problem().isEmpty()) failure = body_->problem();
  failure_->setText(failure);
  failure_->setVisible(!failure.isEmpty());
  text_->setText(text);
  const bool both = model_.start() && model_.target();
  swap_->setEnabled(both);
  copy_->setEnabled(both);
  clear_->setEnabled(model_.start() || model_.target());
}

}  // namespace footfall::ui
