// Texts that explain why a place is walkable or not, in the user's language.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>
#include <cstdint>

#include "footfall/inspect.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/level_units.hpp"
#include "ui/view/scene/appearance.hpp"

namespace footfall::ui {

class WhyText {
  Q_DECLARE_TR_FUNCTIONS(WhyText)

 public:
  /// "Not walkable: too low"
  static QString headline(const Inspector& inspector, const PlaceExplanation& told);
  /// One or two sentences: what decided, and who is responsible.
  static QString reason(const Inspector& inspector, const PlaceExplanation& told, const LevelUnits& units);
  static QString slope(const PlaceExplanation& told);
  static QString headroom(const Inspector& inspector, const PlaceExplanation& told, const LevelUnits& units);
  /// The distances of the nearest wall and ledge.
  static QString borders(const PlaceExplanation& told, const LevelUnits& units);
  /// The triangle's number, and the names of its mesh and material where the file has some: "12 (door, wood)".
  static QString triangle(const Inspector& inspector, std::uint32_t triangle);
  /// The colour and pattern of such places in the view.
  static Paint paint(const Inspector& inspector, const PlaceExplanation& told);

 private:
  /// The reason of the filter that removed the place.
  static QString removalReason(const Inspector& inspector, const PlaceExplanation& told, const LevelUnits& units);
};

}  // namespace footfall::ui
