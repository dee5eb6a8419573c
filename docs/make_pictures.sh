#!/usr/bin/env bash
# make_pictures.sh [BUILD]: makes the pictures of docs/guide.md anew, from the real editor on a virtual display.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
repository="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
build="${1:-${repository}/build/release}"
cmake --build "${build}" --target test_stories
unset WAYLAND_DISPLAY
export QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 FOOTFALL_PICTURES="${repository}/docs/images"
xvfb-run -a -s "-screen 0 1920x1200x24" "${build}/tests/test_stories"
