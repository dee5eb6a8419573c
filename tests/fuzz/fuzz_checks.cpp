// Feeds any bytes to the checks of other formats before and beside Assimp: truncation of PLY and STL, and Collada's
// <asset>. The first byte chooses the check.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "core/io/collada_asset.hpp"
#include "core/io/truncation_check.hpp"
#include "tests/fuzz/fuzz_target.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::fuzz;

namespace {

void requireSane(const ColladaAsset& asset) {
  require(asset.upAxis == 'X' || asset.upAxis == 'Y' || asset.upAxis == 'Z', "an up axis that is none");
  require(!asset.metresPerUnit || (std::isfinite(*asset.metresPerUnit) && *asset.metresPerUnit > 0),
          "a unit that is no length");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view text = textOf(data + 1, size - 1);
  const std::string file = "fuzz.mesh";
  try {
    switch (data[0]) {
      case 'p':
        rejectTruncatedPly(file, text);
        break;
      case 's':
        rejectTruncatedStl(file, text);
        break;
      default:
        requireSane(readColladaAsset(text));
        break;
    }
  } catch (const InputError& error) {
    requireGoodMessage(error.what(), file + ":");
  }
  return 0;
}
