// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/cell_tile.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "core/assembly/mesh_assembly.hpp"
#include "core/exact/source_predicates.hpp"
#include "core/filters/apply_filter.hpp"
#include "core/filters/clearance/chosen_clearance.hpp"
#include "core/filters/filter_traits.hpp"
#include "core/filters/rounding/rounded_mesh.hpp"
#include "core/pipeline/block_structure.hpp"
#include "core/tiles/cell_links.hpp"
#include "core/tiles/tile_geometry.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"

namespace footfall::detail {
namespace {

constexpr Pattern kSecondStep = FOOTFALL_TEXT(
    "%1: a second %2 cannot keep to a bound of memory; leave it out, or run without the bound, with all of the "
    "environment in memory");
constexpr Pattern kBehindSteps = FOOTFALL_TEXT(
    "%1: %2 stands behind a StepFilter, which needs what it leaves; put it before that, or run without the bound, with "
    "all of the environment in memory");
constexpr Pattern kBehindGlobal = FOOTFALL_TEXT(
    "%1: %2 stands behind a filter that needs all cells; put it before that, or run without the bound, with all of the "
    "environment in memory");
constexpr Pattern kBehindArea = FOOTFALL_TEXT(
    "%1: %2 stands behind an AreaFilter, which needs all cells; put it before that, or run without the bound, with all "
    "of the environment in memory");

/// One flag per face of the source mesh: its kind is at least `least`.
std::vector<char> facesOfKind(const SourceMesh& mesh, const std::vector<CellKind>& kinds, CellKind least) {
  std::vector<char> chosen(mesh.triangles.size());
  for (std::size_t t = 0; t < chosen.size(); ++t) chosen[t] = static_cast<char>(kinds[mesh.inputTriangles[t]] >= least);
  return chosen;
}

std::shared_ptr<const Environment> environmentOf(const CellFaces& cell, const Environment& head) {
  auto environment = std::make_shared<Environment>();
  environment->source = head.source;
  environment->vertices = cell.faces.soup.vertices;
  environment->triangles = cell.faces.soup.triangles;
  environment->up = head.up;
  environment->metresPerUnit = head.metresPerUnit;
  environment->bothSides = head.bothSides;
  environment->grid = head.grid;
  environment->obstacleOnly = cell.obstacleOnly;
  return environment;
}

StatePtr runSteps(StatePtr state, const std::vector<char>& chosen, const std::vector<PipelineStep>& steps,
                  RunContext& context) {
  for (const PipelineStep& step : steps) {
    if (step.filter->type == FilterType::VerticalClearance)
      state = applyClearanceToChosen(state, step.values[0], chosen, context).state;
    else
      state = applyFilter(*step.filter, step.values, state, context).state;
  }
  if (state->mesh) return state;
  auto floors = std::make_shared<WalkableState>(*state);
  for (std::size_t t = 0; t < chosen.size(); ++t)
    floors->walkable[t] = static_cast<char>(floors->walkable[t] != 0 && chosen[t] != 0);
  ExactFallbacks fallbacks;
  return withMesh(floors, context, fallbacks);
}

/// Takes the triangles of the cell's own floors out of the mesh.
class TileMaker {
 public:
  TileMaker(const WalkableState& state, const CellFaces& cell)
      : kernel_(*state.kernel), source_(state.kernel->mesh()), mesh_(*state.mesh), sources_(cell.faces.faceNumbers) {}

  Tile make(const std::vector<char>& isOwn, bool keepsGeometry, RunContext& context,
            const std::function<void(const Tile&, const ExactPlaceOf&)>& inspect) {
    numbers_.assign(mesh_.vertices.size(), -1);
    isShared_.assign(mesh_.vertices.size(), 0);
    const std::vector<CellLink> links = mesh_.links.empty() ? std::vector<CellLink>{} : linksOf(mesh_, isOwn);
    addTriangles(isOwn, context);
    for (const CellLink& link : links) addLink(link);
    std::vector<MeshVertex> vertices;
    vertices.reserve(used_.size());
    for (const Index v : used_) vertices.push_back(mesh_.vertices[v]);
    tile_.places = roundVertices(kernel_, vertices, tile_.exact, context);
    for (std::size_t v = 0; v < used_.size(); ++v) {
      if (v % 1024 == 0) context.checkCancelled();
      if (isShared_[used_[v]] != 0) addBorder(static_cast<Index>(v), vertices[v]);
    }
    if (keepsGeometry) addGeometry(vertices);
    addOutside(context);
    if (inspect)
      inspect(tile_, [&](Index v) {
        const MeshVertex& vertex = vertices[static_cast<std::size_t>(v)];
        return kernel_.exactPosition(vertex.point, vertex.face);
      });
    return std::move(tile_);
  }

