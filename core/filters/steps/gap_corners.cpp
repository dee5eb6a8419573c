// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/steps/gap_corners.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "core/base/geometry.hpp"
#include "core/mesh/mesh_topology.hpp"

namespace footfall::detail {
namespace {

/// A search ends after so many triangles: then a link stays that may not be needed.
constexpr std::size_t kMostTriangles = 256;
constexpr std::size_t kPolled = 1024;

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

/// What hangs together about a place: the mesh with its steps, and its gaps without a corner.
class Neighbourhood {
 public:
  Neighbourhood(const std::vector<GapStretch>& gaps, const std::vector<StepStretch>& steps, const BorderSplits& splits,
                double reach, Poll poll)
      : splits_(splits), reach_(reach), borderAt_(3 * splits.mesh().triangles.size(), -1) {
    const auto count = static_cast<Index>(splits.borders().size());
    for (Index number = 0; number < count; ++number) borderAt_[splits.border(number).side] = number;
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
    ways_[gap.first].push_back({partOf(gap.first, gap.piece), gap.second});
    ways_[gap.second].push_back({partOf(gap.second, gap.piece), gap.first});
  }

  [[nodiscard]] bool joins(const GapStretch& gap) const {
    const Vec3& place = *gap.piece.corner;
    const Index target = triangleOf(gap.second);
    std::vector<Index> reached{triangleOf(gap.first)};
    const auto reach = [&](Index triangle) {
      if (std::find(reached.begin(), reached.end(), triangle) == reached.end()) reached.push_back(triangle);
    };
    for (std::size_t i = 0; i < std::min(reached.size(), kMostTriangles); ++i) {
      if (reached[i] == target) return true;
      for (int k = 0; k < 3; ++k) {
        const Index side = 3 * reached[i] + k;
        if (borderAt_[side] < 0) {
          if (const Index other = beyond(side, place); other >= 0) reach(other);
        } else if (const auto found = ways_.find(borderAt_[side]); found != ways_.end()) {
          for (const Way& way : found->second)
            if (way.part.isNear(place, reach_)) reach(triangleOf(way.other));
        }
      }
    }
    return false;
  }

 private:
  /// Over a part of a border to another one.
  struct Way {
    PlanSegment part;
    Index other = -1;
  };

  void add(Index first, Index second, const PlanSegment& part) {
    ways_[first].push_back({part, second});
    ways_[second].push_back({part, first});
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
  /// The triangle behind a side that is no border, if the side is near the place.
  [[nodiscard]] Index beyond(Index side, const Vec3& place) const {
    const WalkableMesh& mesh = splits_.mesh();
    const auto& corners = mesh.triangles[side / 3].corners;
    const Index a = corners[side % 3], b = corners[next(side % 3)];
    if (!between(mesh.vertices[a], mesh.vertices[b]).isNear(place, reach_)) return -1;
    const Index other = findSide(mesh.triangles, splits_.topology(), b, a);
    return other < 0 ? -1 : other / 3;
  }

  const BorderSplits& splits_;
  double reach_;
  std::vector<Index> borderAt_;  ///< of sides
  std::unordered_map<Index, std::vector<Way>> ways_;
};

}  // namespace

void removeNeedlessCorners(std::vector<GapStretch>& gaps, const std::vector<StepStretch>& steps,
                           const BorderSplits& splits, double gap, Poll poll) {
  const auto isAtCorner = [](const GapStretch& stretch) { return stretch.piece.corner.has_value(); };
  if (std::none_of(gaps.begin(), gaps.end(), isAtCorner)) return;
  const double reach = std::ldexp(2 * gap, splits.kernel()->mesh().grid.scaleExponent());
  Neighbourhood neighbourhood(gaps, steps, splits, reach, poll);
  std::vector<std::size_t> corners;  // the longest first
  for (std::size_t i = 0; i < gaps.size(); ++i)
    if (isAtCorner(gaps[i])) corners.push_back(i);
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
  gaps = std::move(kept);
}

}  // namespace footfall::detail
