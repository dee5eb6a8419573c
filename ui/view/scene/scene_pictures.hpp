// Pictures of a scene that are drawn in slices and kept while the camera rests.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLFramebufferObject>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "ui/view/scene/drawing_slice.hpp"
#include "ui/view/scene/scene_content.hpp"
#include "ui/view/scene/scene_painter.hpp"

namespace footfall::ui {

/// All data that a picture depends on: pictures with equal keys are equal.
struct PictureKey {
  /// All data that the picture of the environment alone depends on.
  struct Still {
    std::shared_ptr<const EnvironmentGeometry> environment;
    BackdropPtr backdrop;
    std::shared_ptr<const EnvironmentLayers> layers;
    std::set<std::uint32_t> hidden;
    StillLook look;
    bool operator==(const Still&) const = default;
  };
  Still still;
  SceneParts parts;
  std::vector<std::shared_ptr<const NavigationMeshGeometry>> surfaces;
  std::shared_ptr<const CellGeometry> cells;
  int cellColours = 0;
  std::shared_ptr<const FieldGeometry> field;
  FieldScale scale;
  bool operator==(const PictureKey&) const = default;
};

/// Keeps two pictures: of the environment alone, and of the environment with content and cells, but without changes and
/// marks. Each is drawn into a buffer of its own, in several passes. Needs an OpenGL context from initialize() to
/// release().
class ScenePictures : protected QOpenGLExtraFunctions {
 public:
  ScenePictures(ScenePainter& painter, SceneBatches& batches) : painter_(painter), batches_(batches) {}

  void initialize() { initializeOpenGLFunctions(); }
  void release();
  /// False once OpenGL has failed to keep a picture.
  [[nodiscard]] bool canKeep() const { return canKeep_; }

  [[nodiscard]] PictureKey keyOf(const SceneContent& scene, const SceneCamera& camera, const SceneParts& parts) const;
  /// Returns whether this many changes become part of the picture.
  static bool holds(const std::vector<MeshBatches>& changes);

  /// Sets the picture that goOn() draws; empty: none. A complete picture needs no drawing.
  void want(std::optional<PictureKey> key);
  [[nodiscard]] bool wants(const PictureKey& key) const { return wanted_ && *wanted_ == key; }
  [[nodiscard]] bool isWanting() const { return wanted_.has_value(); }
  /// Draws for about `ms`; returns whether the wanted picture has become complete.
  bool goOn(const SceneContent& scene, double ms);
  /// Drops an unfinished picture.
  void dropUnfinished();
  /// Also drops the complete picture.
  void forget();

  /// Copies the complete picture to a frame buffer, if it was drawn with this camera; returns whether it did.
  bool copyTo(GLuint frame, const SceneCamera& camera);
  /// Time of the last complete picture; 0 before the first.
  [[nodiscard]] double wholeMs() const { return wholeMs_; }

 private:
  using Picture = std::unique_ptr<QOpenGLFramebufferObject>;  ///< colour and depth
  using Clock = std::chrono::steady_clock;

  void goOnWithStill(const SceneContent& scene, const PictureKey::Still& key);
  bool goOnWithContent(const SceneContent& scene, const PictureKey& key);
  Clock::time_point beginGo(DrawingSlice& slice);
  bool endGo(Clock::time_point begun, DrawingSlice& slice, double& sum);
  bool copy(const QOpenGLFramebufferObject& picture, GLuint frame);

  ScenePainter& painter_;
  SceneBatches& batches_;
  Picture still_;  ///< belongs to stillKey_
  PictureKey::Still stillKey_;
  bool stillComplete_ = false;
  Picture picture_;  ///< belongs to pictureKey_, complete
  PictureKey pictureKey_;
  Picture next_;  ///< belongs to nextKey_, not complete
  PictureKey nextKey_;
  std::optional<PictureKey> wanted_;
  DrawingSlice stillSlice_, nextSlice_;
  bool canKeep_ = true;
  std::int64_t goSize_ = 1024;  ///< for one pass
  double stillMs_ = 0, nextMs_ = 0, wholeMs_ = 0;
};

}  // namespace footfall::ui
