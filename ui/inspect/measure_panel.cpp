// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspect/measure_panel.hpp"

#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QHeaderView>
#include <QInputDialog>
#include <QVBoxLayout>
#include <array>
#include <cmath>

#include "ui/base/text/localized_numbers.hpp"
#include "ui/base/widgets/flow_layout.hpp"

namespace footfall::ui {

MeasurePanel::MeasurePanel(MeasureTool& tool, QWidget* parent) : QWidget(parent), tool_(tool) {
  setObjectName(QStringLiteral("measurePanel"));
  table_ = new QTableWidget(0, 5, this);
  table_->setObjectName(QStringLiteral("measureTable"));
  table_->setAccessibleName(tr("Measured pieces"));
  table_->setToolTip(tr("Each piece between two places; height and slope from the first place to the second"));
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->verticalHeader()->hide();
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setTabKeyNavigation(false);
  table_->setMinimumHeight(90);
  sum_ = new QLabel(this);
  sum_->setObjectName(QStringLiteral("measureSum"));
  sum_->setWordWrap(true);
  sum_->setTextInteractionFlags(Qt::TextSelectableByMouse);

  auto* buttons = new FlowLayout(6);
  const auto add = [&](const QString& id, const QString& text, const QString& help) {
    auto* button = new QPushButton(text, this);
    button->setObjectName(id);
    button->setToolTip(help);
    buttons->addWidget(button);
    return button;
  };
  copy_ = add(QStringLiteral("measureCopy"), tr("Copy"), tr("Copy places and measures as a table"));
  back_ = add(QStringLiteral("measureBack"), tr("Remove last"), tr("Remove the last place"));
  scale_ = add(QStringLiteral("measureScale"), tr("Set scale..."),
               tr("Enter the length of the last piece in metres, to set the scale of the level"));
  clear_ = add(QStringLiteral("measureClear"), tr("Clear"), tr("Remove all places"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(10, 6, 8, 8);
  layout->setSpacing(6);
  layout->addWidget(table_, 1);
  layout->addWidget(sum_);
  frame_ = new QLabel(this);
  frame_->setObjectName(QStringLiteral("measureFrame"));
  frame_->setWordWrap(true);
  frame_->setEnabled(false);
  layout->addWidget(frame_);
  layout->addLayout(buttons);

  connect(copy_, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(tool_.text()); });
  connect(back_, &QPushButton::clicked, &tool_, &MeasureTool::removeLast);
  connect(scale_, &QPushButton::clicked, this, &MeasurePanel::askForLength);
  connect(clear_, &QPushButton::clicked, this, [this] { tool_.setPlaces({}); });
  connect(&tool_, &MeasureTool::placesChanged, this, &MeasurePanel::showPlaces);
  connect(&tool_, &MeasureTool::unitsChanged, this, &MeasurePanel::showPlaces);
  showPlaces();
}

void MeasurePanel::showPlaces() {
  const auto& places = tool_.places();
  const LevelUnits& units = tool_.units();
  // The unit is shown below, because five columns have no room for it in a narrow panel.
  table_->setHorizontalHeaderLabels({tr("Length"), tr("In plan"), tr("Height"), tr("Slope °"), tr("Slope %")});
  frame_->setText(units.frameText());
  const int rows = places.size() > 1 ? static_cast<int>(places.size()) - 1 : 0;
  table_->setRowCount(rows);
  double distance = 0, plan = 0;
  for (int i = 0; i < rows; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Measure m = measureBetween(places[k], places[k + 1]);
    distance += m.distance;
    plan += m.plan;
    const std::array<QString, 5> fields{units.lengthNumber(m.distance), units.lengthNumber(m.plan),
                                        units.lengthNumber(m.height), fixedText(m.degrees, 1), fixedText(m.percent, 1)};
    for (int column = 0; column < 5; ++column) {
      auto* item = new QTableWidgetItem(fields[static_cast<std::size_t>(column)]);
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      item->setToolTip(measureSummary(m, units));
      table_->setItem(i, column, item);
    }
  }
  sum_->setText(places.empty() ? tr("Click two or more places in the view.")
                : rows == 0    ? tr("From %1").arg(units.place(places.front()))
                : rows == 1    ? tr("From %1\nto %2").arg(units.place(places[0]), units.place(places[1]))
                               : tr("Together %1, in the plan %2").arg(units.length(distance), units.length(plan)));
  copy_->setEnabled(!places.empty());
  back_->setEnabled(!places.empty());
  clear_->setEnabled(!places.empty());
  scale_->setEnabled(rows > 0);
}

// The last piece is the reference: a door, a step, the length of a building.
void MeasurePanel::askForLength() {
  const auto& places = tool_.places();
  if (places.size() < 2) return;
  const double length = measureBetween(places[places.size() - 2], places.back()).distance;
  if (!(length > 0)) return;
  auto* dialog = new QInputDialog(this);
  dialog->setObjectName(QStringLiteral("scaleByReference"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Scale by reference"));
  dialog->setInputMode(QInputDialog::DoubleInput);
  dialog->setLabelText(
      tr("The last piece is %1 of the file's units long. How many metres is that?").arg(shortText(length, 6)));
  dialog->setDoubleRange(1e-6, 1e6);
  dialog->setDoubleDecimals(4);
  dialog->setDoubleValue(length * tool_.units().metresPerUnit);
  connect(dialog, &QInputDialog::doubleValueSelected, this,
          [this, length](double metres) { emit scaleChosen(metres / length); });
  dialog->open();
}

MeasureFeature::MeasureFeature(const FeatureHost& host, LevelView& view, LevelFile& file, LevelComposer& composer,
                               ImportPanel& import)
    : QObject(&host.window), tool_(view, [&composer] { return composer.level(); }) {
  auto* panel = new MeasurePanel(tool_);
  connect(panel, &MeasurePanel::scaleChosen, &import, &ImportPanel::chooseScale);
  QDockWidget* dock = host.panels.add({QStringLiteral("panel.measure"),
                                       tr("Measure"),
                                       tr("Distances, heights and slopes between places"),
                                       {},
                                       {},
                                       Qt::RightDockWidgetArea,
                                       false},
                                      panel);
  host.tools.add({QStringLiteral("tools.measure"),
                  CommandMenu::Tools,
                  QStringLiteral("tools"),
                  tr("&Measure"),
                  tr("Distance, height and slope between places that you click"),
                  {Qt::Key_M},
                  QStringLiteral("measure")},
                 &tool_, dock);
  host.commands.add({.id = QStringLiteral("tools.scaleByReference"),
                     .menu = CommandMenu::Tools,
                     .group = QStringLiteral("tools"),
                     .text = tr("Scale b&y reference..."),
                     .help = tr("Click two places whose distance you know, and type it")},
                    [this, &host, &view, panel](bool) {
                      if (tool_.places().size() > 1) return panel->askForLength();
                      host.commands.find(QStringLiteral("tools.measure"))->trigger();
                    });
  const auto follow = [this, &view, dock] { tool_.setShown(view.tool() == &tool_ || !dock->isHidden()); };
  connect(&view, &LevelView::toolChanged, this, follow);
  connect(dock, &QDockWidget::visibilityChanged, this, follow);
  connect(&file, &LevelFile::opened, this, [this] { tool_.setPlaces({}); });
  const auto takeUnits = [this, &units = host.units] { tool_.setUnits(units.units()); };
  connect(&host.units, &UnitChoice::changed, this, takeUnits);
  takeUnits();
}

}  // namespace footfall::ui
