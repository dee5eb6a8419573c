// The dialog for the number of processes that run the cells, and the further settings of their start.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>

#include "ui/run/run_places.hpp"

namespace footfall::ui {

class RunPlaceDialog : public QDialog {
  Q_OBJECT

 public:
  /// `place` fills the fields. Its kind is one of those that need settings, and not that of this program.
  explicit RunPlaceDialog(const RunPlace& place, QWidget* parent = nullptr);

  [[nodiscard]] RunPlace place() const;

 private:
  QLineEdit* addPath(const QString& name, const std::string& path, bool isFolder);
  void check();

  RunPlace::Kind kind_;
  QSpinBox* processes_ = nullptr;
  QLineEdit* hostFile_ = nullptr;
  QLineEdit* partition_ = nullptr;
  QLineEdit* folder_ = nullptr;
  QLabel* problem_ = nullptr;
  QDialogButtonBox* buttons_ = nullptr;
};

}  // namespace footfall::ui
