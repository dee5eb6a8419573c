#!/usr/bin/env bash
# wheel.sh: builds the Python package (preset release) and makes build/footfall-VERSION-...whl of it, which `pip install`
# takes on Debian 12 and on what is as new, without a library of Footfall's installed there.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
# shellcheck source=installer/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"
[ "$#" -eq 0 ] || fail "unknown arguments $*; usage: wheel.sh"

prepare release
"${repository}/installer/install_dependencies.sh" --wheel
say "building"
cmake --build --preset release -j "$(build_jobs)" --target footfall_python
rm -f -- "${repository}"/build/footfall-*.whl
wheel="$(/usr/bin/python3 -B "${repository}/installer/wheel/make_wheel.py" build/release build)"
say "wheel: ${wheel} ($(du -h "${wheel}" | cut -f1))"
