// The colours of what is exported and drawn.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace footfall::detail {

/// Red, green and blue from 0 to 255, as in sRGB.
using Rgb = std::array<int, 3>;

// Colours that people with the common colour deficiencies can distinguish (Okabe and Ito 2008).
inline constexpr Rgb kOrange{230, 159, 0};
inline constexpr Rgb kSkyBlue{86, 180, 233};
inline constexpr Rgb kBluishGreen{0, 158, 115};
inline constexpr Rgb kYellow{240, 228, 66};
inline constexpr Rgb kBlue{0, 114, 178};
inline constexpr Rgb kVermilion{213, 94, 0};
inline constexpr Rgb kReddishPurple{204, 121, 167};

/// Layers, from the first on; vermilion is kept for obstacle edges.
inline constexpr std::array<Rgb, 6> kLayerColours{kBluishGreen, kSkyBlue, kYellow, kBlue, kReddishPurple, kOrange};

}  // namespace footfall::detail
