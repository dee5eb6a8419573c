# Helpers for the scripts in this folder; sourced, not run.
# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash

# The repository's root, whatever the current directory is.
repository="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
# Where libQGLViewer is built; cmake/FindQGLViewerQt6.cmake looks there.
# shellcheck disable=SC2034 # used by the scripts that source this
qglviewer_prefix="${repository}/build/deps/qglviewer"

# Prints one line to standard error and ends the script.
fail() {
  printf '%s: %s\n' "$(basename -- "$0")" "$*" >&2
  exit 1
}

# Says on standard output what happens next.
say() {
  printf '== %s\n' "$*"
}

# Jobs for a parallel build: one a core, but never more than one for each 1.5 GB of free memory, which is what the
# largest translation units need.
build_jobs() {
  local cores memory
  cores="$(nproc)"
  memory="$(awk '/^MemAvailable:/ { print int($2 / 1500000) }' /proc/meminfo)"
  if [ "${memory}" -lt 1 ]; then memory=1; fi
  if [ "${memory}" -lt "${cores}" ]; then echo "${memory}"; else echo "${cores}"; fi
}

# Runs a command with its output in the file named first; shows the end of that file when the command fails.
quietly() {
  local log="$1"
  shift
  if ! "$@" >"${log}" 2>&1; then
    tail -n 30 "${log}" >&2
    fail "'$*' failed; the whole output is in ${log}"
  fi
}

# Packages, libQGLViewer and a configured build of the preset named first; further arguments go to cmake.
prepare() {
  local preset="$1"
  shift
  "${repository}/installer/install_dependencies.sh"
  "${repository}/installer/build_qglviewer.sh"
  mkdir -p "${repository}/build"
  cd -- "${repository}" || fail "cannot enter ${repository}"
  say "configuring (${preset})"
  quietly "${repository}/build/configure-${preset}.log" cmake --preset "${preset}" "$@"
}
