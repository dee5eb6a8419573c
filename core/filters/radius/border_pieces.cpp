// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/radius/border_pieces.hpp"

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <limits>

#include "core/filters/height_levels.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kSidesPerTask = 16;
constexpr double kDoubt = 4;  // margins of an EdgeFrame between what is wall for certain and what is ledge

// Ledges as they are for certain, or as they may be: neighbours that may touch are one.
std::vector<EdgePiece> widened(std::vector<EdgePiece> ledges, double doubt) {
  std::vector<EdgePiece> result;
  for (EdgePiece piece : ledges) {
    piece = {std::max(piece.begin - doubt, 0.0), std::min(piece.end + doubt, 1.0)};
    if (!result.empty() && piece.begin <= result.back().end)
      result.back().end = piece.end;
    else
      result.push_back(piece);
  }
  return result;
}

double heightForKinds(const WalkableState& state) {
  return state.clearance > 0 ? state.clearance
                             : sufficientHeight(state.kernel->mesh(), std::numeric_limits<double>::max());
}

}  // namespace

std::shared_ptr<const PlanKernel> kernelForKinds(const WalkableState& state) {
  std::shared_ptr<const PlanKernel> kernel = kernelWithHeight(state.kernel, heightForKinds(state));
  return state.step > 0 ? kernelWithHeight(kernel, state.step) : kernel;
}

std::vector<BorderPiece> wholeBorders(const MarginSurface& surface) {
  std::vector<BorderPiece> pieces;
  for (Index side = 0; side < surface.sideCount(); ++side)
    if (surface.isBorder(side)) pieces.push_back({side, surface.begin(side), surface.end(side)});
  return pieces;
}

BorderDivider::BorderDivider(const WalkableState& state, const MarginSurface& surface, bool isLedgeInDoubt)
    : mesh_(*state.mesh),
      surface_(surface),
      isLedgeInDoubt_(isLedgeInDoubt),
      kinds_(*state.kernel, state.removed, state.step > 0 ? state.kernel->levelOf(state.step).value() : 0,
             state.kernel->levelOf(heightForKinds(state)).value()) {}

void BorderDivider::divide(Index side, std::vector<BorderPiece>& pieces) {
  const MeshVertex &a = mesh_.vertices[surface_.beginVertex(side)], &b = mesh_.vertices[surface_.endVertex(side)];
  const PlanVector begin = surface_.begin(side), end = surface_.end(side);
  // A point, for doubles; or the side of a bridge over a gap, which lies on no face.
  if ((begin.x == end.x && begin.y == end.y) || surface_.face(side) < 0) {
    pieces.push_back({side, begin, end, isLedgeInDoubt_});
    return;
  }
  kinds_.turnTo({a, b, surface_.face(side)}, {begin.x, begin.y, a.z}, {end.x, end.y, b.z}, 0);
  const double error = kDoubt * kinds_.frame().margin(), doubt = error / kinds_.frame().length();
  double at = 0;
  const auto placeAt = [&](double t) { return t == 0 ? begin : t == 1 ? end : begin + t * (end - begin); };
  const auto add = [&](double to, bool isLedge) {
    if (!(at < to)) return;
    pieces.push_back({side, placeAt(at), placeAt(to), isLedge, at == 0 && to == 1 ? 0 : error});
    at = to;
  };
  for (const EdgePiece& ledge : widened(kinds_.ledges(), isLedgeInDoubt_ ? doubt : 0)) {
    add(ledge.begin, false);
    add(ledge.end, true);
  }
  add(1, false);
}

std::vector<BorderPiece> dividedBorders(const WalkableState& state, const MarginSurface& surface, bool isLedgeInDoubt,
                                        RunContext& context, ExactFallbacks& fallbacks) {
  const std::vector<BorderPiece> sides = wholeBorders(surface);
  std::vector<std::vector<BorderPiece>> found(sides.size());
  tbb::enumerable_thread_specific<BorderDivider> dividers(
      [&] { return BorderDivider(state, surface, isLedgeInDoubt); });
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, sides.size(), kSidesPerTask), [&](const auto& range) {
    BorderDivider& divider = dividers.local();
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      context.checkCancelled();
      divider.divide(sides[i].side, found[i]);
    }
  });
  for (BorderDivider& divider : dividers) fallbacks += divider.fallbacks();
  std::vector<BorderPiece> pieces;
  for (const auto& some : found) pieces.insert(pieces.end(), some.begin(), some.end());
  return pieces;
}

}  // namespace footfall::detail
