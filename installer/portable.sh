#!/usr/bin/env bash
# portable.sh [PRESET]: makes build/footfall-VERSION-ARCHITECTURE.tar.gz from a finished build: a folder that runs where
# it is unpacked, on Debian 12 and later and on what is as new, without Qt installed there. Its launchers are `footfall`
# and `footfall-editor`. The C and C++ libraries, X11 and OpenGL stay those of the machine, which has to match its kernel
# and its graphics driver.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
# shellcheck source=installer/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"
preset="${1:-release}"
build="${repository}/build/${preset}"
[ -x "${build}/footfall-editor" ] || fail "${build} holds no footfall-editor; build it first, or run installer/package.sh"

version="$("${build}/footfall" --version | awk '{ print $NF }')"
name="footfall-${version}-$(uname -m)"
folder="${repository}/build/${name}"
rm -rf -- "${folder}" "${folder}.tar.gz"
say "portable folder: ${folder}"
quietly "${build}/portable.log" cmake --install "${build}" --prefix "${folder}" --component programs --strip

# Libraries that belong to the machine: loader and C library, compiler's runtime, display, OpenGL and what Mesa's drivers
# load too, fonts' settings.
machine='^(ld-linux.*|lib(c|m|dl|rt|pthread|resolv|util|nsl|anl|mvec|BrokenLocale|gcc_s|stdc\+\+)|lib(GL|EGL|GLX|OpenGL|GLdispatch|GLESv2|drm|gbm|vulkan)|lib(X11|X11-xcb|xcb|xcb-(glx|randr|shm|sync|xfixes)|Xau|Xdmcp|wayland-[a-z]+)|lib(fontconfig|freetype|expat|uuid|z|zstd))\.so(\..*)?$'

plugins="$(qmake6 -query QT_INSTALL_PLUGINS)"
mkdir -p "${folder}/lib" "${folder}/plugins/platforms" "${folder}/plugins/xcbglintegrations" "${folder}/plugins/imageformats"
cp -- "${plugins}/platforms/libqxcb.so" "${plugins}/platforms/libqoffscreen.so" "${folder}/plugins/platforms/"
cp -- "${plugins}"/xcbglintegrations/*.so "${folder}/plugins/xcbglintegrations/"
cp -- "${plugins}/imageformats/libqsvg.so" "${plugins}/imageformats/libqjpeg.so" "${folder}/plugins/imageformats/"
for kind in platformthemes/libqxdgdesktopportal.so iconengines/libqsvgicon.so; do
  if [ -f "${plugins}/${kind}" ]; then
    mkdir -p "${folder}/plugins/$(dirname -- "${kind}")"
    cp -- "${plugins}/${kind}" "${folder}/plugins/${kind}"
  fi
done

# ldd names all that is loaded, so one pass over programs and plug-ins finds everything.
needed="$(find "${folder}/bin" "${folder}/libexec" "${folder}/plugins" -type f -exec ldd {} + | awk '/=>/ { print $1, $3 }' | sort -u)"
if grep -q ' not$' <<<"${needed}"; then fail "libraries are missing here: $(awk '$2 == "not" { print $1 }' <<<"${needed}")"; fi
while read -r library path; do
  if [[ "${library}" =~ ${machine} ]]; then continue; fi
  cp -L -- "${path}" "${folder}/lib/${library}"
done <<<"${needed}"

for program in footfall footfall-editor; do
  cat >"${folder}/${program}" <<'LAUNCHER'
#!/bin/sh
# Starts the program of this folder with the libraries of this folder.
here="$(dirname -- "$(readlink -f -- "$0")")"
LD_LIBRARY_PATH="${here}/lib${LD_LIBRARY_PATH:+:${LD_LIBRARY_PATH}}"
QT_PLUGIN_PATH="${here}/plugins"
export LD_LIBRARY_PATH QT_PLUGIN_PATH
LAUNCHER
  # shellcheck disable=SC2016 # the launcher expands it
  printf 'exec "${here}/bin/%s" "$@"\n' "${program}" >>"${folder}/${program}"
  chmod 755 "${folder}/${program}"
done
# The notices of what is in lib/ and plugins/, as Debian ships them.
mkdir -p "${folder}/share/doc/footfall/libraries"
mapfile -t names < <(find "${folder}/lib" "${folder}/plugins" -name '*.so*' -type f -printf '*/%f\n')
mapfile -t owners < <(dpkg-query -S "${names[@]}" 2>/dev/null | cut -d: -f1 | sort -u || true)
for owner in "${owners[@]}"; do
  notice="/usr/share/doc/${owner}/copyright"
  if [ -f "${notice}" ]; then cp -L -- "${notice}" "${folder}/share/doc/footfall/libraries/${owner}"; fi
done

tar -C "${repository}/build" --sort=name --owner=0 --group=0 --numeric-owner -czf "${folder}.tar.gz" "${name}"
say "portable archive: ${folder}.tar.gz ($(du -h "${folder}.tar.gz" | cut -f1))"
