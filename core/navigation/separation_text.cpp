// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/navigation/separation_text.hpp"

#include <algorithm>
#include <cmath>

namespace footfall::detail {
namespace {

constexpr double kNothing = 1e-9;  // share of the larger of gap and step: the other one is rounding

Text openText(const BorderLink& link, const std::function<std::string(double)>& length, double allowed) {
  const double step = std::fabs(link.rise), none = step <= allowed ? 0 : kNothing * std::max(link.gap, step);
  const bool isUp = link.rise > 0;
  if (step <= none && link.gap <= none) return FOOTFALL_TEXT("an obstacle edge without a visible wall");
  if (step <= none) return Text(FOOTFALL_TEXT("a gap of %1"), length(link.gap));
  if (link.gap <= none)
    return isUp ? Text(FOOTFALL_TEXT("a step of %1 up"), length(step))
                : Text(FOOTFALL_TEXT("a step of %1 down"), length(step));
  return isUp ? Text(FOOTFALL_TEXT("a gap of %1 and a step of %2 up"), length(link.gap), length(step))
              : Text(FOOTFALL_TEXT("a gap of %1 and a step of %2 down"), length(link.gap), length(step));
}

}  // namespace

Text barrierText(const BorderLink& link, const std::function<std::string(double)>& length, double step) {
  const bool isApart = link.size() > 0 && link.gap > kNothing * link.size();
  switch (link.kind) {
    case LinkKind::Open:
      return openText(link, length, step);
    case LinkKind::Obstacle:
      return Text(FOOTFALL_TEXT("an obstacle of %1 to climb over"), length(link.obstacle));
    case LinkKind::LowCeiling:
      return Text(FOOTFALL_TEXT("a place with only %1 of free height"), length(link.headroom));
    case LinkKind::Wall:
      return isApart ? Text(FOOTFALL_TEXT("a wall; the parts are %1 apart"), length(link.gap))
                     : Text(FOOTFALL_TEXT("an obstacle edge: a wall without thickness"));
    case LinkKind::Touch:
      return FOOTFALL_TEXT("the parts only touch in a point, which is too narrow for an agent");
  }
  return {};
}

Text lackText(const BorderLink& link, const Separation& separation, const std::function<std::string(double)>& length) {
  Text what = barrierText(link, length, separation.step);
  if (link.kind == LinkKind::LowCeiling && link.headroom < separation.height)
    return {FOOTFALL_TEXT("%1, %2 too low"), what, length(separation.height - link.headroom)};
  if (separation.step == 0 || (link.kind != LinkKind::Open && link.kind != LinkKind::Obstacle)) return what;
  const double climbed = std::max(std::fabs(link.rise), link.kind == LinkKind::Obstacle ? link.obstacle : 0);
  const double wide = separation.gap > 0 ? link.gap - separation.gap : 0;
  if (climbed > separation.step && climbed - separation.step >= wide)
    return {FOOTFALL_TEXT("%1, %2 too high"), what, length(climbed - separation.step)};
  if (wide > 0) return {FOOTFALL_TEXT("%1, %2 too wide"), what, length(wide)};
  if (link.gap > 0 && wide < 0)
    return {FOOTFALL_TEXT("%1; narrow and low enough, but StepFilter does not link it"), what};
  if (climbed > 0 && link.gap == 0) return {FOOTFALL_TEXT("%1; low enough, but StepFilter does not link it"), what};
  return what;
}

}  // namespace footfall::detail

namespace footfall {

std::string_view linkWord(LinkKind kind) {
  switch (kind) {
    case LinkKind::Open:
      return "open";
    case LinkKind::Obstacle:
      return "obstacle";
    case LinkKind::LowCeiling:
      return "low_ceiling";
    case LinkKind::Wall:
      return "wall";
    case LinkKind::Touch:
      return "touch";
  }
  return {};
}

std::string_view statusWord(PathStatus status) {
  switch (status) {
    case PathStatus::Found:
      return "found";
    case PathStatus::NothingWalkable:
      return "nothing_walkable";
    case PathStatus::StartNotWalkable:
      return "start_not_walkable";
    case PathStatus::TargetNotWalkable:
      return "target_not_walkable";
    case PathStatus::NotConnected:
      return "not_connected";
  }
  return {};
}

}  // namespace footfall
