#!/usr/bin/env bash
# ifc.sh [FOLDER]: installs the converter that Footfall reads IFC files with (web-ifc, MPL-2.0, run by Node.js) for the
# current user, or in FOLDER (such as /usr/local/share/footfall/ifc for all users). Needs Node.js 18, npm and a network.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail

fail() {
  printf '%s: %s\n' "$(basename -- "$0")" "$*" >&2
  exit 1
}

source="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)/ifc"
case "$#" in
  0) target="${XDG_DATA_HOME:-${HOME:?is not set; name a folder}/.local/share}/footfall/ifc" ;;
  1) target="$1" ;;
  *) fail "too many arguments; usage: ifc.sh [FOLDER]" ;;
esac
for program in node npm; do
  command -v "${program}" >/dev/null || fail "${program} is missing; install it (Debian: apt-get install nodejs npm)"
done
major="$(node --version | sed 's/^v\([0-9]*\).*/\1/')"
[ "${major}" -ge 18 ] || fail "Node.js $(node --version) is too old; install version 18 or later"
mkdir -p -- "${target}" || fail "${target} cannot be made; name another folder"

# Made beside the target and renamed, so that a broken download leaves an earlier one as it was.
fresh="$(mktemp -d -- "${target}.XXXXXX")"
trap 'rm -rf -- "${fresh}"' EXIT
cp -- "${source}/package.json" "${source}/footfall-ifc.mjs" "${fresh}/"
npm install --prefix "${fresh}" --omit=dev --no-audit --no-fund --no-package-lock --ignore-scripts --loglevel=error >&2 ||
  fail "npm could not fetch web-ifc; see its message above"
chmod 755 "${fresh}"
rm -rf -- "${target}"
mv -- "${fresh}" "${target}"
printf 'installed in %s\n' "${target}"
