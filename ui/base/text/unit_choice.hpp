// The unit in which lengths are shown and typed: the user's choice, and the loaded level's scale and axes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>

#include "ui/base/text/level_units.hpp"

namespace footfall::ui {

class UnitChoice : public QObject {
  Q_OBJECT

 public:
  explicit UnitChoice(QObject* parent = nullptr);

  [[nodiscard]] const LevelUnits& units() const { return units_; }
  /// Sets the unit that is used wherever the scale is known; kept in the user's settings.
  void choose(LengthUnit unit);
  /// Sets the unit of a session without changing the settings; empty: the user's choice again.
  void useForSession(std::optional<LengthUnit> unit);
  /// Sets scale and axes after a level has been loaded, or its scale changed.
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
