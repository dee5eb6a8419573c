#!/usr/bin/env bash
# thesis.sh [--docs] [BUILD_FOLDER [OPTION...]]: runs the thesis's experiments (5.3 to 5.7, and the roundings of 5.1.1) again
# on our samples and makes one page of all tables, plots and pictures: BUILD_FOLDER/thesis.html. Says at its start how
# long it takes. Options go to footfall-thesis-bench (--runs 3 --least-seconds 0 --seconds 5: quick and rough). What is
# not built (footfall-mpi) is left out, and the page says so. A machine that does something else meanwhile spoils times.
# --docs also measures the environments in $FOOTFALL_SHARED (../shared unless set) and writes the tables of
# docs/reference/thesis_measurements.md between their markers.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
repository="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)"
docs=false
if [ "${1:-}" = --docs ]; then
  docs=true
  shift
fi
build="$(realpath -- "${1:-${repository}/build/release}")"
if [ "$#" -gt 0 ]; then shift; fi
for program in footfall footfall-thesis-bench footfall-communication-bench footfall-rounding-experiment; do
  if [ ! -x "${build}/${program}" ]; then
    echo "thesis.sh: ${build}/${program} is missing; build it first, or name another build folder" >&2
    exit 2
  fi
done
page="${repository}/tests/bench/thesis_page"
document="${repository}/docs/reference/thesis_measurements.md"
scratch="$(mktemp -d)"
trap 'rm -rf -- "${scratch}"' EXIT
# shellcheck source=tests/bench/tables.sh
source "${repository}/tests/bench/tables.sh"

began="${SECONDS}"
step() { echo "thesis.sh: $((SECONDS - began)) s: $*" >&2; }
# Measured on two processors without other work: 10 minutes of the clock with --docs (12 of processor time), and 8 minutes
# of processor time without.
minutes=8
if "${docs}"; then minutes=10; fi
echo "thesis.sh: this takes about ${minutes} minutes on two idle processors; the page will be ${build}/thesis.html" >&2

step "5.4 to 5.6: strategies, listings, correctness, scaling"
arguments=("$@" --samples --json "${scratch}/thesis.json" --markdown "${scratch}/thesis.md")
if "${docs}"; then environments; fi
"${build}/footfall-thesis-bench" "${arguments[@]}" 2>"${scratch}/progress" || {
  cat "${scratch}/progress" >&2
  exit 1
}
step "5.3: communication, up to a million points"
"${build}/footfall-communication-bench" --folder "${build}" --json "${scratch}/communication.json" \
  >"${scratch}/communication.md" 2>"${scratch}/progress"
step "5.1.1: cut obstacles and rounded cuts"
"${build}/footfall-rounding-experiment" --samples --json "${scratch}/rounding.json" >"${scratch}/rounding.md"
step "5.7: ranks of 8 threads"
FOOTFALL="${build}/footfall" FOOTFALL_MPI="${build}/footfall-mpi" FOOTFALL_SAMPLES="${repository}/samples" \
  FOOTFALL_MPIRUN="$(command -v mpirun.openmpi || command -v mpirun || true)" \
  "${repository}/tests/mpi/measure.sh" --threads 8 --ranks "2 4" >"${scratch}/distributed.md" || true
step "figures 25 to 37"
python3 -B "${page}/make_pictures.py" "${build}/footfall" "${repository}/samples" "${scratch}"
python3 -B "${page}/make_page.py" "${scratch}" "${build}/thesis.html"
cp -- "${scratch}/thesis.json" "${build}/thesis-bench.json"
if "${docs}"; then replace thesis "${scratch}/thesis.md"; fi
step "done: ${build}/thesis.html"
