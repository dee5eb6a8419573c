#!/usr/bin/env bash
# Builds libQGLViewer for Qt6 from Debian's source package into build/deps/qglviewer; Debian 12 ships a Qt5 build only.
# Skipped when that was done before, and where a Qt6 package of the library is installed. Needs no root.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
# shellcheck source=installer/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

if [ -f "${qglviewer_prefix}/lib/libQGLViewer-qt6.a" ]; then exit 0; fi
if ls /usr/lib/*/libQGLViewer-qt6.so >/dev/null 2>&1; then exit 0; fi

for tool in qmake6 make g++; do
  command -v "${tool}" >/dev/null || fail "${tool} is missing; run installer/install_dependencies.sh first"
done

scratch="$(mktemp -d)"
trap 'rm -rf -- "${scratch}"' EXIT
chmod 755 "${scratch}" # apt downloads as its own user, who must be able to look inside
logs="${qglviewer_prefix}/logs"

say "libQGLViewer: fetching the source package"
fetch_source libqglviewer "${scratch}" "${logs}"
shopt -s nullglob
sources=("${scratch}"/source/libqglviewer-*/QGLViewer)
[ "${#sources[@]}" -eq 1 ] || fail "the source package of libqglviewer does not hold one folder QGLViewer"
cd "${sources[0]}"

say "libQGLViewer: building for Qt6"
# Static, so that the editor can be installed anywhere without it.
quietly "${logs}/qmake.log" qmake6 QGLViewer.pro QGLVIEWER_STATIC=yes CONFIG+=release CONFIG+=silent \
  QMAKE_CXXFLAGS+="-fPIC -w"
quietly "${logs}/make.log" make -j "$(build_jobs)"
libraries=(libQGLViewer*.a)
[ "${#libraries[@]}" -eq 1 ] || fail "the build made no static library; see ${logs}/make.log"

mkdir -p "${qglviewer_prefix}/include/QGLViewer" "${qglviewer_prefix}/lib"
cp -- *.h "${qglviewer_prefix}/include/QGLViewer/"
# The library last and in one move: its presence says that all is done.
cp -- "${libraries[0]}" "${qglviewer_prefix}/lib/libQGLViewer-qt6.a.part"
mv -- "${qglviewer_prefix}/lib/libQGLViewer-qt6.a.part" "${qglviewer_prefix}/lib/libQGLViewer-qt6.a"
say "libQGLViewer: done, in ${qglviewer_prefix}"
