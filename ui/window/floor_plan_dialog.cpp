// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/floor_plan_dialog.hpp"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/base/namespaces.hpp"

namespace footfall::ui {

FloorPlanDialog::FloorPlanDialog(QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("floorPlanDialog"));
  setWindowTitle(tr("Floor plan"));
  auto* form = new QFormLayout;
  const auto addChoice = [this, form](const char* id, const QString& label, const QString& help) {
    auto* choice = new QComboBox(this);
    choice->setObjectName(QString::fromLatin1(id));
    choice->setToolTip(help);
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

  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  QPushButton* save = buttons->addButton(tr("Save as..."), QDialogButtonBox::AcceptRole);
  save->setObjectName(QStringLiteral("planSave"));
  save->setToolTip(tr("Choose the file, PDF or SVG, and draw the plan"));
  save->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  layout->addWidget(buttons);
}

PlanOptions FloorPlanDialog::options() const {
  PlanOptions options;
  options.pages = static_cast<PlanPages>(pages_->currentData().toInt());
  options.colours = static_cast<PlanColours>(colours_->currentData().toInt());
  if (const double scale = scale_->currentData().toDouble(); scale > 0) options.scale = scale;
  if (const int paper = paper_->currentData().toInt(); paper >= 0) options.paper = static_cast<Paper>(paper);
  return options;
}

}  // namespace footfall::ui
