#!/usr/bin/env bash
# check_includes.sh [--counts]: fails, naming the lines, when a file of core/, ui/ or app/ includes one of a folder that
# comes after its own in the order of docs/explanation/architecture.md, when bindings include what is not public, or
# when anything but core/base uses the library for threads. With --counts: how often each folder includes which others,
# and the order, for docs/make_architecture.sh.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

# Each folder may use those before it, and itself. A public header belongs to the folder that implements it.
core="base exact mesh environment io assembly filters partitioning distributed pipeline tiles navigation inspect compare report"
base="text look work commands widgets messages files" # the folders of ui/base; they come after the files beside them
ui="base document view run level agents filters cells inspect path window"
public="text:base errors:base geometry:base statistics:base run_context:base navigation_mesh:mesh
  environment:environment edit:environment up_axis:environment io:io filter:filters filter_type:filters parameter:filters place_verdict:filters agent:pipeline agent_list:pipeline pipeline:pipeline run:pipeline
  walkable_area:pipeline path:navigation corridor_map:navigation body_path:navigation ground:navigation plan_areas:io inspect:inspect compare:compare report:report footfall:report version:base"

if grep -rnE '^ *#include *["<](core|ui|app)/' bindings; then
  echo "the bindings may use public headers only"
  exit 1
fi
# A loop of TBB's own ends early, without an exception, when a group around it is cancelled.
if grep -rnE 'include *[<"](oneapi/)?tbb/|\btbb::' core app bindings ui --include='*.[chm]pp' --include='*.[ch]' |
  grep -v '^core/base/'; then
  echo "parallel work starts through core/base/parallel.hpp and parallel_sort.hpp only"
  exit 1
fi

grep -rnE '^ *#include "(core|footfall|ui|app)/' core ui app | awk -v core="${core}" -v base="${base}" -v ui="${ui}" -v public="${public}" -v counts="${1:-}" '
  BEGIN {
    count = split(core, names, " ")
    for (i = 1; i <= count; ++i) rank["core/" names[i]] = ++ranks
    count = split(public, names, " ")
    for (i = 1; i <= count; ++i) { split(names[i], pair, ":"); home[pair[1] ".hpp"] = "core/" pair[2] }
    count = split(ui, names, " ")
    for (i = 1; i <= count; ++i) rank["ui/" names[i]] = ++ranks
    count = split(base, names, " ")
    for (i = 1; i <= count; ++i) within["ui/base/" names[i]] = i
    rank["app"] = ++ranks
  }
  function folderOf(path,    parts) {
    split(path, parts, "/")
    if (parts[1] == "app") return "app"
    if (parts[1] == "footfall") return home[parts[2]]
    if (path ~ /^core\/include\//) return home[parts[4]]
    return parts[1] "/" parts[2]
  }
  function placeIn(path,    parts) {
    split(path, parts, "/")
    return within[parts[1] "/" parts[2] "/" parts[3]] + 0
  }
  {
    colon = index($0, ":")
    file = substr($0, 1, colon - 1)
    match($0, /"[^"]*"/)
    target = substr($0, RSTART + 1, RLENGTH - 2)
    from = folderOf(file); to = folderOf(target)
    ++seen
    if (from != to) ++uses[from " " to]
    if (!(from in rank) || !(to in rank)) { print $0 ": a folder that the order does not have"; ++wrong }
    else if (rank[to] > rank[from]) { print $0 ": " from " comes before " to; ++wrong }
    else if (from == to && placeIn(target) > placeIn(file)) { print $0 ": against the order of the folders in " to; ++wrong }
    if (file ~ /^ui\/base\/.*\// && placeIn(file) == 0) { print $0 ": a folder that the order does not have"; ++wrong }
  }
  END {
    if (counts != "") {
      for (folder in rank) print "folder", rank[folder], folder
      for (use in uses) print "uses", use, uses[use]
    }
    if (seen == 0) { print "no includes found"; exit 1 }
    if (wrong > 0) { print wrong " of " seen " includes run against the order of the folders"; exit 1 }
    print seen " includes, all in the order of the folders"
  }'
