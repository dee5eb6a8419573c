// Finds the place in an area with the most room for words.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/base/poll.hpp"
#include "core/report/plan_sheet.hpp"

namespace footfall::detail {

struct RoomiestPlace {
  SheetPoint at;
  double radius = 0;  ///< radius of the largest circle found inside
};

/// The middle of a circle inside the area (its rings filled by the even-odd rule) that is as large as any, up to
/// `precision`: squares that could hold a larger one are divided, the most promising first. `poll` may throw.
RoomiestPlace findRoomiestPlace(std::span<const std::vector<SheetPoint>> rings, double precision, Poll poll = {});

}  // namespace footfall::detail
