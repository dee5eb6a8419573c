// The question about a guessed scale.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "core/inspect/scale_evidence.hpp"
#include "footfall/environment.hpp"

namespace footfall::ui {

struct ScaleQuestion {
  QString text;                 ///< such as "1 unit = 1 m?" or "640 m long: is 1 unit = 1 cm?"
  double scale = 1;             ///< metres per unit for "yes"
  std::optional<double> guess;  ///< metres per unit for "no", where `scale` is not the guess itself
};

/// `size` is the level's in the file's units, its height last. Where the guess makes the level larger than a town or
/// smaller than a table, the question proposes the nearest usual unit that does not. Where the level has risers,
/// doorways or storeys that suggest a unit (findScale()), the question proposes that one.
ScaleQuestion askAboutScale(const Vec3& size, double guessedMetresPerUnit,
                            const std::optional<detail::ScaleEvidence>& evidence = {});

/// A unit's length for people: "1 cm", "1 inch", "0.05 m".
QString unitLengthText(double metresPerUnit);

}  // namespace footfall::ui
