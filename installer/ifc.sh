#!/usr/bin/env bash
# ifc.sh [FOLDER]: installs the converter for buildings in IFC: installer/ifc/ifc_to_obj.mjs and the npm package web-ifc
# (MPL-2.0) beside it. FOLDER is by default footfall/ifc of the user's data, or /usr/local/share/footfall/ifc for root, where
# Footfall looks for it. Needs Node.js and npm; installs them with apt where they are missing, as root or through sudo.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
# shellcheck source=installer/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"
[ "$#" -le 1 ] || fail "unknown arguments $*; usage: ifc.sh [FOLDER]"

if [ "$#" -eq 1 ]; then
  folder="$1"
elif [ "$(id -u)" -eq 0 ]; then
  folder=/usr/local/share/footfall/ifc
else
  folder="${XDG_DATA_HOME:-${HOME}/.local/share}/footfall/ifc"
fi

if ! command -v node >/dev/null || ! command -v npm >/dev/null; then
  as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || fail "Node.js or npm is missing, and there is no sudo; run as root: apt-get install nodejs npm"
    as_root=(sudo)
  fi
  say "installing Node.js and npm"
  "${as_root[@]}" apt-get install -y --no-install-recommends nodejs npm
fi

say "installing the converter in ${folder}"
mkdir -p -- "${folder}"
cp -- "${repository}/installer/ifc/package.json" "${repository}/installer/ifc/ifc_to_obj.mjs" "${folder}/"
# Nothing of the package needs to run while it is installed.
(cd -- "${folder}" && npm install --no-audit --no-fund --ignore-scripts --silent)
node "${folder}/ifc_to_obj.mjs" 2>/dev/null && fail "the converter in ${folder} does not work" || code=$?
[ "${code}" -eq 2 ] || fail "the converter in ${folder} cannot be started; run it for the reason: node ${folder}/ifc_to_obj.mjs"
say "done; Footfall uses it for .ifc from now on"
