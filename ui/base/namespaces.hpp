// The editor's names see those of the library's inside.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace footfall {
namespace detail {}
namespace ui {
using namespace detail;
}
}  // namespace footfall
