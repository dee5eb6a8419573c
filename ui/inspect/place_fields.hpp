// Three fields for a place: X, Y and Z.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>
#include <QWidget>
#include <array>
#include <optional>

#include "footfall/environment.hpp"
#include "ui/base/text/level_units.hpp"

namespace footfall::ui {

/// A place is set once all three fields hold numbers; the fields are empty while there is no place. Fields show a few
/// digits, and an unedited coordinate keeps all of its digits. Fields are along the file's axes in the shown unit; the
/// place is in the level's coordinates.
class PlaceFields : public QWidget {
  Q_OBJECT

 public:
  /// `name` is the name of the place for screen readers and tests ("Start").
  PlaceFields(const QString& name, const QString& id, QWidget* parent = nullptr);

  void setPlace(const std::optional<Vec3>& place);
  void setUnits(const LevelUnits& units);
  [[nodiscard]] QLineEdit* field(std::size_t axis) const { return fields_[axis]; }

 signals:
  void edited(const footfall::Vec3& place);

 private:
  void read();
  void showProblems();

  void showUnits();

  QString name_;
  std::optional<Vec3> place_;
  LevelUnits units_;
  std::array<QLineEdit*, 3> fields_{};
};

}  // namespace footfall::ui
