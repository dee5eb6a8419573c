#!/usr/bin/env bash
# check_namesakes.sh: fails, naming them, when two headers have one name, or when two files define a type of one name in
# one namespace. Linked into one program, such types are undefined by the one-definition rule, and no compiler says so.
# Types in unnamed namespaces and in other types are free.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

# Headers of one name are mixed up by people and by editors' searches.
twice="$(find core ui app bindings -name '*.hpp' -printf '%f\n' | LC_ALL=C sort | uniq -d)"
if [ -n "${twice}" ]; then
  echo "headers with a namesake: ${twice//$'\n'/ }"
  exit 1
fi

find core ui app bindings samples tests/support tests/reference tests/bench -name '*.[ch]pp' -print0 | sort -z | xargs -0 awk '
  FNR == 1 { depth = 0 }
  /^(inline )?namespace .*\{$/ || /^namespace \{$/ {
    name = $0
    sub(/^(inline )?namespace */, "", name); sub(/ *\{$/, "", name)
    space[++depth] = name == "" ? "unnamed" : name
    next
  }
  /^\} *\/\/ *(inline )?namespace/ { if (depth > 0) --depth; next }
  /^(class|struct|union|enum class|enum) / && !/;[ \t]*(\/\/.*)?$/ {
    name = $0
    sub(/^(class|struct|union|enum class|enum) /, "", name); sub(/^(FOOTFALL_[A-Z]+|alignas\([^)]*\)) /, "", name)
    if (name ~ /^[A-Za-z0-9_]+::[A-Za-z]/) next
    sub(/[^A-Za-z0-9_].*/, "", name)
    path = ""
    for (i = 1; i <= depth; ++i) path = path space[i] "::"
    if (name == "" || path ~ /unnamed/) next
    ++seen
    place = FILENAME ":" FNR
    if (path name in first) { print path name ": " first[path name] " and " place; ++wrong } else first[path name] = place
  }
  END {
    if (seen == 0) { print "no types found"; exit 1 }
    if (wrong > 0) { print wrong " of " seen " types have a namesake"; exit 1 }
    print seen " types, each with a name of its own"
  }'
