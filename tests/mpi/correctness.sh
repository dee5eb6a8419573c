#!/usr/bin/env bash
# correctness.sh: the thesis's experiment of 5.5 over ranks. House, arena and villa, sequentially and in cells of the
# sorted recursive strategy (four levels) by 1 to 4 ranks: distances between both results from all vertices of either
# and the share of the walkable space (`footfall compare`), as the thesis's tables, in Markdown. Fails where the sets of
# points differ, or where a file has other lines than those that name the pipeline. Environment as check.sh.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
# shellcheck source=tests/mpi/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"
export FOOTFALL_TEST_LIMIT=300

fail() {
  echo "failed: $*"
  exit 1
}
# row NAME RANKS: of what compare said.
row() {
  python3 - "$@" "${work}/both.json" <<'PYTHON'
import json, sys
name, ranks, file = sys.argv[1:]
both = json.load(open(file))
ways = both["distances"].values()
ways = [way for way in ways if isinstance(way, dict)]
figures = [min(way["d_min"] for way in ways)] + [max(way[key] for way in ways) for key in ("d_max", "d_mean", "d_rms")]
samples = sum(way["samples"] for way in ways)
print(f"| {name} | {ranks} | {both['a']['triangles']} | {samples} | "
      + " | ".join(f"{figure:g}" for figure in figures)
      + f" | {both['walkable_space_covered']:g} | {both['exact']['a_without_b']['area']:g} |"
      + f" {both['exact']['b_without_a']['area']:g} |")
PYTHON
}

echo "| environment | ranks | triangles | samples | d_min | d_max | d_mean | d_rms | covered | lost | new |"
echo "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|"
for name in house arena villa; do
  sample="${FOOTFALL_SAMPLES}/${name}/${name}.obj"
  awk '/^VerticalClearanceFilter/ { print "SortedRecursiveStrategy 50 4 true" } { print }
    /^VerticalClearanceFilter/ { print "Collapse" }' "${FOOTFALL_SAMPLES}/${name}/${name}.pipeline" >"${work}/cells.pipeline"
  "${FOOTFALL}" run "${sample}" -p "${FOOTFALL_SAMPLES}/${name}/${name}.pipeline" --quiet -o "${work}/one.obj"
  for count in 1 2 3 4; do
    ranks "${count}" "${FOOTFALL_MPI}" run "${sample}" -p "${work}/cells.pipeline" --quiet --threads 1 \
      -o "${work}/many.obj" || fail "${name} by ${count} ranks ended with $?"
    "${FOOTFALL}" compare "${work}/one.obj" "${work}/many.obj" --quiet --json --fail-if-different >"${work}/both.json" ||
      fail "${name} by ${count} ranks: other points"
    cmp <(grep -v "^# pipeline: " "${work}/one.obj") <(grep -v "^# pipeline: " "${work}/many.obj") ||
      fail "${name} by ${count} ranks: other bytes"
    row "${name}" "${count}"
  done
done
echo "all the same, to the last byte but for the comments that name the strategy"
