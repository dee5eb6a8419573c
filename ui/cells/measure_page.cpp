// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cells/measure_page.hpp"

#include <QHBoxLayout>
#include <QScrollArea>
#include <QVBoxLayout>
#include <functional>

#include "ui/base/commands/keys_back.hpp"
#include "ui/base/text/localized_numbers.hpp"
#include "ui/cells/balance_plot.hpp"
#include "ui/cells/timeline.hpp"
#include "ui/view/cells/cell_colours.hpp"

namespace footfall::ui {
namespace {

constexpr int kMostRuns = 50;
constexpr int kUsualRuns = 5;

QString line(const QString& name, const QString& median, const QString& least, const QString& most) {
  return QStringLiteral(
             "<tr><td>%1&nbsp;&nbsp;</td><td align='right'><b>%2</b></td><td align='right'>&nbsp;&nbsp;%3"
             "</td><td align='right'>&nbsp;&nbsp;%4</td></tr>")
      .arg(name.toHtmlEscaped(), median, least, most);
}

QString line(const QString& name, const std::vector<MeasuredRun>& runs,
             const std::function<double(const MeasuredRun&)>& value, const std::function<QString(double)>& text) {
  std::vector<double> values;
  for (const MeasuredRun& run : runs) values.push_back(value(run));
  const Spread spread = spreadOf(std::move(values));
  return line(name, text(spread.median), text(spread.least), text(spread.most));
}

double imbalanceOf(const MeasuredRun& run) {
  double most = 1;
  for (const BlockReport& block : run.result.blocks) most = std::max(most, block.imbalance(run.result.threads));
  return most;
}

double waitedOf(const MeasuredRun& run) { return run.processors.waitedMs(0, run.result.totalMs); }

}  // namespace

QString measurementTable(const std::vector<MeasuredRun>& runs) {
  if (runs.empty()) return {};
  QString text = QStringLiteral("<table cellspacing=0 cellpadding=0>");
  text += line({}, MeasurePage::tr("median"), MeasurePage::tr("least"), MeasurePage::tr("most"));
  text += line(
      MeasurePage::tr("whole run"), runs, [](const auto& run) { return run.result.totalMs; }, durationText);
  const auto phases = phasesOf(runs.front().result.times);
  for (std::size_t i = 0; i < phases.size(); ++i)
    text += line(
        phases[i].name, runs, [i](const auto& run) { return phasesOf(run.result.times)[i].milliseconds; },
        durationText);
  const auto ratio = [](double value) { return fixedText(value, 2); };
  text += line(MeasurePage::tr("imbalance"), runs, imbalanceOf, ratio);
  text += line(
      MeasurePage::tr("processors in use"), runs,
      [](const auto& run) { return run.result.totalMs > 0 ? run.result.cpuMs / run.result.totalMs : 0; }, ratio);
  if (runs.front().processors.known())
    text += line(MeasurePage::tr("taken by other programs"), runs, waitedOf, durationText);
  return text + QStringLiteral("</table>");
}

MeasurePage::MeasurePage(LoadMeasurement& measurement, QWidget* parent) : QWidget(parent), measurement_(measurement) {
  setObjectName(QStringLiteral("measurePage"));
  count_ = new QSpinBox(this);
  count_->setRange(1, kMostRuns);
  count_->setValue(kUsualRuns);
  count_->setSuffix(tr(" runs"));
  count_->setAccessibleName(tr("How many runs"));
  count_->setToolTip(tr("The number of runs, one after the other"));
  button_ = new QPushButton(this);
  giveKeysBackAfterClick(*button_);
  state_ = new QLabel(this);
  state_->setWordWrap(true);
  table_ = new QLabel(this);
  table_->setTextFormat(Qt::RichText);
  table_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  table_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(table_);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  auto* head = new QHBoxLayout;
  head->addWidget(button_);
  head->addWidget(count_);
  head->addStretch(1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 4, 0, 0);
  layout->setSpacing(3);
  layout->addLayout(head);
  layout->addWidget(state_);
  layout->addWidget(scroll, 1);
  connect(button_, &QPushButton::clicked, this, [this] {
    if (measurement_.busy())
      measurement_.stop();
    else
      emit requested(count_->value());
  });
  connect(&measurement_, &LoadMeasurement::progressed, this, &MeasurePage::showProgress);
  connect(&measurement_, &LoadMeasurement::finished, this, &MeasurePage::showTable);
  connect(&measurement_, &LoadMeasurement::ended, this, &MeasurePage::showTable);
  connect(&measurement_, &LoadMeasurement::failed, this, [this](const QString& message) {
    showTable();
    state_->setText(message);
  });
  showTable();
}

void MeasurePage::setObstacle(const QString& text) {
  obstacle_ = text;
  if (!measurement_.busy()) showTable();
}

void MeasurePage::showProgress(int done, int all) {
  button_->setText(tr("Stop"));
  button_->setEnabled(true);
  count_->setEnabled(false);
  state_->setText(tr("Run %1 of %2 is under way.").arg(done + 1).arg(all));
}

void MeasurePage::showTable() {
  button_->setText(tr("Measure again"));
  button_->setToolTip(tr("Run the whole pipeline several times, without caches"));
  button_->setEnabled(obstacle_.isEmpty());
  count_->setEnabled(obstacle_.isEmpty());
  table_->setText(measurementTable(measurement_.runs()));
  const auto count = static_cast<int>(measurement_.runs().size());
  if (!obstacle_.isEmpty())
    state_->setText(obstacle_);
  else if (count > 0)
    state_->setText(tr("%n run(s), nothing from caches; the timeline shows the median one.", nullptr, count));
  else
    state_->setText(tr("Runs the whole pipeline anew, without caches and previews. An edit stops it."));
}

}  // namespace footfall::ui
