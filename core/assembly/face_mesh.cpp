// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assembly/face_mesh.hpp"

#include "core/base/geometry.hpp"

namespace footfall::detail {

void FaceMesher::insertCuts(const FaceCuts& cuts) {
  std::vector<Index> points, lines;
  for (std::size_t i = 0; i < cuts.points.size(); ++i) {
    points.push_back(geometry_.point(cuts.points[i]));
    geometry_.addBorder(points.back(), cuts.borders[i]);
  }
  for (const PlanLine& l : cuts.lines) lines.push_back(geometry_.line(l));

  for (const Index p : points) triangulation_.insertPoint(p);
  constexpr std::size_t kTold = 64;
  std::size_t inserted = 0;
  for (const CutSegment& s : cuts.segments) {
    triangulation_.insertSegment(triangulation_.insertPoint(points[s.from]), triangulation_.insertPoint(points[s.to]),
                                 lines[s.line], s.direction, s.winding, s.wall);
    if (++inserted % kTold == 0 && advance_) advance_(kTold);
  }
  if (advance_) advance_(inserted % kTold);
  triangulation_.improve();
}

FaceMesh FaceMesher::mesh(Index face, const FaceCuts* cuts, bool covered) {
  FaceMesh result;
  if (cuts != nullptr && cuts->removed && !covered) return result;
  geometry_.start(face);
  triangulation_.start();
  if (cuts != nullptr) {
    for (int k = 0; k < 3; ++k)
      if ((cuts->edgeWalls >> k & 1) != 0) triangulation_.markEdgeWall(k);
    insertCuts(*cuts);
  }
  const auto& cells = triangulation_.cells();
  const std::vector<int> winding = triangulation_.windingNumbers();
  const bool all = cuts != nullptr && cuts->removed;
  const auto taken = [&](Index c) { return all || (winding[c] == 0) != covered; };

  std::vector<Index> pointOf(geometry_.pointCount(), -1), lineOf;
  const auto addPoint = [&](Index p) {
    if (pointOf[p] < 0) {
      pointOf[p] = static_cast<Index>(result.points.size());
      result.points.push_back(geometry_[p]);
      result.approximate.push_back(geometry_.approximate(p));
    }
    return pointOf[p];
  };
  const auto addLine = [&](Index l) {
    if (static_cast<std::size_t>(l) >= lineOf.size()) lineOf.resize(l + 1, -1);
    if (lineOf[l] < 0) {
      lineOf[l] = static_cast<Index>(result.lines.size());
      result.lines.push_back(geometry_.lineAt(l));
    }
    return lineOf[l];
  };
  for (int k = 0; k < 3; ++k) addPoint(k);
  for (Index i = 0; i < static_cast<Index>(cells.size()); ++i) {
    if (!taken(i)) continue;
    FaceMesh::Cell cell;
    for (int k = 0; k < 3; ++k) {
      const int edge = previous(k);  // so that a face without cuts keeps its first corner
      cell.corners[k] = addPoint(cells[i].corners[edge]);
      const Index other = cells[i].neighbors[edge];
      const bool outline = other < 0 || !taken(other);
      if (outline) cell.outlineEdges |= static_cast<std::uint8_t>(1 << k);
      if (cells[i].walls[edge] != 0) cell.obstacleEdges |= static_cast<std::uint8_t>(1 << k);
      if ((outline || cells[i].walls[edge] != 0) && cells[i].lines[edge] >= 0)
        cell.lines[k] = addLine(cells[i].lines[edge]);
      // the lines 0, 1, 2 are the face's own edges
      if (other < 0) cell.faceEdges[k] = static_cast<std::int8_t>(cells[i].lines[edge]);
    }
    result.cells.push_back(cell);
  }
  return result;
}

}  // namespace footfall::detail
