// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspect/corridors/corridors_panel.hpp"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>
#include <cmath>
#include <cstdint>
#include <utility>

#include "ui/base/text/counted_noun.hpp"
#include "ui/base/text/localized_numbers.hpp"
#include "ui/base/widgets/list_table.hpp"
#include "ui/base/widgets/positive_number.hpp"
#include "ui/inspect/corridors/corridor_colours.hpp"

namespace footfall::ui {
namespace {

constexpr double kUsualWidth = 0.6;  // metres: a person, shoulder to shoulder

ParameterDescriptor agentWidthNumber() {
  ParameterDescriptor number = positiveNumber("width", "Width of an agent", kUsualWidth);
  number.unit = Unit::Length;
  return number;
}

}  // namespace

CorridorsPanel::CorridorsPanel(QWidget* parent)
    : QWidget(parent),
      width_(new NumberField(agentWidthNumber(), this)),
      unit_(new QLabel(this)),
      problem_(new QLabel(this)),
      colours_(new QLabel(this)),
      summary_(new QLabel(this)),
      frame_(new QLabel(this)),
      map_(new QCheckBox(tr("Show the &map"), this)),
      only_(new QCheckBox(tr("&Only those without another way"), this)),
      table_(new QTableView(this)),
      copy_(new QPushButton(tr("Copy as text"), this)) {
  setObjectName(QStringLiteral("corridorsPanel"));
  width_->setObjectName(QStringLiteral("corridorsWidth"));
  width_->setAccessibleName(tr("Width of an agent"));
  width_->setToolTip(tr("Width of an agent; narrower passages are too narrow for it"));
  width_->setFixedWidth(72);
  width_->setValue(kUsualWidth);
  auto* label = new QLabel(tr("&Agent's width"), this);
  label->setBuddy(width_);
  width_->takeDragsOf(label);
  problem_->setObjectName(QStringLiteral("rowError"));
  problem_->setWordWrap(true);
  problem_->hide();
  map_->setObjectName(QStringLiteral("corridorsMap"));
  map_->setToolTip(tr("Draw the middle lines of all passages in the colours of their widths"));
  map_->setChecked(true);
  only_->setObjectName(QStringLiteral("corridorsOnlyWays"));
  only_->setToolTip(tr("List only bottlenecks that everybody must pass to get from one side to the other"));
  colours_->setObjectName(QStringLiteral("corridorsColours"));
  colours_->setAccessibleName(tr("Colours of the map, narrow to wide"));
  colours_->setTextFormat(Qt::RichText);
  colours_->setWordWrap(true);
  summary_->setObjectName(QStringLiteral("corridorsSummary"));
  summary_->setTextFormat(Qt::PlainText);
  summary_->setWordWrap(true);
  summary_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  table_->setObjectName(QStringLiteral("corridorsTable"));
  table_->setAccessibleName(tr("Bottlenecks, narrowest first"));
  table_->setToolTip(tr("Click a bottleneck, or press Return on it, to bring it into sight"));
  table_->setModel(&model_);
  prepareList(*table_);
  table_->horizontalHeader()->setStretchLastSection(true);
  setColumnWidths(*table_, {{BottleneckModel::Width, 10}, {BottleneckModel::Agent, 13}, {BottleneckModel::Sides, 34}});
  frame_->setObjectName(QStringLiteral("corridorsFrame"));
  frame_->setWordWrap(true);
  frame_->setEnabled(false);
  copy_->setObjectName(QStringLiteral("corridorsCopy"));
  copy_->setToolTip(tr("Copy the list to the clipboard, with tabs for a spreadsheet"));

  auto* head = new QHBoxLayout;
  head->addWidget(label);
  head->addWidget(width_);
  head->addWidget(unit_, 1);
  auto* foot = new QHBoxLayout;
  foot->addWidget(frame_, 1);
  foot->addWidget(copy_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(10, 6, 8, 8);
  layout->setSpacing(6);
  layout->addLayout(head);
  layout->addWidget(problem_);
  layout->addWidget(map_);
  layout->addWidget(colours_);
  layout->addWidget(only_);
  layout->addWidget(summary_);
  layout->addWidget(table_, 1);
  layout->addLayout(foot);

  connect(width_, &NumberField::valueEdited, this, [this](double width) {
    setAgentWidth(width);
    emit agentWidthEdited();
  });
  connect(width_, &NumberField::problemChanged, this, [this] {
    problem_->setText(width_->problem());
    problem_->setVisible(!width_->problem().isEmpty());
  });
  connect(map_, &QCheckBox::toggled, this, &CorridorsPanel::mapToggled);
  connect(only_, &QCheckBox::toggled, this, [this](bool only) {
    model_.setOnlyWays(only);
    describe();
    emit chosen(-1);  // it may be another bottleneck now
    emit onlyWaysToggled(only);
  });
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& current) { emit chosen(current.isValid() ? current.row() : -1); });
  onRowChosen(*table_, [this](int row) { emit frameRequested(row); });
  connect(copy_, &QPushButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(model_.toText()); });
  setUnits({});
  setAgentWidth(kUsualWidth);
}

