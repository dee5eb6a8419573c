#!/usr/bin/env bash
# check.sh TEST_PROGRAM LIBRARY HEADER FOOTFALL SAMPLE: runs the C test with the export of the command line to hold its own
# against, and checks that the library shows exactly the functions of its header.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
test="$1" library="$2" header="$3" footfall="$4" sample="$5"
scratch="$(mktemp -d)"
trap 'rm -rf -- "${scratch}"' EXIT
"${footfall}" run "${sample}" --quiet -o "${scratch}/expected.obj"
"${test}" "${sample}" "${scratch}" "${scratch}/expected.obj"

grep -oE '\bfootfall_[a-z_]+\(' <(grep -A1 'FOOTFALL_API' "${header}") | tr -d '(' | sort -u >"${scratch}/declared"
nm -D --defined-only "${library}" | awk '{ print $3 }' | sort -u >"${scratch}/shown"
[ "$(wc -l <"${scratch}/declared")" -gt 40 ] || { echo "too few functions found in ${header}" >&2; exit 1; }
diff "${scratch}/declared" "${scratch}/shown" || { echo "the header and the library differ as above" >&2; exit 1; }
readelf -d "${library}" | grep -qE 'SONAME.*\[libfootfall\.so\.[0-9]+\.[0-9]+\]' || { echo "no soname" >&2; exit 1; }
echo "$(wc -l <"${scratch}/shown") functions"
