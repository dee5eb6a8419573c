# Sourced by the scripts that measure: the environments from outside, and putting tables into a document.
# Needs ${repository}, ${document} and ${scratch}; gives ${shared} and fills ${arguments}.
# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash disable=SC2154
shared="${FOOTFALL_SHARED:-${repository}/../shared}"

# environments: adds those in ${shared} to ${arguments}, each with its clearance: 2 m in its units.
environments() {
  local entry
  for entry in nav_test.obj:2 level.obj:0.35 ot.obj:40 turbine.obj:40 dutility.obj:40 complex.obj:40 steelribs.obj:40 \
    fortitude.obj:40 town/town_model.gltf:2; do
    if [ -f "${shared}/envs/${entry%:*}" ]; then arguments+=("${shared}/envs/${entry}"); fi
  done
}

# scenes: adds those in ${shared} to ${arguments}. In house.glb 0.1 stand for 2 m: it is a model, half a metre wide.
scenes() {
  local entry
  for entry in lowpoly_map:2 office:2 house:0.1 proto-level:2; do
    if [ -f "${shared}/envs/scenes/${entry%:*}.glb" ]; then
      arguments+=("${shared}/envs/scenes/${entry%:*}.glb:${entry#*:}")
    fi
  done
}

# replace NAME FILE: puts the file between the lines "<!-- NAME: begin -->" and "<!-- NAME: end -->".
replace() {
  awk -v begin="<!-- $1: begin -->" -v end="<!-- $1: end -->" -v file="$2" '
    $0 == end { inside = 0 }
    !inside { print }
    $0 == begin { inside = 1; print ""; while ((getline line < file) > 0) print line; print "" }
  ' "${document}" | cat -s >"${scratch}/document.md"
  cat -- "${scratch}/document.md" >"${document}"
}
