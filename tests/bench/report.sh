#!/usr/bin/env bash
# report.sh [BUILD_FOLDER [OPTION...]]: measures everything again and writes the tables of docs/performance.md between
# their markers. Options go to footfall-bench (--runs 3 --seconds 2: quick and rough).
# Environments from outside come from the folder $FOOTFALL_SHARED (../shared unless set); its prototype/ is built when it
# is there. The editor is measured where it was built and a display is or xvfb-run can make one. Takes some minutes; a
# machine that does something else meanwhile spoils the figures.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
repository="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)"
build="$(realpath -- "${1:-${repository}/build/release}")"
if [ "$#" -gt 0 ]; then shift; fi
shared="${FOOTFALL_SHARED:-${repository}/../shared}"
document="${repository}/docs/performance.md"
scratch="$(mktemp -d)"
trap 'rm -rf -- "${scratch}"' EXIT

arguments=("$@" --samples --growth --live --cancel 60 --json "${build}/bench.json" --markdown "${scratch}/bench.md")
# The clearance of each file: 2 m in its units.
environment() {
  if [ -f "${shared}/envs/$1" ]; then arguments+=("${shared}/envs/$1:$2"); fi
}
environment nav_test.obj 2
environment level.obj 0.35
for name in ot turbine dutility complex steelribs fortitude; do environment "${name}.obj" 40; done
environment town/town_model.gltf 2
if [ -f "${shared}/prototype/main.cpp" ]; then
  echo "building the prototype" >&2
  g++ -O3 -march=native -ffp-contract=off -std=c++20 -w "${shared}/prototype/main.cpp" -ltbb -lgmp \
    -o "${scratch}/prototype"
  arguments+=(--prototype "${scratch}/prototype")
fi
"${build}/footfall-bench" "${arguments[@]}"

# replace NAME FILE: puts the file between the lines "<!-- NAME: begin -->" and "<!-- NAME: end -->".
replace() {
  awk -v begin="<!-- $1: begin -->" -v end="<!-- $1: end -->" -v file="$2" '
    $0 == end { inside = 0 }
    !inside { print }
    $0 == begin { inside = 1; print ""; while ((getline line < file) > 0) print line; print "" }
  ' "${document}" | cat -s >"${scratch}/document.md"
  cat -- "${scratch}/document.md" >"${document}"
}
replace bench "${scratch}/bench.md"

if [ -x "${build}/footfall-editor-bench" ]; then
  command=("${build}/footfall-editor-bench" --json "${build}/editor-bench.json" --markdown "${scratch}/editor.md")
  if [ -n "${DISPLAY:-}" ]; then
    "${command[@]}"
  else
    QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a -s "-screen 0 1280x1024x24" "${command[@]}"
  fi
  replace editor "${scratch}/editor.md"
fi
