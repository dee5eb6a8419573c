// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cells/run_place_dialog.hpp"

#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>

#include "ui/base/text/core_text.hpp"

namespace footfall::ui {
namespace {

using Kind = RunPlace::Kind;

constexpr int kWidth = 460;

}  // namespace

RunPlaceDialog::RunPlaceDialog(const RunPlace& place, QWidget* parent) : QDialog(parent), kind_(place.kind) {
  setObjectName(QStringLiteral("runPlaceDialog"));
  setWindowTitle(tr("Run on: %1").arg(placeText(kind_)));
  auto* form = new QFormLayout(this);
  processes_ = new QSpinBox(this);
  processes_->setRange(1, kMostProcesses);
  processes_->setValue(place.processes);
  form->addRow(kind_ == Kind::Slurm ? tr("Machines, a process each:") : tr("Processes:"), processes_);
  if (kind_ == Kind::Hosts) hostFile_ = addPath(tr("Host file:"), place.hostFile, false);
  if (kind_ == Kind::Slurm) {
    partition_ = new QLineEdit(QString::fromStdString(place.partition), this);
    partition_->setPlaceholderText(tr("Slurm's default"));
    form->addRow(tr("Partition:"), partition_);
  }
  if (kind_ != Kind::Processes) {
    folder_ = addPath(tr("Folder that all machines share:"),
                      place.folder.empty() ? QDir::homePath().toStdString() : place.folder, true);
    folder_->setToolTip(tr("Jobs stay there while they run, and are removed at the end"));
  }
  problem_ = new QLabel(this);
  problem_->setWordWrap(true);
  problem_->setObjectName(QStringLiteral("problem"));
  form->addRow(problem_);
  buttons_ = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  form->addRow(buttons_);
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  for (const QLineEdit* field : {hostFile_, folder_})
    if (field != nullptr) connect(field, &QLineEdit::textChanged, this, &RunPlaceDialog::check);
  setMinimumWidth(kWidth);
  check();
}

QLineEdit* RunPlaceDialog::addPath(const QString& name, const std::string& path, bool isFolder) {
  auto* row = new QWidget(this);
  auto* field = new QLineEdit(QString::fromStdString(path), row);
  auto* browse = new QPushButton(tr("Browse..."), row);
  browse->setAutoDefault(false);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(field, 1);
  layout->addWidget(browse);
  connect(browse, &QPushButton::clicked, this, [this, field, name, isFolder] {
    const QString chosen = isFolder ? QFileDialog::getExistingDirectory(this, name, field->text())
                                    : QFileDialog::getOpenFileName(this, name, field->text());
    if (!chosen.isEmpty()) field->setText(chosen);
  });
  static_cast<QFormLayout*>(this->layout())->addRow(name, row);
  return field;
}

void RunPlaceDialog::check() {
  QString problem = coreText(problemOf(place(), runPrograms()));
  if (problem.isEmpty() && folder_ != nullptr && !QFileInfo(folder_->text()).isDir())
    problem = tr("%1 is not a folder; give one that all machines share").arg(folder_->text());
  problem_->setText(problem);
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(problem.isEmpty());
}

RunPlace RunPlaceDialog::place() const {
  RunPlace place;
  place.kind = kind_;
  place.processes = processes_->value();
  if (hostFile_ != nullptr) place.hostFile = hostFile_->text().toStdString();
  if (partition_ != nullptr) place.partition = partition_->text().trimmed().toStdString();
  if (folder_ != nullptr) place.folder = folder_->text().toStdString();
  return place;
}

}  // namespace footfall::ui
