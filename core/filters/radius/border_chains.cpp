// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/radius/border_chains.hpp"

#include <algorithm>
#include <cmath>

namespace footfall::detail {
namespace {

constexpr double kShort = MarginSurface::kShort;
constexpr double kSlack = MarginSurface::kSlack;
constexpr double kStraight = 8 * MarginSurface::kUnit;  // borders that turn less go on
constexpr std::size_t kLongestChain = 64;

bool isStraightOver(const std::vector<PlanVector>& places) {
  const PlanVector chord = places.back() - places.front();
  const double size = length(chord);
  if (size < kShort) return false;
  double furthest = 0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const PlanVector& p = places[i];
    if (length(p - places[i - 1]) < kShort) return false;
    const double at = dot(p - places.front(), chord) / size;
    if (std::fabs(cross(chord, p - places.front())) > kStraight * size || at < furthest - kStraight) return false;
    furthest = std::max(furthest, at);
  }
  return true;
}

void finishChain(BorderChain& chain, const MarginSurface& surface) {
  chain.begin = surface.begin(chain.sides.front());
  chain.end = surface.end(chain.sides.back());
  const PlanVector whole = chain.end - chain.begin;
  const double size = length(whole);
  chain.isShort = size < kShort;
  chain.along = chain.isShort ? PlanVector{1, 0} : (1 / size) * whole;
  chain.slack = kSlack;
  for (const Index side : chain.sides)
    chain.slack = std::max({chain.slack, kSlack + 2 * surface.error(surface.beginVertex(side)),
                            kSlack + 2 * surface.error(surface.endVertex(side))});
}

}  // namespace

std::vector<BorderChain> findBorderChains(const MarginSurface& surface) {
  std::vector<BorderChain> chains;
  std::vector<Index> borders, numberOf(static_cast<std::size_t>(surface.sideCount()), -1);
  for (Index side = 0; side < surface.sideCount(); ++side) {
    if (!surface.isBorder(side)) continue;
    numberOf[side] = static_cast<Index>(borders.size());
    borders.push_back(side);
  }
  std::vector<Index> behind(borders.size()), before(borders.size(), -1);
  std::vector<char> isStraight(borders.size(), 0);
  std::vector<Index> fan;
  for (std::size_t b = 0; b < borders.size(); ++b) {
    surface.fanBehind(borders[b], fan);
    behind[b] = numberOf[fan.back()];
    if (behind[b] < 0) continue;
    before[behind[b]] = static_cast<Index>(b);
    const Index vertex = surface.endVertex(borders[b]);
    const bool isOnePlace =
        std::all_of(fan.begin(), fan.end(), [&](Index side) { return surface.beginVertex(side) == vertex; });
    isStraight[b] = static_cast<char>(
        isOnePlace && isStraightOver({surface.begin(borders[b]), surface.begin(fan.back()), surface.end(fan.back())}));
  }
  std::vector<Index> chainOf(borders.size(), -1);
  const auto addChain = [&](Index first) {
    while (first >= 0 && chainOf[first] < 0) {
      BorderChain chain;
      std::vector<PlanVector> places{surface.begin(borders[first])};
      Index last = -1;
      for (Index b = first; b >= 0 && chainOf[b] < 0; b = behind[b]) {
        places.push_back(surface.end(borders[b]));
        if (last >= 0 && (isStraight[last] == 0 || places.size() > kLongestChain || !isStraightOver(places))) break;
        chainOf[b] = static_cast<Index>(chains.size());
        chain.sides.push_back(borders[b]);
        last = b;
      }
      finishChain(chain, surface);
      chains.push_back(std::move(chain));
      first = isStraight[last] != 0 ? behind[last] : -1;
    }
  };
  for (std::size_t b = 0; b < borders.size(); ++b)
    if (before[b] < 0 || isStraight[before[b]] == 0) addChain(static_cast<Index>(b));
  for (std::size_t b = 0; b < borders.size(); ++b) addChain(static_cast<Index>(b));  // loops as small as doubles
  for (BorderChain& chain : chains) {
    const Index after = behind[numberOf[chain.sides.back()]], ahead = before[numberOf[chain.sides.front()]];
    chain.behind = after < 0 ? -1 : chainOf[after];
    chain.before = ahead < 0 ? -1 : chainOf[ahead];
  }
  return chains;
}

}  // namespace footfall::detail
