// What is loaded and how it was read: up axis, scale, winding. Guesses are named as such and can be overruled.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QWidget>

#include "core/environment/environment.hpp"
#include "ui/number_field.hpp"

namespace footfall {

class ImportPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ImportPanel(QWidget* parent = nullptr);

  /// The options as they are asked for; what is empty is guessed.
  void setOptions(const ImportOptions& options);
  /// Null: nothing is loaded.
  void setEnvironment(const Environment* environment, const Vec3& size);

  [[nodiscard]] QComboBox* upBox() const { return up_; }
  [[nodiscard]] NumberField* scaleField() const { return scale_; }
  [[nodiscard]] QCheckBox* bothSidesBox() const { return bothSides_; }
  /// Whether the file is read again when another program saves it. Remembered by the caller.
  [[nodiscard]] QCheckBox* watchBox() const { return watch_; }

  /// Puts a widget below the figures; takes it over.
  void addBelowFigures(QWidget* widget);

 signals:
  void optionsEdited(const footfall::ImportOptions& options);

 private:
  void showGuesses();

  ImportOptions options_;
  UpAxis guessedUp_ = UpAxis::Z;
  double guessedScale_ = 1;
  bool loaded_ = false;
  QLabel *name_, *figures_, *scaleNote_, *scaleError_;
  QComboBox* up_;
  NumberField* scale_;
  QCheckBox *bothSides_, *watch_;
};

}  // namespace footfall
