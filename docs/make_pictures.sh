#!/usr/bin/env bash
# make_pictures.sh [BUILD]: makes the pictures of docs/tutorials/guide.md and README.md anew, from the real editor on a virtual
# display. That of steelribs needs the environments from outside ($FOOTFALL_SHARED, ../shared unless set).
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
repository="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
build="${1:-${repository}/build/release}"
cmake --build "${build}" --target test_stories footfall-editor
unset WAYLAND_DISPLAY
export QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 FOOTFALL_PICTURES="${repository}/docs/images"
xvfb-run -a -s "-screen 0 1920x1200x24" "${build}/tests/test_stories"

cells() {
  xvfb-run -a -s "-screen 0 1920x1200x24" "${build}/footfall-editor" "$@" --show cells,timeline --size 1440x900
}
cells "${repository}/samples/villa/villa.obj" -p "${repository}/resources/pipelines/parallel.pipeline" \
  --screenshot "${FOOTFALL_PICTURES}/villa-cells.png"
# villa_for NAME SLOPE HEIGHT STEP GAP RADIUS: the villa for one agent, in metres.
villa_for() {
  local pipeline
  pipeline="$(mktemp)"
  printf '%s\n' "SlopeFilter $2" "VerticalClearanceFilter $3" "StepFilter $4 $5" "RadiusFilter $6" "AreaFilter 1" \
    SimplificationFilter LayerSubdivisionFilter >"${pipeline}"
  xvfb-run -a -s "-screen 0 1920x1200x24" "${build}/footfall-editor" "${repository}/samples/villa/villa.obj" \
    -p "${pipeline}" --size 1200x750 --screenshot "${FOOTFALL_PICTURES}/guide-villa-$1.png"
  rm -f -- "${pipeline}"
}
villa_for person 45 2 0.22 0.05 0.27
villa_for wheelchair 5 1.5 0.013 0.013 0.38
villa_for unity 45 2 0.75 0.05 0.5
steelribs="${FOOTFALL_SHARED:-${repository}/../shared}/envs/steelribs.obj"
if [ -f "${steelribs}" ]; then
  pipeline="$(mktemp)"
  trap 'rm -f -- "${pipeline}"' EXIT
  printf '%s\n' DegeneracyFilter "HeightAwareStrategy 50 4 true" "SlopeFilter 45" "VerticalClearanceFilter 40" Collapse \
    "AreaFilter 400" SimplificationFilter LayerSubdivisionFilter >"${pipeline}"
  cells "${steelribs}" -p "${pipeline}" --cell-colours time --screenshot "${FOOTFALL_PICTURES}/steelribs-cells.png"
else
  echo "make_pictures.sh: ${steelribs} is missing: its picture stays as it is" >&2
fi
