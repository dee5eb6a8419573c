// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inspect/parameter_check.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "core/environment/scale_guess.hpp"
#include "core/exact/grid.hpp"
#include "core/inspect/scale_evidence.hpp"
#include "core/inspect/upright.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"

namespace footfall::detail {
namespace {

constexpr double kSame = 1e-6;            // heights that differ by less of them are the same but for roundings
constexpr double kNear = 0.05;            // a step that misses risers by less of it was meant to climb them
constexpr double kFewestAgents = 10;      // heights of agents in the longest side of a level
constexpr double kLargest = 20000;        // metres
constexpr double kNearSlope = 0.05;       // degrees beyond the limit that roundings can make of a slope
constexpr double kSameSlope = 1e-12;      // of angles that are computed in doubles
constexpr double kMuch = 0.01;            // of all that faces up
constexpr std::size_t kFewest = 6;        // triangles: three risers are stairs
constexpr std::uint64_t kFewestNear = 6;  // vertices that miss others
constexpr double kMuchNear = 0.01;        // of all vertices
constexpr int kMostBits = 128;            // of coordinates; levels with rounding errors about zero have up to 120

/// The text of a note, empty where there is none, and its change.
struct Advice {
  Text text;
  std::optional<ParameterMend> mend;
};

struct Risers {
  double lowest = 0, highest = 0;
  std::size_t triangles = 0;
};

/// The most frequent height of walls that are no higher than `limit`.
Risers mostFrequent(const std::vector<double>& heights, double limit) {
  Risers best;
  for (auto first = heights.begin(); first != heights.end() && *first <= limit;) {
    const auto end = std::upper_bound(first, heights.end(), *first * (1 + kSame));
    const auto count = static_cast<std::size_t>(end - first);
    if (count > best.triangles) best = {*first, *(end - 1), count};
    first = end;
  }
  return best;
}

std::string shortNumber(double value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 6);
  return {digits.data(), end.ptr};
}

/// A size of a level: to the metre, or in three digits.
std::string metresText(double metres) {
  std::array<char, 32> digits{};
  const auto end =
      metres < 100 ? std::to_chars(digits.data(), digits.data() + digits.size(), metres, std::chars_format::general, 3)
                   : std::to_chars(digits.data(), digits.data() + digits.size(), std::round(metres),
                                   std::chars_format::fixed, 0);
  return end.ec == std::errc() ? std::string(digits.data(), end.ptr) : shortNumber(metres);
}

/// The number that such a text stands for.
double numberOf(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// A little more, in two digits.
std::string littleMore(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return shortNumber(std::ceil(value * (1 + kNear / 10) / unit) * unit);
}

Advice stepAdvice(const LevelMeasures& level, double step, double clearance) {
  const Risers risers = mostFrequent(level.wallHeights, clearance / 2);
  if (risers.triangles < kFewest || risers.highest <= step || risers.lowest > step * (1 + kNear)) return {};
  const std::string more = littleMore(risers.highest);
  const ParameterMend mend{0, numberOf(more)};
  if (risers.lowest > step * (1 + kSame)) {
    return {
        Text(FOOTFALL_TEXT("most risers here are %1 high, a little more than the step, and are not climbed; give %2"),
             shortNumber(risers.highest), more),
        mend};
  }
  const auto above = std::ranges::upper_bound(level.wallHeights, step);
  const auto higher = std::ranges::upper_bound(level.wallHeights, risers.highest) - above;
  return {
      Text(FOOTFALL_TEXT("most risers here are %1 high, as the step is, and roundings make %2 of %3 a little higher, "
                         "which are not climbed; give %4"),
           shortNumber(risers.highest), Text::count(static_cast<std::uint64_t>(higher + 1) / 2),
           Text::count((risers.triangles + 1) / 2), more),
      mend};
}

/// The nearest power of ten times the level's scale by which its longest side is as many metres as levels have.
double plausibleScale(const LevelMeasures& level, double longest, double least, double most) {
  double scale = level.metresPerUnit;
  while (scale * longest < least) scale *= 10;
  while (scale * longest > most) scale /= 10;
  return scale;
}

/// A level that no agent of this height fits into as people and levels fit together.
Advice sizeAdvice(const LevelMeasures& level, double height) {
  const double longest = std::max({level.size.x, level.size.y, level.size.z});
  const double metres = level.metresPerUnit * longest, agent = level.metresPerUnit * height;
  if (!(longest > 0) || !std::isfinite(metres) || !std::isfinite(agent)) return {};
  if (metres < kFewestAgents * agent) {
    // A house is small, and right, where its steps, doorways or storeys are of the size of people.
    const std::optional<ScaleEvidence> evidence = findScale(level);
    if (evidence && evidence->metresPerUnit == level.metresPerUnit) return {};
    const bool isLarger = evidence && evidence->metresPerUnit > level.metresPerUnit;
    const std::string scale = shortNumber(isLarger ? evidence->metresPerUnit
                                                   : plausibleScale(level, longest, kFewestAgents * agent, kLargest));
    return {Text(FOOTFALL_TEXT("the whole level is no larger than %1 m, less than ten times an agent's height of %2 m; "
                               "if its unit is larger, give the metres of a unit, perhaps %3"),
                 metresText(metres), shortNumber(agent), scale),
            ParameterMend{{}, numberOf(scale)}};
  }
  if (metres > kLargest) {
    const std::string scale = shortNumber(plausibleScale(level, longest, 0, kLargest));
    return {
        Text(FOOTFALL_TEXT("the level is %1 m large; if its unit is smaller, give the metres of a unit, perhaps %2"),
             metresText(metres), scale),
        ParameterMend{{}, numberOf(scale)}};
  }
  return {};
}

Advice slopeAdvice(const LevelMeasures& level, double steepest, double tolerance) {
  const double limit = steepest + tolerance;
  const auto isUpTo = [](double slope, const LevelMeasures::Ramp& ramp) { return slope < ramp.slope; };
  double area = 0, slope = 0;
  // Rounded slopes of what is kept may lie a little above the limit.
  for (auto ramp = std::upper_bound(level.ramps.begin(), level.ramps.end(), limit + kSameSlope, isUpTo);
       ramp != level.ramps.end() && ramp->slope <= limit + kNearSlope; ++ramp) {
    area += ramp->area;
    slope = ramp->slope;
  }
  if (area == 0 || area < kMuch * level.upwardArea) return {};
  const double over = slope - steepest, unit = std::pow(10, std::floor(std::log10(over)));
  const std::string more = shortNumber(std::ceil(over / unit + kSameSlope) * unit);
  return {Text(FOOTFALL_TEXT("%1 square metres of ramps are steeper than %2 degrees by less than %3 degrees, and are "
                             "not walkable; for a tolerance of %3 give SlopeFilter %2 %3"),
               shortNumber(area * level.metresPerUnit * level.metresPerUnit), shortNumber(steepest), more),
          ParameterMend{1, numberOf(more)}};
}

Advice heightAdvice(const LevelMeasures& level, double height) {
  double highest = 0;
  for (const Doorway& doorway : level.doorways) highest = std::max(highest, doorway.height);
  if (level.doorways.empty() || height <= highest) return {};
  return {Text(FOOTFALL_TEXT("agents are %1 high, and the highest doorway here is %2: nobody gets through one; give %2 "
                             "or less"),
               shortNumber(height), shortNumber(highest)),
          std::nullopt};
}

Text radiusText(const LevelMeasures& level, double radius, double height) {
  const double shortest = std::min(level.size.x, level.size.y);
  if (2 * radius >= shortest && shortest > 0)
    return {FOOTFALL_TEXT("agents are %1 wide, and the whole level is no wider than %2: nothing will be left; check "
                          "the scale"),
            shortNumber(2 * radius), shortNumber(shortest)};
  double widest = 0;
  for (const Doorway& doorway : level.doorways)
    if (doorway.height >= height) widest = std::max(widest, doorway.width);
  if (widest == 0 || 2 * radius < widest) return {};
  return {FOOTFALL_TEXT("agents are %1 wide, and the widest doorway here is %2: nobody gets through one; give a radius "
                        "below %3"),
          shortNumber(2 * radius), shortNumber(widest), shortNumber(widest / 2)};
}

void addRamp(const std::array<Vec3, 3>& p, bool bothSides, LevelMeasures& measures) {
  const double ux = p[1].x - p[0].x, uy = p[1].y - p[0].y, uz = p[1].z - p[0].z;
  const double vx = p[2].x - p[0].x, vy = p[2].y - p[0].y, vz = p[2].z - p[0].z;
  const double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
  if (nz == 0 || (nz < 0 && !bothSides)) return;
  const double steep = std::hypot(nx, ny), area = std::hypot(steep, nz) / 2;
  measures.upwardArea += area;
  if (steep > 0) measures.ramps.push_back({std::atan2(steep, std::abs(nz)) * 180 / std::numbers::pi, area});
}

}  // namespace

LevelMeasures measureLevel(const Environment& environment, const Poll& poll) {
  constexpr std::size_t kPollEvery = 4096;
  LevelMeasures measures;
  measures.metresPerUnit = environment.metresPerUnit;
  measures.scaleGuessed = environment.scaleGuessed;
  Vec3 low, high;
  Grid grid;
  for (std::size_t t = 0; t < environment.triangles.size(); ++t) {
    if (t % kPollEvery == 0) poll();
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = environment.vertices[environment.triangles[t][k]];
    if (t == 0) low = high = p[0];
    bool isLevel = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &a = p[k], &b = p[(k + 1) % 3];
      for (const double x : {a.x, a.y, a.z}) grid.include(x);
      low = {std::min(low.x, a.x), std::min(low.y, a.y), std::min(low.z, a.z)};
      high = {std::max(high.x, a.x), std::max(high.y, a.y), std::max(high.z, a.z)};
      isLevel = isLevel || a.z == b.z;
    }
    const auto [least, most] = std::minmax({p[0].z, p[1].z, p[2].z});
    addRamp(p, environment.bothSides, measures);
    if (isLevel && most > least && isUpright(p)) measures.wallHeights.push_back(most - least);
  }
  poll();
  std::ranges::sort(measures.ramps, {}, &LevelMeasures::Ramp::slope);
  std::ranges::sort(measures.wallHeights);
  measures.size = {high.x - low.x, high.y - low.y, high.z - low.z};
  measures.doorways = findDoorways(environment, poll);
  measures.bits = grid.width();
  measures.nearPlaces = countNearPlaces(environment, poll);
  return measures;
}

