#!/usr/bin/env bash
# scale.sh FILE.obj RANKS...: the parts of the model in docs/explanation/scaling.md, a line for each number of ranks:
# processor seconds and peak memory of rank 0 and of the others (mean), and megabytes sent. The least of ROUNDS (3)
# runs by the processor time of all. With 0 ranks: reading, the filters before the block, and those behind it, by
# `footfall`. Environment as check.sh.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
# shellcheck source=tests/mpi/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

environment="$1"
shift
rounds="${ROUNDS:-3}"
block=(--filter DegeneracyFilter --filter "HeightAwareStrategy 50 6" --filter "SlopeFilter 45"
  --filter "VerticalClearanceFilter 2" --filter Collapse)
behind=(--filter "StepFilter 0.4" --filter "AreaFilter 1" --filter SimplificationFilter --filter LayerSubdivisionFilter)

# Runs the rest and writes "RANK PROCESSOR-SECONDS PEAK-MB" to a file of its own in the folder.
cat >"${work}/timed.py" <<'PYTHON'
import os, resource, subprocess, sys
code = subprocess.run(sys.argv[2:]).returncode
used = resource.getrusage(resource.RUSAGE_CHILDREN)
rank = os.environ.get("OMPI_COMM_WORLD_RANK", "0")
with open(f"{sys.argv[1]}/{rank}", "w") as file:
    file.write(f"{rank} {used.ru_utime + used.ru_stime:.3f} {used.ru_maxrss / 1024:.0f}\n")
sys.exit(code)
PYTHON
# best FOLDER...: of the rounds the one with the least time, as "RANK0-S OTHERS-S RANK0-MB OTHERS-MB SENT-MB".
best() {
  python3 - "$@" <<'PYTHON'
import json, os, sys
def read(folder):
    return sorted(tuple(map(float, open(f"{folder}/{name}").read().split())) for name in os.listdir(folder) if name.isdigit())
folder = min(sys.argv[1:], key=lambda folder: sum(rank[1] for rank in read(folder)))
ranks = read(folder)
others = ranks[1:] or [(0, 0, 0)]
stats = json.load(open(f"{folder}/stats.json"))
sent = sum(rank["bytes_sent"] for rank in stats.get("distributed", {}).get("ranks", [])) / 1e6
mean = lambda i: sum(rank[i] for rank in others) / len(others)
print(f"{ranks[0][1]:.2f} {mean(1):.2f} {ranks[0][2]:.0f} {mean(2):.0f} {sent:.2f}")
PYTHON
}
# measure NAME COMMAND...: prints a line of the table.
measure() {
  local name="$1" folders=()
  shift
  for ((i = 0; i < rounds; ++i)); do
    mkdir -p "${work}/round-${i}"
    rm -f "${work}/round-${i}"/*
    "$@" "${work}/round-${i}"
    folders+=("${work}/round-${i}")
  done
  read -r first others firstMb othersMb sent < <(best "${folders[@]}")
  echo "| ${name} | ${first} | ${others} | ${firstMb} | ${othersMb} | ${sent} |"
}
alone() {
  local folder="${*: -1}"
  python3 "${work}/timed.py" "${folder}" "${FOOTFALL}" run "${environment}" --quiet --threads 1 "${@:1:$#-1}" \
    --stats "${folder}/stats.json"
}
together() {
  local count="$1" folder="$2"
  ranks "${count}" python3 "${work}/timed.py" "${folder}" "${FOOTFALL_MPI}" run "${environment}" --quiet --threads 1 \
    "${block[@]}" "${behind[@]}" --stats "${folder}/stats.json"
}

echo "| run | rank 0 (s) | others (s) | rank 0 (MB) | others (MB) | sent (MB) |"
echo "|---|--:|--:|--:|--:|--:|"
for count in "$@"; do
  if [ "${count}" -gt 0 ]; then
    measure "${count} ranks" together "${count}"
    continue
  fi
  measure "reading and DegeneracyFilter" alone --filter DegeneracyFilter
  measure "with the block" alone "${block[@]}"
  measure "all" alone "${block[@]}" "${behind[@]}"
done
