#!/usr/bin/env bash
# tiles.sh: footfall-mpi run --memory by mpirun, with 1 to 4 processes, leaves the folder of footfall run --memory, of
# which no process reads all; what is wrong is said once and leaves nothing, and where a run was
# ended the next one goes on.
# Environment as check.sh, with footfall-samples beside FOOTFALL.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
# shellcheck source=tests/mpi/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

export FOOTFALL_TEST_LIMIT=300
fail() {
  echo "failed: $*"
  cat "${work}/err" 2>/dev/null || true
  exit 1
}
local_steps=(--filter "SlopeFilter 45" --filter "VerticalClearanceFilter 2")

# compare RANKS ENVIRONMENT OPTION...: against the folder one, of the same options.
compare() {
  local count="$1" environment="$2"
  shift 2
  rm -rf "${work}/many"
  ranks "${count}" "${FOOTFALL_MPI}" run "${environment}" "$@" --quiet --threads 1 -o "${work}/many" \
    --stats "${work}/stats.json" || fail "${count} ranks, $*: ended with $?"
  diff -r "${work}/one" "${work}/many" || fail "${count} ranks, $*: another folder"
}

# The default pipeline, by what is packed first, with the bytes of a run in memory.
villa="${FOOTFALL_SAMPLES}/villa/villa.obj"
"${FOOTFALL}" run "${villa}" --memory 90M --quiet -o "${work}/one"
for count in 1 2 3 4; do compare "${count}" "${villa}" --memory 90M; done
"${FOOTFALL}" run "${villa}" --quiet -o "${work}/whole.obj"
"${FOOTFALL}" join "${work}/many" --quiet -o "${work}/joined.obj"
cmp "${work}/whole.obj" "${work}/joined.obj" || fail "joined: other bytes"

# A city in many cells: alone each process reads more than the file, together less.
city="${work}/city.ffenv"
"$(dirname -- "${FOOTFALL}")/footfall-samples" city 600000 "${work}/city.obj" >/dev/null
"${FOOTFALL}" pack "${work}/city.obj" --quiet -o "${city}" >/dev/null
within=("${local_steps[@]}" --memory 190M)
rm -rf "${work}/one"
"${FOOTFALL}" run "${city}" "${within[@]}" --quiet -o "${work}/one"
for count in 1 2 4; do compare "${count}" "${city}" "${within[@]}"; done
python3 - "${work}/stats.json" "$(stat -c %s "${city}")" <<'PYTHON' || fail "what ranks read"
import json, sys
stats, size = json.load(open(sys.argv[1])), int(sys.argv[2])
ranks = stats["ranks"]
assert len(ranks) == 4, ranks
assert sum(rank["cells"] for rank in ranks) == stats["cells"]["count"] >= 4, stats
# Whoever is free takes a cell: one rank may take most where the machine has few processors.
assert sorted(rank["bytes_read"] for rank in ranks)[1] < size, (size, ranks)
assert all(rank["peak_bytes"] <= stats["memory"]["bound_bytes"] for rank in ranks), stats
PYTHON
# An area before steps makes cells run twice; the environment itself, packed by rank 0.
steps=("${local_steps[@]}" --filter "AreaFilter 1" --filter "StepFilter 0.4 0" --filter "AreaFilter 2" --memory 190M)
rm -rf "${work}/one"
"${FOOTFALL}" run "${city}" "${steps[@]}" --quiet -o "${work}/one"
compare 3 "${city}" "${steps[@]}"

