#!/usr/bin/env bash
# tidy.sh [BASE | --all]: runs clang-tidy on core/, ui/, app/ and bindings/c, and fails on findings in the lines that differ
# from the commit BASE, the one before HEAD unless given. Looks at the sources that differ, and at the source beside each
# header that does; starts no further one after TIDY_SECONDS (240), and lists those left out. --all: every source, every
# line, no limit. Where the commit before HEAD is not known (a shallow clone, an archive), nothing counts as changed.
# Builds nothing. Needs what installer/test.sh installs.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
# shellcheck source=installer/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../installer/common.sh"

base="${1:-HEAD~1}"
folders=(core ui app bindings/c)
cd -- "${repository}"
mkdir -p build
changes=build/tidy.diff
case "${base}" in
  -h | --help)
    sed -n '2,6s/^# //p' "${BASH_SOURCE[0]}"
    exit 0
    ;;
  --all) : >"${changes}" ;;
  *)
    if ! git rev-parse --quiet --verify "${base}^{commit}" >/dev/null 2>&1; then
      if [ "$#" -gt 0 ]; then fail "${base} is no commit; give one, or --all"; fi
      say "clang-tidy: the commit before HEAD is not known here, so nothing counts as changed"
      exit 0
    fi
    git diff --no-color --no-ext-diff --src-prefix=a/ --dst-prefix=b/ --no-renames --diff-filter=d -U0 "${base}" -- \
      "${folders[@]}" >"${changes}"
    if ! grep -qE '^\+\+\+ b/.*\.(cpp|hpp|h)$' "${changes}"; then
      say "clang-tidy: no source differs from ${base}"
      exit 0
    fi
    ;;
esac

"${repository}/installer/install_dependencies.sh" --tidy || fail "clang-tidy cannot be installed here; see above"
build="${repository}/build/tidy"
# Clang reads no precompiled header of GCC.
quietly "${build}.log" cmake -S "${repository}" -B "${build}" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DFOOTFALL_UNITY=OFF \
  -DFOOTFALL_TESTS=OFF -DFOOTFALL_PYTHON=OFF -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
python3 - "${base}" "${build}" "$(build_jobs)" "${TIDY_SECONDS:-240}" "${changes}" "${folders[@]}" <<'PYTHON'
import concurrent.futures, json, os, re, subprocess, sys, time
base, build, jobs, seconds, changes, folders = sys.argv[1], sys.argv[2], int(sys.argv[3]), int(sys.argv[4]), sys.argv[5], sys.argv[6:]
known = {os.path.realpath(entry["file"]) for entry in json.load(open(f"{build}/compile_commands.json"))}
if base == "--all":
    end, filters = float("inf"), [f"--header-filter=/({'|'.join(folders)})/"]
    sources = {os.path.relpath(file) for file in known}
    sources = [file for file in sorted(sources) if file.startswith(tuple(folder + "/" for folder in folders))]
else:
    lines, end = {}, time.monotonic() + seconds  # the changed ranges of each file
    for line in open(changes, errors="replace"):
        if line.startswith("+++ b/"): ranges = lines.setdefault(line[6:].strip(), [])
        elif hunk := re.match(r"@@ -\S+ \+(\d+)(?:,(\d+))? @@", line):
            first, count = int(hunk[1]), int(hunk[2] or 1)
            if count: ranges.append([first, first + count - 1])
    lines = {file: ranges for file, ranges in lines.items() if ranges and file.endswith((".cpp", ".hpp", ".h"))}
    sources = [file for file in lines if file.endswith(".cpp")]
    sources += [os.path.splitext(file)[0] + ".cpp" for file in lines if not file.endswith(".cpp")]
    sources = [file for file in dict.fromkeys(sources) if os.path.realpath(file) in known]
    headers = [re.escape(file) for file in lines if not file.endswith(".cpp")]
    filters = ["--line-filter=" + json.dumps([{"name": "/" + file, "lines": ranges} for file, ranges in lines.items()]),
               f"--header-filter=/({'|'.join(headers) or 'none'})$"]
print(f"== clang-tidy: {len(sources)} files", flush=True)
def check(source):
    if time.monotonic() > end: return None
    run = subprocess.run(["clang-tidy", "-p", build, "--quiet", "--warnings-as-errors=*",
                          "--extra-arg=-Wno-unknown-warning-option", *filters, source], capture_output=True, text=True)
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
