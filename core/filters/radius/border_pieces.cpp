// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/radius/border_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.hpp"
#include "core/base/vector.hpp"
#include "core/filters/height_levels.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kSidesPerTask = 16;
/// Rounding to a grid makes half of the upright walls lean away from the border, by at most so many steps of the grid.
constexpr double kStepsAtWall = 4;
constexpr double kDoubt = 4;  // margins of an EdgeFrame between what is wall for certain and what is ledge

// Ledges end a little before the places where something begins or ends. What is no longer than `point` is one, and
// points do not count, neither ledges nor what is between two of them. `more` goes to all ends.
std::vector<EdgePiece> widened(const std::vector<EdgePiece>& ledges, double more, double point) {
  std::vector<EdgePiece> result;
  for (EdgePiece piece : ledges) {
    if (piece.end - piece.begin <= point) continue;
    if (piece.begin <= std::max(more, point)) piece.begin = 0;
    if (piece.end >= 1 - std::max(more, point)) piece.end = 1;
    piece = {std::max(piece.begin - more, 0.0), std::min(piece.end + more, 1.0)};
    if (!result.empty() && piece.begin <= result.back().end + point)
      result.back().end = std::max(piece.end, result.back().end);
    else
      result.push_back(piece);
  }
  return result;
}

constexpr double kLevel = 0x1p-20;  // of slopes

/// The normal of a triangle that is not vertical, and the height of its plane over the ends of the border.
struct CoverHeights {
  Vec3 normal;
  double atBegin = 0, atEnd = 0;
};
CoverHeights heightsOver(const EdgeFrame& frame, const std::array<Vec3, 3>& corners) {
  const Vec3& p = corners[0];
  const Vec3 n = cross(corners[1] - p, corners[2] - p);
  const auto above = [&](const Vec3& place) {
    return p.z - (n.x * (place.x - p.x) + n.y * (place.y - p.y)) / n.z - place.z;
  };
  return {n, above(frame.at(0)), above(frame.at(1))};
}

/// The triangle is at most as high over the border as the step, or at least as high as the clearance, to within
/// rounding. This is true of floors and slopes that end where the area ends. Doubles do not decide it for very steep
/// triangles.
bool isBesideToRounding(BorderKinds& kinds, Index triangle) {
  if (kinds.kernel().mesh().facing[triangle] == 0) return false;
  const EdgeFrame& frame = kinds.frame();
  const auto [n, atBegin, atEnd] = heightsOver(frame, kinds.cornersOf(triangle));
  if (std::fabs(n.z) < kLevel * std::max(std::fabs(n.x), std::fabs(n.y))) return false;
  return std::max(atBegin, atEnd) <= kinds.heightOf(kinds.stepLevel()) + frame.margin() ||
         std::min(atBegin, atEnd) >= kinds.heightOf(kinds.heightLevel()) - frame.margin();
}

/// Pieces where a triangle begins to be a wall right at the border: it is as high over the border as the step and rises
/// outwards, or as the clearance and falls. All borders of a slanting ceiling are such pieces, to within rounding. A
/// triangle that ends at the border, to within rounding, does neither.
std::vector<EdgePiece> grazedWalls(BorderKinds& kinds) {
  const EdgeFrame& frame = kinds.frame();
  const double step = kinds.heightOf(kinds.stepLevel()), height = kinds.heightOf(kinds.heightLevel());
  std::vector<EdgePiece> walls;
  for (std::size_t i = 0; i < kinds.covers().size(); ++i) {
    const CoverAlong& cover = kinds.covers()[i];
    if (!cover.isOutside) continue;
    const std::array<Vec3, 3> corners = kinds.cornersOf(cover.triangle);
    if (std::all_of(corners.begin(), corners.end(),
                    [&](const Vec3& p) { return frame.outwards().at(frame.local(p)) <= 2 * frame.margin(); }))
      continue;
    const CoverHeights above = heightsOver(frame, corners);
    const double atBegin = above.atBegin, atEnd = above.atEnd;
    const Vec3 n = above.normal;
    const double rise = -(n.x * frame.outwards().x + n.y * frame.outwards().y) / n.z;
    const auto isAt = [&](double level) {
      return std::max(std::fabs(atBegin - level), std::fabs(atEnd - level)) <= frame.margin();
    };
    if (!(isAt(height) && rise < -kLevel) && !(isAt(step) && rise > kLevel)) continue;
    EdgePieces pieces;
    for (const SignAlong& sign : kinds.locate(i).inside) pieces.add(sign);
    const std::vector<EdgePiece> covered = pieces.where([&](const EdgePiece& piece) { return cover.covers(piece); });
    walls.insert(walls.end(), covered.begin(), covered.end());
  }
  return walls;
}

