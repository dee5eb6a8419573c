#!/usr/bin/env bash
# measure.sh [ROUNDS]: the thesis's table of 5.7 with our samples, as Markdown: footfall with as many threads as there are
# ranks, and footfall-mpi with ranks of one thread each; the least of ROUNDS (3). Environment as check.sh.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
# shellcheck source=tests/mpi/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

rounds="${1:-3}"
# least FILE...: of each figure the least over the rounds, in whole milliseconds (and megabytes).
least() {
  python3 - "$@" <<'PYTHON'
import json, sys
runs = [json.load(open(name)) for name in sys.argv[1:]]
def least(figure): return min(figure(run) for run in runs)
post = least(lambda run: run["times"]["postprocessing_ms"])
if "distributed" not in runs[0]:
    print(f"{least(lambda run: run['total_ms']):.0f} {post:.0f}")
else:
    best = min(runs, key=lambda run: run["distributed"]["t_distributed_ms"])
    d = best["distributed"]
    sent = sum(rank["bytes_sent"] for rank in d["ranks"]) / 1e6
    print(f"{d['t_distributed_ms']:.0f} {post:.0f} {d['ranks'][0]['start_up_ms']:.0f} {d['ranks'][0]['waiting_ms']:.0f}"
          f" {d['merging_ms']:.0f} {sent:.2f}")
PYTHON
}

echo "| environment | ranks | t_parallel | t_distributed | difference | start-up | waiting | t_merging | t_postprocessing | MB sent |"
echo "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|"
for name in villa arena; do
  awk '/^VerticalClearanceFilter/ { print "SortedRecursiveStrategy 50 4 true" } { print }
    /^VerticalClearanceFilter/ { print "Collapse" }' "${FOOTFALL_SAMPLES}/${name}/${name}.pipeline" >"${work}/p.pipeline"
  run=("${FOOTFALL_SAMPLES}/${name}/${name}.obj" -p "${work}/p.pipeline" --quiet -o "${work}/out.obj")
  for count in 1 2 4; do
    for ((i = 0; i < rounds; ++i)); do
      "${FOOTFALL}" run "${run[@]}" --threads "${count}" --stats "${work}/one-${i}.json"
      ranks "${count}" "${FOOTFALL_MPI}" run "${run[@]}" --threads 1 --stats "${work}/many-${i}.json"
    done
    read -r one _ < <(least "${work}"/one-*.json)
    read -r many post start waiting merging sent < <(least "${work}"/many-*.json)
    echo "| ${name} | ${count} | ${one} | ${many} | $((many - one)) | ${start} | ${waiting} | ${merging} | ${post} | ${sent} |"
  done
done
