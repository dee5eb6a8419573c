// The dialog of the turntable: how many frames, how large, and where.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>

#include "ui/window/turntable/turntable.hpp"

namespace footfall::ui {

class TurntableDialog : public QDialog {
  Q_OBJECT

 public:
  TurntableDialog(const TurntableSettings& suggested, QWidget* parent);

  [[nodiscard]] TurntableSettings settings() const;
  [[nodiscard]] QLineEdit* folderField() const { return folder_; }
  [[nodiscard]] QSpinBox* framesField() const { return frames_; }
  [[nodiscard]] QComboBox* sizeBox() const { return size_; }

 signals:
  void requested(const footfall::ui::TurntableSettings& settings);

 private:
  void browse();
  void showLength();

  QLineEdit* folder_;
  QSpinBox* frames_;
  QComboBox* size_;
  QLabel* length_;
};

}  // namespace footfall::ui
