#!/usr/bin/env bash
# check.sh CMAKE BUILD_FOLDER COMPILER FLAGS: installs the build into a scratch prefix, then builds and runs the project
# beside this file against it.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cmake="$1" build="$2" compiler="$3" flags="$4"
here="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)"
scratch="$(mktemp -d)"
trap 'rm -rf -- "${scratch}"' EXIT
"${cmake}" --install "${build}" --prefix "${scratch}/prefix" >"${scratch}/install.log"
"${cmake}" -G Ninja -S "${here}" -B "${scratch}/build" -DCMAKE_PREFIX_PATH="${scratch}/prefix" \
  -DCMAKE_CXX_COMPILER="${compiler}" -DCMAKE_CXX_FLAGS="${flags}"
"${cmake}" --build "${scratch}/build"
"${scratch}/build/consumer"
