// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/path/walk/walk_bar.hpp"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <array>
#include <cmath>

#include "ui/base/look/icon.hpp"
#include "ui/base/text/localized_numbers.hpp"
#include "ui/base/widgets/flow_layout.hpp"

namespace footfall::ui {
namespace {

constexpr int kSteps = 1000;  // of the slider
constexpr std::array kPaces{0.25, 0.5, 1.0, 2.0, 4.0, 8.0};
constexpr int kUsualPace = 2;

}  // namespace

WalkBar::WalkBar(Walker& walker, WalkerView& view, QWidget* parent) : QWidget(parent), walker_(walker), view_(view) {
  setObjectName(QStringLiteral("walkBar"));
  play_ = new QToolButton(this);
  play_->setObjectName(QStringLiteral("walkPlay"));
  play_->setFocusPolicy(Qt::StrongFocus);
  slider_ = new QSlider(Qt::Horizontal, this);
  slider_->setObjectName(QStringLiteral("walkTime"));
  slider_->setRange(0, kSteps);
  slider_->setPageStep(kSteps / 20);
  slider_->setSingleStep(kSteps / 100);
  slider_->setAccessibleName(tr("Time on the way"));
  slider_->setToolTip(tr("Where the walker is on the path"));
  time_ = new QLabel(this);
  time_->setObjectName(QStringLiteral("walkSeconds"));
  pace_ = new QComboBox(this);
  pace_->setObjectName(QStringLiteral("walkPace"));
  pace_->setAccessibleName(tr("Pace of the playback"));
  pace_->setToolTip(tr("How fast the walk is played"));
  for (const double pace : kPaces) pace_->addItem(tr("%1 ×").arg(shortText(pace, 3)), pace);
  pace_->setCurrentIndex(kUsualPace);
  camera_ = new QComboBox(this);
  camera_->setObjectName(QStringLiteral("walkCamera"));
  camera_->setAccessibleName(tr("Camera of the walker"));
  camera_->setToolTip(tr("Where the camera is while the walker goes"));
  camera_->addItem(tr("Camera stays"), static_cast<int>(WalkCamera::Free));
  camera_->addItem(tr("Camera follows"), static_cast<int>(WalkCamera::Follows));
  camera_->addItem(tr("Through its eyes"), static_cast<int>(WalkCamera::Eyes));

  auto* time = new QHBoxLayout;
  time->setSpacing(6);
  time->addWidget(play_);
  time->addWidget(slider_, 1);
  time->addWidget(time_);
  auto* choices = new FlowLayout(6);
  choices->addWidget(camera_);
  choices->addWidget(pace_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);
  layout->addLayout(time);
  layout->addLayout(choices);

  connect(play_, &QToolButton::clicked, this, [this] { walker_.setPlaying(!walker_.isPlaying()); });
  connect(slider_, &QSlider::valueChanged, this, [this](int value) {
    walker_.setPlaying(false);
    walker_.setTime(walker_.track().seconds() * value / kSteps);
  });
  connect(pace_, &QComboBox::currentIndexChanged, this, [this] { walker_.setPace(pace_->currentData().toDouble()); });
  connect(camera_, &QComboBox::currentIndexChanged, this,
          [this] { view_.setCamera(static_cast<WalkCamera>(camera_->currentData().toInt())); });
  for (QComboBox* box : {pace_, camera_}) connect(box, &QComboBox::currentIndexChanged, this, &WalkBar::chosen);
  connect(&walker_, &Walker::changed, this, &WalkBar::showTime);
  showTime();
}

void WalkBar::choose(double pace, WalkCamera camera) {
  const auto take = [](QComboBox& box, const QVariant& data) {
    if (const int index = box.findData(data); index >= 0) box.setCurrentIndex(index);
  };
  take(*pace_, pace);
  take(*camera_, static_cast<int>(camera));
}

void WalkBar::showTime() {
  const bool isPlaying = walker_.isPlaying();
  play_->setIcon(icon(isPlaying ? QStringLiteral("pause") : QStringLiteral("run")));
  play_->setToolTip(isPlaying ? tr("Pause (Space in the view)") : tr("Walk the path (Space in the view)"));
  play_->setAccessibleName(isPlaying ? tr("Pause") : tr("Walk the path"));
  const double all = walker_.track().seconds();
  const QSignalBlocker blocked(slider_);
  slider_->setValue(all > 0 ? static_cast<int>(std::lround(kSteps * walker_.time() / all)) : 0);
  time_->setText(walker_.track().isEmpty() ? QString()
                                           : tr("%1 of %2 s").arg(fixedText(walker_.time(), 1), fixedText(all, 1)));
  setEnabled(!walker_.track().isEmpty());
}

}  // namespace footfall::ui
