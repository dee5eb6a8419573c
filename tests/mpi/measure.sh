#!/usr/bin/env bash
# measure.sh [--threads N] [--ranks "N ..."] [ROUNDS]: the thesis's table of 5.7 with our samples, as Markdown: footfall-mpi
# with ranks of N threads each (1), and footfall with as many threads as all ranks together; the least of ROUNDS (3). The
# thesis has nodes of 8 threads: --threads 8 --ranks "2 4"; its own rows stand below ours then. Environment as check.sh.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
usage() {
  echo "measure.sh: $1; usage: measure.sh [--threads N] [--ranks \"N ...\"] [ROUNDS]" >&2
  exit 2
}
isCount() { [[ "$1" =~ ^[1-9][0-9]{0,3}$ ]]; }

threads=1
counts=(1 2 4)
rounds=3
while [ "$#" -gt 0 ]; do
  case "$1" in
    --threads)
      isCount "${2:-}" || usage "--threads takes a number of threads for each rank"
      threads="$2"
      shift 2
      ;;
    --ranks)
      read -ra counts <<<"${2:-}"
      [ "${#counts[@]}" -gt 0 ] || usage "--ranks takes numbers of ranks"
      for count in "${counts[@]}"; do isCount "${count}" || usage "--ranks: ${count} is no number of ranks"; done
      shift 2
      ;;
    *)
      isCount "$1" || usage "$1 is no number of rounds"
      rounds="$1"
      shift
      ;;
  esac
done
# shellcheck source=tests/mpi/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

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

# The thesis's row (5.7.1) for nodes of 8 threads: t_parallel, t_distributed, its t_overhead, t_postprocessing, in ms.
thesisRow() {
  case "$1 $2 $3" in
    "villa 2 8") echo "133,770 192,261 58,491 69,384" ;;
    "arena 2 8") echo "132,408 188,359 55,951 60,082" ;;
    "villa 4 8") echo "133,770 136,790 3,020 71,484" ;;
    "arena 4 8") echo "132,408 133,911 1,503 58,383" ;;
  esac
}

processors="$(nproc)"
for count in "${counts[@]}"; do
  if [ $((count * threads)) -gt "${processors}" ]; then
    echo "${count} ranks of ${threads} threads take turns on ${processors} processors: their times say little about scaling" >&2
  fi
done
echo "| environment | ranks | threads a rank | t_parallel | t_distributed | difference | start-up | waiting | t_merging | t_postprocessing | MB sent |"
echo "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|"
for name in villa arena; do
  awk '/^VerticalClearanceFilter/ { print "SortedRecursiveStrategy 50 4 true" } { print }
    /^VerticalClearanceFilter/ { print "Collapse" }' "${FOOTFALL_SAMPLES}/${name}/${name}.pipeline" >"${work}/p.pipeline"
  run=("${FOOTFALL_SAMPLES}/${name}/${name}.obj" -p "${work}/p.pipeline" --quiet -o "${work}/out.obj")
  for count in "${counts[@]}"; do
    for ((i = 0; i < rounds; ++i)); do
      "${FOOTFALL}" run "${run[@]}" --threads "$((count * threads))" --stats "${work}/one-${i}.json"
      ranks "${count}" "${FOOTFALL_MPI}" run "${run[@]}" --threads "${threads}" --stats "${work}/many-${i}.json"
    done
    read -r one _ < <(least "${work}"/one-*.json)
    read -r many post start waiting merging sent < <(least "${work}"/many-*.json)
    echo "| ${name} | ${count} | ${threads} | ${one} | ${many} | $((many - one)) | ${start} | ${waiting} | ${merging} | ${post} | ${sent} |"
    while read -r one many difference post; do
      echo "| *the thesis* | ${count} | ${threads} | ${one} | ${many} | ${difference} | | | | ${post} | |"
    done < <(thesisRow "${name}" "${count}" "${threads}")
  done
done
