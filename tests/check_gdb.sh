#!/usr/bin/env bash
# check_gdb.sh CXX: fails when the printers for gdb (tools/gdb) do not print points and meshes by their meaning.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
repository="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
if ! command -v gdb >/dev/null; then
  echo "skipped: gdb is not installed"
  exit 0
fi
scratch="$(mktemp -d)"
trap 'rm -rf -- "${scratch}"' EXIT
cat >"${scratch}/points.cpp" <<'SOURCE'
#include "core/mesh/walkable_mesh.hpp"
using namespace footfall::detail;
void stop(const PlanPoint&, const PlanPoint&, const WalkableMesh&) {}
int main() {
  const PlanPoint source = PlanPoint::source(7);
  const PlanPoint crossing = PlanPoint::crossing({PlanLine::Edge, 4, 9}, {PlanLine::Trace, 17, 1}, 3);
  WalkableMesh mesh;
  mesh.vertices.resize(3);
  mesh.triangles.resize(1);
  stop(source, crossing, mesh);
}
SOURCE
"${1:-c++}" -std=c++20 -g -O0 -I"${repository}" -I"${repository}/core/include" "${scratch}/points.cpp" -o "${scratch}/points"
output="$(gdb -batch -nx -x "${repository}/tools/gdb/footfall.py" -ex 'break stop' -ex run -ex up -ex 'print source' \
  -ex 'print crossing' -ex 'print mesh' "${scratch}/points" 2>&1)" || true
# Where processes may not be traced (containers), gdb cannot run anything.
if grep -qiE 'ptrace|not permitted|Could not trace' <<<"${output}"; then
  echo "skipped: gdb may not trace processes here"
  exit 0
fi
for expected in 'source vertex 7' \
  'crossing of \[edge 4-9\] and \[trace of triangle 17 at level 1\] on face 3' '3 vertices, 1 triangles'; do
  if ! grep -q "${expected}" <<<"${output}"; then
    printf 'gdb does not print "%s":\n%s\n' "${expected}" "${output}" >&2
    exit 1
  fi
done
