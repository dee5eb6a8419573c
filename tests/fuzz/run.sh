#!/usr/bin/env bash
# run.sh [SECONDS]: builds the fuzz targets (preset fuzz, in build/fuzz) and runs each for SECONDS, 60 unless given; 0
# runs their corpora only. What fails is left in build/fuzz/found. The seed is fixed, so that a run says something about
# a change and not about luck; FOOTFALL_FUZZ_SEED chooses another. See README.md.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
# shellcheck source=installer/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../../installer/common.sh"

seconds="${1:-60}"
seed="${FOOTFALL_FUZZ_SEED:-1}"
case "${seconds}${seed}" in
  *[!0-9]*)
    sed -n '2,4s/^# //p' "${BASH_SOURCE[0]}" >&2
    exit 2
    ;;
esac

"${repository}/installer/install_dependencies.sh" --fuzzing ||
  fail "fuzzing needs Clang 14 with libFuzzer, which cannot be installed here; see above"
command -v clang++-14 >/dev/null || fail "clang++-14 is missing although its package is installed"

mkdir -p "${repository}/build"
cd -- "${repository}"
say "configuring (fuzz)"
quietly build/configure-fuzz.log cmake --preset fuzz
say "building the fuzz targets"
cmake --build --preset fuzz -j "$(build_jobs)" --target fuzzers

found="${repository}/build/fuzz/found"
mkdir -p "${found}"
# What Assimp does not free is not ours to mend.
export ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=print_stacktrace=1
limits=(-timeout=20 -rss_limit_mb=4096 -verbosity=0 -print_final_stats=1 "-seed=${seed}")

# run_target NAME LENGTH: inputs of at most LENGTH bytes; new ones stay out of the repository.
run_target() {
  local corpus="tests/fuzz/corpus/$1" fresh="build/fuzz/corpus/$1"
  mkdir -p "${fresh}"
  say "fuzz_$1"
  if [ "${seconds}" -eq 0 ]; then
    "build/fuzz/tests/fuzz/fuzz_$1" -runs=0 "${limits[@]}" "${corpus}"
  else
    "build/fuzz/tests/fuzz/fuzz_$1" "-max_total_time=${seconds}" "-max_len=$2" "-artifact_prefix=${found}/$1-" \
      "${limits[@]}" "${fresh}" "${corpus}"
  fi
}

run_target obj 2048
run_target pipeline_file 512
run_target checks 1024
run_target import 1024
run_target share 2048
run_target packed 2048
run_target streams 1024
run_target tile 2048
say "footfall-fuzz-pipeline"
if [ "${seconds}" -eq 0 ]; then
  build/fuzz/tests/fuzz/footfall-fuzz-pipeline --cases 1 --seed "${seed}" --folder "${found}"
else
  build/fuzz/tests/fuzz/footfall-fuzz-pipeline --seconds "${seconds}" --seed "${seed}" --folder "${found}"
fi
if [ "${seconds}" -gt 0 ]; then
  say "footfall-fuzz-slowest"
  # With sanitizers everything takes ten times as long.
  build/fuzz/tests/fuzz/footfall-fuzz-slowest --seconds "${seconds}" --triangles 100 --seed "${seed}" --limit 200000 \
    --folder "${found}"
fi
say "nothing found"
