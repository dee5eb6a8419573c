// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exact/plan_places.hpp"

namespace footfall::detail {
namespace {

/// An equal place is looked for so far ahead in either list where they differ.
constexpr std::size_t kAhead = 512;
/// No more places than so many for each place of both lists are looked at: lists that differ too much are not related.
constexpr std::size_t kMostLooked = 4;

bool isSame(const Vec3& a, const Vec3& b) { return a.x == b.x && a.y == b.y; }

/// How far ahead in a list, from `begin` on, a place comes; 0: not near.
std::size_t distanceTo(const std::vector<Vec3>& places, std::size_t begin, const Vec3& place) {
  for (std::size_t ahead = 1; ahead <= kAhead && begin + ahead < places.size(); ++ahead)
    if (isSame(places[begin + ahead], place)) return ahead;
  return 0;
}

}  // namespace

// Runs number places in one order, so that both lists are equal but for what an edit brings, takes or moves.
std::vector<Index> relatePlanPlaces(const SourceMesh& before, const SourceMesh& now) {
  std::vector<Index> numbers(before.planPlaces, -1);
  const std::size_t firstBefore = before.vertices.size() - before.planPlaces;
  std::size_t i = firstBefore, j = now.vertices.size() - now.planPlaces, looked = 0;
  const std::size_t most = kMostLooked * (before.planPlaces + now.planPlaces) + 16 * kAhead;
  while (i < before.vertices.size() && j < now.vertices.size() && looked < most) {
    const Vec3 &then = before.vertices[i], &place = now.vertices[j];
    if (isSame(then, place)) {
      numbers[i++ - firstBefore] = static_cast<Index>(j++);
      continue;
    }
    const std::size_t gone = distanceTo(before.vertices, i, place), added = distanceTo(now.vertices, j, then);
    looked += (gone > 0 ? gone : kAhead) + (added > 0 ? added : kAhead);
    if (gone > 0 && (added == 0 || gone <= added)) {
      i += gone;
    } else if (added > 0) {
      j += added;
    } else {
      ++i;
      ++j;
    }
  }
  return numbers;
}

}  // namespace footfall::detail
