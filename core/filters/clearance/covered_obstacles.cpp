// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/clearance/covered_obstacles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <memory>
#include <numeric>

#include "core/exact/face_geometry.hpp"

namespace footfall::detail {
namespace {

/// Quarters the box of the face until a cell is covered by one obstacle, or too few obstacles are left for more, or it
/// has taken so long that the obstacles themselves are no more work.
class CoverSearch {
 public:
  CoverSearch(const PlanKernel& kernel, Index face, std::span<const ClearanceCandidate> candidates, Poll poll)
      : mesh_(kernel.mesh()),
        slack_(kernel.sign().slack),
        face_(face),
        candidates_(candidates),
        poll_(poll),
        needed_(candidates.size(), 0) {
    const auto& f = mesh_.triangles[face];
    for (const auto axis : {&Vec3::x, &Vec3::y}) {
      const auto [low, high] =
          std::minmax({mesh_.scaled[f[0]].*axis, mesh_.scaled[f[1]].*axis, mesh_.scaled[f[2]].*axis});
      lower_.push_back(low);
      upper_.push_back(high);
    }
  }

  std::vector<char> run() {
    std::vector<Index> all(candidates_.size());
    std::iota(all.begin(), all.end(), Index{0});
    open_.push_back({{}, std::make_shared<const std::vector<Index>>(std::move(all))});
    // Large cells first: they tell most. When that becomes too much, all that is left counts.
    const std::size_t most = kMostTests * candidates_.size();
    for (; !open_.empty() && tests_ <= most; open_.pop_front()) visit(open_.front().cell, *open_.front().above);
    for (const Open& open : open_)
      for (const Index i : *open.above) needed_[i] = 1;
    std::vector<char> covered(candidates_.size());
    for (std::size_t i = 0; i < covered.size(); ++i) covered[i] = static_cast<char>(needed_[i] == 0);
    return covered;
  }

 private:
  static constexpr int kDeepest = 10;
  static constexpr std::size_t kFew = 6;
  static constexpr std::size_t kMostTests = 64;  ///< of each candidate, on average

  struct Cell {
    int level = 0;
    std::uint32_t x = 0, y = 0;
  };
  struct Open {
    Cell cell;
    std::shared_ptr<const std::vector<Index>> above;  ///< obstacles that may reach into the cell around it
  };
  using Corners = std::array<ApproximatePoint, 4>;

  /// Neighbouring cells get the same doubles.
  [[nodiscard]] double edge(std::size_t axis, int level, std::uint32_t i) const {
    const double share = std::ldexp(static_cast<double>(i), -level);
    return share == 0 ? lower_[axis] : share == 1 ? upper_[axis] : lower_[axis] * (1 - share) + upper_[axis] * share;
  }

  [[nodiscard]] Corners cornersOf(const Cell& cell) const {
    const double left = edge(0, cell.level, cell.x), right = edge(0, cell.level, cell.x + 1);
    const double bottom = edge(1, cell.level, cell.y), top = edge(1, cell.level, cell.y + 1);
    return {{{left, bottom, 0}, {right, bottom, 0}, {right, top, 0}, {left, top, 0}}};
  }

  [[nodiscard]] ApproximatePoint scaled(Index vertex) const {
    return {mesh_.scaled[vertex].x, mesh_.scaled[vertex].y, 0};
  }

  /// +1: the cell lies inside the triangle, corners and all. -1: they have no more than borders in common, as far as
  /// rounded coordinates tell. 0: neither is certain.
  [[nodiscard]] int compare(const Corners& cell, Index triangle) const {
    const auto& o = mesh_.triangles[triangle];
    if (isBeside(cell, o)) return -1;
    const int facing = mesh_.facing[triangle];
    if (facing == 0) return 0;  // a wall is a line in the plan; it covers nothing
    bool isInside = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const ApproximatePoint a = scaled(o[k]), b = scaled(o[k == 2 ? 0 : k + 1]);
      // The corners that lie farthest out and farthest in, beyond which no other one is.
      const bool inIsLeft = (b.y > a.y) == (facing > 0), inIsUp = (b.x > a.x) == (facing > 0);
      const std::size_t in = inIsUp ? (inIsLeft ? 3 : 2) : (inIsLeft ? 0 : 1);
      if (filteredOrientation(a, b, cell[in], slack_) == -facing) return -1;
      isInside = isInside && filteredOrientation(a, b, cell[(in + 2) % 4], slack_) == facing;
    }
    return isInside ? 1 : 0;
  }

