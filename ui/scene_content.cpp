// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene_content.hpp"

#include <unordered_map>

namespace footfall {
namespace {

using Geometry = std::shared_ptr<const MeshGeometry>;

MeshBatches makeMesh(SceneBatches& batches, const Geometry& geometry, bool withLines) {
  MeshBatches made{geometry, batches.makeSurface(geometry, geometry->surface), {}, {}, {}, {}, {}};
  const bool layered = !geometry->surfaceLayers.empty();
  if (layered) {
    made.surface = batches.withLayers(made.surface, [geometry](std::size_t i) { return geometry->surfaceLayers[i]; });
  }
  if (!geometry->coarse.surface.empty()) {
    made.coarse = batches.makeSurface(geometry, geometry->coarse.surface);
    if (layered) {
      made.coarse = batches.withLayers(
          made.coarse, [geometry](std::size_t i) { return geometry->surfaceLayers[geometry->coarse.triangles[i]]; });
    }
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
  return made;
}

// The same geometry comes again and again while a run goes on, in thousands of parts: what is there already stays.
std::vector<MeshBatches> makeMeshes(SceneBatches& batches, const std::vector<Geometry>& geometries, bool withLines,
                                    const std::vector<MeshBatches>& before, const std::vector<MeshBatches>& known) {
  std::unordered_map<const MeshGeometry*, const MeshBatches*> there;
  for (const auto* list : {&known, &before}) {
    for (const MeshBatches& mesh : *list) there[mesh.geometry.get()] = &mesh;
  }
  std::vector<MeshBatches> made;
  made.reserve(geometries.size());
  for (const Geometry& geometry : geometries) {
    const auto found = there.find(geometry.get());
    made.push_back(found != there.end() ? *found->second : makeMesh(batches, geometry, withLines));
  }
  return made;
}

}  // namespace

void SceneContent::makeBatches(SceneBatches& batches, const SceneContent& before) {
  // What an edit changes is to be seen first.
  changes = makeMeshes(batches, content.changes, false, before.changes, changes);
  makeEnvironmentBatches(batches, before);
  makeFieldBatch(batches, before);
  std::vector<Geometry> removals;
  for (const ViewContent::Removed& removal : content.removed) removals.push_back(removal.before);
  removed = makeMeshes(batches, removals, false, before.removed, removed);
  walkable = makeMeshes(batches, content.walkable, true, before.walkable, walkable);
  if (!sources) {
    sourceMesh = {};
  } else if (before.sourceMesh.geometry == sources) {
    sourceMesh = before.sourceMesh;
  } else if (sourceMesh.geometry != sources) {
    sourceMesh = makeMesh(batches, sources, true);
  }
  madeEnvironment_ = environment;
  madeLayers_ = content.environmentLayers;
  madeField_ = field;
}

void SceneContent::makeEnvironmentBatches(SceneBatches& batches, const SceneContent& before) {
  if (!environment) {
    environmentSurface = environmentCoarse = environmentCreases = nullptr;
    return;
  }
  const std::shared_ptr<const EnvironmentLayers>& layers = content.environmentLayers;
  const SceneContent* const same =
      before.madeEnvironment_ == environment ? &before : (madeEnvironment_ == environment ? this : nullptr);
  if (same) {
    environmentSurface = same->environmentSurface;
    environmentCoarse = same->environmentCoarse;
    environmentCreases = same->environmentCreases;
    if (same->madeLayers_ == layers) return;
  } else {
    environmentSurface = batches.makeSurface(environment, environment->surface);
    environmentCreases = batches.makeLines(environment, environment->creases);
    environmentCoarse = environment->coarse.surface.empty()
                            ? nullptr
                            : batches.makeSurface(environment, environment->coarse.surface);
  }
  // The layers of the environment's triangles come with results.
  const bool fits = layers && layers->size() * 3 == environment->surface.size();
  if (!fits && !same) return;
  const SceneBatches::LayerOf layerOf = [layers](std::size_t i) { return (*layers)[i]; };
  const SceneBatches::LayerOf layerOfCoarse = [layers, geometry = environment](std::size_t i) {
    return (*layers)[geometry->coarse.triangles[i]];
  };
  const SceneBatches::LayersOf layersOf = [layers, geometry = environment](std::size_t i) {
    const auto of = [&](std::uint32_t triangle) { return triangle < layers->size() ? (*layers)[triangle] : kNoLayer; };
    return LineLayers{of(geometry->creaseTriangles[i][0]), of(geometry->creaseTriangles[i][1])};
  };
  environmentSurface = batches.withLayers(environmentSurface, fits ? layerOf : SceneBatches::LayerOf());
  if (environmentCoarse)
    environmentCoarse = batches.withLayers(environmentCoarse, fits ? layerOfCoarse : SceneBatches::LayerOf());
  environmentCreases = batches.withLineLayers(environmentCreases, fits ? layersOf : SceneBatches::LayersOf());
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
    fieldSurface = batches.makeField(field, field->surface);
  }
  if (!layers && !same) return;
  fieldSurface = batches.withLayers(fieldSurface, layers ? SceneBatches::LayerOf([layers, field = field](std::size_t i) {
    const std::uint32_t source = field->sources[i];
    return source < layers->size() ? (*layers)[source] : kNoLayer;
  })
                                                         : SceneBatches::LayerOf());
}

}  // namespace footfall
