// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/cell_links.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "core/base/disjoint_sets.hpp"
#include "core/base/index_and_box.hpp"
#include "core/filters/steps/chosen_steps.hpp"
#include "core/filters/steps/gap_ways.hpp"
#include "core/filters/steps/step_memory.hpp"
#include "core/mesh/mesh_geometry.hpp"

namespace footfall::detail {
namespace {

/// Links in a row, one over the other, from some edges on.
class LinkRows {
 public:
  LinkRows(const PlanKernel& kernel, const StepMemory& memory, const std::unordered_set<Index>& first)
      : borders_(memory.borders),
        stretches_(memory.found.stretches),
        geometry_(kernel, memory.given->vertices),
        first_(first) {
    for (std::size_t i = 0; i < stretches_.size(); ++i)
      for (const Index border : {stretches_[i].first, stretches_[i].second})
        stretchesAt_[borders_[border].edge].push_back(i);
  }

  /// True when there are fewer than `most`.
  bool areShorterThan(int most, const RunContext& context) {
    for (const StepStretch& s : stretches_) {
      const std::array edges{edgeOf(s.first), edgeOf(s.second)};
      for (const std::size_t k : {0, 1})
        if (first_.contains(edges[k])) reach({edges[1 - k], ordered(s, axisOf(s)), 1});
    }
    while (!open_.empty()) {
      context.checkCancelled();
      const Piece piece = std::move(open_.back());
      open_.pop_back();
      if (piece.links >= most) return false;
      goOnFrom(piece);
    }
    return true;
  }

  /// True when links lead to the edge, after a call of areShorterThan().
  [[nodiscard]] bool leadTo(Index edge) const { return first_.contains(edge) || reached_.contains(edge); }

 private:
  /// A part of an edge's line between two places, in the order of a coordinate in which they differ.
  struct Part {
    MeshVertex low, high;
    int axis = 0;
  };
  struct Piece {
    Index edge = -1;
    Part part;
    int links = 0;
  };

  [[nodiscard]] Index edgeOf(Index border) const { return borders_[border].edge; }
  int axisOf(const StepStretch& s) { return BorderSplits::axisBetween(s.begin, s.end, geometry_); }
  Part ordered(const StepStretch& s, int axis) {
    if (geometry_.compare(s.begin, s.end, axis) < 0) return {s.begin, s.end, axis};
    return {s.end, s.begin, axis};
  }

  // The first edges need no search, nor do places where the same piece was reached before.
  void reach(Piece piece) {
    if (first_.contains(piece.edge)) return;
    std::vector<Part>& known = reached_[piece.edge];
    const auto& [low, high, axis] = piece.part;
    for (const Part& part : known)
      if (geometry_.compare(part.low, low, axis) <= 0 && geometry_.compare(high, part.high, axis) <= 0) return;
    known.push_back(piece.part);
    open_.push_back(std::move(piece));
  }

  // Goes on to all that is linked within the piece; single points spread nothing.
  void goOnFrom(const Piece& piece) {
    for (const std::size_t i : stretchesAt_[piece.edge]) {
      const StepStretch& s = stretches_[i];
      const Index other = edgeOf(s.first) == piece.edge ? edgeOf(s.second) : edgeOf(s.first);
      if (first_.contains(other)) continue;
      const int axis = piece.part.axis;
      Part common = ordered(s, axis);
      if (geometry_.compare(common.low, piece.part.low, axis) < 0) common.low = piece.part.low;
      if (geometry_.compare(piece.part.high, common.high, axis) < 0) common.high = piece.part.high;
      if (geometry_.compare(common.low, common.high, axis) < 0) reach({other, std::move(common), piece.links + 1});
    }
  }

  const std::vector<MeshBorder>& borders_;
  const std::vector<StepStretch>& stretches_;
  MeshGeometry geometry_;
  const std::unordered_set<Index>& first_;
  std::unordered_map<Index, std::vector<std::size_t>> stretchesAt_;  ///< stretches by edge
  std::unordered_map<Index, std::vector<Part>> reached_;             ///< parts by edge
  std::vector<Piece> open_;
};

/// The floors of a cell, with all that was found between their borders.
struct GapFloors {
  const SourceMesh& source;
  const StepMemory& memory;
  const std::vector<std::uint32_t>& numbers;  ///< number in the environment of each input triangle
  const std::vector<char>& isOwn;             ///< one flag per face

