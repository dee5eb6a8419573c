#!/usr/bin/env bash
# kill.sh: kills processes of footfall-mpi at random moments: one rank, all of them, mpirun, or all with a share that is
# then damaged; or asks mpirun to end, as Ctrl+C does. The next run, of another number of ranks, must end with the bytes
# of footfall. 4 rounds, or FOOTFALL_TEST_ROUNDS; FOOTFALL_TEST_SEED for other moments. Environment as check.sh, and
# FOOTFALL_SAMPLE (a sample).
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
# shellcheck source=tests/mpi/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

rounds="${FOOTFALL_TEST_ROUNDS:-4}"
RANDOM="${FOOTFALL_TEST_SEED:-1}"
name="${FOOTFALL_SAMPLE:-docks}"
sample="${FOOTFALL_SAMPLES}/${name}/${name}.obj"
steps=(--filter DegeneracyFilter --filter "SortedRecursiveStrategy 50 6 true" --filter "SlopeFilter 45"
  --filter "VerticalClearanceFilter 2" --filter Collapse --filter "AreaFilter 1" --filter LayerSubdivisionFilter)
folder="${work}/shares"
out="${work}/many.obj"

fail() {
  echo "failed in round ${round:-0}: $*"
  cat "${work}/err" 2>/dev/null || true
  exit 1
}
now() { date +%s%N; }
# Running, and not only waiting for its parent to hear that it ended.
is_alive() { [[ "$(ps -o stat= -p "$1" 2>/dev/null)" =~ ^[^Z] ]]; }
start() {
  ranks "$1" "${FOOTFALL_MPI}" run "${sample}" "${steps[@]}" --quiet --threads 1 --work "${folder}" -o "${out}"
}
finish() {
  FOOTFALL_TEST_LIMIT=300 start "$1" >"${work}/out" 2>"${work}/err" || fail "the run behind it ended with $?"
  cmp "${work}/one.obj" "${out}" || fail "other bytes"
  [ -z "$(ls "${folder}")" ] || [ -z "$(ls "${folder}"/*.share 2>/dev/null)" ] || fail "shares are left"
}

"${FOOTFALL}" run "${sample}" "${steps[@]}" --quiet -o "${work}/one.obj"
begun="$(now)"
finish 3
whole=$((($(now) - begun) / 1000000))

interrupted=0 taken=0 late=0 damaged=0 stuck=0
for ((round = 1; round <= rounds; ++round)); do
  rm -f "${out}"
  count=$((1 + RANDOM % 4)) victim=$((RANDOM % 5)) moment=$((whole / 10 + RANDOM * whole / 32768))
  start "${count}" >"${work}/out" 2>"${work}/err" &
  shell=$!
  sleep "$((moment / 1000)).$(printf %03d $((moment % 1000)))"
  # The shell's child is mpirun, whose children are the ranks.
  mpirun="$(ps -o pid= --ppid "${shell}" | head -n 1 | tr -d ' ')" || true
  [ -n "${mpirun}" ] || mpirun="${shell}"
  mapfile -t pids < <(ps -o pid= --ppid "${mpirun}" | tr -d ' ')
  case "${victim}" in
    0) [ "${#pids[@]}" -eq 0 ] || kill -9 "${pids[RANDOM % ${#pids[@]}]}" 2>/dev/null || true ;;
    1) kill -9 "${mpirun}" 2>/dev/null || true ;;
    2) kill -TERM "${mpirun}" 2>/dev/null || true ;;
    *) kill -9 "${mpirun}" "${pids[@]}" 2>/dev/null || true ;;
  esac
  # Ranks without mpirun end by themselves, but not at once.
  for pid in "${pids[@]}"; do
    for ((i = 0; i < 300; ++i)); do
      is_alive "${pid}" || break
      sleep 0.1
    done
    ! is_alive "${pid}" || fail "rank ${pid} goes on"
  done
  # Open MPI's mpirun may wait for ever for a rank that was killed while it started them.
  for ((i = 0; i < 100; ++i)); do
    is_alive "${mpirun}" || break
    sleep 0.1
  done
  if is_alive "${mpirun}"; then
    stuck=$((stuck + 1))
    kill -9 "${mpirun}"
  fi
  code=0
  wait "${shell}" || code=$?
  if [ "${code}" -eq 0 ]; then
    late=$((late + 1))
  else
    interrupted=$((interrupted + 1))
    [ ! -f "${out}" ] || cmp "${work}/one.obj" "${out}" || fail "half a result"
  fi
  mapfile -t shares < <(ls "${folder}"/*.share 2>/dev/null || true)
  [ "${#shares[@]}" -eq 0 ] || taken=$((taken + 1))
  if [ "${victim}" -eq 3 ] && [ "${#shares[@]}" -gt 0 ]; then
    damaged=$((damaged + 1))
    share="${shares[RANDOM % ${#shares[@]}]}"
    truncate -s "$((RANDOM % $(stat -c %s "${share}")))" "${share}"
  fi
  finish $((1 + RANDOM % 4))
done
echo "${rounds} rounds (a whole run takes ${whole} ms): ${interrupted} runs killed, ${late} were done before," \
  "${taken} left shares for the next run, of which one was damaged in ${damaged};" \
  "mpirun itself had to be killed ${stuck} times; all ended with the same bytes"
