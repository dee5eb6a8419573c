#!/usr/bin/env bash
# check.sh: footfall-mpi by mpirun, with 1 to 4 processes, gives the bytes of footfall for every strategy, and says what
# is wrong once. Environment: FOOTFALL, FOOTFALL_MPI, FOOTFALL_MPIRUN (programs), FOOTFALL_SAMPLES (folder).
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
# shellcheck source=tests/mpi/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

export FOOTFALL_TEST_LIMIT=300
fail() {
  echo "failed: $*"
  exit 1
}

# compare SAMPLE RANKS STRATEGY
compare() {
  local sample="${FOOTFALL_SAMPLES}/$1/$1.obj" count="$2" strategy="$3"
  local steps=(--filter DegeneracyFilter --filter "${strategy}" --filter "SlopeFilter 45"
    --filter "VerticalClearanceFilter 2" --filter Collapse --filter "StepFilter 0.4" --filter "AreaFilter 1"
    --filter SimplificationFilter --filter LayerSubdivisionFilter)
  local one="${work}/$1-${strategy// /_}.obj"
  [ -f "${one}" ] || "${FOOTFALL}" run "${sample}" "${steps[@]}" --quiet -o "${one}"
  rm -f "${work}/many.obj"
  ranks "${count}" "${FOOTFALL_MPI}" run "${sample}" "${steps[@]}" --quiet --threads 1 -o "${work}/many.obj" \
    --stats "${work}/stats.json" --trace "${work}/trace.json" || fail "$* ended with $?"
  cmp "${one}" "${work}/many.obj" || fail "$*: other bytes"
  [ "$(grep -c '"bytes_sent"' "${work}/stats.json")" -eq "${count}" ] || fail "$*: statistics of other ranks"
  grep -q "rank $((count - 1)), thread 0" "${work}/trace.json" || fail "$*: the trace lacks a rank"
  grep -q '"t_distributed_ms"' "${work}/stats.json" || fail "$*: no t_distributed"
}

strategies=("GridStrategy 4 4" "RecursiveStrategy 50 3 true" "SortedRecursiveStrategy 50 4 true"
  "HeightAwareStrategy 50 4" AutoStrategy)
for count in 1 2 3 4; do
  for strategy in "${strategies[@]}"; do compare house "${count}" "${strategy}"; done
done
compare docks 2 "SortedRecursiveStrategy 50 4 true"
compare docks 3 AutoStrategy

# A packed environment gives the bytes of its original.
"${FOOTFALL}" pack "${FOOTFALL_SAMPLES}/docks/docks.obj" --quiet -o "${work}/docks.ffenv" >/dev/null
steps=(--filter AutoStrategy --filter "SlopeFilter 45" --filter "VerticalClearanceFilter 2" --filter Collapse)
"${FOOTFALL}" run "${FOOTFALL_SAMPLES}/docks/docks.obj" "${steps[@]}" --quiet -o "${work}/one.obj"
ranks 2 "${FOOTFALL_MPI}" run "${work}/docks.ffenv" "${steps[@]}" --quiet --threads 1 -o "${work}/packed.obj"
cmp "${work}/one.obj" "${work}/packed.obj" || fail "a packed environment: other bytes"

# Without mpirun it is one process.
"${FOOTFALL_MPI}" run "${FOOTFALL_SAMPLES}/house/house.obj" --quiet -o "${work}/alone.obj"
"${FOOTFALL}" run "${FOOTFALL_SAMPLES}/house/house.obj" --quiet -o "${work}/one.obj"
cmp "${work}/one.obj" "${work}/alone.obj" || fail "without mpirun: other bytes"

# What is wrong is told once, and by the exit code.
tells() {
  local code="$1" words="$2" seen=0
  shift 2
  ranks 3 "${FOOTFALL_MPI}" run "$@" >"${work}/out" 2>"${work}/err" || seen=$?
  [ "${seen}" -eq "${code}" ] || fail "$*: exit code ${seen}, not ${code}: $(cat "${work}/err")"
  [ "$(grep -c "^footfall-mpi: .*${words}" "${work}/err")" -eq 1 ] || fail "$*: $(cat "${work}/err")"
}
tells 2 "missing.obj" "${work}/missing.obj"
tells 2 "max_slope" "${FOOTFALL_SAMPLES}/house/house.obj" --filter "SlopeFilter 91"
tells 2 "nonsense" "${FOOTFALL_SAMPLES}/house/house.obj" --nonsense
tells 1 "cannot be made" "${FOOTFALL_SAMPLES}/house/house.obj" --work "${work}/missing/work"
# Also where the others know it long before rank 0 does: mpirun ends what still runs as soon as one has an exit code.
seen=0
# shellcheck disable=SC2016 # for the shell of the rank
ranks 3 sh -c '[ "${OMPI_COMM_WORLD_RANK}" != 0 ] || sleep 1; exec "$@"' rank "${FOOTFALL_MPI}" run \
  "${FOOTFALL_SAMPLES}/house/house.obj" --nonsense >"${work}/out" 2>"${work}/err" || seen=$?
[ "${seen}" -eq 2 ] || fail "rank 0 comes late: exit code ${seen}, not 2: $(cat "${work}/err")"
[ "$(grep -c "^footfall-mpi: .*nonsense" "${work}/err")" -eq 1 ] || fail "rank 0 comes late: $(cat "${work}/err")"

# A rank fails while rank 0 reads for longer than anybody waits, a pipeline that never comes: that rank says why, and ends
# all.
mkfifo "${work}/slow.pipeline"
seen=0
# shellcheck disable=SC2016 # for the shell of the rank
ranks 2 sh -c 'if [ "${OMPI_COMM_WORLD_RANK}" = 0 ]; then exec "$1" run "$3" -p "$2/slow.pipeline"; fi
  exec "$1" run "$2/missing.obj"' rank "${FOOTFALL_MPI}" "${work}" "${FOOTFALL_SAMPLES}/house/house.obj" \
  >"${work}/out" 2>"${work}/err" || seen=$?
[ "${seen}" -eq 2 ] || fail "rank 0 reads for long: exit code ${seen}, not 2: $(cat "${work}/err")"
[ "$(grep -c "^footfall-mpi: .*missing.obj" "${work}/err")" -eq 1 ] || fail "rank 0 reads for long: $(cat "${work}/err")"
echo "all the same"
