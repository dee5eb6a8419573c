#!/usr/bin/env bash
# out_of_core.sh TRIANGLES MEMORY FOLDER: a city of so many triangles through `footfall run --memory`: packed, run cell
# by cell within so much memory (as for --memory, such as 4G), and its tiles joined. Prints a line of
# docs/explanation/scaling.md's table for each step: wall and processor seconds, peak memory, bytes on disk. FOLDER must not exist
# and is removed at the end; it needs some 300 bytes for each triangle. JOIN=0 leaves out joining, which holds the whole
# result. KEEP=1 leaves the folder. MORE="--filter SimplificationFilter --filter LayerSubdivisionFilter" are filters behind
# slope and clearance. BUILD_DIR is the build's folder (build/release by default).
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail

if (($# != 3)); then
  sed -n 's/^# //p' "$0" | head -9
  exit 2
fi
read -ra more <<<"${MORE:-}"
triangles="$1" memory="$2" work="$3"
build="${BUILD_DIR:-$(dirname -- "${BASH_SOURCE[0]}")/../../build/release}"
footfall="${build}/footfall"
mkdir -- "${work}"
[[ "${KEEP:-0}" == 1 ]] || trap 'rm -rf -- "${work}"' EXIT

# step NAME RESULT COMMAND...: a line of the table; RESULT is a file or a folder.
step() {
  python3 - "$@" <<'PYTHON'
import os, resource, subprocess, sys, time
name, result, command = sys.argv[1], sys.argv[2], sys.argv[3:]
start = time.monotonic()
code = subprocess.run(command, stdout=sys.stderr).returncode
wall, used = time.monotonic() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
if code != 0:
    sys.exit(code)
paths = [os.path.join(result, file) for file in os.listdir(result)] if os.path.isdir(result) else [result]
size = sum(os.path.getsize(path) for path in paths)
print(f"| {name} | {wall:.1f} s | {used.ru_utime + used.ru_stime:.1f} s | {used.ru_maxrss / 1024:.0f} MB | {size / 1e6:.0f} MB |",
      flush=True)
PYTHON
}

echo "| step | time | processor time | peak memory | on disk |"
echo "|---|--:|--:|--:|--:|"
step "city as OBJ" "${work}/city.obj" "${build}/footfall-samples" city "${triangles}" "${work}/city.obj"
step "pack" "${work}/city.ffenv" "${footfall}" pack "${work}/city.obj" -o "${work}/city.ffenv" --quiet
rm -- "${work}/city.obj"
step "run --memory ${memory}" "${work}/tiles" "${footfall}" run "${work}/city.ffenv" --filter DegeneracyFilter \
  --filter "SlopeFilter 45" --filter "VerticalClearanceFilter 2" "${more[@]}" --memory "${memory}" -o "${work}/tiles" \
  --stats "${work}/stats.json"
python3 - "${work}/stats.json" >&2 <<'PYTHON'
import json, sys
stats = json.load(open(sys.argv[1]))
if stats["memory"]["peak_bytes"] > stats["memory"]["bound_bytes"]:
    sys.exit("the bound was not kept")
print(stats["cells"], stats["tiles"])
PYTHON
if [[ "${JOIN:-1}" == 1 ]]; then
  step "join" "${work}/joined.obj" "${footfall}" join "${work}/tiles" -o "${work}/joined.obj" --quiet
fi