 private:
  void addGeometry(const std::vector<MeshVertex>& vertices) {
    tile_.geometry = geometryOf(kernel_, vertices, sources_);
    tile_.pieces.reserve(tile_.triangles.size());
    Index face = -1;
    std::uint32_t number = 0;
    for (const MeshTriangle& triangle : tile_.triangles) {
      if (triangle.face != std::exchange(face, triangle.face)) number = 0;
      tile_.pieces.push_back({number++, face});
    }
  }

  void addTriangles(const std::vector<char>& isOwn, RunContext& context) {
    for (const MeshTriangle& triangle : mesh_.triangles)
      if (isOwn[triangle.face] == 0)
        for (const Index v : triangle.corners) isShared_[v] = 1;
    Index face = -1;
    std::size_t polled = 0;
    for (MeshTriangle triangle : mesh_.triangles) {
      if (++polled % 65536 == 0) context.checkCancelled();
      if (isOwn[triangle.face] == 0) continue;
      if (triangle.face != std::exchange(face, triangle.face)) addFace(face);
      ++tile_.faces.back().triangles;
      triangle.face = static_cast<Index>(tile_.faces.size()) - 1;
      for (Index& v : triangle.corners) {
        if (numbers_[v] < 0) {
          numbers_[v] = static_cast<Index>(used_.size());
          used_.push_back(v);
        }
        v = numbers_[v];
      }
      tile_.triangles.push_back(triangle);
    }
  }

  void addFace(Index face) {
    TileFace made{sourceOf(face), 0, {}};
    for (std::size_t k = 0; k < 3; ++k) made.corners[k] = source_.vertices[source_.triangles[face][k]];
    tile_.faces.push_back(made);
  }

  // Vertices outside follow all vertices of the tile's own.
  void addLink(const CellLink& link) {
    const auto numbered = [&](const std::array<Index, 2>& edge) {
      std::array<Index, 2> result{};
      for (const std::size_t i : {0, 1}) {
        const Index v = edge[i];
        if (link.isShared) isShared_[v] = 1;
        if (numbers_[v] < 0) {
          numbers_[v] = static_cast<Index>(used_.size() + outside_.size());
          outside_.push_back(v);
        }
        result[i] = numbers_[v];
      }
      return result;
    };
    const std::array<Index, 2> from = numbered(link.link.from), to = numbered(link.link.to);
    tile_.links.push_back({from, to, link.hasFrom, link.hasTo, link.link.isGap});
  }

  void addOutside(RunContext& context) {
    std::vector<MeshVertex> vertices;
    vertices.reserve(outside_.size());
    for (const Index v : outside_) vertices.push_back(mesh_.vertices[v]);
    std::vector<char> exact;
    const std::vector<Vec3> places = roundVertices(kernel_, vertices, exact, context);
    for (std::size_t i = 0; i < places.size(); ++i) {
      TileBorder name = borderOf(kernel_, vertices[i], exact[i] != 0, -1, sourceOf(vertices[i].face));
      tile_.outside.push_back({places[i], name.face, std::move(name.exact)});
    }
  }

  [[nodiscard]] std::uint32_t sourceOf(Index face) const { return sources_[source_.inputTriangles[face]]; }

  // All floors at a vertex of two tiles touch floors of both: either cell has them all, and so the same first one.
  void addBorder(Index number, const MeshVertex& vertex) {
    tile_.borders.push_back(borderOf(kernel_, vertex, tile_.exact[number] != 0, number, sourceOf(vertex.face)));
  }

  const PlanKernel& kernel_;
  const SourceMesh& source_;
  const WalkableMesh& mesh_;
  const std::vector<std::uint32_t>& sources_;  ///< number of each input triangle of the cell
  std::vector<Index> numbers_;                 ///< number in the tile of each vertex of the mesh, or -1
  std::vector<char> isShared_;                 ///< one flag per vertex of the mesh: other tiles have it, too
  std::vector<Index> used_, outside_;
  Tile tile_;
};

}  // namespace

namespace {

/// Puts the steps of a pipeline where cells run them.
class StepSorter {
 public:
  explicit StepSorter(const Pipeline& pipeline) : pipeline_(pipeline) {}

