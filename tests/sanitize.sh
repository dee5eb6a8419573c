#!/usr/bin/env bash
# sanitize.sh address [--change | SUITE...] | thread [SUITE...]: builds and runs unit suites with sanitizers, and fails on
# any report and any failed suite.
# address: AddressSanitizer, leaks and UndefinedBehaviorSanitizer, by Clang, in the build of the fuzz targets (preset fuzz).
# Runs all suites under tests/unit, or those named; --change chooses the few that .ci/run runs.
# thread: ThreadSanitizer, by GCC (preset tsan), once with a TBB that it sees into. Runs the suites of what is threaded.
# FOOTFALL_TEST_ROUNDS chooses how many random cases are tried: a tenth of the usual number unless it is set.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
# shellcheck source=installer/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../installer/common.sh"

usage="usage: sanitize.sh address [--change | SUITE...] | thread [SUITE...]"
case "${1:-}" in
  -h | --help)
    sed -n '2,7s/^# //p' "${BASH_SOURCE[0]}"
    exit 0
    ;;
  address) preset=fuzz ;;
  thread) preset=tsan ;;
  "") fail "a sanitizer is missing; ${usage}" ;;
  *) fail "unknown argument $1; ${usage}" ;;
esac
shift

threaded=(test_parallel test_parallel_blocks test_runner test_live_edits test_cancelling test_cancelled_moments
  test_strategies test_cutting test_compare test_source_mesh)
# A suite of each subject, those that are short and compile soon.
changed=(test_parallel test_exact_numbers test_handmade test_metamorphic test_runner test_live_edits test_compare
  test_random_cuts test_path_finder)
# It replaces operator new, as the sanitizer does.
excluded=(test_memory_runs_out)
if [ "${1:-}" = --change ] && [ "${preset}" = fuzz ] && [ "$#" -eq 1 ]; then
  suites=("${changed[@]}")
elif [ "$#" -gt 0 ]; then
  for argument in "$@"; do
    case "${argument}" in
      test_*) ;;
      *) fail "unknown argument ${argument}: suites are called test_NAME; ${usage}" ;;
    esac
  done
  suites=("$@")
elif [ "${preset}" = tsan ]; then
  suites=("${threaded[@]}")
else
  mapfile -t suites < <(find "${repository}/tests/unit" -name 'test_*.cpp' -exec basename -s .cpp {} + | LC_ALL=C sort |
    grep -vxF -f <(printf '%s\n' "${excluded[@]}"))
fi

# Without the large environments, which take long here and run no other code than the samples do.
export FOOTFALL_SHARED=none QT_QPA_PLATFORM=offscreen QTEST_FUNCTION_TIMEOUT=1500000 RC_PARAMS=seed=1
export FOOTFALL_TEST_ROUNDS="${FOOTFALL_TEST_ROUNDS:-0.1}"
if [ "${preset}" = fuzz ]; then
  "${repository}/installer/install_dependencies.sh" --fuzzing || fail "Clang 14 cannot be installed here; see above"
fi
prepare "${preset}"
build="${repository}/build/${preset}"
say "building ${#suites[@]} suites"
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
# run_suite NAME: leaves a log, and a file NAME.failed where it fails.
run_suite() {
  local log="${reports}/$1.log"
  if timeout 1500 "${build}/tests/$1" >"${log}" 2>&1; then
    printf '%s: %s\n' "$1" "$(grep '^Totals' "${log}" || echo passed)"
  else
    touch "${reports}/$1.failed"
    printf '%s: FAILED\n' "$1"
    grep -A 3 -E '^(FAIL|QFATAL|Totals)' "${log}" || tail -n 30 "${log}"
  fi
}
export -f run_suite
export reports build
say "running ${#suites[@]} suites"
# shellcheck disable=SC2016 # the inner shell expands it
printf '%s\0' "${suites[@]}" | xargs -0 -n 1 -P "$(build_jobs)" bash -c 'run_suite "$0"'

shopt -s nullglob
found=("${reports}"/report.*)
failed=("${reports}"/*.failed)
if [ "${#found[@]}" -gt 0 ]; then
  head -n 200 "${found[@]}"
  fail "${#found[@]} processes have reports, whole in ${reports}"
fi
if [ "${#failed[@]}" -gt 0 ]; then fail "no reports, but ${#failed[@]} suites failed; output in ${reports}"; fi
say "no reports in ${#suites[@]} suites"
