#!/usr/bin/env bash
# tsan.sh [SUITE...]: looks for data races with ThreadSanitizer. Builds a TBB that it sees into (once), then the suites
# that run on many threads, or those named, and runs them; fails on any report. Takes too long for each change (10 min).
# FOOTFALL_TEST_ROUNDS chooses how many random cases are tried: a tenth of the usual number unless it is set.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
# shellcheck source=installer/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../installer/common.sh"

suites=(test_parallel_blocks test_runner test_live_edits test_cancelling test_strategies test_cutting test_compare
  test_source_mesh)
case "${1:-}" in
  -h | --help)
    sed -n '2,4s/^# //p' "${BASH_SOURCE[0]}"
    exit 0
    ;;
  -*) fail "unknown argument $1; usage: tsan.sh [SUITE...]" ;;
  "") ;;
  *) suites=("$@") ;;
esac

prepare tsan
build="${repository}/build/tsan"
say "building"
cmake --build "${build}" -j "$(build_jobs)" --target "${suites[@]}"

reports="${build}/reports"
rm -rf -- "${reports}"
mkdir -p "${reports}"
# Each process writes a file of its own, so that programs that a suite starts count as well.
options="suppressions=${repository}/cmake/tsan.supp:halt_on_error=0:exitcode=66:history_size=4"
export TSAN_OPTIONS="${options}:log_path=${reports}/race"
# Without the large environments, which take long here and run no other code than the samples do.
export FOOTFALL_SHARED=none QT_QPA_PLATFORM=offscreen QTEST_FUNCTION_TIMEOUT=1500000 RC_PARAMS=seed=1
export FOOTFALL_TEST_ROUNDS="${FOOTFALL_TEST_ROUNDS:-0.1}"
failed=()
for suite in "${suites[@]}"; do
  say "${suite}"
  log="${reports}/${suite}.log"
  "${build}/tests/${suite}" >"${log}" 2>&1 || failed+=("${suite}")
  grep -A 3 -E '^(FAIL|QFATAL|Totals)' "${log}" || tail -n 30 "${log}"
done

shopt -s nullglob
races=("${reports}"/race.*)
if [ "${#races[@]}" -gt 0 ]; then
  head -n 200 "${races[@]}"
  fail "$(cat "${races[@]}" | grep -c '^WARNING: ThreadSanitizer') reports, whole in ${reports}"
fi
if [ "${#failed[@]}" -gt 0 ]; then fail "no reports, but these failed: ${failed[*]}; output in ${reports}"; fi
say "no reports in ${#suites[@]} suites"
