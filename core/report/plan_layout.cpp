// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/plan_layout.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "core/base/number_text.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

constexpr double kMargin = 10;      // round the frame
constexpr double kTitleBlock = 30;  // height below the drawing
constexpr double kBestA4 = 100;     // the scale from which on A3 is taken
constexpr std::array kPapers{Paper::A4, Paper::A3, Paper::A2, Paper::A1, Paper::A0};
// Shorter and longer sides.
constexpr std::array<std::array<double, 2>, 5> kPaperSizes{
    {{210, 297}, {297, 420}, {420, 594}, {594, 841}, {841, 1189}}};

/// Usual scales, from 1:1 on.
double nextScale(double scale) {
  const double decade = std::pow(10, std::floor(std::log10(scale * 1.0001)));
  const double digit = scale / decade;
  for (const double next : {2.0, 2.5, 5.0, 10.0})
    if (digit < next * 0.999 && (next != 2.5 || decade >= 100)) return next * decade;
  return 10 * decade;
}

/// Millimetres for a drawing of the box at 1:1 that is left on the paper at `scale`; negative: it does not fit.
PlanLayout layOut(Paper paper, bool isUpright, double scale, double millimetresPerUnit) {
  const auto& size = kPaperSizes[static_cast<std::size_t>(paper)];
  PlanLayout layout;
  layout.width = size[isUpright ? 0 : 1];
  layout.height = size[isUpright ? 1 : 0];
  layout.window = {{kMargin, kMargin + kTitleBlock}, {layout.width - kMargin, layout.height - kMargin}};
  layout.scale = scale;
  layout.unit = millimetresPerUnit / scale;
  return layout;
}

/// The smallest scale at which the box fits on this paper.
double leastScale(const PlanLayout& layout, double width, double height) {
  const auto& [lower, upper] = layout.window;
  return std::max(width / (upper.x - lower.x), height / (upper.y - lower.y));
}

}  // namespace

std::string scaleText(double scale) {
  std::string text = "1:";
  appendNumber(text, scale);
  return text;
}

std::optional<Paper> paperFrom(std::string_view name) {
  if (name.size() != 2 || std::toupper(static_cast<unsigned char>(name[0])) != 'A' || name[1] < '0' || name[1] > '4')
    return std::nullopt;
  return kPapers[static_cast<std::size_t>('4' - name[1])];
}

PlanLayout layOutPlan(const PlanWindow& box, double metresPerUnit, const PlanOptions& options) {
  const double inMillimetres = metresPerUnit * 1000;
  const double width = (box.upper[0] - box.lower[0]) * inMillimetres,
               height = (box.upper[1] - box.lower[1]) * inMillimetres;
  const auto finish = [&](PlanLayout layout) {
    layout.middle = {(box.lower[0] + box.upper[0]) / 2, (box.lower[1] + box.upper[1]) / 2};
    return layout;
  };
  const auto bestOn = [&](Paper paper) {
    // Upright where both ways are as good.
    const double upright = leastScale(layOut(paper, true, 1, 1), width, height);
    const double across = leastScale(layOut(paper, false, 1, 1), width, height);
    return std::pair(upright <= across, std::min(upright, across));
  };
  double fitting = 0;
  for (const Paper paper : kPapers) {
    if (options.paper && paper != *options.paper) continue;
    const auto [isUpright, least] = bestOn(paper);
    if (options.scale) {
      fitting = least;
      if (*options.scale >= least) return finish(layOut(paper, isUpright, *options.scale, inMillimetres));
      continue;
    }
    double scale = 1;
    while (scale < least) scale = nextScale(scale);
    if (!options.paper && paper == Paper::A4 && scale > kBestA4) continue;
    return finish(layOut(paper, isUpright, scale, inMillimetres));
  }
  double scale = 1;
  while (scale < fitting) scale = nextScale(scale);
  throw InputError(FOOTFALL_TEXT("the plan does not fit the paper at %1; choose %2 or a larger paper"),
                   scaleText(*options.scale), scaleText(scale));
}

}  // namespace footfall::detail
