#!/usr/bin/env bash
# make_reference.sh [FOLDER [BUILD]]: writes the API reference of C++ and C (html) and that of Python (python) below FOLDER
# (build/reference unless given). Python's is that of the package in BUILD (build/release unless given), and is left out
# where there is none. Fails on any warning of Doxygen or Sphinx. Without Doxygen or Sphinx it says so and does nothing.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."
folder="${1:-build/reference}" package="${2:-build/release}/python"
python=/usr/bin/python3
[ -x "${python}" ] || python=python3
if ! command -v doxygen >/dev/null; then
  echo "skipped: doxygen is not installed (installer/install_dependencies.sh --reference)"
  exit 0
fi
if ! "${python}" -c 'import sphinx' 2>/dev/null; then
  echo "skipped: Sphinx is not installed (installer/install_dependencies.sh --reference)"
  exit 0
fi
mkdir -p -- "${folder}"
version="$(sed -n 's/^#define FOOTFALL_VERSION "\(.*\)"/\1/p' core/include/footfall/version.hpp)"
{
  cat docs/Doxyfile
  echo "PROJECT_NUMBER = ${version}"
  echo "OUTPUT_DIRECTORY = \"${folder}\""
} | doxygen -
echo "${folder}/html/index.html"

if ! compgen -G "${package}/footfall/_core.*" >/dev/null; then
  echo "no Python package in ${package}: its reference is left out"
  exit 0
fi
export PYTHONPATH="${package}" PYTHONDONTWRITEBYTECODE=1
rm -rf -- "${folder}/python"
"${python}" -m sphinx -q -W --keep-going -b html docs/python_reference "${folder}/python"
"${python}" - "${folder}/python/index.html" <<'CHECK'
import sys
import footfall
with open(sys.argv[1], encoding="utf-8") as file:
    page = file.read()
missing = [name for name in footfall.__all__ if f'id="footfall.{name}"' not in page]
missing += [f"the types of {kind}" for kind in ("ArrayLike", "NDArray", "Optional") if kind not in page]
sys.exit(f"the reference of Python lacks {', '.join(missing)}" if missing else 0)
CHECK
echo "${folder}/python/index.html"
