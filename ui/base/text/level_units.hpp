// Lengths and places of the loaded level in the shown unit (metres, millimetres, feet or the file's units), along the
// file's axes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>
#include <array>

#include "footfall/environment.hpp"
#include "footfall/parameter.hpp"

namespace footfall::ui {

enum class LengthUnit { Metres, Feet, FileUnits, Millimetres };

/// The editor converts every shown or typed length, area and place with this. Stored values stay in the file's units,
/// with Z up. The file's units are shown while the scale is a guess, whatever unit is chosen.
struct LevelUnits {
  Q_DECLARE_TR_FUNCTIONS(footfall::ui::LevelUnits)

 public:
  UpAxis up = UpAxis::Z;  ///< up axis of the file
  double metresPerUnit = 1;
  bool scaleKnown = false;
  LengthUnit wanted = LengthUnit::Metres;
  bool operator==(const LevelUnits&) const = default;

  /// The unit that is shown.
  [[nodiscard]] LengthUnit unit() const { return scaleKnown ? wanted : LengthUnit::FileUnits; }
  /// The number of shown units in one unit of the file, for a value that is a length, an area or neither.
  [[nodiscard]] double factor() const;
  [[nodiscard]] double factor(Unit unit) const;
  /// Converts a parameter's value to the shown unit and back. A round trip gives the same text.
  [[nodiscard]] double shown(double value, Unit unit = Unit::Length) const;
  [[nodiscard]] double stored(double shown, Unit unit = Unit::Length) const;

  /// The shown unit: "m", "mm", "ft" or "units".
  [[nodiscard]] QString name() const;
  /// The unit of areas: "m²", "ft²" or "units²". Areas are in square metres when lengths are in millimetres.
  [[nodiscard]] QString areaName() const;
  /// A length with its unit: "2.5 m".
  [[nodiscard]] QString length(double length) const;
  [[nodiscard]] QString area(double area) const;
  /// A size with its unit: "1 × 2.5 × 0.3 m".
  [[nodiscard]] QString size(const Vec3& size) const;
  /// The number of a length in the shown unit, without the unit.
  [[nodiscard]] QString lengthNumber(double length) const;
  [[nodiscard]] QString areaNumber(double area) const;

  /// Converts a place to the shown unit along the file's x, y and z, and back.
  [[nodiscard]] Vec3 shownPlace(const Vec3& place) const;
  [[nodiscard]] Vec3 storedPlace(const Vec3& shown) const;
  /// The coordinates of a place in the order of the file's axes: "1.2, 0, -3.4".
  [[nodiscard]] QString placeNumbers(const Vec3& place) const;
  /// A place with axes and unit: "x 1.2, y 0, z -3.4 m".
  [[nodiscard]] QString place(const Vec3& place) const;
  /// The height of a place in the level as the file's coordinate along its up axis, in the shown unit.
  [[nodiscard]] double shownHeight(double z) const;

  /// The frame of places: "Places are in the file's frame (Y up), in m".
  [[nodiscard]] QString frameText() const;
  /// The up axis: "Y up".
  [[nodiscard]] QString upText() const;
  /// The file's axis, 0 to 2, along an axis of the level (Z up), and whether it points the same way.
  struct FileAxis {
    int axis = 0;
    bool same = true;
  };
  [[nodiscard]] FileAxis fileAxis(int levelAxis) const;
};

/// The name of an axis: "X", "Y" or "Z".
QString axisName(int axis);

/// The text for a file with this axis up: "Y up".
QString upAxisText(UpAxis up);

}  // namespace footfall::ui
