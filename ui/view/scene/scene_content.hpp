// The content of a view, with the buffers made from it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "ui/view/geometry/field_geometry.hpp"
#include "ui/view/geometry/render_geometry.hpp"
#include "ui/view/scene/backdrop.hpp"
#include "ui/view/scene/scene_batches.hpp"

namespace footfall::ui {

struct MeshBatches {
  /// The geometries of these batches, which may appear again with other content.
  std::vector<std::shared_ptr<const NavigationMeshGeometry>> geometries;
  SceneBatchPtr surface, creases, outline, obstacleEdges, connections, steps, gaps, drops;
};

/// Few triangles that stand for a large environment and its content while the camera moves.
struct CoarseBatches {
  SceneBatchPtr plain;                   ///< null for small environments
  std::array<SceneBatchPtr, 3> painted;  ///< by CoarsePaints; null without a result
};

struct BackdropBatch {
  BackdropPiecePtr piece;
  SceneBatchPtr surface;
};

struct SceneContent {
  std::shared_ptr<const EnvironmentGeometry> environment;
  BackdropPtr backdrop;  ///< null for environments that are loaded as a whole
  ViewContent content;
  std::shared_ptr<const FieldGeometry> field;
  std::shared_ptr<const NavigationMeshGeometry> sources;

  // Buffers made by SceneContent::makeBatches().
  SceneBatchPtr environmentSurface, environmentCreases;
  CoarseBatches coarse;
  BackdropBatch coarseBackdrop;
  std::vector<BackdropBatch> backdropBlocks;
  SceneBatchPtr fieldSurface;
  MeshBatches sourceMesh;
  /// Where there are many small meshes, each batch has several of them.
  std::vector<MeshBatches> removed, walkable, changes;

  /// Reuses the buffers of `before`, or of an earlier call, for the same data, and makes the others, which are then
  /// uploaded.
  void makeBatches(SceneBatches& batches, const SceneContent& before);

 private:
  /// The data that the batches were made from.
  std::shared_ptr<const EnvironmentGeometry> madeEnvironment_;
  std::shared_ptr<const EnvironmentLayers> madeLayers_;
  std::shared_ptr<const FieldGeometry> madeField_;
  std::shared_ptr<const FloorStates> madeStates_;

  void makeEnvironmentBatches(SceneBatches& batches, const SceneContent& before);
  void makeCoarseBatches(SceneBatches& batches, const SceneContent& before);
  void makeFieldBatch(SceneBatches& batches, const SceneContent& before);
  void makeBackdropBatches(SceneBatches& batches, const SceneContent& before);
};

}  // namespace footfall::ui
