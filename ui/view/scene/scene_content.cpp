// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/scene/scene_content.hpp"

#include <unordered_map>
#include <utility>

#include "ui/view/geometry/coarse_geometry.hpp"

namespace footfall::ui {
namespace {

using Geometry = std::shared_ptr<const NavigationMeshGeometry>;

// Marks pieces that lie on covers, one geometry after the other; null where there are none.
SceneBatches::CoversPtr coversOf(const std::vector<Geometry>& geometries, const EnvironmentGeometry* environment) {
  if (!environment || !environment->covered) return nullptr;
  auto covers = std::make_shared<std::vector<bool>>();
  bool any = false;
  for (const Geometry& geometry : geometries) {
    const std::size_t triangles = geometry->surface.size() / 3;
    for (std::size_t t = 0; t < triangles; ++t) {
      covers->push_back(t < geometry->sources.size() && environment->isCover(geometry->sources[t]));
      any = any || covers->back();
    }
  }
  return any ? covers : nullptr;
}

MeshBatches makeMesh(SceneBatches& batches, const Geometry& geometry, bool withLines,
                     const EnvironmentGeometry* environment) {
  const SceneBatches::CoversPtr covers = coversOf({geometry}, environment);
  MeshBatches made;
  made.geometries = {geometry};
  made.surface = batches.makeSurface(geometry, geometry->surface, covers);
  const bool layered = !geometry->surfaceLayers.empty();
  if (layered) {
    made.surface = batches.withLayers(made.surface, [geometry](std::size_t i) { return geometry->surfaceLayers[i]; });
  }
  if (!withLines) return made;
  const auto lines = [&](const std::vector<LineSegment>& segments, const std::vector<LineLayers>& layers) {
    const SceneBatchPtr batch = batches.makeLines(geometry, segments);
    if (layers.size() != segments.size()) return batch;
    return batches.withLineLayers(batch, [geometry, &layers](std::size_t i) { return layers[i]; });
  };
  made.creases = lines(geometry->creases, geometry->creaseLayers);
  made.outline = lines(geometry->outline, geometry->outlineLayers);
  made.obstacleEdges = lines(geometry->obstacleEdges, geometry->obstacleEdgeLayers);
  made.connections = lines(geometry->connections, geometry->connectionLayers);
  made.steps = lines(geometry->steps, geometry->stepLayers);
  made.gaps = lines(geometry->gaps, geometry->gapLayers);
  made.drops = lines(geometry->drops, geometry->dropLayers);
  return made;
}

bool hasOnly(const MeshBatches& mesh, const Geometry& geometry) { return mesh.geometries == std::vector{geometry}; }

// Returns whether geometry is an intermediate part of a run: without layers, and small.
bool isPart(const NavigationMeshGeometry& geometry) {
  constexpr std::size_t kSmall = 3 * 2000;  // corners
  return geometry.surface.size() < kSmall && geometry.surfaceLayers.empty() && geometry.creaseLayers.empty();
}

MeshBatches makeGroup(SceneBatches& batches, const std::vector<Geometry>& geometries, bool withLines,
                      const EnvironmentGeometry* environment) {
  const auto joined = [&]<typename Element>(std::vector<Element> NavigationMeshGeometry::*member) {
    SceneBatches::Joined<Element> elements;
    for (const Geometry& geometry : geometries) elements.push_back({geometry, &((*geometry).*member)});
    return elements;
  };
  MeshBatches made;
  made.geometries = geometries;
  made.surface = batches.makeSurface(joined(&NavigationMeshGeometry::surface), coversOf(geometries, environment));
  if (!withLines) return made;
  made.creases = batches.makeLines(joined(&NavigationMeshGeometry::creases));
  made.outline = batches.makeLines(joined(&NavigationMeshGeometry::outline));
  made.obstacleEdges = batches.makeLines(joined(&NavigationMeshGeometry::obstacleEdges));
  made.connections = batches.makeLines(joined(&NavigationMeshGeometry::connections));
  made.steps = batches.makeLines(joined(&NavigationMeshGeometry::steps));
  made.gaps = batches.makeLines(joined(&NavigationMeshGeometry::gaps));
  made.drops = batches.makeLines(joined(&NavigationMeshGeometry::drops));
  return made;
}

// During a run, the same geometry appears again and again in thousands of parts. Existing batches are reused, and
// consecutive parts are drawn together.
std::vector<MeshBatches> makeMeshes(SceneBatches& batches, const std::vector<Geometry>& geometries, bool withLines,
                                    const std::vector<MeshBatches>& before, const std::vector<MeshBatches>& known,
                                    const EnvironmentGeometry* environment) {
  constexpr std::size_t kGroup = 64;
  std::unordered_map<const NavigationMeshGeometry*, const MeshBatches*> there;  // by the first of their geometries
  for (const auto* list : {&known, &before}) {
    for (const MeshBatches& mesh : *list) there[mesh.geometries.front().get()] = &mesh;
  }
  std::vector<MeshBatches> made;
  for (std::size_t i = 0; i < geometries.size();) {
    std::size_t end = i + 1;
    while (geometries.size() > kGroup && isPart(*geometries[i]) && end < geometries.size() && end < i + kGroup &&
           isPart(*geometries[end]))
      ++end;
    const std::vector<Geometry> group(geometries.begin() + static_cast<std::ptrdiff_t>(i),
                                      geometries.begin() + static_cast<std::ptrdiff_t>(end));
    const auto found = there.find(group.front().get());
    if (found != there.end() && found->second->geometries == group) {
      made.push_back(*found->second);
    } else if (group.size() > 1) {
      made.push_back(makeGroup(batches, group, withLines, environment));
    } else {
      made.push_back(makeMesh(batches, group.front(), withLines, environment));
    }
    i = end;
  }
  return made;
}

}  // namespace

void SceneContent::makeBatches(SceneBatches& batches, const SceneContent& before) {
  // The changes of an edit are uploaded first.
  const EnvironmentGeometry* const level = environment.get();
  changes = makeMeshes(batches, content.changes, false, before.changes, changes, level);
  makeEnvironmentBatches(batches, before);
  makeCoarseBatches(batches, before);
  makeFieldBatch(batches, before);
  makeBackdropBatches(batches, before);
  std::vector<Geometry> removals;
  for (const ViewContent::Removed& removal : content.removed) removals.push_back(removal.before);
  removed = makeMeshes(batches, removals, false, before.removed, removed, level);
  walkable = makeMeshes(batches, content.walkable, true, before.walkable, walkable, level);
  if (!sources) {
    sourceMesh = {};
  } else if (hasOnly(before.sourceMesh, sources)) {
    sourceMesh = before.sourceMesh;
  } else if (!hasOnly(sourceMesh, sources)) {
    sourceMesh = makeMesh(batches, sources, true, level);
  }
  madeEnvironment_ = environment;
  madeLayers_ = content.environmentLayers;
  madeField_ = field;
  madeStates_ = content.floorStates;
}

void SceneContent::makeEnvironmentBatches(SceneBatches& batches, const SceneContent& before) {
  if (!environment) {
    environmentSurface = environmentCreases = nullptr;
    return;
  }
  const std::shared_ptr<const EnvironmentLayers>& layers = content.environmentLayers;
  const SceneContent* const same =
      before.madeEnvironment_ == environment ? &before : (madeEnvironment_ == environment ? this : nullptr);
  if (same) {
    environmentSurface = same->environmentSurface;
    environmentCreases = same->environmentCreases;
    if (same->madeLayers_ == layers) return;
  } else {
    environmentSurface = batches.makeSurface(environment, environment->surface);
    environmentCreases = batches.makeLines(environment, environment->creases);
  }
  // The layers of the environment's triangles belong to a result.
  const bool fits = layers && layers->size() * 3 == environment->surface.size();
  if (!fits && !same) return;
  const SceneBatches::LayerOf layerOf = [layers](std::size_t i) { return (*layers)[i]; };
  const SceneBatches::LayersOf layersOf = [layers, geometry = environment](std::size_t i) {
    const auto of = [&](std::uint32_t triangle) { return triangle < layers->size() ? (*layers)[triangle] : kNoLayer; };
    return LineLayers{of(geometry->creaseTriangles[i][0]), of(geometry->creaseTriangles[i][1])};
  };
  environmentSurface = batches.withLayers(environmentSurface, fits ? layerOf : SceneBatches::LayerOf());
  environmentCreases = batches.withLineLayers(environmentCreases, fits ? layersOf : SceneBatches::LayersOf());
}

void SceneContent::makeCoarseBatches(SceneBatches& batches, const SceneContent& before) {
  if (!environment || environment->coarse.surface.empty()) {
    coarse = {};
    return;
  }
  const SceneContent* const same =
      before.madeEnvironment_ == environment ? &before : (madeEnvironment_ == environment ? this : nullptr);
  if (same && same->madeStates_ == content.floorStates && same->madeLayers_ == content.environmentLayers) {
    coarse = same->coarse;
    return;
  }
  const std::shared_ptr<const EnvironmentLayers>& layers = content.environmentLayers;
  const bool layered = layers && layers->size() * 3 == environment->surface.size();
  const auto make = [&](const SceneBatches::Owner& owner, const std::vector<SurfaceVertex>& surface) {
    const SceneBatchPtr batch = batches.makeSurface(owner, surface);
    if (!layered) return batch;
    return batches.withLayers(
        batch, [layers, geometry = environment](std::size_t i) { return (*layers)[geometry->coarse.triangles[i]]; });
  };
  coarse.plain = make(environment, environment->coarse.surface);
  coarse.painted = {};
  if (!content.floorStates) return;
  for (const CoarsePaints paints : {CoarsePaints::Result, CoarsePaints::Vivid, CoarsePaints::WalkableOnly}) {
    const auto painted =
        std::make_shared<const std::vector<SurfaceVertex>>(paintedCoarse(environment->coarse, content, paints));
    coarse.painted[static_cast<std::size_t>(paints)] = make(painted, *painted);
  }
}

// Blocks are added and removed while the others stay.
void SceneContent::makeBackdropBatches(SceneBatches& batches, const SceneContent& before) {
  std::unordered_map<const BackdropPiece*, SceneBatchPtr> there;
  for (const SceneContent* content : {static_cast<const SceneContent*>(this), &before}) {
    there[content->coarseBackdrop.piece.get()] = content->coarseBackdrop.surface;
    for (const BackdropBatch& block : content->backdropBlocks) there[block.piece.get()] = block.surface;
  }
  const auto make = [&](const BackdropPiecePtr& piece) {
    const auto found = there.find(piece.get());
    return BackdropBatch{piece, found != there.end() ? found->second : batches.makeSurface(piece, piece->surface)};
  };
  std::vector<BackdropBatch> blocks;
  if (backdrop)
    for (const BackdropPiecePtr& piece : backdrop->loaded) blocks.push_back(make(piece));
  coarseBackdrop = backdrop && backdrop->coarse ? make(backdrop->coarse) : BackdropBatch{};
  backdropBlocks = std::move(blocks);
}

void SceneContent::makeFieldBatch(SceneBatches& batches, const SceneContent& before) {
  if (!field) {
    fieldSurface = nullptr;
    return;
  }
  const std::shared_ptr<const EnvironmentLayers>& layers = content.environmentLayers;
  const SceneContent* const same = before.madeField_ == field ? &before : (madeField_ == field ? this : nullptr);
  if (same) {
    fieldSurface = same->fieldSurface;
    if (same->madeLayers_ == layers) return;
  } else {
    SceneBatches::CoversPtr covers;
    if (environment && environment->covered) {
      std::vector<bool> found;
      for (const std::uint32_t source : field->sources) found.push_back(environment->isCover(source));
      covers = std::make_shared<const std::vector<bool>>(std::move(found));
    }
    fieldSurface = batches.makeField(field, field->surface, covers);
  }
  if (!layers && !same) return;
  fieldSurface =
      batches.withLayers(fieldSurface, layers ? SceneBatches::LayerOf([layers, field = field](std::size_t i) {
                           const std::uint32_t source = field->sources[i];
                           return source < layers->size() ? (*layers)[source] : kNoLayer;
                         })
                                              : SceneBatches::LayerOf());
}

}  // namespace footfall::ui
