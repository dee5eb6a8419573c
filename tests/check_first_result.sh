#!/usr/bin/env bash
# check_first_result.sh CMAKE NINJA SOURCE_FOLDER BUILD_FOLDER: fails when the command line that installer/run.sh builds
# first (FOOTFALL_COMMAND_LINE_ONLY) is compiled otherwise than in a complete build, which would compile it again.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cmake="$1" ninja="$2" source="$3" build="$4"
work="$(mktemp -d)"
trap 'rm -rf -- "${work}"' EXIT

# The commands that compile the target footfall, without the folder in which they run.
commands() {
  "${ninja}" -C "$1" -t commands footfall | grep -F -- ' -c ' | sed "s|$1|BUILD|g" | LC_ALL=C sort
}
options=(-DFOOTFALL_COMMAND_LINE_ONLY=ON)
while IFS= read -r option; do options+=("-D${option}"); done < <(
  grep -E '^(CMAKE_BUILD_TYPE|CMAKE_CXX_COMPILER|CMAKE_CXX_FLAGS[A-Z_]*|FOOTFALL_UNITY|FOOTFALL_WERROR|TBB_DIR):' \
    "${build}/CMakeCache.txt")
"${cmake}" -S "${source}" -B "${work}/build" -G Ninja "${options[@]}" >"${work}/log" 2>&1 || {
  tail -n 20 "${work}/log" >&2
  exit 1
}
commands "${build}" >"${work}/complete"
commands "${work}/build" >"${work}/first"
[ -s "${work}/first" ] || { echo "nothing compiles the target footfall: the check sees nothing" >&2; exit 1; }
if ! diff "${work}/complete" "${work}/first" >"${work}/differences"; then
  echo "the complete build compiles the command line otherwise than the first one:" >&2
  cut -c1-300 "${work}/differences" | head -n 6 >&2
  exit 1
fi
echo "$(wc -l <"${work}/first") compilations of the first result are those of the complete build"
