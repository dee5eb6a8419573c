// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/partitioning/triangle_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"

namespace footfall::detail {
namespace {

using Point = TrianglePieces::Point;

constexpr std::size_t kPiecesPerPoll = 4096;
constexpr std::size_t kPiecesPerTask = 8192;

// The point where a line from a to b, on either side of the border, crosses it. Computed from halves, so that no
// difference overflows; where they are too small to divide, the middle is used.
Point crossing(const Point& a, const Point& b, int axis, double coordinate) {
  const double part = (coordinate / 2 - a[axis] / 2) / (b[axis] / 2 - a[axis] / 2);
  Point result;
  result[axis] = coordinate;
  result[1 - axis] = std::lerp(a[1 - axis], b[1 - axis], part >= 0 && part <= 1 ? part : 0.5);
  return result;
}

// The two sides of a convex outline that lies on both.
void clip(std::span<const Point> outline, int axis, double coordinate, std::array<std::vector<Point>, 2>& sides) {
  sides[0].clear(), sides[1].clear();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point &a = outline[i], &b = outline[i + 1 == outline.size() ? 0 : i + 1];
    if (a[axis] <= coordinate) sides[0].push_back(a);
    if (a[axis] >= coordinate) sides[1].push_back(a);
    if ((a[axis] < coordinate && b[axis] > coordinate) || (a[axis] > coordinate && b[axis] < coordinate)) {
      const Point point = crossing(a, b, axis, coordinate);
      sides[0].push_back(point);
      sides[1].push_back(point);
    }
  }
}

}  // namespace

TrianglePieces::TrianglePieces(const StrategyInput& input) {
  const SourceMesh& mesh = input.mesh;
  const auto boxes = std::make_shared<std::vector<PlanBox>>(mesh.triangles.size());
  forRanges(boxes->size(), kPiecesPerTask, [&](std::size_t first, std::size_t last) {
    input.poll();
    for (std::size_t t = first; t < last; ++t) (*boxes)[t] = planBoxOf(mesh, static_cast<Index>(t));
  });
  boxes_ = boxes;
  whole_.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (input.removed[t] == 0) whole_.push_back(static_cast<Index>(t));
}

std::vector<double> TrianglePieces::ends(int axis) const {
  std::vector<double> ends;
  ends.reserve(size());
  for (const Index t : whole_) ends.push_back((*boxes_)[t].upper[axis]);
  for (const Part& part : parts_) ends.push_back(part.box.upper[axis]);
  return ends;
}

void TrianglePieces::addPart(std::span<const Point> outline) {
  Part part;
  part.firstCorner = static_cast<Index>(corners_.size());
  part.cornerCount = static_cast<Index>(outline.size());
  for (const Point& point : outline)
    for (int axis = 0; axis < 2; ++axis) {
      part.box.lower[axis] = std::min(part.box.lower[axis], point[axis]);
      part.box.upper[axis] = std::max(part.box.upper[axis], point[axis]);
    }
  parts_.push_back(part);
  corners_.insert(corners_.end(), outline.begin(), outline.end());
}

std::array<TrianglePieces, 2> TrianglePieces::split(int axis, double coordinate, const StrategyInput& input) {
  std::array<TrianglePieces, 2> result{TrianglePieces(), TrianglePieces()};
  for (TrianglePieces& side : result) side.boxes_ = boxes_;
  const auto sideOf = [&](const PlanBox& box) {
    return box.upper[axis] <= coordinate ? 0 : box.lower[axis] >= coordinate ? 1 : 2;
  };
  std::array<std::vector<Point>, 2> sides;
  const auto addBoth = [&](std::span<const Point> outline) {
    clip(outline, axis, coordinate, sides);
    for (int side = 0; side < 2; ++side) result[side].addPart(sides[side]);
  };
  std::size_t polls = 0;
  for (const Index t : whole_) {
    if (++polls % kPiecesPerPoll == 0) input.poll();
    const int side = sideOf((*boxes_)[t]);
    if (side < 2) {
      result[side].whole_.push_back(t);
      continue;
    }
    std::array<Point, 3> outline;
    for (int k = 0; k < 3; ++k) {
      const Vec3& corner = input.mesh.vertices[input.mesh.triangles[t][k]];
      outline[k] = {corner.x, corner.y};
    }
    addBoth(outline);
  }
  for (const Part& part : parts_) {
    if (++polls % kPiecesPerPoll == 0) input.poll();
    const std::span<const Point> outline = std::span(corners_).subspan(part.firstCorner, part.cornerCount);
    const int side = sideOf(part.box);
    if (side < 2)
      result[side].addPart(outline);
    else
      addBoth(outline);
  }
  *this = TrianglePieces();
  return result;
}

}  // namespace footfall::detail
