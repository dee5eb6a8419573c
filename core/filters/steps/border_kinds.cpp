// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/steps/border_kinds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace footfall::detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The places of an edge at which a triangle is a wall: `begin` is one, `end` is none.
struct WallSpan {
  double begin = -kInfinity, end = kInfinity;

  /// Keeps the places at which a located sign is `wanted`, or zero. Returns false where there are none.
  bool keep(const SignAlong& sign, int wanted, bool isZeroToo) {
    if (!sign.changes()) {
      const int all = sign.on({});
      return all * wanted > 0 || (isZeroToo && all == 0);
    }
    if (sign.begin * wanted > 0)
      end = std::min(end, sign.low);
    else
      begin = std::max(begin, sign.low);
    return true;
  }
};

}  // namespace

bool CoverAlong::covers(const EdgePiece& piece) const {
  return std::all_of(inside.begin(), inside.end(), [&](const SignAlong& s) { return s.on(piece) >= 0; });
}

BorderKinds::BorderKinds(const PlanKernel& kernel, const std::vector<char>& removed, Index step, Index height)
    : kernel_(kernel), removed_(removed), step_(step), height_(height), signs_(kernel), frame_({}, {1, 0, 0}, 1) {
  for (const Vec3& p : kernel.mesh().scaled)
    largest_ = std::max({largest_, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
}

double BorderKinds::heightOf(Index level) const {
  return level == 0 ? 0 : std::ldexp(kernel_.heights()[level - 1], kernel_.mesh().grid.scaleExponent());
}

std::array<Vec3, 3> BorderKinds::cornersOf(Index triangle) const {
  const SourceMesh& mesh = kernel_.mesh();
  const auto& f = mesh.triangles[triangle];
  return {mesh.scaled[f[0]], mesh.scaled[f[1]], mesh.scaled[f[2]]};
}

EdgeExtent BorderKinds::extentOf(const std::array<Vec3, 3>& corners) const {
  const auto along = [&](std::size_t k) { return frame_.along().at(frame_.local(corners[k])); };
  const auto [first, last] = std::minmax({along(0), along(1), along(2)});
  const auto [lowest, highest] = std::minmax({corners[0].z, corners[1].z, corners[2].z});
  return {first, last, lowest, highest};
}

bool BorderKinds::mayBeOver(const EdgeExtent& triangle, const EdgeExtent& other) const {
  const double margin = 2 * frame_.margin(), alongMargin = margin / frame_.length();
  return triangle.last >= other.first - alongMargin && triangle.first <= other.last + alongMargin &&
         triangle.highest >= other.lowest - margin;
}

void BorderKinds::widen(Box& box) const {
  const int unscale = -kernel_.mesh().grid.scaleExponent();
  for (int k = 0; k < 3; ++k) {
    box.lower[k] = std::ldexp(box.lower[k] - frame_.margin(), unscale);
    box.upper[k] = std::ldexp(box.upper[k] + frame_.margin(), unscale);
  }
}

void BorderKinds::turnTo(const BorderEdge& edge, const Vec3& begin, const Vec3& end) {
  edge_ = edge;
  frame_ = EdgeFrame(begin, end, largest_);
  covers_.clear();
  walls_.clear();
  near_ = {{std::min(begin.x, end.x), std::min(begin.y, end.y), std::min(begin.z, end.z)},
           {std::max(begin.x, end.x), std::max(begin.y, end.y), std::max(begin.z, end.z) + heightOf(height_)}};
  visitNear(near_, [&](Index t) {
    if (kernel_.mesh().facing[t] == 0)
      addWall(t);
    else
      addCover(t);
  });
  sortCovers();
}

void BorderKinds::sortCovers() {
  std::sort(covers_.begin(), covers_.end(),
            [](const CoverAlong& a, const CoverAlong& b) { return a.triangle < b.triangle; });
}

void BorderKinds::lookBelow(double below) {
  Box box = near_;
  box.lower[2] -= below;
  const std::size_t known = covers_.size();
  visitNear(box, [&](Index t) {
    if (kernel_.mesh().facing[t] == 0) return;
    const auto last = covers_.begin() + static_cast<std::ptrdiff_t>(known);
    const auto found = std::lower_bound(covers_.begin(), last, t,
                                        [](const CoverAlong& c, Index triangle) { return c.triangle < triangle; });
    if (found == last || found->triangle != t) addCover(t);
  });
  sortCovers();
}

const CoverAlong& BorderKinds::locate(std::size_t cover) {
  CoverAlong& c = covers_[cover];
  for (SignAlong& sign : c.inside) signs_.locate(edge_, sign);
  signs_.locate(edge_, c.overStep);
  signs_.locate(edge_, c.underHeight);
  return c;
}

void BorderKinds::addCover(Index triangle) {
  CoverAlong cover;
  cover.triangle = triangle;
  for (int k = 0; k < 3; ++k) {
    SignAlong& inside = cover.inside[k] = signs_.inside(edge_, triangle, k);
    if (inside.begin <= 0 && inside.end <= 0) {
      if (!inside.isZero()) return;
      cover.isOutside = signs_.orientation(edge_, kernel_.mesh().triangles[triangle][previous(k)]) < 0;
    }
  }
  cover.extent = extentOf(cornersOf(triangle));
  cover.overStep = signs_.height(edge_, triangle, edge_.face, step_);
  cover.underHeight = signs_.height(edge_, triangle, edge_.face, height_);
  covers_.push_back(cover);
}

// A wall that does not run along the edge meets it in one point.
void BorderKinds::addWall(Index triangle) {
  const auto& f = kernel_.mesh().triangles[triangle];
  bool reachesUp = false, reachesDown = false;
  for (const Index v : f) {
    if (signs_.orientation(edge_, v) != 0) return;
    reachesUp = reachesUp || kernel_.heightSign(edge_.face, v, step_, signs_.fallbacks) > 0;
    reachesDown = reachesDown || kernel_.heightSign(edge_.face, v, height_, signs_.fallbacks) < 0;
  }
  if (!reachesUp || !reachesDown) return;
  const LinearFunction& above = frame_.above();
  if (const auto piece =
          frame_.shadow(cornersOf(triangle),
                        frame_.widened({above + -heightOf(step_), LinearFunction{} - above + heightOf(height_)})))
    walls_.push_back(*piece);
}

// Pieces come in order, so that the covers that begin before the middle of one are the first of a sorted list.
std::vector<EdgePiece> BorderKinds::ledgesWithout(const std::vector<std::size_t>& covers) {
  EdgePieces pieces;
  std::vector<WallSpan> spans;
  for (const std::size_t i : covers) {
    const CoverAlong& c = locate(i);
    for (const SignAlong& sign : c.inside) pieces.add(sign);
    pieces.add(c.overStep);
    pieces.add(c.underHeight);
    WallSpan span;
    const bool isWall =
        span.keep(c.overStep, 1, false) && span.keep(c.underHeight, -1, false) &&
        std::all_of(c.inside.begin(), c.inside.end(), [&](const SignAlong& s) { return span.keep(s, 1, true); });
    if (isWall) spans.push_back(span);
  }
  std::sort(spans.begin(), spans.end(), [](const WallSpan& a, const WallSpan& b) { return a.begin < b.begin; });
  std::size_t begun = 0;
  double reached = -kInfinity;
  return without(pieces.where([&](const EdgePiece& piece) {
    for (; begun < spans.size() && spans[begun].begin <= piece.middle(); ++begun)
      reached = std::max(reached, spans[begun].end);
    return reached <= piece.middle();
  }),
                 walls_);
}

bool BorderKinds::isKnownBeside(Index triangle, Index level, int sign) {
  const SourceMesh& mesh = kernel_.mesh();
  const auto& floor = mesh.triangles[edge_.face];
  const double z = mesh.vertices[floor[0]].z;
  if (mesh.vertices[floor[1]].z != z || mesh.vertices[floor[2]].z != z) return false;
  const auto& f = mesh.triangles[triangle];
  return std::none_of(f.begin(), f.end(),
                      [&](Index v) { return sign * kernel_.heightSign(edge_.face, v, level, signs_.fallbacks) > 0; });
}

}  // namespace footfall::detail
