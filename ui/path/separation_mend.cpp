// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/path/separation_mend.hpp"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/filter_text.hpp"

namespace footfall::ui {
namespace {

/// The struct is the context of the translations.
struct MendText {
  Q_DECLARE_TR_FUNCTIONS(footfall::ui::SeparationMend)
};

// A margin for values that are off by a rounding.
constexpr double kRoundings = 0x1p-40;
constexpr double kPerUnit = 100;

struct Need {
  FilterType filter = FilterType::Step;
  std::string_view parameter;
  double value = 0;     ///< in environment units
  bool atMost = false;  ///< the value may be at most that; else at least
};

// After a radius, borders are where a body must stop, and not where the obstacles are.
std::optional<Need> needOf(const BorderLink& link, double step, const std::vector<FilterEntry>& filters) {
  double gap = 0;
  for (const FilterEntry& entry : filters) {
    if (!entry.step.enabled) continue;
    if (entry.step.filter->type == FilterType::Radius) return std::nullopt;
    if (entry.step.filter->type == FilterType::Step) gap = std::max(gap, entry.step.values[1]);
  }
  if (link.isClosed()) return std::nullopt;
  const double climbed = std::max(std::abs(link.rise), link.kind == LinkKind::Obstacle ? link.obstacle : 0.0);
  const bool isLow = link.kind == LinkKind::LowCeiling, isHigh = climbed > step, isWide = link.gap > gap;
  // none or more than one value would have to change
  if (int{isLow} + int{isHigh} + int{isWide} != 1) return std::nullopt;
  if (isLow) return Need{FilterType::VerticalClearance, "height", link.headroom, true};
  if (isHigh) return Need{FilterType::Step, "step", climbed, false};
  return Need{FilterType::Step, "gap", link.gap, false};
}

double roundedAway(const Need& need, const LevelUnits& units) {
  const double shown = units.shown(need.value) * kPerUnit;
  return units.stored((need.atMost ? std::floor(shown * (1 - kRoundings)) : std::ceil(shown * (1 + kRoundings))) /
                      kPerUnit);
}

}  // namespace

std::optional<SeparationMend> mendOf(const Separation& separation, const std::vector<FilterEntry>& filters,
                                     const LevelUnits& units) {
  const auto need = needOf(separation.barrier(), separation.step, filters);
  if (!need) return std::nullopt;
  const double value = roundedAway(*need, units);
  std::optional<SeparationMend> mend;
  for (const FilterEntry& entry : filters) {
    const FilterDescriptor& filter = *entry.step.filter;
    if (!entry.step.enabled || filter.type != need->filter) continue;
    const auto parameter = std::ranges::find(filter.parameters, need->parameter, &ParameterDescriptor::name);
    if (parameter == filter.parameters.end()) continue;
    const auto index = static_cast<std::size_t>(parameter - filter.parameters.begin());
    if (index >= entry.step.values.size() || !checkValue(*parameter, value).empty()) continue;
    const double now = entry.step.values[index];
    if (need->atMost ? now <= value : now >= value) continue;
    const QString text = need->atMost ? MendText::tr("Lower %1 to %2") : MendText::tr("Raise %1 to %2");
    if (mend) return std::nullopt;  // two filters block the way
    mend = {entry.id, index, value, text.arg(filterText(parameter->label), units.length(value))};
  }
  return mend;
}

}  // namespace footfall::ui
