// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/partitioning/triangle_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "core/environment/parallel_ranges.hpp"

namespace footfall {
namespace {

using Point = TrianglePieces::Point;

constexpr std::size_t kPiecesPerPoll = 4096;
constexpr std::size_t kPiecesPerTask = 8192;

// Where a line from a to b, on either side of the border, crosses it. Halves, so that no difference overflows; where
// they are too small to tell, the middle will do.
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

TrianglePieces TrianglePieces::of(const StrategyInput& input) {
  TrianglePieces result;
  const SourceMesh& mesh = input.mesh;
  result.pieces.resize(mesh.triangles.size());
  forRanges(result.pieces.size(), kPiecesPerTask, [&](std::size_t first, std::size_t last) {
    input.poll();
    for (std::size_t t = first; t < last; ++t) {
      if (input.removed[t] != 0) continue;
      result.pieces[t].box = planBoxOf(mesh, static_cast<Index>(t));
      result.pieces[t].triangle = static_cast<Index>(t);
    }
  });
  std::erase_if(result.pieces, [](const TrianglePiece& piece) { return piece.triangle < 0; });
  return result;
}

void TrianglePieces::add(const TrianglePiece& piece, const TrianglePieces& from) {
  pieces.push_back(piece);
  if (piece.firstCorner < 0) return;
  pieces.back().firstCorner = static_cast<Index>(corners.size());
  const auto first = from.corners.begin() + piece.firstCorner;
  corners.insert(corners.end(), first, first + piece.cornerCount);
}

void TrianglePieces::add(Index triangle, std::span<const Point> outline) {
  TrianglePiece piece;
  piece.triangle = triangle;
  piece.firstCorner = static_cast<Index>(corners.size());
  piece.cornerCount = static_cast<Index>(outline.size());
  for (const Point& point : outline)
    for (int axis = 0; axis < 2; ++axis) {
      piece.box.lower[axis] = std::min(piece.box.lower[axis], point[axis]);
      piece.box.upper[axis] = std::max(piece.box.upper[axis], point[axis]);
    }
  pieces.push_back(piece);
  corners.insert(corners.end(), outline.begin(), outline.end());
}

std::array<TrianglePieces, 2> TrianglePieces::split(int axis, double coordinate, const StrategyInput& input) const {
  std::array<TrianglePieces, 2> result;
  for (TrianglePieces& side : result) side.pieces.reserve(pieces.size() / 2 + pieces.size() / 8);
  std::array<Point, 3> triangle;
  std::array<std::vector<Point>, 2> sides;
  std::size_t polls = 0;
  for (const TrianglePiece& piece : pieces) {
    if (++polls % kPiecesPerPoll == 0) input.poll();
    if (piece.box.upper[axis] <= coordinate) {
      result[0].add(piece, *this);
    } else if (piece.box.lower[axis] >= coordinate) {
      result[1].add(piece, *this);
    } else {
      std::span<const Point> outline = triangle;
      if (piece.firstCorner >= 0)
        outline = std::span(corners).subspan(piece.firstCorner, piece.cornerCount);
      else
        for (int k = 0; k < 3; ++k) {
          const Vec3& corner = input.mesh.vertices[input.mesh.triangles[piece.triangle][k]];
          triangle[k] = {corner.x, corner.y};
        }
      clip(outline, axis, coordinate, sides);
      result[0].add(piece.triangle, sides[0]);
      result[1].add(piece.triangle, sides[1]);
    }
  }
  return result;
}

}  // namespace footfall
