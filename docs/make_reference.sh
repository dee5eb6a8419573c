#!/usr/bin/env bash
# make_reference.sh [FOLDER]: writes the API reference of C++ and C as HTML below FOLDER (build/reference unless given).
# Fails on any warning of Doxygen (Debian: doxygen). Without Doxygen it says so and does nothing.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."
folder="${1:-build/reference}"
if ! command -v doxygen >/dev/null; then
  echo "skipped: doxygen is not installed"
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
