#!/usr/bin/env bash
# install_dependencies.sh [--command-line | --fuzzing | --tidy | --wheel | --reference]: installs the Debian packages that
# Footfall is built with, tested with and runs on. With --command-line only those that the command line is built with;
# with another option also those that tests/fuzz/run.sh, tests/tidy.sh, installer/wheel.sh or docs/make_reference.sh
# need. Does nothing, quickly, when all are there. Needs root, or sudo, only when something is missing.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
# shellcheck source=installer/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

command_line=(
  # building
  ccache cmake g++ ninja-build
  # the core and the programs
  libassimp-dev zlib1g-dev libminizip-dev libcgal-dev libcli11-dev libdraco-dev libgmp-dev libhpdf-dev
  libmeshoptimizer-dev libmpfr-dev librecast-dev libtbb-dev
  nlohmann-json3-dev
)
packages=(
  "${command_line[@]}"
  # libQGLViewer from its source package
  ca-certificates dpkg-dev git make
  # the editor; fonts, because a bare system has none and Qt then draws empty boxes
  fonts-dejavu-core libegl-dev libgl-dev libgl1-mesa-dri libglu1-mesa-dev libopengl-dev libqcustomplot-dev
  libqt6opengl6-dev qmake6 qt6-base-dev qt6-base-dev-tools qt6-l10n-tools qt6-qpa-plugins qt6-svg-dev
  qt6-tools-dev qt6-tools-dev-tools qt6-translations-l10n
  # footfall-mpi
  libopenmpi-dev openmpi-bin
  # the Python package
  pybind11-dev python3-dev python3-numpy
  # the package: icons in all sizes, checks of its files, a clean root to install it in
  appstream debian-archive-keyring desktop-file-utils gzip librsvg2-bin man-db mmdebstrap shared-mime-info
  # testing
  clang-format librapidcheck-dev poppler-utils python3-shapely xauth xvfb
  # a peer that the benchmark compares with
  libembree-dev
)

case "$#:${1:-}" in
  0:) ;;
  1:--command-line) packages=("${command_line[@]}") ;;
  1:--fuzzing) packages+=(clang-14 libclang-rt-14-dev) ;;
  1:--tidy) packages+=(clang-tidy) ;;
  1:--wheel) packages+=(binutils patchelf python3-venv) ;;
  1:--reference) packages+=(doxygen python3-sphinx) ;;
  *) fail "unknown arguments $*; usage: install_dependencies.sh [--command-line | --fuzzing | --tidy | --wheel | --reference]" ;;
esac

command -v dpkg-query >/dev/null || fail "this is not a Debian system; install by hand: ${packages[*]}"
missing=()
for package in "${packages[@]}"; do
  # A virtual or missing package gives no line, a removed one another status.
  status="$(dpkg-query -W -f '${db:Status-Status}\n' "${package}" 2>/dev/null || true)"
  case $'\n'"${status}"$'\n' in
    *$'\ninstalled\n'*) ;;
    *) missing+=("${package}") ;;
  esac
done
if [ "${#missing[@]}" -eq 0 ]; then exit 0; fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || fail "not root and no sudo; run as root: apt-get install ${missing[*]}"
  as_root=(sudo)
fi
say "installing ${#missing[@]} packages: ${missing[*]}"
mkdir -p "${repository}/build/deps"
log="${repository}/build/deps/packages.log"
quietly "${log}" "${as_root[@]}" apt-get update
quietly "${log}" "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get -o DPkg::Lock::Timeout=300 install -y --no-install-recommends "${missing[@]}"
