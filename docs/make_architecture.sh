#!/usr/bin/env bash
# make_architecture.sh: draws docs/images/architecture.svg, the folders in their order and who includes whom, from the
# sources as they are.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."
{ tests/check_includes.sh --counts || true; } | grep -E '^(folder|uses) ' | LC_ALL=C sort -k1,1 -k2,2n -k3,3 | awk '
  function colour(name) { return name ~ /^core/ ? "#2f6fa8" : name ~ /^ui/ ? "#a8642f" : "#4f7f4a" }
  $1 == "folder" { name[$2] = $3; rank[$3] = $2; if ($2 > last) last = $2 }
  $1 == "uses" { from[++pairs] = $2; to[pairs] = $3; count[pairs] = $4 }
  END {
    step = 26; top = 30; left = 430; width = 150; height = last * step + 2 * top
    printf "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"880\" height=\"%d\" font-family=\"sans-serif\" font-size=\"13\">\n", height
    printf "<rect width=\"880\" height=\"%d\" fill=\"white\"/>\n", height
    for (p = 1; p <= pairs; ++p) {
      a = rank[from[p]]; b = rank[to[p]]
      y1 = top + (a - 0.5) * step; y2 = top + (b - 0.5) * step; r = (y1 - y2) / 2
      if (r < 0) r = -r
      # Arrows upwards, the allowed ones, are on the left; any that run downwards would be red and on the right.
      back = b > a; x = back ? left + width : left
      printf "<path d=\"M%d %.1f A%.1f %.1f 0 0 %d %d %.1f\" fill=\"none\" stroke=\"%s\" stroke-opacity=\"%.2f\" stroke-width=\"%.1f\"><title>%s includes %s: %d</title></path>\n",
        x, y1, r * 0.9 + 1, r + 1, 1, x, y2, back ? "#d00000" : colour(from[p]), back ? 1 : 0.35, 0.6 + log(1 + count[p]) * 0.7, from[p], to[p], count[p]
    }
    for (i = 1; i <= last; ++i) {
      y = top + (i - 1) * step
      printf "<rect x=\"%d\" y=\"%.1f\" width=\"%d\" height=\"%d\" rx=\"4\" fill=\"%s\"/>\n", left, y + 2, width, step - 4, colour(name[i])
      printf "<text x=\"%d\" y=\"%.1f\" fill=\"white\" text-anchor=\"middle\">%s</text>\n", left + width / 2, y + step / 2 + 5, name[i]
    }
    printf "<text x=\"%d\" y=\"%d\" fill=\"#444\">Each folder includes only folders above it.</text>\n", left + width + 24, top + 18
    printf "<text x=\"%d\" y=\"%d\" fill=\"#444\">The wider an arc, the more often.</text>\n", left + width + 24, top + 38
    print "</svg>"
  }' >docs/images/architecture.svg
