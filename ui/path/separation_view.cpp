// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/path/separation_view.hpp"

#include <QVBoxLayout>
#include <utility>

#include "ui/base/commands/keys_back.hpp"
#include "ui/base/widgets/flow_layout.hpp"

namespace footfall::ui {
namespace {

const QString kSeparationOverlay = QStringLiteral("separation");

const std::optional<Separation>& separationOf(const PathModel& model) {
  static const std::optional<Separation> kNone;
  return model.result() ? model.result()->separation : kNone;
}

}  // namespace

SeparationView::SeparationView(PathModel& model, LevelView& view, QWidget* parent)
    : QWidget(parent),
      model_(model),
      view_(view),
      text_(new QLabel(this)),
      show_(new QPushButton(tr("Show &it"), this)),
      mend_(new QPushButton(this)) {
  text_->setObjectName(QStringLiteral("pathSeparation"));
  text_->setTextFormat(Qt::PlainText);
  text_->setWordWrap(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  text_->setAccessibleName(tr("The obstacle between start and target"));
  show_->setObjectName(QStringLiteral("pathShowSeparation"));
  show_->setToolTip(tr("Bring the place into sight where the two parts are nearest to each other"));
  mend_->setObjectName(QStringLiteral("pathMend"));
  mend_->setToolTip(tr("Change the filter so that this place can be passed; undo takes it back"));
  auto* buttons = new FlowLayout(6);
  buttons->addWidget(show_);
  buttons->addWidget(mend_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(text_);
  layout->addLayout(buttons);
  connect(show_, &QPushButton::clicked, this, &SeparationView::frame);
  giveKeysBackAfterClick(*mend_);
  connect(mend_, &QPushButton::clicked, this, [this] {
    const auto& separation = separationOf(model_);
    if (const auto mend = separation && mends_ ? mends_(*separation) : std::nullopt) emit mendRequested(*mend);
  });
  connect(&model_, &PathModel::resultChanged, this, &SeparationView::update);
  hide();
}

void SeparationView::setWriter(LevelWriter writer) {
  write_ = std::move(writer);
  update();
}

void SeparationView::setMends(std::function<std::optional<SeparationMend>(const Separation&)> mends) {
  mends_ = std::move(mends);
  refreshMend();
}

void SeparationView::refreshMend() {
  const auto& separation = separationOf(model_);
  const auto mend = separation && mends_ ? mends_(*separation) : std::nullopt;
  mend_->setVisible(mend.has_value());
  if (mend) mend_->setText(mend->text);
}

void SeparationView::setShown(bool shown) {
  shown_ = shown;
  update();
}

void SeparationView::frame() {
  const auto& separation = separationOf(model_);
  if (!separation) return;
  const auto [lower, upper] = boundsOf(*separation, margin_);
  view_.cameraController().frame(lower, upper);
}

void SeparationView::update() {
  const auto& separation = separationOf(model_);
  const bool isKnown = separation && write_.length && write_.place;
  text_->setText(isKnown ? separationText(*separation, write_) : QString());
  setVisible(isKnown);
  refreshMend();
  if (!isKnown || !shown_) {
    view_.removeOverlay(kSeparationOverlay);
    return;
  }
  ViewOverlay overlay;
  overlay.throughWalls = true;
  addSeparation(overlay, *separation, write_);
  view_.setOverlay(kSeparationOverlay, std::move(overlay));
}

}  // namespace footfall::ui
