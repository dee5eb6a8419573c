// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/steps/gap_corners.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/base/geometry.hpp"
#include "core/mesh/mesh_topology.hpp"

namespace footfall::detail {
namespace {

/// A search ends after so many triangles on either side: then a link stays that may not be needed.
constexpr std::size_t kMostTriangles = 256;
constexpr std::size_t kPolled = 1024;
constexpr Index kEdgesPolled = 1 << 16;

struct PlanSegment {
  double fromX = 0, fromY = 0, toX = 0, toY = 0;
  [[nodiscard]] bool isNear(const Vec3& place, double reach) const {
    const double x = toX - fromX, y = toY - fromY, square = x * x + y * y;
    const double px = place.x - fromX, py = place.y - fromY;
    const double t = square > 0 ? std::clamp((px * x + py * y) / square, 0.0, 1.0) : 0;
    const double dx = px - t * x, dy = py - t * y;
    return dx * dx + dy * dy <= reach * reach;
  }
};
PlanSegment between(const MeshVertex& a, const MeshVertex& b) { return {a.x, a.y, b.x, b.y}; }

/// What hangs together about a place: the mesh with its steps, and its gaps that are needed anyway.
class Neighbourhood {
 public:
  Neighbourhood(const std::vector<GapStretch>& gaps, const std::vector<StepStretch>& steps, const BorderSplits& splits,
                double reach, Poll poll)
      : splits_(splits),
        reach_(reach),
        borderAt_(3 * splits.mesh().triangles.size(), -1),
        beyond_(borderAt_.size(), -1),
        stamps_(splits.mesh().triangles.size(), 0),
        firstWay_(splits.borders().size(), -1) {
    const auto count = static_cast<Index>(splits.borders().size());
    for (Index number = 0; number < count; ++number) borderAt_[splits.border(number).side] = number;
    findBeyond(poll);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      if (i % kPolled == 0) poll();
      add(steps[i].first, steps[i].second, between(steps[i].begin, steps[i].end));
    }
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      if (i % kPolled == 0) poll();
      if (!gaps[i].piece.corner) add(gaps[i]);
    }
  }

  void add(const GapStretch& gap) {
    addWay(gap.first, {partOf(gap.first, gap.piece), gap.second, -1});
    addWay(gap.second, {partOf(gap.second, gap.piece), gap.first, -1});
  }

  /// Searches from both sides take turns. Where one has seen all that hangs together with it, they are apart.
  [[nodiscard]] bool joins(const GapStretch& gap) {
    const Vec3& place = *gap.piece.corner;
    ++search_;
    bool isMet = false;
    const auto reach = [&](std::size_t from, Index triangle) {
      std::uint64_t& stamp = stamps_[triangle];
      if (stamp == 2 * search_ + from) return;
      if (stamp == 2 * search_ + 1 - from) isMet = true;
      stamp = 2 * search_ + from;
      reached_[from].push_back(triangle);
    };
    for (const std::size_t from : {0, 1}) {
      reached_[from].clear();
      reach(from, triangleOf(from == 0 ? gap.first : gap.second));
    }
    for (std::size_t i = 0; i < kMostTriangles; ++i)
      for (const std::size_t from : {0, 1}) {
        if (isMet) return true;
        if (i == reached_[from].size()) return false;
        visitNeighbours(reached_[from][i], place, [&](Index triangle) { reach(from, triangle); });
      }
    return isMet;
  }

 private:
  /// Over a part of a border to another one.
  struct Way {
    PlanSegment part;
    Index other = -1, next = -1;
  };

