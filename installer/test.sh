#!/usr/bin/env bash
# test.sh [--werror] [PRESET]: installs what is missing, builds Footfall (preset release, or dev, asan, tsan) and runs
# all tests, on virtual displays with software OpenGL. --werror makes warnings errors, as in continuous integration.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
# shellcheck source=installer/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

preset=release
options=()
for argument in "$@"; do
  case "${argument}" in
    -h | --help)
      sed -n '2,3s/^# //p' "${BASH_SOURCE[0]}"
      exit 0
      ;;
    --werror) options+=(-DFOOTFALL_WERROR=ON) ;;
    dev | release | asan | tsan) preset="${argument}" ;;
    *) fail "unknown argument ${argument}; usage: test.sh [--werror] [dev|release|asan|tsan]" ;;
  esac
done

prepare "${preset}" "${options[@]}"
# The tests make a wheel and the API reference.
"${repository}/installer/install_dependencies.sh" --wheel
"${repository}/installer/install_dependencies.sh" --reference
say "building"
cmake --build --preset "${preset}" -j "$(build_jobs)"

say "testing"
# Suites of the editor make displays of their own (tests/on_display.sh).
ctest --preset "${preset}" -j "$(build_jobs)"