  // The switch is without a default, so that a use that is left out does not compile.
#pragma GCC diagnostic push
#pragma GCC diagnostic error "-Wswitch"
  void add(std::size_t i) {
    const PipelineStep& step = pipeline_.steps[i];
    const FilterTraits& traits = *step.filter->traits;
    switch (traits.tileUse(step.values)) {
      case TileUse::LeftOut:
        break;
      case TileUse::Never:
        fail(i, traits.tileProblem);
      case TileUse::OverTilesOnce:
        if (steps.step && isOverTilesAlready(*step.filter)) fail(i, kSecondStep);
        steps.global.push_back(step);
        break;
      case TileUse::OverTiles:
        steps.global.push_back(step);
        break;
      case TileUse::Regions: {
        if (!steps.global.empty()) fail(i, kBehindGlobal);
        std::optional<double>& minimum = steps.step ? steps.minimumLinkedArea : steps.minimumArea;
        minimum = std::max(minimum.value_or(0), step.values[0]);
        break;
      }
      case TileUse::Links:
        if (!steps.global.empty()) fail(i, kBehindGlobal);
        if (steps.step) fail(i, kSecondStep);
        steps.step = step;
        break;
      case TileUse::InCells:
        if (!steps.global.empty()) fail(i, kBehindGlobal);
        if (steps.step) fail(i, kBehindSteps);
        if (steps.minimumArea) fail(i, kBehindArea);
        steps.local.push_back(step);
        break;
    }
  }
#pragma GCC diagnostic pop

  CellSteps steps;

 private:
  [[noreturn]] void fail(std::size_t i, Pattern problem) const {
    throw InputError(problem, placeOfStep(pipeline_, i), pipeline_.steps[i].filter->name);
  }

  [[nodiscard]] bool isOverTilesAlready(const FilterDescriptor& filter) const {
    return std::ranges::any_of(steps.global, [&filter](const PipelineStep& other) { return other.filter == &filter; });
  }

  const Pipeline& pipeline_;
};

}  // namespace

CellSteps stepsOfCells(const Pipeline& pipeline) {
  StepSorter sorter(pipeline);
  for (std::size_t i = 0; i < pipeline.steps.size(); ++i)
    if (pipeline.steps[i].enabled) sorter.add(i);
  return std::move(sorter.steps);
}

FloorRule floorRuleOf(const CellSteps& steps) {
  FloorRule rule;
  bool isJoined = false;  // later filters take triangles out of a mesh that is joined
  for (const PipelineStep& step : steps.local) {
    if (step.filter->type == FilterType::Slope && !isJoined)
      rule.slopes.push_back(slopeLimit(step.values[0], step.values[1]));
    if (step.filter->type != FilterType::VerticalClearance) continue;
    isJoined = true;
    rule.height = std::max(rule.height, step.values[0]);
  }
  if (!steps.step) return rule;
  rule.step = steps.step->values[0];
  rule.gap = steps.step->values[1];
  rule.height = std::max(rule.height, rule.step);
  return rule;
}

std::optional<MadeTile> makeTile(const CellFaces& cell, const Environment& head, const Grid& grid, const CellWork& work,
                                 RunContext& context,
                                 const std::function<void(const Tile&, const ExactPlaceOf&)>& inspect) {
  if (cell.faces.soup.triangles.empty()) return MadeTile{};
  const std::vector<std::uint32_t>& numbers = cell.faces.faceNumbers;
  const StatePtr first = makeInitialState(environmentOf(cell, head), context, {}, grid);
  const SourceMesh& mesh = first->kernel->mesh();
  StatePtr last = runSteps(first, facesOfKind(mesh, cell.kinds, CellKind::Near), work.local, context);
  const std::vector<char> isOwn = facesOfKind(mesh, cell.kinds, CellKind::Own);
  if (work.step == nullptr) return MadeTile{TileMaker(*last, cell).make(isOwn, work.keepsGeometry, context, inspect)};
  if (work.dropped != nullptr) last = withoutDropped(last, numbers, *work.dropped);
  std::optional<LinkedCell> linked = withSteps(last, numbers, facesOfKind(mesh, cell.kinds, CellKind::Seen), isOwn,
                                               *work.step, cell.reach, cell.isListed, context);
  if (!linked) return std::nullopt;
  return MadeTile{TileMaker(*linked->state, cell).make(linked->isOwn, work.keepsGeometry, context, inspect),
                  std::move(linked->atGaps)};
}

}  // namespace footfall::detail
