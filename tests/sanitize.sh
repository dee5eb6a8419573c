#!/usr/bin/env bash
# sanitize.sh address|thread [SUITE...]: builds and runs the unit suites of what is threaded, or those named, with
# AddressSanitizer and UndefinedBehaviorSanitizer (preset asan) or with ThreadSanitizer (preset tsan, and once a TBB that
# it sees into). Fails on any report. Takes too long for each change: a build of its own, and ten minutes of tests.
# FOOTFALL_TEST_ROUNDS chooses how many random cases are tried: a tenth of the usual number unless it is set.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
# shellcheck source=installer/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../installer/common.sh"

usage="usage: sanitize.sh address|thread [SUITE...]"
case "${1:-}" in
  -h | --help)
    sed -n '2,5s/^# //p' "${BASH_SOURCE[0]}"
    exit 0
    ;;
  address) preset=asan ;;
  thread) preset=tsan ;;
  "") fail "a sanitizer is missing; ${usage}" ;;
  *) fail "unknown argument $1; ${usage}" ;;
esac
shift
for argument in "$@"; do
  case "${argument}" in
    test_*) ;;
    *) fail "unknown argument ${argument}: suites are called test_NAME; ${usage}" ;;
  esac
done
suites=(test_parallel test_memory_runs_out test_parallel_blocks test_runner test_live_edits test_cancelling
  test_cancelled_moments test_strategies test_cutting test_compare test_source_mesh)
if [ "$#" -gt 0 ]; then suites=("$@"); fi

prepare "${preset}"
build="${repository}/build/${preset}"
say "building"
cmake --build "${build}" -j "$(build_jobs)" --target "${suites[@]}"

reports="${build}/reports"
rm -rf -- "${reports}"
mkdir -p "${reports}"
# Each process writes a file of its own, so that programs that a suite starts count as well.
export TSAN_OPTIONS="suppressions=${repository}/cmake/tsan.supp:halt_on_error=0:exitcode=66:history_size=4:log_path=${reports}/report"
# A program that breaks a promise of the language ends at once, as the preset says; so each suite has one report at most.
export ASAN_OPTIONS="exitcode=66:allocator_may_return_null=1:log_path=${reports}/report"
export UBSAN_OPTIONS="print_stacktrace=1:exitcode=66:log_path=${reports}/report"
export LSAN_OPTIONS="suppressions=${repository}/cmake/lsan.supp"
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
found=("${reports}"/report.*)
if [ "${#found[@]}" -gt 0 ]; then
  head -n 200 "${found[@]}"
  fail "${#found[@]} processes have reports, whole in ${reports}"
fi
if [ "${#failed[@]}" -gt 0 ]; then fail "no reports, but these failed: ${failed[*]}; output in ${reports}"; fi
say "no reports in ${#suites[@]} suites"