/// Returns whether a triangle leans by at most `reach`, to within rounding, between the step and the clearance: an
/// upright wall that rounding to a grid tilted. A reach of 0 stands for no grid.
bool isTilted(BorderKinds& kinds, Index triangle, double reach) {
  if (reach == 0) return false;
  const auto [n, atBegin, atEnd] = heightsOver(kinds.frame(), kinds.cornersOf(triangle));
  return std::hypot(n.x, n.y) * reach * (1 + 0x1p-40) >=
         std::fabs(n.z) * (kinds.heightOf(kinds.heightLevel()) - kinds.heightOf(kinds.stepLevel()));
}

/// Pieces of the border with a wall along it to within rounding, such as the walls on which a product was cut, or with
/// a tilted wall within `reach` (scaled) on its far side. The pieces are closed; a wall as high as the step or the
/// clearance, to within rounding, does not count.
std::vector<EdgePiece> nearWalls(BorderKinds& kinds, double reach) {
  const EdgeFrame& frame = kinds.frame();
  const double hair = 2 * frame.margin();
  const double lowest = kinds.heightOf(kinds.stepLevel()) + hair, highest = kinds.heightOf(kinds.heightLevel()) - hair;
  const LinearFunction none{}, &above = frame.above(), &outwards = frame.outwards();
  const auto within = [&](double distance) {
    return frame.widened({outwards, none - outwards + distance, above + -lowest, none - above + highest});
  };
  const std::vector<LinearFunction> beside = within(0), beyond = within(reach);
  const Vec3 a = frame.at(0), b = frame.at(1);
  std::vector<EdgePiece> walls;
  kinds.visitNear({{std::min(a.x, b.x) - reach, std::min(a.y, b.y) - reach, std::min(a.z, b.z) + lowest},
                   {std::max(a.x, b.x) + reach, std::max(a.y, b.y) + reach, std::max(a.z, b.z) + highest}},
                  [&](Index t) {
                    const bool reachesBeyond = isTilted(kinds, t, reach);
                    if (!reachesBeyond && isBesideToRounding(kinds, t)) return;
                    if (const auto piece = frame.shadow(kinds.cornersOf(t), reachesBeyond ? beyond : beside))
                      walls.push_back(*piece);
                  });
  return walls;
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
      reach_(std::ldexp(kStepsAtWall * state.environment->grid.step, state.kernel->mesh().grid.scaleExponent())),
      kinds_(*state.kernel, state.removed, state.step > 0 ? state.kernel->levelOf(state.step).value() : 0,
             state.kernel->levelOf(heightForKinds(state)).value()) {}

void BorderDivider::divide(Index side, std::vector<BorderPiece>& pieces) {
  const MeshVertex &a = mesh_.vertices[surface_.beginVertex(side)], &b = mesh_.vertices[surface_.endVertex(side)];
  const PlanVector begin = surface_.begin(side), end = surface_.end(side);
  if (begin.x == end.x && begin.y == end.y) {  // a point, for doubles, does not count: it is what is next to it
    pieces.push_back({side, begin, end, !isLedgeInDoubt_});
    return;
  }
  // The side of a bridge over a gap, on no face. No wall stands there except at its ends, where borders begin that have
  // a kind and a distance of their own.
  if (surface_.face(side) < 0) {
    pieces.push_back({side, begin, end, !isLedgeInDoubt_});
    return;
  }
  kinds_.turnTo({a, b, surface_.face(side)}, {begin.x, begin.y, a.z}, {end.x, end.y, b.z});
  const std::vector<EdgePiece> ledges =
      without(without(kinds_.ledges([&](const CoverAlong& c) { return isBesideToRounding(kinds_, c.triangle); }),
                      grazedWalls(kinds_)),
              nearWalls(kinds_, reach_));
  if (ledges.size() == 1 && ledges[0].begin == 0 && ledges[0].end == 1) {  // nothing is in doubt, however short it is
    pieces.push_back({side, begin, end, true});
    return;
  }
  const double error = kDoubt * kinds_.frame().margin(), doubt = error / kinds_.frame().length();
  double at = 0;
  const auto placeAt = [&](double t) { return t == 0 ? begin : t == 1 ? end : begin + t * (end - begin); };
  const auto add = [&](double to, bool isLedge) {
    if (!(at < to)) return;
    pieces.push_back({side, placeAt(at), placeAt(to), isLedge, at == 0 && to == 1 ? 0 : error});
    at = to;
  };
  for (const EdgePiece& ledge : widened(ledges, isLedgeInDoubt_ ? doubt : 0, 2 * doubt)) {
    add(ledge.begin, false);
    add(ledge.end, true);
  }
  add(1, false);
}

std::vector<BorderPiece> dividedBorders(const WalkableState& state, const MarginSurface& surface, bool isLedgeInDoubt,
                                        RunContext& context, ExactFallbacks& fallbacks) {
  const std::vector<BorderPiece> sides = wholeBorders(surface);
  std::vector<std::vector<BorderPiece>> found(sides.size());
  PerThread<BorderDivider> dividers([&] { return BorderDivider(state, surface, isLedgeInDoubt); });
  parallelRanges(sides.size(), kSidesPerTask, [&](const auto& range) {
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
