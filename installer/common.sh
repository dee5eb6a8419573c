# Helpers for the scripts in this folder; sourced, not run.
# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash

# The repository's root, whatever the current directory is.
repository="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
# Where libQGLViewer is built; cmake/FindQGLViewerQt6.cmake looks there.
# shellcheck disable=SC2034 # used by the scripts that source this
qglviewer_prefix="${repository}/build/deps/qglviewer"
# Where the TBB for ThreadSanitizer is built; the preset tsan looks there.
# shellcheck disable=SC2034 # used by the scripts that source this
tsan_tbb_prefix="${repository}/build/deps/tbb-tsan"

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

# Configures the preset named first; further arguments go to cmake.
configure() {
  local preset="$1"
  shift
  mkdir -p "${repository}/build"
  cd -- "${repository}" || fail "cannot enter ${repository}"
  say "configuring (${preset})"
  quietly "${repository}/build/configure-${preset}.log" cmake --preset "${preset}" -UFOOTFALL_COMMAND_LINE_ONLY "$@"
}

# Packages, the libraries that are built here, and a configured build of the preset named first; further arguments go to
# cmake.
prepare() {
  local preset="$1"
  shift
  "${repository}/installer/install_dependencies.sh"
  "${repository}/installer/build_qglviewer.sh"
  if [ "${preset}" = tsan ]; then "${repository}/installer/build_tsan_tbb.sh"; fi
  configure "${preset}" "$@"
}

# Fetches the source of the Debian package named first and unpacks it below the folder named second, which must be new
# and below one that apt's own user may enter; logs go to the folder named third. apt checks the signatures. The source
# lists are derived from the machine's own and live in that folder, so that the system's configuration stays as it is.
# Needs no root.
fetch_source() {
  local package="$1" folder="$2" logs="$3" list_file="" list_parts="" file copy
  for tool in apt-get apt-config dpkg-source; do
    command -v "${tool}" >/dev/null || fail "${tool} is missing; run installer/install_dependencies.sh first"
  done
  mkdir -p "${folder}/parts" "${folder}/lists/partial" "${folder}/cache/archives/partial" "${folder}/source" "${logs}"

  # Each of the machine's source lists again, with sources in place of binaries.
  eval "$(apt-config shell list_file Dir::Etc::sourcelist/f list_parts Dir::Etc::sourceparts/d)"
  for file in "${list_file}" "${list_parts%/}"/*.list "${list_parts%/}"/*.sources; do
    [ -r "${file}" ] || continue
    copy="${folder}/parts/$(basename -- "${file}")"
    case "${file}" in
      *.sources) sed -E 's/^Types:.*$/Types: deb-src/I' "${file}" >"${copy}" ;;
      *) sed -nE '/cdrom:/d; s/^[[:space:]]*deb(-src)?([[:space:]].*)$/deb-src\2/p' "${file}" | sort -u >"${copy}" ;;
    esac
  done
  local apt_options=(
    -o "Dir::Etc::sourcelist=/dev/null"
    -o "Dir::Etc::sourceparts=${folder}/parts"
    -o "Dir::State::lists=${folder}/lists"
    -o "Dir::Cache=${folder}/cache"
  )
  # Some lists may offer no sources; what counts is whether the package is found afterwards.
  apt-get "${apt_options[@]}" update >"${logs}/update.log" 2>&1 || true
  cd -- "${folder}/source" || fail "cannot enter ${folder}/source"
  quietly "${logs}/source.log" apt-get "${apt_options[@]}" source "${package}"
}