# What is wrong is told once, by the exit code of footfall, and leaves no folder.
tells() {
  local code="$1" words="$2" seen=0
  shift 2
  ranks 3 "${FOOTFALL_MPI}" run "$@" >"${work}/out" 2>"${work}/err" || seen=$?
  [ "${seen}" -eq "${code}" ] || fail "$*: exit code ${seen}, not ${code}"
  [ "$(grep -c "^footfall-mpi: .*${words}" "${work}/err")" -eq 1 ] || fail "$*: not said once"
  [ ! -e "${work}/none" ] || fail "$*: leaves $(ls "${work}/none")"
}
tells 2 "RadiusFilter sees across cells" "${villa}" "${local_steps[@]}" --filter "RadiusFilter 0.4" --memory 1G -o "${work}/none"
tells 2 "a memory of 1 MB is too little" "${villa}" --memory 1M -o "${work}/none"
tells 2 "a memory of 70 MB is too little" "${city}" --memory 70M -o "${work}/none"
tells 2 "excludes" "${villa}" --memory 1G --work "${work}/shares" -o "${work}/none"
tells 2 "missing.ffenv" "${work}/missing.ffenv" --memory 1G -o "${work}/none"
tells 2 "this file is in the folder of the tiles" "${city}" --memory 1G -o "${work}"
mkdir "${work}/taken"
touch "${work}/taken/own"
tells 2 "is not an empty folder" "${city}" --memory 1G -o "${work}/taken"
# Blocks are checked when they are read: the one in the middle is read by another rank than 0.
cp "${city}" "${work}/damaged.ffenv"
printf 'damaged' | dd of="${work}/damaged.ffenv" bs=1 seek="$(($(stat -c %s "${city}") / 2))" conv=notrunc status=none
tells 2 "it is damaged" "${work}/damaged.ffenv" "${within[@]}" -o "${work}/none"
# Not the folder of rank 0, as on machines that share nothing.
seen=0
# shellcheck disable=SC2016 # for the shell of the rank
ranks 2 sh -c 'exec "$1" run "$2" --memory 1G --quiet -o "$3/none$OMPI_COMM_WORLD_RANK"' rank "${FOOTFALL_MPI}" "${city}" \
  "${work}" >"${work}/out" 2>"${work}/err" || seen=$?
[ "${seen}" -eq 1 ] || fail "other folders: exit code ${seen}"
[ "$(grep -c "^footfall-mpi: rank 1: .*is not the folder that rank 0 made" "${work}/err")" -eq 1 ] || fail "other folders"
[ ! -e "${work}/none0" ] || fail "other folders: leaves $(ls "${work}/none0")"

# Asked to end, all ranks do; a rank that is killed ends all. The next run goes on from there.
is_alive() { [[ "$(ps -o stat= -p "$1" 2>/dev/null)" =~ ^[^Z] ]]; }
for signal in TERM KILL; do
  ranks 3 "${FOOTFALL_MPI}" run "${city}" "${steps[@]}" --quiet --threads 1 -o "${work}/ended" >"${work}/out" \
    2>"${work}/err" &
  shell=$!
  for ((i = 0; i < 3000; ++i)); do
    [ -z "$(ls "${work}/ended"/cell-*.cell 2>/dev/null)" ] || break
    sleep 0.02
  done
  timer="$(ps -o pid= --ppid "${shell}" | head -n 1 | tr -d ' ')"
  mpirun="$(ps -o pid= --ppid "${timer:-1}" | head -n 1 | tr -d ' ')"
  mapfile -t pids < <(ps -o pid= --ppid "${mpirun:-1}" | tr -d ' ')
  [ "${#pids[@]}" -eq 3 ] || fail "${signal}: ${#pids[@]} ranks"
  case "${signal}" in
    TERM) kill -TERM "${mpirun}" ;;
    KILL) kill -9 "${pids[1]}" ;;
  esac
  code=0
  wait "${shell}" || code=$?
  [ "${code}" -ne 0 ] || fail "${signal}: the run went on"
  for pid in "${pids[@]}"; do
    for ((i = 0; i < 300; ++i)); do
      is_alive "${pid}" || break
      sleep 0.1
    done
    ! is_alive "${pid}" || fail "${signal}: a rank goes on"
  done
  [ ! -e "${work}/ended/index.json" ] || fail "${signal}: an index of half a run"
  kept="$(find "${work}/ended" -name '*.cell' | wc -l)"
  [ "${kept}" -gt 0 ] || fail "${signal}: no cells are left"
  ranks 2 "${FOOTFALL_MPI}" run "${city}" "${steps[@]}" --quiet --threads 1 -o "${work}/ended" \
    --stats "${work}/stats.json" || fail "${signal}: the next run ended with $?"
  diff -r "${work}/one" "${work}/ended" || fail "${signal}: the next run left another folder"
  grep -q "\"taken_over\": ${kept}," "${work}/stats.json" || fail "${signal}: ${kept} cells were there"
  rm -r "${work}/ended"
done
echo "the same folders"
