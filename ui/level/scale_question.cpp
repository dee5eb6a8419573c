// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/scale_question.hpp"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/environment/scale_guess.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/localized_numbers.hpp"

namespace footfall::ui {
namespace {

/// The struct is the context of the translations.
struct ScaleText {
  Q_DECLARE_TR_FUNCTIONS(footfall::ui::ScaleText)
};

}  // namespace

QString unitLengthText(double metresPerUnit) {
  struct Named {
    double metres;
    QString name;
  };
  const std::array<Named, 5> named = {{{1, ScaleText::tr("1 m")},
                                       {0.01, ScaleText::tr("1 cm")},
                                       {0.001, ScaleText::tr("1 mm")},
                                       {0.0254, ScaleText::tr("1 inch")},
                                       {0.3048, ScaleText::tr("1 foot")}}};
  for (const Named& unit : named)
    if (std::abs(unit.metres / metresPerUnit - 1) < 1e-9) return unit.name;
  return ScaleText::tr("%1 m").arg(numberText(metresPerUnit));
}

ScaleQuestion askAboutScale(const Vec3& size, double guess, const std::optional<ScaleEvidence>& evidence) {
  if (evidence && evidence->metresPerUnit != guess) {
    const QString length = shortText(evidence->length, 3);
    const QString unit = unitLengthText(evidence->metresPerUnit);
    switch (evidence->of) {
      case ScaleEvidence::Of::Risers:
        return {ScaleText::tr("Most steps are %1 high: is 1 unit = %2?").arg(length, unit), evidence->metresPerUnit,
                guess};
      case ScaleEvidence::Of::Doorways:
        return {ScaleText::tr("Doorways are %1 high: is 1 unit = %2?").arg(length, unit), evidence->metresPerUnit,
                guess};
      case ScaleEvidence::Of::Storeys:
        return {ScaleText::tr("Most walls are %1 high: is 1 unit = %2?").arg(length, unit), evidence->metresPerUnit,
                guess};
    }
  }
  if (evidence) return {ScaleText::tr("1 unit = %1?").arg(unitLengthText(guess)), guess, std::nullopt};
  const std::optional<double> other = betterScale(size, guess);
  if (!other) return {ScaleText::tr("1 unit = %1?").arg(unitLengthText(guess)), guess, std::nullopt};
  const bool high = isTooHigh(size, guess);
  const QString what = high ? ScaleText::tr("%1 m high: is 1 unit = %2?") : ScaleText::tr("%1 m long: is 1 unit = %2?");
  const double metres = guess * (high ? size.z : std::max(size.x, size.y));
  return {what.arg(shortText(metres, 3), unitLengthText(*other)), *other, guess};
}

}  // namespace footfall::ui
