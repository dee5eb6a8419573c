// All that a view shows, with the buffers made of it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "ui/view/backdrop.hpp"
#include "ui/view/field_geometry.hpp"
#include "ui/view/render_geometry.hpp"
#include "ui/view/scene_batches.hpp"

namespace footfall::ui {

struct MeshBatches {
  /// What they were made of, which may come again with other content.
  std::vector<std::shared_ptr<const NavigationMeshGeometry>> geometries;
  SceneBatchPtr surface, creases, outline, obstacleEdges, connections, steps, gaps, drops;
};

/// Few triangles that stand for a large environment and what is on it, while the camera moves.
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

  // Of the above, by SceneContent::makeBatches().
  SceneBatchPtr environmentSurface, environmentCreases;
  CoarseBatches coarse;
  BackdropBatch coarseBackdrop;
  std::vector<BackdropBatch> backdropBlocks;
  SceneBatchPtr fieldSurface;
  MeshBatches sourceMesh;
  /// Where there are many small meshes, each of these is made of several.
  std::vector<MeshBatches> removed, walkable, changes;

  /// Reuses what `before` has of the same, or what the content itself has of an earlier call, and makes the rest,
  /// which is then to be uploaded.
  void makeBatches(SceneBatches& batches, const SceneContent& before);

 private:
  /// What the batches were made of.
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
