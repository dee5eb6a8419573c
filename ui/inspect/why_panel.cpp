// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspect/why_panel.hpp"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "footfall/pipeline.hpp"
#include "ui/base/widgets/flow_layout.hpp"
#include "ui/inspect/why_text.hpp"

namespace footfall::ui {
namespace {

constexpr QSize kReasonSwatch(22, 22);

/// A wrapped text that mouse and keyboard can select.
QLabel* makeText(QWidget* parent, const QString& name) {
  auto* label = new QLabel(parent);
  label->setObjectName(name);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  return label;
}

}  // namespace

WhyPanel::WhyPanel(QWidget* parent) : QWidget(parent), pages_(new QStackedWidget(this)) {
  setObjectName(QStringLiteral("whyPanel"));
  pages_->addWidget(makeEmptyPage());
  pages_->addWidget(makeAnswerPage());
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(pages_);
}

QWidget* WhyPanel::makeEmptyPage() {
  auto* page = new QWidget(this);
  auto* text = new QLabel(tr("Choose Tools > Why? (Y) and click a place in the view: this panel then says why it is "
                             "walkable, or which filter rejected it and what stands in the way."),
                          page);
  text->setObjectName(QStringLiteral("whyEmpty"));
  text->setWordWrap(true);
  text->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* layout = new QVBoxLayout(page);
  layout->addWidget(text, 1);
  return page;
}

QLabel* WhyPanel::addFigure(QGridLayout* grid, const QString& name, const QString& objectName) {
  const int row = grid->rowCount();
  auto* title = new QLabel(name, this);
  QLabel* value = makeText(this, objectName);
  title->setBuddy(value);
  value->setAccessibleName(name);
  grid->addWidget(title, row, 0, Qt::AlignTop);
  grid->addWidget(value, row, 1);
  return value;
}

QWidget* WhyPanel::makeAnswerPage() {
  auto* page = new QWidget(this);
  swatch_ = new QLabel(page);
  swatch_->setFixedSize(kReasonSwatch);
  swatch_->setAccessibleName(tr("Its colour in the view"));
  headline_ = makeText(page, QStringLiteral("whyHeadline"));
  headline_->setAccessibleName(tr("Verdict"));
  QFont bold = headline_->font();
  bold.setBold(true);
  headline_->setFont(bold);
  auto* head = new QHBoxLayout;
  head->addWidget(swatch_, 0, Qt::AlignTop);
  head->addWidget(headline_, 1);
  reason_ = makeText(page, QStringLiteral("whyReason"));
  reason_->setAccessibleName(tr("Reason"));

  auto* grid = new QGridLayout;
  grid->setColumnStretch(1, 1);
  place_ = addFigure(grid, tr("Where"), QStringLiteral("whyPlace"));
  triangle_ = addFigure(grid, tr("Triangle"), QStringLiteral("whyTriangle"));
  triangle_->setToolTip(
      tr("Counted from 0 in the order of the file, without ignored parts; with the names of mesh and material"));
  slope_ = addFigure(grid, tr("Slope"), QStringLiteral("whySlope"));
  slope_->setToolTip(tr("Between the upper side of the triangle and the horizontal; beyond 90° it faces down"));
  headroom_ = addFigure(grid, tr("Free height"), QStringLiteral("whyHeadroom"));
  headroom_->setToolTip(tr("Up to the lowest triangle straight above"));
  borders_ = addFigure(grid, tr("Borders"), QStringLiteral("whyBorders"));
  borders_->setToolTip(
      tr("How far the nearest wall and the nearest ledge are, straight over the walkable area as it is "
         "before a radius narrows it, seen from above"));

  showFilter_ = new QPushButton(page);
  showFilter_->setObjectName(QStringLiteral("whyShowFilter"));
  showFilter_->setToolTip(tr("Go to the filter that rejected this place, in the list"));
  frameObstacle_ = new QPushButton(tr("Frame the &obstacle"), page);
  frameObstacle_->setObjectName(QStringLiteral("whyFrameObstacle"));
  frameObstacle_->setToolTip(tr("Bring what stands in the way into sight"));
  framePlace_ = new QPushButton(tr("Frame the &place"), page);
  framePlace_->setObjectName(QStringLiteral("whyFramePlace"));
  framePlace_->setToolTip(tr("Bring the triangle into sight"));
  connect(showFilter_, &QPushButton::clicked, this, &WhyPanel::showFilterRequested);
  connect(frameObstacle_, &QPushButton::clicked, this, &WhyPanel::frameObstacleRequested);
  connect(framePlace_, &QPushButton::clicked, this, &WhyPanel::framePlaceRequested);
  auto* buttons = new FlowLayout(6);
  buttons->addWidget(framePlace_);
  buttons->addWidget(frameObstacle_);

  auto* layout = new QVBoxLayout(page);
  layout->addLayout(head);
  layout->addWidget(reason_);
  layout->addWidget(showFilter_);
  layout->addLayout(grid);
  frame_ = makeText(page, QStringLiteral("whyFrame"));
  frame_->setEnabled(false);
  layout->addWidget(frame_);
  layout->addLayout(buttons);
  layout->addStretch(1);
  return page;
}

void WhyPanel::show(const std::shared_ptr<const Inspector>& inspector, const PlaceExplanation& told,
                    const LevelUnits& units) {
  swatch_->setPixmap(paintSwatch(WhyText::paint(*inspector, told), kReasonSwatch, devicePixelRatioF()));
  headline_->setText(WhyText::headline(*inspector, told));
  reason_->setText(WhyText::reason(*inspector, told, units));
  place_->setText(units.place(told.place.point));
  frame_->setText(units.frameText());
  triangle_->setText(WhyText::triangle(*inspector, told.place.triangle));
  slope_->setText(WhyText::slope(told));
  headroom_->setText(WhyText::headroom(*inspector, told, units));
  borders_->setText(WhyText::borders(told, units));
  showFilter_->setVisible(told.step.has_value());
  if (told.step)
    showFilter_->setText(tr("Go to step %1: %2")
                             .arg(*told.step + 1)
                             .arg(QString::fromStdString(formatStep(inspector->pipeline().steps[*told.step]))
                                      .replace(QLatin1Char('&'), QStringLiteral("&&"))));
  frameObstacle_->setEnabled(told.obstacle || told.above || !told.walls.empty());
  pages_->setCurrentIndex(1);
  setWaiting(false);
}

void WhyPanel::clear() { pages_->setCurrentIndex(0); }

void WhyPanel::setWaiting(bool waiting) { headline_->setEnabled(!waiting); }

}  // namespace footfall::ui
