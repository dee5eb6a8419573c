// Divides floors at gaps into groups that run apart from each other.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A gap gives vertices to both of its borders, and these go on to borders that are linked with them. A gap at a corner
// is linked only where other ways do not lead to the same place within two gaps. Floors between which neither of these
// leads decide nothing about each other, so the result of a group is that of the whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/poll.hpp"
#include "core/tiles/cell_faces.hpp"

namespace footfall::detail {

class GapGroups {
 public:
  GapGroups() = default;
  /// `gap` is the widest gap in environment units. Groups are in the order of their first floors. Throws
  /// std::logic_error where a corner or a side is of a floor that is not listed.
  GapGroups(FloorsAtGaps all, double gap, Poll poll);

  /// The memory that it takes to make groups of these, with them.
  [[nodiscard]] static std::uint64_t bytesToMake(const FloorsAtGaps& all);

  [[nodiscard]] std::size_t count() const { return groups_.empty() ? 0 : groups_.size() - 1; }
  /// A group strictly between two others, about as many floors behind the first one as before the last one.
  [[nodiscard]] std::size_t middleOf(std::size_t first, std::size_t last) const;
  /// The floors of the groups from `first` up to, not including, `last`.
  [[nodiscard]] ListedFloors list(std::size_t first, std::size_t last) const;
  [[nodiscard]] std::uint64_t bytes() const {
    return floors_.size() * sizeof(floors_[0]) + corners_.size() * sizeof(corners_[0]) +
           groups_.size() * sizeof(groups_[0]);
  }

 private:
  /// The begin of a group in both lists.
  struct Begin {
    std::size_t floor = 0, corner = 0;
  };
  std::vector<std::uint32_t> floors_;
  std::vector<FloorsAtGaps::Corner> corners_;
  std::vector<Begin> groups_;  ///< one per group, then the end of all
};

}  // namespace footfall::detail
