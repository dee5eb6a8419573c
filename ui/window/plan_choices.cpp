// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/plan_choices.hpp"

#include <QFormLayout>
#include <QHBoxLayout>
#include <algorithm>

#include "ui/base/namespaces.hpp"
#include "ui/base/widgets/positive_number.hpp"

namespace footfall::ui {

namespace {

constexpr double kUsualWidth = 1;  // metres: two people do not pass each other

ParameterDescriptor bottleneckWidth() {
  ParameterDescriptor number = positiveNumber("width", "Width of bottlenecks", kUsualWidth);
  number.unit = Unit::Length;
  return number;
}

}  // namespace

PlanChoices::PlanChoices(QWidget* parent) : QWidget(parent) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  const auto addChoice = [this, form](const char* id, const QString& label, const QString& help) {
    auto* choice = new QComboBox(this);
    choice->setObjectName(QString::fromLatin1(id));
    choice->setToolTip(help);
    connect(choice, &QComboBox::currentIndexChanged, this, &PlanChoices::changed);
    form->addRow(label, choice);
    return choice;
  };
  pages_ = addChoice("planPages", tr("&Pages"), tr("What each page of the plan shows"));
  pages_->addItem(tr("One for each storey"), static_cast<int>(PlanPages::Storeys));
  pages_->addItem(tr("One for each layer"), static_cast<int>(PlanPages::Layers));
  scale_ = addChoice("planScale", tr("&Scale"), tr("How large the plan is drawn"));
  scale_->addItem(tr("As large as fits"), 0.0);
  for (const int scale : {20, 50, 100, 200, 500, 1000, 2000, 5000})
    scale_->addItem(QStringLiteral("1:%1").arg(scale), static_cast<double>(scale));
  paper_ = addChoice("planPaper", tr("P&aper"), tr("The size of a page"));
  paper_->addItem(tr("As needed"), -1);
  for (const Paper paper : {Paper::A4, Paper::A3, Paper::A2, Paper::A1, Paper::A0})
    paper_->addItem(QStringLiteral("A%1").arg(4 - static_cast<int>(paper)), static_cast<int>(paper));
  colours_ = addChoice("planColours", tr("&Colours"), tr("For the screen or for printing"));
  colours_->addItem(tr("In colour"), static_cast<int>(PlanColours::Colour));
  colours_->addItem(tr("Black and white"), static_cast<int>(PlanColours::BlackAndWhite));
  const auto addBox = [this](const char* id, const QString& text, const QString& help) {
    auto* box = new QCheckBox(text, this);
    box->setObjectName(QString::fromLatin1(id));
    box->setToolTip(help);
    connect(box, &QCheckBox::toggled, this, &PlanChoices::changed);
    return box;
  };
  corridors_ = addBox("planCorridors", tr("Corridor &map"), tr("Draw lines in the middle of all passages"));
  bottlenecks_ = addBox("planBottlenecks", tr("&Bottlenecks narrower than"),
                        tr("Draw passages narrower than this as dimension lines with their widths"));
  width_ = new NumberField(bottleneckWidth(), this);
  width_->setObjectName(QStringLiteral("planWidth"));
  width_->setAccessibleName(tr("Width of bottlenecks"));
  width_->setToolTip(tr("Wider passages get no dimension line"));
  width_->setFixedWidth(72);
  width_->setEnabled(false);
  unit_ = new QLabel(this);
  connect(bottlenecks_, &QCheckBox::toggled, width_, &QWidget::setEnabled);
  connect(width_, &NumberField::valueEdited, this, &PlanChoices::changed);
  connect(width_, &NumberField::problemChanged, this, &PlanChoices::changed);
  auto* row = new QHBoxLayout;
  row->addWidget(bottlenecks_);
  row->addWidget(width_);
  row->addWidget(unit_, 1);
  form->addRow(corridors_);
  form->addRow(row);
  setUnits({});
}

void PlanChoices::setUnits(const LevelUnits& units) {
  width_->setUnits(units);
  width_->setValue(kUsualWidth / units.metresPerUnit);
  unit_->setText(units.name());
}

QString PlanChoices::problem() const {
  if (!bottlenecks_->isChecked() || width_->problem().isEmpty()) return {};
  return tr("Width of bottlenecks: %1").arg(width_->problem());
}

PlanOptions PlanChoices::options() const {
  PlanOptions options;
  options.pages = static_cast<PlanPages>(pages_->currentData().toInt());
  options.colours = static_cast<PlanColours>(colours_->currentData().toInt());
  if (const double scale = scale_->currentData().toDouble(); scale > 0) options.scale = scale;
  if (const int paper = paper_->currentData().toInt(); paper >= 0) options.paper = static_cast<Paper>(paper);
  options.hasCorridors = corridors_->isChecked();
  if (bottlenecks_->isChecked()) options.narrowerThan = width_->value();
  return options;
}

void PlanChoices::setOptions(const PlanOptions& options) {
  const auto choose = [](QComboBox* box, const QVariant& value) {
    box->setCurrentIndex(std::max(0, box->findData(value)));
  };
  choose(pages_, static_cast<int>(options.pages));
  choose(scale_, options.scale.value_or(0));
  choose(paper_, options.paper ? static_cast<int>(*options.paper) : -1);
  choose(colours_, static_cast<int>(options.colours));
  corridors_->setChecked(options.hasCorridors);
  bottlenecks_->setChecked(options.narrowerThan.has_value());
  if (options.narrowerThan) width_->setValue(*options.narrowerThan);
}

}  // namespace footfall::ui
