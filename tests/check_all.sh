#!/usr/bin/env bash
# check_all.sh: runs every check of the project, in stages: .ci/run, clang-tidy over all sources, all unit suites with
# AddressSanitizer and UndefinedBehaviorSanitizer, the threaded ones with ThreadSanitizer, ten minutes of each fuzz target,
# and allocations that fail. Takes hours. A stage that fails does not stop the others; the end lists those that failed.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
# shellcheck source=installer/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../installer/common.sh"
[ "$#" -eq 0 ] || fail "unknown arguments $*; usage: check_all.sh"

cd -- "${repository}"
failed=()
# stage COMMAND...: runs it and notes whether it failed.
stage() {
  local start="${SECONDS}" outcome=passed
  say "stage: $*"
  if ! "$@"; then
    failed+=("$*")
    outcome=failed
  fi
  say "stage ${outcome} after $((SECONDS - start)) s: $*"
}
stage .ci/run
stage tests/tidy.sh --all
stage tests/sanitize.sh address
stage tests/sanitize.sh thread
stage tests/fuzz/run.sh 600
stage tests/memory/run.sh build/release/footfall 100 samples/villa/villa.obj
if [ "${#failed[@]}" -gt 0 ]; then
  printf 'failed: %s\n' "${failed[@]}" >&2
  exit 1
fi
say "every stage passed"