std::vector<ParameterNote> checkParameters(const LevelMeasures& level, const Pipeline& pipeline) {
  std::vector<ParameterNote> notes;
  const auto add = [&notes](std::size_t step, Advice advice) {
    if (!advice.text.empty()) notes.push_back({step, std::move(advice.text), advice.mend});
  };
  if (level.scaleGuessed) {
    if (const auto other = betterScale(level.size, level.metresPerUnit)) {
      const bool high = isTooHigh(level.size, level.metresPerUnit);
      const double metres = level.metresPerUnit * (high ? level.size.z : std::max(level.size.x, level.size.y));
      notes.push_back({std::nullopt,
                       Text(high ? FOOTFALL_TEXT("the scale is a guess that makes the level %1 m high; give "
                                                 "the metres of a unit, perhaps %2")
                                 : FOOTFALL_TEXT("the scale is a guess that makes the level %1 m long; give "
                                                 "the metres of a unit, perhaps %2"),
                            shortNumber(metres), shortNumber(*other)),
                       ParameterMend{{}, *other}});
    }
  }
  double clearance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < pipeline.steps.size(); ++i) {
    const PipelineStep& step = pipeline.steps[i];
    if (!step.enabled || step.values.empty()) continue;
    const double value = step.values[0];
    if (step.filter->type == FilterType::Slope) {
      add(i, slopeAdvice(level, value, step.values[1]));
    } else if (step.filter->type == FilterType::VerticalClearance) {
      clearance = value;
      const bool isScaleKnown = notes.empty() || notes.front().step;  // else there is a note on the scale already
      Advice advice = isScaleKnown ? sizeAdvice(level, value) : Advice();
      add(i, advice.text.empty() ? heightAdvice(level, value) : std::move(advice));
    } else if (step.filter->type == FilterType::Radius) {
      add(i, {radiusText(level, value, std::isfinite(clearance) ? clearance : 0), std::nullopt});
    } else if (step.filter->type == FilterType::Step) {
      add(i, stepAdvice(level, value, clearance));
    } else if (step.filter->type == FilterType::Drop) {
      if (value > level.size.z && level.size.z > 0)
        add(i, {Text(FOOTFALL_TEXT("drops are %1 deep at most, and the whole level is no higher than %2; check the "
                                   "scale"),
                     shortNumber(value), shortNumber(level.size.z)),
                std::nullopt});
    }
  }
  if (level.bits > kMostBits)
    notes.push_back({std::nullopt,
                     Text(FOOTFALL_TEXT("coordinates of very different sizes need %1 bits together, and "
                                        "runs take many times longer; put them on a grid when the file "
                                        "is read, or check the largest and the smallest ones"),
                          Text::count(static_cast<std::uint64_t>(level.bits))),
                     std::nullopt, true});
  else if (const NearPlaces& near = level.nearPlaces;
           near.count >= kFewestNear && static_cast<double>(near.count) >= kMuchNear * static_cast<double>(near.all))
    notes.push_back(
        {std::nullopt,
         Text(FOOTFALL_TEXT("about %1 vertices lie within %2 m of others without meeting them, as roundings leave "
                            "them, and runs take several times longer; put the coordinates on a grid when "
                            "the file is read"),
              Text::count(near.count), shortNumber(near.step * level.metresPerUnit)),
         std::nullopt, true});
  return notes;
}

}  // namespace footfall::detail
