// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inspect/scale_evidence.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace footfall::detail {
namespace {

constexpr double kInch = 0.0254;
constexpr std::array kUnits{1.0, 0.01, 0.001, kInch, 12 * kInch, 1.0 / 32, 1.0 / 20, 1.0 / 16, 1.0 / 10};
constexpr double kPerson = 1.8;     // metres; no level is lower
constexpr double kLongest = 20000;  // metres; no city is longer
constexpr double kSame = 1e-4;      // heights that differ by less of them are one
constexpr std::size_t kModes = 6;
constexpr double kLeast = 0.25;  // of the walls a scale must explain
constexpr double kBetter = 1.3;  // another scale explains so many times as much as the level's own

struct Mode {
  double height = 0;
  double share = 0;  ///< of all walls
};

// Ascending heights; the most frequent first.
std::vector<Mode> modesOf(const std::vector<double>& heights) {
  std::vector<Mode> modes;
  for (auto first = heights.begin(); first != heights.end();) {
    const auto end = std::upper_bound(first, heights.end(), *first * (1 + kSame));
    modes.push_back({*first, static_cast<double>(end - first) / static_cast<double>(heights.size())});
    first = end;
  }
  std::ranges::stable_sort(modes, std::ranges::greater(), &Mode::share);
  if (modes.size() > kModes) modes.resize(kModes);
  return modes;
}

// The frequency, from 0 to 1, of a height of this many metres in buildings: risers, parapets and sills, storeys.
double usualness(double metres) {
  if (metres >= 0.12 && metres <= 0.22) return 1;
  if (metres >= 2.2 && metres <= 4.2) return 0.9;
  if (metres >= 0.8 && metres <= 1.2) return 0.5;
  if (metres >= 4.2 && metres <= 8) return 0.3;
  return 0;
}

double explained(const LevelMeasures& level, const std::vector<Mode>& modes, double scale) {
  double sum = 0;
  for (const Mode& mode : modes) sum += mode.share * usualness(mode.height * scale);
  double doors = 0;
  for (const Doorway& door : level.doorways) {
    const bool isDoor = door.height * scale >= 1.9 && door.height * scale <= 2.6 && door.width * scale >= 0.6 &&
                        door.width * scale <= 2.6;
    doors += isDoor ? 1 : 0;
  }
  if (!level.doorways.empty()) sum += doors / static_cast<double>(level.doorways.size());
  return sum;
}

ScaleEvidence reasonFor(const LevelMeasures& level, const std::vector<Mode>& modes, double scale) {
  for (const Mode& mode : modes)
    if (mode.height * scale >= 0.12 && mode.height * scale <= 0.22)
      return {scale, ScaleEvidence::Of::Risers, mode.height};
  for (const Doorway& door : level.doorways)
    if (door.height * scale >= 1.9 && door.height * scale <= 2.6)
      return {scale, ScaleEvidence::Of::Doorways, door.height};
  for (const Mode& mode : modes)
    if (usualness(mode.height * scale) > 0) return {scale, ScaleEvidence::Of::Storeys, mode.height};
  return {scale, ScaleEvidence::Of::Storeys, modes.empty() ? 0 : modes.front().height};
}

bool isPossible(const LevelMeasures& level, double scale) {
  return level.size.z * scale >= kPerson && std::max(level.size.x, level.size.y) * scale <= kLongest;
}

}  // namespace

std::optional<ScaleEvidence> findScale(const LevelMeasures& level) {
  const std::vector<Mode> modes = modesOf(level.wallHeights);
  const double own = isPossible(level, level.metresPerUnit) ? explained(level, modes, level.metresPerUnit) : 0;
  double best = std::max(own * kBetter, kLeast);
  double scale = 0;
  for (const double unit : kUnits) {
    if (!isPossible(level, unit)) continue;
    const double score = explained(level, modes, unit);
    if (score <= best) continue;
    best = score;
    scale = unit;
  }
  if (scale > 0) return reasonFor(level, modes, scale);
  if (own >= kLeast) return reasonFor(level, modes, level.metresPerUnit);
  return std::nullopt;
}

}  // namespace footfall::detail
