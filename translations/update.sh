#!/usr/bin/env bash
# update.sh LUPDATE DESCRIPTOR_TEXTS [--check]: brings the texts of the sources into the .ts files beside this script.
# With --check nothing is changed; it fails, naming the texts, when one is missing or has no translation.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
lupdate="$1"
descriptor_texts="$2"
mode="${3:-}"
here="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)"
repository="$(dirname -- "${here}")"
work="$(mktemp -d)"
trap 'rm -rf "${work}"' EXIT

"${descriptor_texts}" >"${work}/descriptor_texts.cpp"
if [ "${mode}" != --check ]; then cp "${work}/descriptor_texts.cpp" "${here}/descriptor_texts.cpp"; fi
echo "${work}/descriptor_texts.cpp" >"${work}/sources"
# What the core says is marked without Qt (footfall/text.hpp): lupdate reads copies with a mark that it knows.
while read -r source; do
  if grep -qE 'FOOTFALL_TEXT\(("|$)' "${source}"; then
    copy="${work}/${source#"${repository}/"}"
    mkdir -p "$(dirname -- "${copy}")"
    sed 's/FOOTFALL_TEXT(/QT_TRANSLATE_NOOP("Core", /g' "${source}" >"${copy}"
    echo "${copy}" >>"${work}/sources"
  elif [[ "${source}" != "${repository}"/core/* ]]; then
    echo "${source}" >>"${work}/sources"
  fi
done < <(find "${repository}"/{core,ui,app} -name '*.cpp' -o -name '*.hpp' | LC_ALL=C sort)

failed=0
for translation in "${here}"/footfall_*.ts; do
  name="$(basename -- "${translation}")"
  options=(-silent -I "${repository}" -locations none -no-obsolete -source-language en)
  # English is what the sources say; only plurals need words.
  case "${name}" in footfall_en.ts) options+=(-pluralonly) ;; esac
  target="${translation}"
  if [ "${mode}" = --check ]; then
    cp "${translation}" "${work}/${name}"
    target="${work}/${name}"
  fi
  "${lupdate}" "${options[@]}" "@${work}/sources" -ts "${target}"
  if [ "${mode}" = --check ] && grep -q 'type="unfinished"' "${target}"; then
    echo "${name}: $(grep -c 'type="unfinished"' "${target}") texts have no translation; run the target" \
      "update_translations and translate them with Qt Linguist:" >&2
    grep -B3 'type="unfinished"' "${target}" | sed -n 's/.*<source>\(.*\)/  \1/p' | head -40 >&2
    failed=1
  fi
done
exit "${failed}"
