#!/usr/bin/env bash
# check_installable.sh NINJA BUILD_FOLDER: fails when `cmake --install` copies a file that the build makes and the target
# `installable`, which installer/run.sh builds, does not make.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
ninja="$1" build="$2"

# Files in the build folder that the install scripts name; those that no build step makes were there after configuring.
named="$(find "${build}" -name cmake_install.cmake -not -path '*/deps/*' -exec grep -ohE "\"${build}/[^\"]+\"" {} + |
  tr -d '"' | sort -u)"
[ -n "${named}" ] || { echo "the install scripts below ${build} name no file of it" >&2; exit 1; }
made="$("${ninja}" -C "${build}" -t targets all | sed -n 's/: .*//p' | sed "s|^\([^/]\)|${build}/\1|" | sort -u)"
needed="$(comm -12 <(echo "${named}") <(echo "${made}"))"
[ -n "${needed}" ] || { echo "no installed file is made by the build: the check sees nothing" >&2; exit 1; }
# The tool "inputs" leaves out what stands behind phony targets; the graph has every file.
brought="$("${ninja}" -C "${build}" -t graph installable | sed -n 's/.*\[label="\([^"]*\)".*/\1/p' |
  sed "s|^\([^/]\)|${build}/\1|" | sort -u)"
missing="$(comm -23 <(echo "${needed}") <(echo "${brought}"))"
# The links to a shared library are made together, by one step; the graph shows only that one which something needs.
missing="$(while read -r file; do
  [ -n "${file}" ] || continue
  step="$("${ninja}" -C "${build}" -t query "${file#"${build}/"}")"
  library="${build}/$(sed -n '3s/^ *//p' <<<"${step}")"
  if grep -q 'input: CMAKE_SYMLINK_LIBRARY' <<<"${step}" && grep -qxF -- "${library}" <<<"${brought}"; then continue; fi
  echo "${file}"
done <<<"${missing}")"
if [ -n "${missing}" ]; then
  echo "not made by the target installable, but installed:" >&2
  echo "${missing}" >&2
  exit 1
fi
echo "$(wc -l <<<"${needed}") installed files are made by the target installable"
