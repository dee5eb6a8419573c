// The <asset> element of a Collada file, which Assimp does not report.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/environment/assimp_reader.hpp"

namespace footfall {

/// Up axis and unit of a Collada document's <asset>. Without <up_axis> it is Y up (Collada 1.4.1, chapter 5); X up
/// leaves `up` empty. Text that is no Collada gives the same as an <asset> without these elements.
FileFrame readColladaAsset(std::string_view text);

}  // namespace footfall
