#!/usr/bin/env bash
# check_command_line.sh FOOTFALL PAGE: fails when an option that `footfall COMMAND --help` lists is missing in the section
# of that command in PAGE (docs/reference/command_line.md), or when the page has an option or command that is not there.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
program="$1" page="$2"
failed=0
complain() {
  echo "$1" >&2
  failed=1
}
# The synopsis of one command: the indented lines of its section. "..." stands for options that are written elsewhere.
synopsis() { awk -v title="## footfall $1" '/^## / { inside = $0 == title } inside && /^    /' "${page}"; }
options() { grep -oE -- '(^|[^a-zA-Z0-9-])--[a-z][a-z-]*' | grep -oE -- '--[a-z-]+' | sort -u; }

commands="$("${program}" --help | awk '/^Subcommands:|^SUBCOMMANDS:/ { inside = 1; next } inside && /^  [a-z]/ { print $1 }')"
[ -n "${commands}" ] || { echo "${program} --help lists no commands" >&2; exit 1; }
for command in ${commands}; do
  text="$(synopsis "${command}")"
  if [ -z "${text}" ]; then
    complain "${page}: no section \"## footfall ${command}\" with its synopsis"
    continue
  fi
  # Options stand at the beginnings of lines of the help; the texts behind them may name others.
  listed="$("${program}" "${command}" --help | sed -nE 's/^  (-[^ ]*).*/\1/p' | options | grep -vxE -- '--(help|pipeline|output)')"
  written="$(options <<<"${text}")"
  for option in $(comm -23 <(echo "${listed}") <(echo "${written}")); do
    complain "${page}: footfall ${command} has ${option}, which its synopsis lacks"
  done
  for option in $(comm -13 <(echo "${listed}") <(echo "${written}")); do
    complain "${page}: footfall ${command} has no ${option}"
  done
done
for section in $(sed -nE 's/^## footfall ([a-z]+)$/\1/p' "${page}"); do
  grep -qx -- "${section}" <<<"${commands}" || complain "${page}: there is no command footfall ${section}"
done
exit "${failed}"
