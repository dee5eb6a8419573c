// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/layers/growing_boxes.hpp"

#include <numeric>
#include <utility>

namespace footfall::detail {
namespace {

constexpr std::size_t kMostFew = 64;

}  // namespace

void GrowingBoxes::settle(const Poll& poll) {
  if (few_.size() <= kMostFew) return;
  std::vector<Entry> together = std::exchange(few_, {});
  while (!parts_.empty() && parts_.back().entries.size() <= 2 * together.size()) {
    const std::vector<Entry>& last = parts_.back().entries;
    together.insert(together.end(), last.begin(), last.end());
    parts_.pop_back();
  }
  std::vector<Index> all(together.size());
  std::iota(all.begin(), all.end(), Index{0});
  Part part;
  part.tree.build(
      all, [&](Index i) { return together[i].bounds; }, poll);
  part.entries = std::move(together);
  parts_.push_back(std::move(part));
}

}  // namespace footfall::detail
