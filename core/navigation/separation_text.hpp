// The words for what keeps two parts of a walkable area apart.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "footfall/path.hpp"
#include "footfall/text.hpp"

namespace footfall::detail {

/// The obstacle between the two borders, such as "a step of 0.43 up" or "a gap of 0.12"; `length` writes lengths, given
/// in the mesh's units. A tiny gap is mentioned when the rise is no more than `step`: then it is the reason.
Text barrierText(const BorderLink& link, const std::function<std::string(double)>& length, double step = 0);

/// The text of barrierText() and the excess, such as "a step of 0.43 up, 0.03 too high"; `link` is one of `separation`.
Text lackText(const BorderLink& link, const Separation& separation, const std::function<std::string(double)>& length);

}  // namespace footfall::detail
