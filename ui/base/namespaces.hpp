// Makes names of the library's inner namespace visible in the editor's namespace.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace footfall {
namespace detail {}
namespace ui {
using namespace detail;
}
}  // namespace footfall
