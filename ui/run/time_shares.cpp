// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/time_shares.hpp"

#include <QStringList>
#include <algorithm>
#include <cmath>

#include "ui/base/text/translated.hpp"
#include "ui/document/edit_text.hpp"
#include "ui/view/cells/cell_colours.hpp"

namespace footfall::ui {
namespace {

constexpr std::size_t kNamed = 3;  // steps in a summary

QString percent(double share) { return QString::number(std::lround(share * 100)); }

}  // namespace

TimeShares timeShares(const std::vector<FilterEntry>& filters, const std::function<StepStatus(int)>& statusOf) {
  TimeShares shares;
  for (const FilterEntry& entry : filters) {
    const StepStatus status = statusOf(entry.id);
    if (!entry.step.enabled || !status.wallMs) continue;
    shares.steps.push_back({entry.id, labelOf(entry.step), *status.wallMs, 0});
    shares.totalMs += *status.wallMs;
  }
  for (TimeShare& step : shares.steps) step.share = shares.totalMs > 0 ? step.ms / shares.totalMs : 0;
  return shares;
}

const TimeShare* shareOf(const TimeShares& shares, int id) {
  const auto found = std::ranges::find(shares.steps, id, &TimeShare::id);
  return found == shares.steps.end() ? nullptr : &*found;
}

QString timeSummary(const TimeShares& shares) {
  if (shares.steps.empty()) return {};
  std::vector<TimeShare> longest = shares.steps;
  std::ranges::stable_sort(longest, std::ranges::greater(), &TimeShare::ms);
  QStringList parts;
  for (const TimeShare& step : longest) {
    if (parts.size() == static_cast<qsizetype>(kNamed) || step.share < 0.005) break;
    parts << tr("%1 %2 %").arg(step.label, percent(step.share));
  }
  if (parts.size() < static_cast<qsizetype>(longest.size())) parts << QStringLiteral("…");
  return tr("%1: %2").arg(durationText(shares.totalMs), parts.join(QStringLiteral(", ")));
}

}  // namespace footfall::ui