  // For sides that are no borders.
  void findBeyond(Poll poll) {
    const Adjacency& topology = splits_.topology();
    const TriangleCorners corners(splits_.mesh().triangles);
    for (Index e = 0; e < topology.edgeCount(); ++e) {
      if (e % kEdgesPolled == 0) poll();
      const auto sides = topology.sidesOf(e);
      for (const Index side : sides) {
        if (borderAt_[side] >= 0) continue;
        const auto other = std::find_if(sides.begin(), sides.end(),
                                        [&](Index s) { return corners.beginOf(s) == corners.endOf(side); });
        if (other != sides.end()) beyond_[side] = *other / 3;
      }
    }
  }
  void addWay(Index border, Way way) {
    way.next = std::exchange(firstWay_[border], static_cast<Index>(ways_.size()));
    ways_.push_back(way);
  }
  void add(Index first, Index second, const PlanSegment& part) {
    addWay(first, {part, second, -1});
    addWay(second, {part, first, -1});
  }
  /// Calls visit(triangle) for those on the other side of an edge, a step or a gap that is near a place.
  template <class Visit>
  void visitNeighbours(Index triangle, const Vec3& place, const Visit& visit) const {
    const WalkableMesh& mesh = splits_.mesh();
    const auto& corners = mesh.triangles[triangle].corners;
    for (int k = 0; k < 3; ++k) {
      const Index side = 3 * triangle + k, border = borderAt_[side];
      if (border >= 0) {
        for (Index w = firstWay_[border]; w >= 0; w = ways_[w].next)
          if (ways_[w].part.isNear(place, reach_)) visit(triangleOf(ways_[w].other));
      } else if (beyond_[side] >= 0) {
        const MeshVertex &a = mesh.vertices[corners[k]], &b = mesh.vertices[corners[next(k)]];
        if (between(a, b).isNear(place, reach_)) visit(beyond_[side]);
      }
    }
  }
  [[nodiscard]] Index triangleOf(Index border) const { return splits_.border(border).side / 3; }
  [[nodiscard]] PlanSegment partOf(Index number, const GapPiece& piece) const {
    const MeshBorder& border = splits_.border(number);
    const PlanSegment whole = between(splits_.vertex(border.from), splits_.vertex(border.to));
    const double from = piece.frame.along(whole.fromX, whole.fromY), to = piece.frame.along(whole.toX, whole.toY);
    const auto at = [&](double along) { return std::clamp((along - from) / (to - from), 0.0, 1.0); };
    const double x = whole.toX - whole.fromX, y = whole.toY - whole.fromY;
    const double low = at(piece.ends[0]), high = at(piece.ends[1]);
    return {whole.fromX + low * x, whole.fromY + low * y, whole.fromX + high * x, whole.fromY + high * y};
  }

  const BorderSplits& splits_;
  double reach_;
  std::vector<Index> borderAt_;        ///< of sides
  std::vector<Index> beyond_;          ///< of sides that are no borders: the triangle behind, or -1
  std::vector<std::uint64_t> stamps_;  ///< of triangles: the last search that reached them, and from which end
  std::uint64_t search_ = 0;
  std::array<std::vector<Index>, 2> reached_;
  std::vector<Index> firstWay_;  ///< of borders, in ways_
  std::vector<Way> ways_;
};

}  // namespace

std::size_t removeNeedlessGaps(std::vector<GapStretch>& gaps, const std::vector<StepStretch>& steps,
                               const BorderSplits& splits, double gap, Poll poll) {
  const auto isOptional = [](const GapStretch& stretch) { return stretch.piece.corner.has_value(); };
  if (std::none_of(gaps.begin(), gaps.end(), isOptional)) return 0;
  const double reach = std::ldexp(2 * gap, splits.kernel()->mesh().grid.scaleExponent());
  Neighbourhood neighbourhood(gaps, steps, splits, reach, poll);
  std::vector<std::size_t> corners;  // the longest first
  for (std::size_t i = 0; i < gaps.size(); ++i)
    if (isOptional(gaps[i])) corners.push_back(i);
  const auto lengthOf = [&](std::size_t i) { return gaps[i].piece.ends[1] - gaps[i].piece.ends[0]; };
  std::stable_sort(corners.begin(), corners.end(),
                   [&](std::size_t a, std::size_t b) { return lengthOf(a) > lengthOf(b); });
  std::vector<char> isNeedless(gaps.size(), 0);
  for (const std::size_t i : corners) {
    poll();
    isNeedless[i] = neighbourhood.joins(gaps[i]) ? 1 : 0;
    if (isNeedless[i] == 0) neighbourhood.add(gaps[i]);
  }
  std::vector<GapStretch> kept;
  for (std::size_t i = 0; i < gaps.size(); ++i)
    if (isNeedless[i] == 0) kept.push_back(std::move(gaps[i]));
  const std::size_t removed = gaps.size() - kept.size();
  gaps = std::move(kept);
  return removed;
}

}  // namespace footfall::detail
