#!/usr/bin/env bash
# report.sh [--only PART,...] [BUILD_FOLDER [OPTION...]]: measures everything again and writes the tables of
# docs/reference/measurements.md between their markers; with --only these parts: scenes, bench, layers, reach, paths, editor.
# Options go to footfall-bench (--runs 3 --seconds 2: quick and rough). Environments and scenes from outside come from the
# folder $FOOTFALL_SHARED (../shared unless set); its prototype/ is built when it is there. The editor is measured where it was
# built and a display is or xvfb-run can make one. Takes half an hour; a machine that does something else meanwhile
# spoils the figures, but for the scenes, whose ratios are of processor times in one run. When a measurement fails, the
# script fails and that part of the document stays as it was; the failures of Recast are findings and are written.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
repository="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)"
only=scenes,bench,layers,reach,paths,editor
if [ "${1:-}" = --only ]; then
  only="${2:?report.sh: --only takes parts: scenes, bench, layers, reach, paths, editor}"
  shift 2
  for part in ${only//,/ }; do
    case "${part}" in
      scenes | bench | layers | reach | paths | editor) ;;
      *)
        echo "report.sh: ${part} is no part of the report; give scenes, bench, layers, reach, paths or editor" >&2
        exit 2
        ;;
    esac
  done
fi
asked() { [[ ",${only}," == *",$1,"* ]]; }
build="$(realpath -- "${1:-${repository}/build/release}")"
if [ "$#" -gt 0 ]; then shift; fi
document="${repository}/docs/reference/measurements.md"
scratch="$(mktemp -d)"
trap 'rm -rf -- "${scratch}"' EXIT
# shellcheck source=tests/bench/tables.sh
source "${repository}/tests/bench/tables.sh"

if asked scenes; then
  arguments=()
  environments
  turned=()
  for environment in "${arguments[@]}"; do turned+=(--turned "${environment}"); done
  arguments=("$@" --scenes --samples "${turned[@]}" --json "${build}/scenes.json" --markdown "${scratch}/scenes.md")
  scenes
  "${build}/footfall-bench" "${arguments[@]}"
  replace scenes "${scratch}/scenes.md"
fi

if asked bench; then
  arguments=("$@" --samples --growth --live --exports "60000,1000000" --cancel 60 --json "${build}/bench.json" --markdown "${scratch}/bench.md")
  environments
  if [ -f "${shared}/prototype/main.cpp" ]; then
    echo "building the prototype" >&2
    g++ -O3 -march=native -ffp-contract=off -std=c++20 -w "${shared}/prototype/main.cpp" -ltbb -lgmp \
      -o "${scratch}/prototype"
    arguments+=(--prototype "${scratch}/prototype")
  fi
  "${build}/footfall-bench" "${arguments[@]}"
  replace bench "${scratch}/bench.md"
fi

if asked layers; then
  arguments=()
  environments
  scenes
  "${build}/footfall-layers-bench" "${arguments[@]}" >"${scratch}/layers.md"
  replace layers "${scratch}/layers.md"
fi

if asked reach; then
  arguments=(--reach --samples --timeout 60 --json "${build}/reach.json" --markdown "${scratch}/reach.md")
  environments
  "${build}/footfall-bench" "${arguments[@]}"
  replace reach "${scratch}/reach.md"
fi

if asked paths; then
  arguments=(--paths 1000 --samples "${repository}/samples/rooms/rooms.obj" --timeout 3000 --json "${build}/paths.json"
    --markdown "${scratch}/paths.md")
  environments
  "${build}/footfall-bench" "${arguments[@]}"
  replace paths "${scratch}/paths.md"
fi

if asked editor && [ -x "${build}/footfall-editor-bench" ]; then
  command=("${build}/footfall-editor-bench" --json "${build}/editor-bench.json" --markdown "${scratch}/editor.md")
  if [ -n "${DISPLAY:-}" ]; then
    "${command[@]}"
  else
    QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a -s "-screen 0 1280x1024x24" "${command[@]}"
  fi
  command=("${build}/footfall-editor-bench" --terrain 1000000 --no-tools --markdown "${scratch}/large.md")
  if [ -n "${DISPLAY:-}" ]; then
    "${command[@]}"
  else
    QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a -s "-screen 0 1280x1024x24" "${command[@]}"
  fi
  cat "${scratch}/large.md" >>"${scratch}/editor.md"
  replace editor "${scratch}/editor.md"
fi
