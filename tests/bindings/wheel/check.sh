#!/usr/bin/env bash
# check.sh PYTHON BUILD_FOLDER: makes a wheel of the build, installs it with pip into an environment of its own, and runs a
# level there as a user would.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
python="$1" build="$2"
here="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)"
repository="$(cd -- "${here}/../../.." && pwd)"
for tool in patchelf strip ldd; do
  command -v "${tool}" >/dev/null || { echo "skipped: ${tool} is not installed (installer/install_dependencies.sh --wheel)"; exit 0; }
done
"${python}" -c 'import ensurepip, venv' 2>/dev/null || { echo "skipped: python3-venv is not installed"; exit 0; }
scratch="$(mktemp -d)"
trap 'rm -rf -- "${scratch}"' EXIT
unset PYTHONPATH LD_LIBRARY_PATH FOOTFALL_IMPORT

wheel="$("${python}" -B "${repository}/installer/wheel/make_wheel.py" "${build}" "${scratch}/wheel")"
again="$("${python}" -B "${repository}/installer/wheel/make_wheel.py" "${build}" "${scratch}/again")"
cmp "${wheel}" "${again}" || { echo "two wheels of one build differ" >&2; exit 1; }

# numpy comes from the system; nothing is fetched.
"${python}" -m venv --system-site-packages "${scratch}/venv"
"${scratch}/venv/bin/pip" install --quiet --disable-pip-version-check --no-index "${wheel}"
cd -- "${scratch}"
"${scratch}/venv/bin/python" "${here}/use_wheel.py" "${build}/footfall" "${repository}/samples/house/house.obj"
"${scratch}/venv/bin/pip" uninstall --quiet --yes footfall
left="$(find "${scratch}/venv" -iname '*footfall*')"
[ -z "${left}" ] || { echo "left behind: ${left}" >&2; exit 1; }
echo "$(basename -- "${wheel}"), $(du -h "${wheel}" | cut -f1)"
