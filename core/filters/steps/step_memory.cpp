// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/steps/step_memory.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/assembly/earlier_result.hpp"
#include "core/assembly/mesh_relation.hpp"
#include "core/exact/grid.hpp"
#include "core/filters/steps/step_linker.hpp"

namespace footfall::detail {

std::size_t bytesOf(const StepMemory& memory) {
  const StepFindings& found = memory.found;
  std::size_t bytes = memory.borders.capacity() * sizeof(MeshBorder) +
                      found.stretches.capacity() * sizeof(StepStretch) + found.gaps.capacity() * sizeof(GapStretch) +
                      found.undecided.capacity() * sizeof(std::array<Index, 2>);
  for (const GapStretch& gap : found.gaps)
    for (const std::vector<Index>& touching : gap.piece.touching) bytes += touching.capacity() * sizeof(Index);
  return bytes;
}

// The result between two borders depends on both, on the lines that cut their faces where none of their own is known,
// and on the obstacles near them. Numbers ascend, so that every choice by the smaller number is the same as before.
void StepLinker::reuse(const StepMemory& before, const EarlierResult& earlier) {
  if (!earlier.sameHeights() || before.given->triangles.empty()) return;
  // Gaps are kept as scaled doubles, whose precision depends on the slack.
  const PlanKernel &then = *earlier.state().kernel, &now = *splits_.kernel();
  if (then.mesh().grid.scaleExponent() != now.mesh().grid.scaleExponent() || then.sign().slack != now.sign().slack)
    return;
  const MeshRelation relation = relateMeshes(earlier, *before.given, splits_.mesh());
  std::vector<Index> borderAt(3 * before.given->triangles.size(), -1);
  for (std::size_t b = 0; b < before.borders.size(); ++b) borderAt[before.borders[b].side] = static_cast<Index>(b);
  const PowerOfTwo unscale(-now.mesh().grid.scaleExponent());
  const auto isTouched = [&](const MeshBorder& border) {
    const BoxTree<3>::Bounds own = boundsOf(border);
    Box box;
    for (int k = 0; k < 3; ++k) {
      box.lower[k] = unscale(own.lower[k]) - (k < 2 ? before.gap : before.step);
      box.upper[k] = unscale(own.upper[k]) + (k < 2 ? before.gap : before.step + before.height);
      // Far more than the errors of these sums, and than the distance that counts as touching for gaps.
      const double margin = std::max(std::fabs(box.lower[k]), std::fabs(box.upper[k])) * 0x1p-30;
      box.lower[k] -= margin;
      box.upper[k] += margin;
    }
    return earlier.isTouched(box);
  };
  enum class Lines : char { Unknown, Same, Other };
  std::vector<Lines> linesOfFaces(state_.walkable.size(), Lines::Unknown);
  const auto hasSameLines = [&](Index face) {
    Lines& known = linesOfFaces[face];
    if (known == Lines::Unknown)
      known = !state_.cuts || earlier.hasSameLines(face, *state_.cuts) ? Lines::Same : Lines::Other;
    return known == Lines::Same;
  };
  numberBefore_.assign(splits_.borders().size(), -1);
  Index last = -1;
  std::vector<Index> numberNow(before.borders.size(), -1);
  for (std::size_t i = 0; i < splits_.borders().size(); ++i) {
    context_.checkCancelled();
    const MeshBorder& border = splits_.borders()[i];
    const Index triangle = relation.triangleBefore[border.side / 3];
    const Index number = triangle < 0 ? -1 : borderAt[3 * triangle + border.side % 3];
    if (number < 0 || isTouched(border)) continue;
    if (!hasSameLines(border.face) && splits_.ownLinesOf(border, splits_.geometry()).empty()) continue;
    // The first of two borders must stay the first; a border that has overtaken another is tried again.
    if (number < last) continue;
    last = number;
    numberBefore_[i] = number;
    numberNow[number] = static_cast<Index>(i);
  }
  // A stretch may end at a place of the plan that is no longer there.
  for (const StepStretch& s : before.found.stretches) {
    if (earlier.hasPlaces(s.begin.point) && earlier.hasPlaces(s.end.point)) continue;
    for (const Index number : {s.first, s.second})
      if (const Index now = std::exchange(numberNow[number], -1); now >= 0) numberBefore_[now] = -1;
  }
  const auto isKept = [&](Index first, Index second) { return numberNow[first] >= 0 && numberNow[second] >= 0; };
  known_.stretches.reserve(before.found.stretches.size());
  known_.gaps.reserve(before.found.gaps.size());
  for (const StepStretch& s : before.found.stretches)
    if (isKept(s.first, s.second))
      known_.stretches.push_back(
          {numberNow[s.first], numberNow[s.second], earlier.vertexNow(s.begin), earlier.vertexNow(s.end)});
  for (const GapStretch& g : before.found.gaps) {
    if (!isKept(g.first, g.second)) continue;
    known_.gaps.push_back(g);
    GapStretch& gap = known_.gaps.back();
    gap.first = numberNow[g.first];
    gap.second = numberNow[g.second];
    for (std::vector<Index>& touching : gap.piece.touching)
      for (Index& t : touching) t = earlier.faceNow(t);
  }
  for (const auto& [first, second] : before.found.undecided)
    if (isKept(first, second)) known_.undecided.push_back({numberNow[first], numberNow[second]});
}

}  // namespace footfall::detail
