#!/usr/bin/env bash
# check.sh CMAKE BUILD_FOLDER COMPILER FLAGS: installs the build into a scratch prefix; builds and runs the project beside
# this file against it; compiles each public header by itself, with COMPILER and, where there is one, Clang.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cmake="$1" build="$2" compiler="$3" flags="$4"
here="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)"
scratch="$(mktemp -d)"
trap 'rm -rf -- "${scratch}"' EXIT
"${cmake}" --install "${build}" --prefix "${scratch}/prefix" >"${scratch}/install.log"
"${cmake}" -G Ninja -S "${here}" -B "${scratch}/build" -DCMAKE_PREFIX_PATH="${scratch}/prefix" \
  -DCMAKE_CXX_COMPILER="${compiler}" -DCMAKE_CXX_FLAGS="${flags}" -DCMAKE_C_FLAGS="${flags}"
"${cmake}" --build "${scratch}/build"

"${scratch}/build/three_lines" "${scratch}/prefix/share/footfall/samples/house/house.obj" "${scratch}/house.obj"
grep -q '^g layer_1$' "${scratch}/house.obj" || { echo "the walkable area of the house has no two layers" >&2; exit 1; }
if "${scratch}/build/three_lines" "${scratch}/none.obj" "${scratch}/out.obj" 2>"${scratch}/error"; then
  echo "a missing level is no error" >&2
  exit 1
fi
grep -q 'none\.obj' "${scratch}/error" || { echo "the error does not name the file: $(<"${scratch}/error")" >&2; exit 1; }
"${scratch}/build/three_lines_c" "${scratch}/prefix/share/footfall/samples/house/house.obj" "${scratch}/house-c.obj"
grep -v '^# \(pipeline\|agent\): ' "${scratch}/house-c.obj" | cmp - "${scratch}/house.obj"
"${scratch}/build/editing_loop"
"${scratch}/build/path_query"
"${scratch}/build/engine_loop"

# Public headers need nothing but the standard library and each other, not even in their order.
include="${scratch}/prefix/include"
headers=("${include}"/footfall/*.hpp)
[ "${#headers[@]}" -ge 15 ] || { echo "only ${#headers[@]} headers are installed" >&2; exit 1; }
stray="$(find "${include}" -type f ! -path "${include}/footfall/*.hpp" ! -path "${include}/footfall.h")"
[ -z "${stray}" ] || { echo "installed, but not public: ${stray}" >&2; exit 1; }
if grep -nE '^ *# *include' "${headers[@]}" | grep -vE '#include (<[a-z_]+>|"footfall/[a-z_]+\.hpp")$'; then
  echo "the includes above are neither of the standard library nor public" >&2
  exit 1
fi
compilers=("${compiler}")
clang="$(command -v clang++ || command -v clang++-14 || true)"
[ -z "${clang}" ] || compilers+=("${clang}")
for each in "${compilers[@]}"; do
  for header in "${headers[@]}"; do
    name="footfall/$(basename -- "${header}")"
    printf '#include "%s"\n#include "%s"\n' "${name}" "${name}" >"${scratch}/alone.cpp"
    "${each}" -std=c++20 -Wall -Wextra -Wpedantic -Werror -fsyntax-only -I "${include}" "${scratch}/alone.cpp"
  done
  echo "${#headers[@]} headers compile alone with ${each}"
done
