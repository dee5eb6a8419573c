// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/scale_question.hpp"

#include <QCoreApplication>
#include <algorithm>
#include <array>

#include "ui/base/number_text.hpp"

namespace footfall::ui {
namespace {

/// For the translations.
struct ScaleText {
  Q_DECLARE_TR_FUNCTIONS(footfall::ui::ScaleText)
};

// In metres. Landscapes of games are up to a few hundred metres long, and their towers a few dozen high; a doll's house
// is no level.
constexpr double kLongest = 400, kHighest = 80, kShortest = 1;
constexpr std::array kUsual = {1.0, 0.01, 0.001};

bool isPlausible(const Vec3& size, double scale) {
  const double length = scale * std::max(size.x, size.y);
  return length >= kShortest && length <= kLongest && scale * size.z <= kHighest;
}

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
    if (unit.metres == metresPerUnit) return unit.name;
  return ScaleText::tr("%1 m").arg(numberText(metresPerUnit));
}

ScaleQuestion askAboutScale(const Vec3& size, double guess) {
  const auto other = std::ranges::find_if(kUsual, [&](double scale) { return isPlausible(size, scale); });
  if (isPlausible(size, guess) || other == kUsual.end())
    return {ScaleText::tr("1 unit = %1?").arg(unitLengthText(guess)), guess, std::nullopt};
  const double length = guess * std::max(size.x, size.y), height = guess * size.z;
  const bool high = length >= kShortest && length <= kLongest;
  const QString what = high ? ScaleText::tr("%1 m high: is 1 unit = %2?") : ScaleText::tr("%1 m long: is 1 unit = %2?");
  return {what.arg(shortText(high ? height : length, 3), unitLengthText(*other)), *other, guess};
}

}  // namespace footfall::ui
