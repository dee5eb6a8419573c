#!/usr/bin/env bash
# check_format.sh [CLANG_FORMAT]: fails, with the places, when a source under version control is not formatted.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."
formatter="${1:-clang-format}"
if ! command -v "${formatter}" >/dev/null; then
  echo "check_format.sh: ${formatter} is missing; run installer/install_dependencies.sh first" >&2
  exit 1
fi
if git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
  mapfile -t files < <(git ls-files -- '*.cpp' '*.hpp' '*.h' '*.c')
else
  mapfile -t files < <(find . -path ./build -prune -o \( -name '*.cpp' -o -name '*.hpp' -o -name '*.[ch]' \) -print)
fi
existing=()
for file in "${files[@]}"; do
  if [ -f "${file}" ]; then existing+=("${file}"); fi
done
if [ "${#existing[@]}" -eq 0 ]; then
  echo "check_format.sh: no sources found" >&2
  exit 1
fi
"${formatter}" --dry-run -Werror "${existing[@]}"
echo "${#existing[@]} files are formatted"
