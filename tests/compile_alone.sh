#!/usr/bin/env bash
# compile_alone.sh: does each file of the editor and of the programs include all that it needs? The preset release
# compiles several of them as one (FOOTFALL_UNITY), where one lends its includes to the next. Headers of libraries that are
# precompiled count as included. Nothing is generated, only looked at. Wants what installer/test.sh has installed.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
# shellcheck source=installer/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../installer/common.sh"

say "compiling each file of the editor and of the programs by itself"
build="${repository}/build/alone"
mkdir -p "${repository}/build"
quietly "${build}.log" cmake -S "${repository}" -B "${build}" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DFOOTFALL_UNITY=OFF \
  -DFOOTFALL_TESTS=OFF -DFOOTFALL_PYTHON=OFF -DFOOTFALL_WERROR=ON -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DCMAKE_AUTOGEN_ORIGIN_DEPENDS=OFF
# Generated sources and precompiled headers, without the library that their targets depend on.
quietly "${build}.log" cmake -E cmake_autogen "${build}/ui/CMakeFiles/footfall_ui_autogen.dir/AutogenInfo.json" Debug
while read -r header; do
  command="$(ninja -C "${build}" -t commands "${header}" | tail -n 1)"
  (cd -- "${build}" && quietly "${build}.log" sh -c "${command}")
done < <(ninja -C "${build}" -t targets all | sed -n 's/: .*//; /cmake_pch.hxx.gch$/p')
python3 - "${build}" "${repository}" "$(build_jobs)" <<'PYTHON'
import concurrent.futures, json, os, re, shlex, subprocess, sys
build, repository, jobs = sys.argv[1], os.path.realpath(sys.argv[2]), int(sys.argv[3])
def problem(entry):
    words = shlex.split(entry["command"])
    compiler = next(i for i, word in enumerate(words) if re.search(r"(c|g|clang)\+\+(-\d+)?$", word))
    words = words[compiler:]
    del words[words.index("-o"):words.index("-o") + 2]
    run = subprocess.run(words + ["-fsyntax-only"], cwd=entry["directory"], capture_output=True, text=True)
    return run.stderr if run.returncode else None
entries = [entry for entry in json.load(open(f"{build}/compile_commands.json"))
           if os.path.relpath(os.path.realpath(entry["file"]), repository).split(os.sep)[0] in ("ui", "app")]
if not entries: sys.exit("no files were found")
with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
    problems = [problem for problem in pool.map(problem, entries) if problem]
print(*problems, sep="\n", file=sys.stderr)
print(f"{len(entries)} files, {len(problems)} with problems")
sys.exit(bool(problems))
PYTHON
