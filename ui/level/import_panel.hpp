// What is loaded and how it was read: up axis, scale, winding. Guesses are named as such and can be overruled.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "core/inspect/scale_evidence.hpp"
#include "footfall/environment.hpp"
#include "ui/base/number_field.hpp"

namespace footfall::ui {

class ImportPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ImportPanel(QWidget* parent = nullptr);

  /// The options as they are asked for; what is empty is guessed.
  void setOptions(const ImportOptions& options);
  /// Null: nothing is loaded. `upGiven`, `scaleGiven`: its up axis, its scale is the user's word, and not the file's or
  /// a guess.
  void setEnvironment(const Environment* environment, const Vec3& size, bool upGiven, bool scaleGiven);
  /// What the shapes of the level say about its unit; nothing where that is not known.
  void setEvidence(const std::optional<detail::ScaleEvidence>& evidence);
  /// As if it had been typed.
  void chooseScale(double metresPerUnit) { setScale(metresPerUnit); }
  /// What is loaded is so many triangles of a larger environment.
  void setPart(std::uint64_t triangles, std::uint64_t ofAll);
  void setUnits(const LevelUnits& units);

  [[nodiscard]] QComboBox* upBox() const { return up_; }
  [[nodiscard]] NumberField* scaleField() const { return scale_; }
  /// Confirm a scale that is a guess; shown while it is one.
  [[nodiscard]] QPushButton* yesButton() const { return yes_; }
  [[nodiscard]] QPushButton* noButton() const { return no_; }
  [[nodiscard]] QString questionText() const { return question_->text(); }
  [[nodiscard]] QComboBox* gridBox() const { return grid_; }
  [[nodiscard]] QCheckBox* bothSidesBox() const { return bothSides_; }
  /// Whether the file is read again when another program saves it. Remembered by the caller.
  [[nodiscard]] QCheckBox* watchBox() const { return watch_; }

  /// Puts a widget below the figures; takes it over.
  void addBelowFigures(QWidget* widget);

 signals:
  void optionsEdited(const footfall::ImportOptions& options);

 private:
  QWidget* makeQuestion();
  void setScale(double metresPerUnit);
  void showGuesses();
  void showGrid(const Environment& environment);
  void showFigures();
  void showQuestion();

  ImportOptions options_;
  UpAxis fileUp_ = UpAxis::Z;
  bool upGuessed_ = true;     ///< and is not the file's own word
  double fileScale_ = 1;      ///< holds while the user gives none
  bool scaleGuessed_ = true;  ///< and is not the file's own word
  bool loaded_ = false;
  QString counts_, notes_, gridText_;
  Vec3 size_;
  std::optional<detail::ScaleEvidence> evidence_;
  LevelUnits units_;
  QLabel *name_, *figures_, *scaleNote_, *scaleError_;
  QWidget* questionRow_;
  QLabel* question_;
  QPushButton *yes_, *no_;
  QComboBox *up_, *grid_;
  NumberField* scale_;
  QCheckBox *bothSides_, *watch_;
};

}  // namespace footfall::ui
