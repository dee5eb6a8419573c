#!/usr/bin/env bash
# run.sh [ENVIRONMENT]: installs what is missing, builds Footfall and opens the editor on ENVIRONMENT, or on a sample.
# A file of the same name with the ending .pipeline beside the environment is its pipeline. Without a display the
# command line is built first, with nothing but what it needs, and computes the walkable area instead; then the rest is
# installed and built.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
# shellcheck source=installer/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

[ "$#" -le 1 ] || fail "too many arguments; usage: run.sh [ENVIRONMENT]"
case "${1:-}" in
  -h | --help)
    sed -n '2,5s/^# //p' "${BASH_SOURCE[0]}"
    exit 0
    ;;
  -*) fail "unknown option ${1}; usage: run.sh [ENVIRONMENT]" ;;
esac

if [ "$#" -eq 1 ]; then
  [ -f "$1" ] || fail "${1}: no such file; name an environment (OBJ, glTF, PLY, ...)"
  environment="$(realpath -- "$1")"
else
  environment=""
  for candidate in "${repository}"/samples/villa/villa.obj "${repository}"/samples/villa.obj \
    "${repository}"/samples/*/*.obj "${repository}"/samples/*.obj; do
    if [ -f "${candidate}" ]; then
      environment="${candidate}"
      break
    fi
  done
  [ -n "${environment}" ] || fail "samples/ holds no environment; name one: run.sh ENVIRONMENT"
fi
arguments=("${environment}")
pipeline="${environment%.*}.pipeline"
if [ -f "${pipeline}" ]; then arguments+=(-p "${pipeline}"); fi

started_in="${PWD}"
if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
  prepare release
  say "building"
  cmake --build --preset release -j "$(build_jobs)" --target installable
  say "opening the editor on ${environment}"
  cd "${started_in}"
  exec "${repository}/build/release/footfall-editor" "${arguments[@]}"
fi
# Without Qt and libQGLViewer the first result is there sooner; later runs find all of it.
if [ -x "${repository}/build/release/footfall" ]; then
  prepare release
else
  "${repository}/installer/install_dependencies.sh" --command-line
  configure release -DFOOTFALL_COMMAND_LINE_ONLY=ON
fi
say "building the command line"
cmake --build --preset release -j "$(build_jobs)" --target footfall
name="$(basename -- "${environment}")"
result="${repository}/build/${name%.*}-walkable.obj"
say "no display: computing the walkable area of ${environment} on the command line"
"${repository}/build/release/footfall" run "${arguments[@]}" -o "${result}"
say "the result is in ${result}"
prepare release
say "building what else can be installed, the editor among it"
cmake --build --preset release -j "$(build_jobs)" --target installable
