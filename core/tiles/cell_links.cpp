// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/cell_links.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "core/base/index_and_box.hpp"
#include "core/filters/steps/chosen_steps.hpp"
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
  std::unordered_set<Index> ownEdges, gapEdges;
  for (const MeshBorder& border : memory.borders)
    if (isOwn[border.face] != 0) ownEdges.insert(border.edge);
  if (!LinkRows(*cell.state->kernel, memory, ownEdges).areShorterThan(reach, context)) return std::nullopt;
  if (hasAllGaps || memory.found.gaps.empty()) return cell;
  const SourceMesh& source = state->kernel->mesh();
  const int unscale = -source.grid.scaleExponent();
  for (const GapStretch& gap : memory.found.gaps) {
    const MeshBorder &first = memory.borders[gap.first], &second = memory.borders[gap.second];
    gapEdges.insert({first.edge, second.edge});
    if (gap.piece.corner && (isOwn[first.face] != 0 || isOwn[second.face] != 0))
      cell.atGaps.corners.push_back(
          {std::ldexp(gap.piece.corner->x, unscale), std::ldexp(gap.piece.corner->y, unscale)});
  }
  LinkRows changed(*cell.state->kernel, memory, gapEdges);
  changed.areShorterThan(std::numeric_limits<int>::max(), context);
  for (const MeshBorder& border : memory.borders)
    if (cell.isOwn[border.face] != 0 && changed.leadTo(border.edge)) {
      cell.isOwn[border.face] = 0;
      cell.atGaps.floors.push_back(numbers[source.inputTriangles[border.face]]);
    }
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
