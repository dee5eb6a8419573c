#!/usr/bin/env bash
# package.sh: builds Footfall (preset release) and makes the Debian packages and the portable archive of it in build/.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
# shellcheck source=installer/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"
[ "$#" -eq 0 ] || fail "unknown arguments $*; usage: package.sh"

prepare release
say "building"
cmake --build --preset release -j "$(build_jobs)" --target installable

say "Debian packages"
rm -f -- "${repository}"/build/footfall_*.deb "${repository}"/build/python3-footfall_*.deb \
  "${repository}"/build/footfall-mpi_*.deb
rm -rf -- "${repository}/build/release/package"
quietly "${repository}/build/release/package.log" cpack --config build/release/CPackConfig.cmake -G DEB \
  -B "${repository}/build/release/package"
mv -- build/release/package/*.deb build/
say "Debian packages:" build/footfall_*.deb build/python3-footfall_*.deb
"${repository}/installer/portable.sh"
