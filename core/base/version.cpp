// SPDX-License-Identifier: GPL-3.0-or-later
#include "footfall/version.hpp"

namespace footfall {

const char* version() { return FOOTFALL_VERSION; }

}  // namespace footfall
