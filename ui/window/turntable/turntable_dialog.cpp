// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/turntable/turntable_dialog.hpp"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <array>

#include "ui/base/text/localized_numbers.hpp"

namespace footfall::ui {
namespace {

constexpr std::array kSizes{QSize(960, 540), QSize(1280, 720), QSize(1920, 1080), QSize(3840, 2160)};
constexpr double kFilmRate = 25;  // frames a second

}  // namespace

TurntableDialog::TurntableDialog(const TurntableSettings& suggested, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("turntableDialog"));
  setWindowTitle(tr("Turntable"));
  auto* about =
      new QLabel(tr("Writes pictures of the result from all around, as a sequence of PNG files (frame_0001.png "
                    "and so on). The first one looks as the view does now."),
                 this);
  about->setWordWrap(true);
  folder_ = new QLineEdit(suggested.folder, this);
  folder_->setObjectName(QStringLiteral("turntableFolder"));
  folder_->setMinimumWidth(280);
  auto* choose = new QPushButton(tr("&Browse..."), this);
  choose->setAutoDefault(false);
  frames_ = new QSpinBox(this);
  frames_->setObjectName(QStringLiteral("turntableFrames"));
  frames_->setRange(kLeastFrames, kMostFrames);
  frames_->setValue(suggested.frames);
  length_ = new QLabel(this);
  length_->setObjectName(QStringLiteral("figures"));
  size_ = new QComboBox(this);
  size_->setObjectName(QStringLiteral("turntableSize"));
  for (const QSize& size : kSizes) {
    size_->addItem(QStringLiteral("%1 × %2").arg(size.width()).arg(size.height()), size);
    if (size == suggested.pixels) size_->setCurrentIndex(size_->count() - 1);
  }
  auto* folder = new QHBoxLayout;
  folder->addWidget(folder_, 1);
  folder->addWidget(choose);
  auto* frames = new QHBoxLayout;
  frames->addWidget(frames_);
  frames->addWidget(length_, 1);
  auto* form = new QFormLayout;
  form->addRow(tr("&Folder"), folder);
  form->addRow(tr("F&rames"), frames);
  form->addRow(tr("&Size"), size_);
  static_cast<QLabel*>(form->labelForField(folder))->setBuddy(folder_);
  static_cast<QLabel*>(form->labelForField(frames))->setBuddy(frames_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  QPushButton* write = buttons->addButton(tr("&Write"), QDialogButtonBox::AcceptRole);
  write->setDefault(true);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(about);
  layout->addLayout(form);
  layout->addWidget(buttons);
  connect(choose, &QPushButton::clicked, this, &TurntableDialog::browse);
  connect(frames_, &QSpinBox::valueChanged, this, &TurntableDialog::showLength);
  connect(folder_, &QLineEdit::textChanged, this,
          [this, write] { write->setEnabled(!folder_->text().trimmed().isEmpty()); });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    const TurntableSettings chosen = settings();
    accept();
    emit requested(chosen);
  });
  showLength();
}

TurntableSettings TurntableDialog::settings() const {
  return {folder_->text().trimmed(), frames_->value(), size_->currentData().toSize()};
}

void TurntableDialog::browse() {
  auto* dialog = new QFileDialog(this, tr("A folder for the frames"), QFileInfo(folder_->text()).path());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  dialog->setOption(QFileDialog::ShowDirsOnly);
  connect(dialog, &QFileDialog::fileSelected, folder_, &QLineEdit::setText);
  dialog->open();
}

void TurntableDialog::showLength() {
  length_->setText(
      tr("%1 s at %2 frames a second").arg(fixedText(frames_->value() / kFilmRate, 1), shortText(kFilmRate)));
}

}  // namespace footfall::ui
