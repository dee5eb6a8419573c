#!/usr/bin/env bash
# make_zip.sh OUT.zip: packs the add-on for Blender; install it by Edit > Preferences > Add-ons > Install.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
[ "$#" -eq 1 ] || { printf 'usage: make_zip.sh OUT.zip\n' >&2; exit 2; }
folder="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)"
# Python packs it, which is there wherever the add-on can be used; no times, so that the same add-on gives the same bytes.
python3 - "${folder}" "$1" <<'END'
import pathlib
import sys
import zipfile

folder, target = pathlib.Path(sys.argv[1]), sys.argv[2]
with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
    for path in sorted((folder / "footfall_blender").glob("*.py")):
        archive.writestr(zipfile.ZipInfo(str(path.relative_to(folder))), path.read_bytes())
END
