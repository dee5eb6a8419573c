// Which unit lengths are shown and typed in: the user's choice, and the loaded level's scale and axes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>

#include "ui/base/level_units.hpp"

namespace footfall::ui {

class UnitChoice : public QObject {
  Q_OBJECT

 public:
  explicit UnitChoice(QObject* parent = nullptr);

  [[nodiscard]] const LevelUnits& units() const { return units_; }
  /// The unit that is wanted wherever the scale is known; kept in the user's settings.
  void choose(LengthUnit unit);
  /// A session's own wish, which the settings do not learn of; nothing: the user's again.
  void useForSession(std::optional<LengthUnit> unit);
  /// Takes scale and axes of a level that has been loaded, or whose scale has been changed.
  void setLevel(const Environment& level);

 signals:
  void changed();

 private:
  void set(const LevelUnits& units);

  LevelUnits units_;
};

/// The name of a unit in settings and sessions: "metres", "millimetres", "feet", "file".
const char* nameOf(LengthUnit unit);
std::optional<LengthUnit> lengthUnitFrom(const QString& name);

}  // namespace footfall::ui
