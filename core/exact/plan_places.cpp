// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exact/plan_places.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "core/base/numbered_table.hpp"

namespace footfall::detail {
namespace {

/// Keeps as many numbers as can rise from each to the next one; the others become -1.
void keepRising(std::vector<Index>& numbers) {
  std::vector<std::size_t> last;                                // the end of the best list of each length
  std::vector<std::size_t> previous(numbers.size(), SIZE_MAX);  // in the list that ends there
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] < 0) continue;
    auto at = last.end();
    if (!last.empty() && numbers[last.back()] >= numbers[i])
      at = std::lower_bound(last.begin(), last.end(), numbers[i],
                            [&](std::size_t end, Index number) { return numbers[end] < number; });
    if (at != last.begin()) previous[i] = *(at - 1);
    if (at == last.end())
      last.push_back(i);
    else
      *at = i;
  }
  std::vector<Index> kept(numbers.size(), -1);
  for (std::size_t i = last.empty() ? SIZE_MAX : last.back(); i != SIZE_MAX; i = previous[i]) kept[i] = numbers[i];
  numbers = std::move(kept);
}

}  // namespace

std::vector<Index> relatePlanPlaces(const SourceMesh& before, const SourceMesh& now) {
  if (before.planPlaces == 0) return {};
  using Key = std::array<std::uint64_t, 2>;
  const auto keyOf = [](const Vec3& p) {
    return Key{std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(p.y)};
  };
  NumberedTable<Key> known;
  const std::size_t first = now.vertices.size() - now.planPlaces, count = now.planPlaces;
  known.reserve(count + before.planPlaces);
  for (std::size_t v = first; v < now.vertices.size(); ++v) known.insert(keyOf(now.vertices[v]));
  std::vector<Index> numbers;
  numbers.reserve(before.planPlaces);
  for (std::size_t v = before.vertices.size() - before.planPlaces; v < before.vertices.size(); ++v) {
    const auto number = static_cast<std::size_t>(known.insert(keyOf(before.vertices[v])).first);
    numbers.push_back(number < count ? static_cast<Index>(first + number) : -1);
  }
  keepRising(numbers);
  return numbers;
}

}  // namespace footfall::detail
