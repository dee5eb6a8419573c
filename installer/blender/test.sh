#!/usr/bin/env bash
# test.sh [MODULES]: installs the add-on from its zip in a Blender without a window and tries it. MODULES is the folder
# with the Python module footfall, build/release/python by default. Exit status 77 where Blender is missing.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
folder="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)"
modules="${1:-${folder}/../../build/release/python}"
if ! command -v blender >/dev/null; then
  echo "skipped: Blender is not installed (Debian: apt-get install blender)"
  exit 77
fi
scratch="$(mktemp -d)"
trap 'rm -rf -- "${scratch}"' EXIT
"${folder}/make_zip.sh" "${scratch}/footfall_blender.zip"
# Settings of its own, so that those of the user are not touched.
BLENDER_USER_RESOURCES="${scratch}/user" PYTHONPATH="${modules}" PYTHONDONTWRITEBYTECODE=1 \
  blender --background --factory-startup --python-use-system-env --python-exit-code 1 \
  --python "${folder}/test_addon.py" -- "${scratch}/footfall_blender.zip"
