#!/usr/bin/env bash
# tidy.sh [BASE | --all]: clang-tidy over the sources of core/, ui/, app/ and bindings/c that differ from BASE (a commit;
# the one before HEAD unless given), or over all of them. Findings in headers count where the header differs. Without
# --all it stops after TIDY_SECONDS (240) and names what it left out. Nothing is built. Wants what installer/test.sh has
# installed.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
# shellcheck source=installer/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../installer/common.sh"

base="${1:-HEAD~1}"
seconds="${TIDY_SECONDS:-240}"
folders=(core ui app bindings/c)
cd -- "${repository}"
if [ "${base}" = --all ]; then
  seconds=0
  headers=(core/ ui/ app/ bindings/c/)
  mapfile -t sources < <(find "${folders[@]}" -name '*.cpp' | LC_ALL=C sort)
elif git rev-parse --quiet --verify "${base}^{commit}" >/dev/null 2>&1; then
  mapfile -t sources < <(git diff --name-only --diff-filter=d "${base}" -- "${folders[@]}" | grep '\.cpp$')
  mapfile -t headers < <(git diff --name-only --diff-filter=d "${base}" -- "${folders[@]}" | grep '\.h')
elif [ "$#" -eq 0 ]; then
  echo "no commit before HEAD is known here, so there are no changed sources"
  exit 0
else
  fail "${base} is no commit; give one, or --all"
fi
if [ "${#sources[@]}" -eq 0 ]; then
  echo "no source differs from ${base}"
  exit 0
fi
"${repository}/installer/install_dependencies.sh" --tidy || fail "clang-tidy cannot be installed here; see above"
say "clang-tidy over ${#sources[@]} files"
build="${repository}/build/tidy"
mkdir -p "${repository}/build"
# Clang reads no precompiled header of GCC.
quietly "${build}.log" cmake -S "${repository}" -B "${build}" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DFOOTFALL_UNITY=OFF \
  -DFOOTFALL_TESTS=OFF -DFOOTFALL_PYTHON=OFF -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
python3 - "${build}" "$(build_jobs)" "${seconds}" "$(IFS="|" && echo "${headers[*]}")" "${sources[@]}" <<'PYTHON'
import concurrent.futures, json, os, subprocess, sys, time
build, jobs, seconds, headers, sources = sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), sys.argv[4], sys.argv[5:]
known = {os.path.realpath(entry["file"]) for entry in json.load(open(f"{build}/compile_commands.json"))}
sources = [source for source in sources if os.path.realpath(source) in known]
end = time.monotonic() + seconds if seconds else float("inf")
def check(source):
    if time.monotonic() > end: return None
    run = subprocess.run(["clang-tidy", "-p", build, "--quiet", "--warnings-as-errors=*",
                          "--extra-arg=-Wno-unknown-warning-option", f"--header-filter=/({headers or 'none'})",
                          source], capture_output=True, text=True)
    return run.stdout + run.stderr if run.returncode else ""
with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
    results = dict(zip(sources, pool.map(check, sources)))
left = [source for source, result in results.items() if result is None]
bad = [result for result in results.values() if result]
print(*bad, sep="\n", file=sys.stderr)
print(f"{len(sources) - len(left)} files checked, {len(bad)} with findings, {len(left)} left out after {seconds} s"
      + "".join(f"\n  {source}" for source in left))
sys.exit(bool(bad))
PYTHON
