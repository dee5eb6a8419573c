// What to ask about a scale that is a guess.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "core/inspect/scale_evidence.hpp"
#include "footfall/environment.hpp"

namespace footfall::ui {

struct ScaleQuestion {
  QString text;                 ///< "1 unit = 1 m?", "640 m long: is 1 unit = 1 cm?"
  double scale = 1;             ///< metres per unit for "yes"
  std::optional<double> guess;  ///< metres per unit for "no", where `scale` is not the guess itself
};

/// `size` is the level's in the file's units, its height last. A level that the guess makes larger than a town or
/// smaller than a table is asked about with the nearest usual unit that does not.
/// Where the level has risers, doorways or storeys that speak for a unit (findScale()), it is asked about that one.
ScaleQuestion askAboutScale(const Vec3& size, double guessedMetresPerUnit,
                            const std::optional<detail::ScaleEvidence>& evidence = {});

/// A unit's length for people: "1 cm", "1 inch", "0.05 m".
QString unitLengthText(double metresPerUnit);

}  // namespace footfall::ui
