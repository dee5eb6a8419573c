#!/usr/bin/env bash
# thesis.sh [BUILD_FOLDER [OPTION...]]: runs the thesis's experiments again and writes the tables of
# docs/reference/thesis_measurements.md between their markers. Options go to footfall-thesis-bench (--runs 3 --least-seconds 0 --seconds 5: quick and rough).
# Environments from outside come from the folder $FOOTFALL_SHARED (../shared unless set). Takes some minutes; a machine
# that does something else meanwhile spoils the figures.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
repository="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)"
build="$(realpath -- "${1:-${repository}/build/release}")"
if [ "$#" -gt 0 ]; then shift; fi
document="${repository}/docs/reference/thesis_measurements.md"
scratch="$(mktemp -d)"
trap 'rm -rf -- "${scratch}"' EXIT
# shellcheck source=tests/bench/tables.sh
source "${repository}/tests/bench/tables.sh"

arguments=("$@" --samples --json "${build}/thesis-bench.json" --markdown "${scratch}/thesis.md")
environments
"${build}/footfall-thesis-bench" "${arguments[@]}"
replace thesis "${scratch}/thesis.md"
