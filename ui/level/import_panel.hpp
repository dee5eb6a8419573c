// Shows the loaded file and how it was read: up axis, scale, winding. Guesses are marked and can be changed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "core/inspect/scale_evidence.hpp"
#include "footfall/environment.hpp"
#include "ui/base/widgets/number_field.hpp"

namespace footfall::ui {

class ImportPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ImportPanel(QWidget* parent = nullptr);

  /// Sets the options as the document has them; empty options are guessed.
  void setOptions(const ImportOptions& options);
  /// Null: nothing is loaded. `upGiven` and `scaleGiven` are true where the user has given the up axis or the scale,
  /// and not the file or a guess.
  void setEnvironment(const Environment* environment, const Vec3& size, bool upGiven, bool scaleGiven);
  /// Sets the unit that the shapes of the level suggest; empty where there is none.
  void setEvidence(const std::optional<detail::ScaleEvidence>& evidence);
  /// Sets the scale as if it had been typed.
  void chooseScale(double metresPerUnit) { setScale(metresPerUnit); }
  /// Sets the number of triangles of the loaded part, and that of the larger environment.
  void setPart(std::uint64_t triangles, std::uint64_t ofAll);
  void setUnits(const LevelUnits& units);

  [[nodiscard]] NumberField* scaleField() const { return scale_; }
  /// The button that confirms a scale; shown while it is a guess.
  [[nodiscard]] QPushButton* yesButton() const { return yes_; }
  [[nodiscard]] QString questionText() const { return question_->text(); }
  [[nodiscard]] QComboBox* gridBox() const { return grid_; }
  [[nodiscard]] QCheckBox* bothSidesBox() const { return bothSides_; }
  /// The box for reading the file again when another program saves it. The caller remembers its state.
  [[nodiscard]] QCheckBox* watchBox() const { return watch_; }

  /// Puts a widget below the figures, and takes ownership of it.
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
  bool upGuessed_ = true;     ///< and is not stated by the file
  double fileScale_ = 1;      ///< applies while the user has given none
  bool scaleGuessed_ = true;  ///< and is not stated by the file
  bool loaded_ = false;
  QString counts_, notes_, gridText_;
  Vec3 size_;
  std::optional<detail::ScaleEvidence> evidence_;
  LevelUnits units_;
  QLabel *name_, *figures_, *scaleNote_, *scaleError_;
  QWidget* questionRow_;
  QLabel* question_;
  QPushButton *yes_, *no_;
  QPushButton* copyCommand_;  ///< copies what installs the converter for IFC files; hidden for all others
  QComboBox *up_, *grid_;
  NumberField* scale_;
  QCheckBox *bothSides_, *watch_;
};

}  // namespace footfall::ui