QSize CorridorsPanel::sizeHint() const {
  return {52 * table_->fontMetrics().horizontalAdvance(QLatin1Char('0')), QWidget::sizeHint().height()};
}

void CorridorsPanel::show(std::shared_ptr<const ShownCorridors> shown, const QString& note) {
  note_ = note;
  if (shown != model_.shown()) {
    model_.setShown(std::move(shown));
    emit chosen(-1);  // it may be another bottleneck now
  }
  describe();
}

void CorridorsPanel::setWaiting(bool waiting) {
  summary_->setEnabled(!waiting);
  table_->setEnabled(!waiting);
}

void CorridorsPanel::setUnits(const LevelUnits& units) {
  units_ = units;
  model_.setUnits(units);
  width_->setUnits(units);
  unit_->setText(units.name());
  frame_->setText(units.frameText());
  describe();
  describeColours();
}

void CorridorsPanel::setAgentWidth(double width) {
  width_->setValue(width);
  model_.setAgentWidth(width);
  describe();
  describeColours();
  emit agentWidthChanged();
}

void CorridorsPanel::describeColours() {
  QStringList parts;
  for (std::size_t i = 0; i < kWidthColours; ++i) {
    const double limit = model_.agentWidth() * kWidthLimits.at(std::min(i, kWidthLimits.size() - 1));
    const QString text = i + 1 == kWidthColours ? tr("wider")
                         : i == 0               ? tr("below %1").arg(units_.length(limit))
                                                : tr("to %1").arg(units_.length(limit));
    parts << QStringLiteral(
                 "<span style=\"white-space:nowrap\"><span style=\"color:%1\">█</span>&nbsp;%2</span>&nbsp;&nbsp;")
                 .arg(widthColour(i).name(), text.toHtmlEscaped().replace(QLatin1Char(' '), QStringLiteral("&nbsp;")));
  }
  colours_->setText(parts.join(QLatin1Char(' ')));
}

void CorridorsPanel::describe() {
  const auto& shown = model_.shown();
  copy_->setEnabled(model_.rowCount() > 0);
  if (!shown) {
    summary_->setText(note_);
    return;
  }
  const int count = model_.rowCount(), tooNarrow = model_.tooNarrow();
  QStringList lines;
  lines << (count == 0 ? tr("No bottlenecks")
                       : countedText(static_cast<std::uint64_t>(count), tr("bottleneck"), tr("bottlenecks")));
  if (tooNarrow > 0)
    lines.last() += tr(", %1 too narrow for the agent").arg(countText(static_cast<std::uint64_t>(tooNarrow)));
  if (shown->list.slits > 0)
    lines << tr("%n slits of at most %1 are left out.", "", static_cast<int>(shown->list.slits))
                 .arg(units_.length(shown->slit));
  if (shown->list.shallow > 0)
    lines << tr("%n places are left out from which the way gets wider by less than %1 %.", "",
                static_cast<int>(shown->list.shallow))
                 .arg(countText(static_cast<std::uint64_t>(std::lround(100 * kUsualProminence))));
  if (shown->isWithoutRadius) lines << tr("Measured without the filter Radius, which makes passages narrower.");
  if (shown->lines.leftOut > 0)
    lines << tr("The widest %n pieces of the map are not drawn.", "", static_cast<int>(shown->lines.leftOut));
  if (!note_.isEmpty()) lines << note_;
  summary_->setText(lines.join(QLatin1Char('\n')));
}

}  // namespace footfall::ui