  [[nodiscard]] std::uint32_t numberOf(Index face) const { return numbers[source.inputTriangles[face]]; }
};

/// The floors whose borders get vertices together: they share an edge, a step or a gap.
DisjointSets joinFloors(const GapFloors& cell, const LinkRows& changed) {
  DisjointSets sets(cell.source.triangles.size());
  const std::vector<MeshBorder>& borders = cell.memory.borders;
  std::unordered_map<Index, Index> faceAt;  // by edge
  for (const MeshBorder& border : borders)
    if (changed.leadTo(border.edge))
      sets.unite(faceAt.try_emplace(border.edge, border.face).first->second, border.face);
  for (const StepStretch& s : cell.memory.found.stretches)
    if (changed.leadTo(borders[s.first].edge) || changed.leadTo(borders[s.second].edge))
      sets.unite(borders[s.first].face, borders[s.second].face);
  for (const GapStretch& gap : cell.memory.found.gaps) sets.unite(borders[gap.first].face, borders[gap.second].face);
  return sets;
}

/// The first side of a gap, in environment units, with one of its own floors. The vertices are rounded; GapGroups
/// leaves room for that.
FloorsAtGaps::Side sideOf(const GapStretch& gap, const GapFloors& cell) {
  const MeshBorder& border = cell.memory.borders[gap.first];
  const Index floor = cell.isOwn[border.face] != 0 ? border.face : cell.memory.borders[gap.second].face;
  const std::vector<MeshVertex>& vertices = cell.memory.given->vertices;
  const PlanSegment part =
      partOf(planSegment(vertices[border.from], vertices[border.to]), gap.piece.frame, gap.piece.ends);
  const int unscale = -cell.source.grid.scaleExponent();
  const auto [lowX, highX] = std::minmax(part.fromX, part.toX);
  const auto [lowY, highY] = std::minmax(part.fromY, part.toY);
  return {cell.numberOf(floor),
          {std::ldexp(lowX, unscale), std::ldexp(lowY, unscale)},
          {std::ldexp(highX, unscale), std::ldexp(highY, unscale)}};
}

/// Own floors to whose borders gaps lead, directly or over steps.
FloorsAtGaps floorsAtGaps(const GapFloors& cell, const LinkRows& changed) {
  FloorsAtGaps result;
  DisjointSets sets = joinFloors(cell, changed);
  const std::vector<MeshBorder>& borders = cell.memory.borders;
  std::vector<char> isAtGap(cell.isOwn.size(), 0);
  std::vector<Index> firstOwn(cell.isOwn.size(), -1);  // by set
  for (const MeshBorder& border : borders)
    if (changed.leadTo(border.edge)) isAtGap[border.face] = 1;
  for (std::size_t f = 0; f < isAtGap.size(); ++f) {
    if (isAtGap[f] == 0 || cell.isOwn[f] == 0) continue;
    if (Index& first = firstOwn[sets.find(static_cast<Index>(f))]; first < 0) first = static_cast<Index>(f);
    result.floors.push_back(cell.numberOf(static_cast<Index>(f)));
  }
  for (std::size_t f = 0; f < isAtGap.size(); ++f) {
    const Index face = static_cast<Index>(f), first = firstOwn[sets.find(face)];
    if (isAtGap[f] != 0 && first >= 0 && first != face)
      result.joined.push_back({cell.numberOf(first), cell.numberOf(face)});
  }
  const int unscale = -cell.source.grid.scaleExponent();
  for (const GapStretch& gap : cell.memory.found.gaps) {
    const Index first = borders[gap.first].face, second = borders[gap.second].face;
    if (cell.isOwn[first] == 0 && cell.isOwn[second] == 0) continue;
    result.sides.push_back(sideOf(gap, cell));
    if (gap.piece.corner)
      result.corners.push_back({result.sides.back().floor, std::ldexp(gap.piece.corner->x, unscale),
                                std::ldexp(gap.piece.corner->y, unscale)});
  }
  return result;
}

/// The triangles at an edge, in one direction.
struct LinkSide {
  Index firstFace = -1;
  bool isFirstOwn = false, isOwn = false, isOthers = false;
};

std::uint64_t keyOf(Index from, Index to) {
  return static_cast<std::uint64_t>(from) << 32 | static_cast<std::uint32_t>(to);
}

}  // namespace

StatePtr withoutDropped(const StatePtr& state, const std::vector<std::uint32_t>& numbers,
                        const DroppedTriangles& dropped) {
  if (dropped.bytes() == 0) return state;
  const SourceMesh& source = state->kernel->mesh();
  auto mesh = std::make_shared<WalkableMesh>();
  mesh->vertices = state->mesh->vertices;
  Index face = -1;
  std::uint32_t place = 0;
  for (const MeshTriangle& triangle : state->mesh->triangles) {
    place = std::exchange(face, triangle.face) == triangle.face ? place + 1 : 0;
    if (!dropped.contains(numbers[source.inputTriangles[face]], place)) mesh->triangles.push_back(triangle);
  }
  auto result = std::make_shared<WalkableState>(*state);
  result->mesh = std::move(mesh);
  result->topology = nullptr;
  return result;
}

std::optional<LinkedCell> withSteps(const StatePtr& state, const std::vector<std::uint32_t>& numbers,
                                    const std::vector<char>& isSeen, const std::vector<char>& isOwn,
                                    const PipelineStep& step, int reach, bool hasAllGaps, RunContext& context) {
  Recall recall;
  recall.keep = true;
  LinkedCell cell{applyStepToChosen(state, step.values[0], step.values[1], &isSeen, hasAllGaps, recall, context).state,
                  isOwn};
  const StepMemory& memory = *cell.state->stepMemory;
  std::unordered_set<Index> ownEdges;
  for (const MeshBorder& border : memory.borders)
    if (isOwn[border.face] != 0) ownEdges.insert(border.edge);
  if (!LinkRows(*cell.state->kernel, memory, ownEdges).areShorterThan(reach, context)) return std::nullopt;
  if (hasAllGaps || memory.found.gaps.empty()) return cell;
  std::unordered_set<Index> gapEdges;
  for (const GapStretch& gap : memory.found.gaps)
    gapEdges.insert({memory.borders[gap.first].edge, memory.borders[gap.second].edge});
  LinkRows changed(*cell.state->kernel, memory, gapEdges);
  changed.areShorterThan(std::numeric_limits<int>::max(), context);
  for (const MeshBorder& border : memory.borders)
    if (changed.leadTo(border.edge)) cell.isOwn[border.face] = 0;
  cell.atGaps = floorsAtGaps(GapFloors{state->kernel->mesh(), memory, numbers, isOwn}, changed);
  return cell;
}

std::vector<CellLink> linksOf(const WalkableMesh& mesh, const std::vector<char>& isOwn) {
  std::unordered_map<std::uint64_t, LinkSide> sides;
  std::vector<char> isEnd(mesh.vertices.size(), 0);
  for (const MeshLink& link : mesh.links)
    for (const auto& [from, to] : {link.from, link.to}) {
      sides[keyOf(from, to)] = {};
      isEnd[from] = isEnd[to] = 1;
    }
  for (const MeshTriangle& triangle : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const Index from = triangle.corners[k], to = triangle.corners[next(k)];
      if (isEnd[from] == 0 || isEnd[to] == 0) continue;
      const auto found = sides.find(keyOf(from, to));
      if (found == sides.end()) continue;
      LinkSide& side = found->second;
      const bool own = isOwn[triangle.face] != 0;
      if (side.firstFace < 0) {
        side.firstFace = triangle.face;
        side.isFirstOwn = own;
      }
      (own ? side.isOwn : side.isOthers) = true;
    }
  std::vector<CellLink> links;
  for (MeshLink link : mesh.links) {
    LinkSide from = sides.at(keyOf(link.from[0], link.from[1])), to = sides.at(keyOf(link.to[0], link.to[1]));
    if (!from.isOwn && !to.isOwn) continue;
    if (to.firstFace < from.firstFace) {
      std::swap(from, to);
      std::swap(link.from, link.to);
    }
    links.push_back({link, from.isFirstOwn, to.isFirstOwn, from.isOthers || to.isOthers});
  }
  return links;
}

}  // namespace footfall::detail
