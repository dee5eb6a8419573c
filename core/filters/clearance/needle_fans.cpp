// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/clearance/needle_fans.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

namespace footfall::detail {
namespace {

/// Fewer needles at a corner are found soon enough by their boxes.
constexpr Index kFewest = 128;
/// Each needle of a fan looks into all fans.
constexpr std::size_t kMostFans = 256;
/// Wider triangles are no needles. Two of them never overlap at two places of a turn.
constexpr double kWidest = std::numbers::pi / 8;
constexpr Index kPolled = 1 << 14;

/// The number of triangles at each corner, by plan id; walls and triangles without area do not count.
std::vector<Index> countAtCorners(const SourceMesh& mesh, const Poll& poll) {
  std::vector<Index> counts(mesh.vertices.size());
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) {
    if (t % kPolled == 0) poll();
    if (mesh.facing[t] == 0) continue;
    for (const Index corner : mesh.triangles[t]) ++counts[mesh.planIds[corner]];
  }
  return counts;
}

/// The corner of a triangle, by plan id, at which most others lie.
Index busiestCorner(const SourceMesh& mesh, Index triangle, const std::vector<Index>& counts) {
  Index busiest = -1;
  for (const Index corner : mesh.triangles[triangle]) {
    const Index id = mesh.planIds[corner];
    if (busiest < 0 || counts[id] > counts[busiest] || (counts[id] == counts[busiest] && id < busiest)) busiest = id;
  }
  return busiest;
}

}  // namespace

NeedleFans::Angles NeedleFans::anglesAt(const SourceMesh& mesh, Index corner, Index triangle) {
  const std::array<Index, 3>& t = mesh.triangles[triangle];
  std::size_t k = 0;
  while (mesh.planIds[t[k]] != corner) ++k;
  const Vec3 &at = mesh.vertices[t[k]], &a = mesh.vertices[t[(k + 1) % 3]], &b = mesh.vertices[t[(k + 2) % 3]];
  const std::array<double, 4> towards{a.x - at.x, a.y - at.y, b.x - at.x, b.y - at.y};
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (!std::all_of(towards.begin(), towards.end(), [](double x) { return std::isfinite(x); })) return {kNone, kNone};
  double first = std::atan2(towards[1], towards[0]), last = std::atan2(towards[3], towards[2]);
  if (mesh.facing[triangle] < 0) std::swap(first, last);
  if (first < 0) first += kTurn;
  while (last < first - kSlack) last += kTurn;  // a needle as thin as the rounding has no width
  return {first, std::max(first, last)};
}

std::unique_ptr<const NeedleFans> NeedleFans::find(const SourceMesh& mesh, const Poll& poll) {
  std::vector<Index> counts = countAtCorners(mesh, poll);
  if (std::none_of(counts.begin(), counts.end(), [](Index count) { return count >= kFewest; })) return nullptr;
  const auto count = static_cast<Index>(mesh.triangles.size());
  std::vector<Index> cornerOf(count, -1), needles(counts.size());
  for (Index t = 0; t < count; ++t) {
    if (t % kPolled == 0) poll();
    if (mesh.facing[t] == 0) continue;
    const Index corner = busiestCorner(mesh, t, counts);
    if (counts[corner] < kFewest) continue;
    const Angles angles = anglesAt(mesh, corner, t);
    if (!(angles.last - angles.first <= kWidest)) continue;
    cornerOf[t] = corner;
    ++needles[corner];
  }
  std::vector<Index> corners;
  for (Index id = 0; id < static_cast<Index>(needles.size()); ++id)
    if (needles[id] >= kFewest) corners.push_back(id);
  if (corners.empty()) return nullptr;
  std::stable_sort(corners.begin(), corners.end(), [&](Index a, Index b) { return needles[a] > needles[b]; });
  if (corners.size() > kMostFans) corners.resize(kMostFans);
  std::fill(needles.begin(), needles.end(), Index{-1});  // from here on the number of the fan
  for (std::size_t i = 0; i < corners.size(); ++i) needles[corners[i]] = static_cast<Index>(i);
  for (Index& corner : cornerOf)
    if (corner >= 0) corner = needles[corner];
  return std::unique_ptr<const NeedleFans>(new NeedleFans(mesh, std::move(cornerOf), std::move(corners), poll));
}

NeedleFans::NeedleFans(const SourceMesh& mesh, std::vector<std::int32_t> fanOf, std::vector<Index> corners,
                       const Poll& poll)
    : mesh_(mesh), fanOf_(std::move(fanOf)), fans_(corners.size()) {
  std::vector<std::vector<std::int32_t>> members(corners.size() + 1);  // the last are those of no fan
  for (Index t = 0; t < static_cast<Index>(fanOf_.size()); ++t) {
    if (t % kPolled == 0) poll();
    if (mesh.degenerate[t] != 0) continue;
    members[fanOf_[t] < 0 ? corners.size() : static_cast<std::size_t>(fanOf_[t])].push_back(t);
  }
  const auto build = [&](TriangleTree& tree, const std::vector<std::int32_t>& ids) {
    std::vector<Box> boxes;
    boxes.reserve(ids.size());
    for (const std::int32_t id : ids) boxes.push_back(boxOf(mesh, id));
    if (!ids.empty()) tree.build(boxes, ids, poll);
  };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    Fan& fan = fans_[i];
    fan.corner = corners[i];
    fan.byAngle.build(
        members[i],
        [&](Index id) {
          const Angles angles = anglesAt(fan.corner, id);
          const Box box = boxOf(mesh, id);
          return BoxTree<2>::Bounds{{angles.first, box.lower[2]}, {angles.last, box.upper[2]}};
        },
        poll);
    build(fan.byBox, members[i]);
  }
  build(rest_, members.back());
}

}  // namespace footfall::detail
