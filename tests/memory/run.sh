#!/usr/bin/env bash
# run.sh FOOTFALL RUNS ENVIRONMENT... [-- ARGUMENT...]: runs `FOOTFALL run ENVIRONMENT ARGUMENT...` RUNS times on each
# environment. In each run allocations of 4 kB and more fail from a random one on. Each run must end by itself, either with
# its result or with a message about memory; the script prints a row for each environment and fails otherwise.
# FOOTFALL_SEED chooses the random numbers. test_memory_runs_out is the short form of this.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
here="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)"
if [ "$#" -lt 3 ]; then
  sed -n '2,5s/^# //p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
program="$1" runs="$2"
shift 2
environments=() arguments=()
while [ "$#" -gt 0 ] && [ "$1" != "--" ]; do
  environments+=("$1")
  shift
done
if [ "$#" -gt 0 ]; then
  shift
  arguments=("$@")
fi
scratch="$(mktemp -d)"
trap 'rm -rf -- "${scratch}"' EXIT
cc -O2 -fPIC -shared -o "${scratch}/fail.so" "${here}/fail_allocations.c"
RANDOM="${FOOTFALL_SEED:-27}"

wrong=0
for environment in "${environments[@]}"; do
  LD_PRELOAD="${scratch}/fail.so" FOOTFALL_FAIL_FROM=1000000000 FOOTFALL_COUNT_TO="${scratch}/count" \
    "${program}" run "${environment}" "${arguments[@]}" >/dev/null 2>&1
  count="$(cat -- "${scratch}/count")"
  ended=0 told=0 died=0 other=0
  for ((i = 0; i < runs; ++i)); do
    from="$(((RANDOM * 32768 + RANDOM) % count))"
    code=0
    LD_PRELOAD="${scratch}/fail.so" FOOTFALL_FAIL_FROM="${from}" timeout 300 "${program}" run "${environment}" \
      "${arguments[@]}" >/dev/null 2>"${scratch}/error" || code="$?"
    if [ "${code}" -eq 0 ]; then
      ended="$((ended + 1))"
    elif [ "${code}" -ge 124 ]; then
      died="$((died + 1))"
      echo "$(basename -- "${environment}"): exit code ${code} when allocations fail from ${from} on:" \
        "$(tail -n 1 "${scratch}/error")"
    elif grep -qi "memory" "${scratch}/error"; then
      told="$((told + 1))"
    else
      other="$((other + 1))"
      echo "$(basename -- "${environment}"): allocations fail from ${from} on: $(tail -n 1 "${scratch}/error")"
    fi
  done
  wrong="$((wrong + died + other))"
  echo "$(basename -- "${environment}"): ${runs} runs, ${count} allocations: ${told} say that memory ran out," \
    "${ended} end with their result, ${died} died, ${other} say something else"
done
if [ "${wrong}" -gt 0 ]; then exit 1; fi
