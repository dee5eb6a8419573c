// The dock "Obstacles": a list of the placed obstacles, and the numbers of the selected one.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QToolButton>
#include <QWidget>
#include <array>

#include "ui/base/text/level_units.hpp"
#include "ui/base/widgets/number_field.hpp"
#include "ui/level/obstacle_editor.hpp"

namespace footfall::ui {

/// All edits can be undone; the numbers typed into one field in a row are one edit. The panel and the editor share the
/// selection.
class ObstaclePanel : public QWidget {
  Q_OBJECT

 public:
  explicit ObstaclePanel(ObstacleEditor& editor, QWidget* parent = nullptr);

  [[nodiscard]] QListWidget* list() const { return list_; }
  /// The fields x, y, z of its base along the file's axes; length, width, height; turn.
  [[nodiscard]] NumberField* field(std::size_t index) const { return fields_[index]; }
  [[nodiscard]] QLineEdit* nameField() const { return name_; }
  [[nodiscard]] QCheckBox* stickBox() const { return stick_; }
  /// Obstacles cannot be placed while nothing is loaded.
  void setPlacing(bool possible);
  void setUnits(const LevelUnits& units);

 signals:
  void placeRequested(footfall::detail::PlacedObstacle::Shape shape);
  void frameRequested(std::uint32_t id);
  void duplicateRequested();
  void stickingChanged(bool on);

 private:
  static constexpr std::size_t kFields = 7;

  void showObstacles();
  void showSelected();
  void showUnits();
  [[nodiscard]] QString describe(const PlacedObstacle& obstacle) const;
  void editField(std::size_t index, double value);
  void showProblem();

  ObstacleEditor& editor_;
  QListWidget* list_;
  QToolButton *add_, *duplicate_, *delete_;
  QWidget* form_;
  QLineEdit* name_;
  std::array<NumberField*, kFields> fields_{};
  QLabel *problem_, *frame_;
  LevelUnits units_;
  QCheckBox* stick_;
};

}  // namespace footfall::ui