  [[nodiscard]] bool isBeside(const Corners& cell, const std::array<Index, 3>& o) const {
    const Vec3 &a = mesh_.scaled[o[0]], &b = mesh_.scaled[o[1]], &c = mesh_.scaled[o[2]];
    return std::max({a.x, b.x, c.x}) < cell[0].x || std::min({a.x, b.x, c.x}) > cell[2].x ||
           std::max({a.y, b.y, c.y}) < cell[0].y || std::min({a.y, b.y, c.y}) > cell[2].y;
  }

  /// The whole triangle takes from the floor what lies under it.
  [[nodiscard]] static bool isWhole(const ClearanceCandidate& c) {
    const bool above = std::all_of(c.floor.begin(), c.floor.end(), [](int s) { return s >= 0; });
    const bool below = std::all_of(c.ceiling.begin(), c.ceiling.end(), [](int s) { return s <= 0; });
    return c.coplanar || (above && below);
  }

  void visit(const Cell& cell, const std::vector<Index>& above) {
    poll_();
    const Corners corners = cornersOf(cell);
    if (compare(corners, face_) < 0) return;  // nobody needs what lies beside the face
    std::vector<Index> here;
    Index cover = -1;
    bool mayBeCovered = false;
    for (const Index i : above) {
      const ClearanceCandidate& candidate = candidates_[static_cast<std::size_t>(i)];
      const int inside = compare(corners, candidate.obstacle);
      if (inside < 0) continue;
      here.push_back(i);
      if (!isWhole(candidate) || mesh_.facing[candidate.obstacle] == 0) continue;
      mayBeCovered = true;
      if (inside > 0 && (cover < 0 || (needed_[cover] == 0 && needed_[i] != 0))) cover = i;
    }
    tests_ += above.size();
    if (cover >= 0) {
      needed_[cover] = 1;
    } else if (!mayBeCovered || here.size() <= kFew || cell.level == kDeepest) {
      for (const Index i : here) needed_[i] = 1;
    } else {
      const auto shared = std::make_shared<const std::vector<Index>>(std::move(here));
      for (const std::uint32_t y : {0U, 1U})
        for (const std::uint32_t x : {0U, 1U})
          open_.push_back({{cell.level + 1, 2 * cell.x + x, 2 * cell.y + y}, shared});
    }
  }

  const SourceMesh& mesh_;
  double slack_;
  Index face_;
  std::span<const ClearanceCandidate> candidates_;
  Poll poll_;
  std::vector<double> lower_, upper_;  ///< of the face's box in the plan, scaled
  std::vector<char> needed_;
  std::deque<Open> open_;
  std::size_t tests_ = 0;
};

double planArea(const Box& a, const Box& b) {
  double area = 1;
  for (const std::size_t axis : {0, 1})
    area *= std::max(0.0, std::min(a.upper[axis], b.upper[axis]) - std::max(a.lower[axis], b.lower[axis]));
  return area;
}

}  // namespace

Crowding::Crowding(const SourceMesh& mesh, Index face)
    : mesh_(mesh), box_(boxOf(mesh, face)), faceArea_(planArea(box_, box_)) {}

void Crowding::add(Index obstacle) {
  if (mesh_.facing[obstacle] == 0) return;
  area_ += planArea(box_, boxOf(mesh_, obstacle));
  ++count_;
}

std::vector<char> findCovered(const PlanKernel& kernel, Index face, std::span<const ClearanceCandidate> candidates,
                              Poll poll) {
  return CoverSearch(kernel, face, candidates, poll).run();
}

}  // namespace footfall::detail
