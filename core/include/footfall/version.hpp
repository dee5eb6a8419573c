// The version of the library, and what it promises.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stable are the names and the meaning of what is in footfall/*.hpp in the namespace `footfall`, except for members
// named inside() and for the namespace `footfall::detail`. Before version 1.0 a new minor version may change them, and
// a new patch version may not: find_package(footfall 0.1) accepts any 0.1.x and no 0.2. There is no stable binary
// interface: programs are compiled anew for each version. What runs compute, their bytes in exports, may change with
// any version, and the release notes say so.
#pragma once

// CMakeLists.txt reads the version of the project from these three lines.
#define FOOTFALL_VERSION_MAJOR 0
#define FOOTFALL_VERSION_MINOR 1
#define FOOTFALL_VERSION_PATCH 0

/// "0.1.0"
#define FOOTFALL_VERSION "0.1.0"

namespace footfall {

/// The version of the library that is linked, which may differ from FOOTFALL_VERSION of the headers.
const char* version();

}  // namespace footfall
