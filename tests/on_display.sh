#!/usr/bin/env bash
# on_display.sh NUMBER COMMAND...: runs COMMAND on a virtual display of its own, so that no other test's window takes the
# focus; NUMBER is where the search for a free one begins.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
number="$1"
shift
unset WAYLAND_DISPLAY
export QT_QPA_PLATFORM=xcb
exec xvfb-run -a -n "${number}" -s "-screen 0 1280x1024x24" "$@"
