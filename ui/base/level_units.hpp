// Lengths and places of the loaded level as people see and type them: in metres, millimetres, feet or the file's units,
// along the file's axes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>
#include <array>

#include "footfall/environment.hpp"
#include "footfall/filter.hpp"

namespace footfall::ui {

enum class LengthUnit { Metres, Feet, FileUnits, Millimetres };

/// Everything in the editor that shows or reads a length, an area or a place goes through this. What is stored stays in
/// the file's units, with Z up. While the scale is a guess, the file's units are shown, whatever is wanted.
struct LevelUnits {
  Q_DECLARE_TR_FUNCTIONS(footfall::ui::LevelUnits)

 public:
  UpAxis up = UpAxis::Z;  ///< of the file
  double metresPerUnit = 1;
  bool scaleKnown = false;
  LengthUnit wanted = LengthUnit::Metres;
  bool operator==(const LevelUnits&) const = default;

  /// The unit that is shown.
  [[nodiscard]] LengthUnit unit() const { return scaleKnown ? wanted : LengthUnit::FileUnits; }
  /// How many of the shown unit one of the file's units is; of a value that is a length, an area or neither.
  [[nodiscard]] double factor() const;
  [[nodiscard]] double factor(Unit unit) const;
  /// A parameter's value as a field shows it, and back. Going there and back gives the same text.
  [[nodiscard]] double shown(double value, Unit unit = Unit::Length) const;
  [[nodiscard]] double stored(double shown, Unit unit = Unit::Length) const;

  /// "m", "mm", "ft" or "units".
  [[nodiscard]] QString name() const;
  /// "m²", "ft²" or "units²". Who measures in millimetres has areas in square metres.
  [[nodiscard]] QString areaName() const;
  /// "2.5 m".
  [[nodiscard]] QString length(double length) const;
  [[nodiscard]] QString area(double area) const;
  /// "1 × 2.5 × 0.3 m".
  [[nodiscard]] QString size(const Vec3& size) const;
  /// The number alone, in the shown unit.
  [[nodiscard]] QString lengthNumber(double length) const;
  [[nodiscard]] QString areaNumber(double area) const;

  /// A place along the file's x, y and z, in the shown unit, and back.
  [[nodiscard]] Vec3 shownPlace(const Vec3& place) const;
  [[nodiscard]] Vec3 storedPlace(const Vec3& shown) const;
  /// "1.2, 0, -3.4", in the order of the file's axes.
  [[nodiscard]] QString placeNumbers(const Vec3& place) const;
  /// "x 1.2, y 0, z -3.4 m".
  [[nodiscard]] QString place(const Vec3& place) const;
  /// A height in the level as the file's coordinate along its up axis, in the shown unit.
  [[nodiscard]] double shownHeight(double z) const;

  /// What a place is in: "Places are in the file's frame (Y up), in m".
  [[nodiscard]] QString frameText() const;
  /// "Y up".
  [[nodiscard]] QString upText() const;
  /// The file's axis, 0 to 2, that lies along an axis of the level (Z up), and whether it points the same way.
  struct FileAxis {
    int axis = 0;
    bool same = true;
  };
  [[nodiscard]] FileAxis fileAxis(int levelAxis) const;
};

/// "X", "Y" or "Z".
QString axisName(int axis);

/// How a file with this axis up is called: "Y up".
QString upAxisText(UpAxis up);

}  // namespace footfall::ui
