// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assembly/face_mesh.hpp"

#include <algorithm>

#include "core/base/index_and_box.hpp"

namespace footfall::detail {
void FaceMesher::insertCuts(const FaceCuts& cuts) {
  points_.clear();
  lines_.clear();
  geometry_.reserve(cuts.points.size());
  for (std::size_t i = 0; i < cuts.points.size(); ++i) {
    points_.push_back(geometry_.point(cuts.points[i]));
    geometry_.addBorder(points_.back(), cuts.borders[i]);
  }
  for (const PlanLine& l : cuts.lines) lines_.push_back(geometry_.newLine(l));

  triangulation_.start(points_, cuts.edgeWalls);
  constexpr std::size_t kTold = 64;
  std::size_t inserted = 0;
  for (const CutSegment& s : cuts.segments) {
    triangulation_.insertSegment(triangulation_.vertexAt(points_[s.from]), triangulation_.vertexAt(points_[s.to]),
                                 lines_[s.line], s.direction, s.winding, s.wall);
    if (++inserted % kTold == 0 && advance_) advance_(kTold);
  }
  if (advance_) advance_(inserted % kTold);
  triangulation_.dropConstraints();
}

const FaceMesh& FaceMesher::mesh(Index face, const FaceCuts* cuts, bool covered) {
  FaceMesh& result = result_;
  result.points.clear();
  result.approximate.clear();
  result.lines.clear();
  result.facets.clear();
  if (cuts != nullptr && cuts->removed && !covered) return result;
  geometry_.start(face);
  if (cuts != nullptr)
    insertCuts(*cuts);
  else
    triangulation_.start({});
  const auto& facets = triangulation_.facets();
  const auto& edges = triangulation_.edges();
  const std::vector<int> winding = triangulation_.windingNumbers(cuts != nullptr ? cuts->startWinding : 0);
  const bool all = cuts != nullptr && cuts->removed;
  std::size_t count = 0;
  isTaken_.resize(facets.size());
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const bool isTaken = all || (winding[i] == 0) != covered;
    isTaken_[i] = static_cast<char>(isTaken);
    count += isTaken ? 1 : 0;
  }
  if (cuts != nullptr) triangulation_.improve(isTaken_);
  const auto taken = [&](Index c) { return isTaken_[c] != 0; };
  result.facets.reserve(count);
  result.points.reserve(std::min(geometry_.pointCount(), 3 * count));
  result.approximate.reserve(std::min(geometry_.pointCount(), 3 * count));
  pointOf_.assign(geometry_.pointCount(), -1);
  lineOf_.assign(geometry_.lineCount(), -1);
  const auto addPoint = [&](Index p) {
    if (pointOf_[p] < 0) {
      pointOf_[p] = static_cast<Index>(result.points.size());
      result.points.push_back(geometry_[p]);
      result.approximate.push_back(geometry_.approximate(p));
    }
    return pointOf_[p];
  };
  const auto addLine = [&](Index l) {
    if (lineOf_[l] < 0) {
      lineOf_[l] = static_cast<Index>(result.lines.size());
      result.lines.push_back(geometry_.lineAt(l));
    }
    return lineOf_[l];
  };
  for (int k = 0; k < 3; ++k) addPoint(k);
  for (Index i = 0; i < static_cast<Index>(facets.size()); ++i) {
    if (!taken(i)) continue;
    FaceMesh::Facet facet;
    for (int k = 0; k < 3; ++k) {
      const int edge = previous(k);  // so that a face without cuts keeps its first corner
      facet.corners[k] = addPoint(facets[i].corners[edge]);
      const Index other = facets[i].neighbors[edge];
      const bool outline = other < 0 || !taken(other);
      if (outline) facet.outlineEdges |= static_cast<std::uint8_t>(1 << k);
      if (edges[i].walls[edge] != 0) facet.obstacleEdges |= static_cast<std::uint8_t>(1 << k);
      if ((outline || edges[i].walls[edge] != 0) && edges[i].lines[edge] >= 0)
        facet.lines[k] = addLine(edges[i].lines[edge]);
      // the lines 0, 1, 2 are the face's own edges
      if (other < 0) facet.faceEdges[k] = static_cast<std::int8_t>(edges[i].lines[edge]);
    }
    result.facets.push_back(facet);
  }
  return result;
}

}  // namespace footfall::detail
