// The <asset> element of a Collada file, which Assimp does not report.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace footfall::detail {

struct ColladaAsset {
  char upAxis = 'Y';  ///< 'X', 'Y' or 'Z'; Y without <up_axis> (Collada 1.4.1, chapter 5)
  std::optional<double> metresPerUnit;
};

/// Reads the first <asset> of a Collada document, which is the document's own. Text that is not Collada gives the
/// defaults.
ColladaAsset readColladaAsset(std::string_view text);

}  // namespace footfall::detail
