// Replaces detour_export.cpp where the library was not found.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/formats/detour_export.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {

bool hasDetour() { return false; }

DetourFile formatDetour(const NavigationMesh&, const ExportHeader&, const ExportOptions&, const DetourLimits&, Poll) {
  throw InputError(
      FOOTFALL_TEXT("this program was built without Detour and cannot write .bin; install librecast-dev and build it "
                    "again, or export as .obj or .glb"));
}

}  // namespace footfall::detail
