// Pictures of a scene that are drawn a slice at a time and kept while the camera rests.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLFramebufferObject>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "ui/view/drawing_slice.hpp"
#include "ui/view/scene_content.hpp"
#include "ui/view/scene_painter.hpp"

namespace footfall::ui {

/// All that a picture depends on: two pictures of the same key are the same.
struct PictureKey {
  /// All that the environment alone depends on.
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

/// Two pictures: of the environment alone, and of it with the content and the cells but without changes and marks. Each
/// is drawn into a buffer of its own, over several goes. Needs an OpenGL context from initialize() to release().
class ScenePictures : protected QOpenGLExtraFunctions {
 public:
  ScenePictures(ScenePainter& painter, SceneBatches& batches) : painter_(painter), batches_(batches) {}

  void initialize() { initializeOpenGLFunctions(); }
  void release();
  /// False once OpenGL has turned out not to be able to keep any.
  [[nodiscard]] bool canKeep() const { return canKeep_; }

  [[nodiscard]] PictureKey keyOf(const SceneContent& scene, const SceneCamera& camera, const SceneParts& parts) const;
  /// Whether so many changes become part of the picture.
  static bool holds(const std::vector<MeshBatches>& changes);

  /// The picture that goOn() draws; nothing: none. A picture that is complete needs no drawing.
  void want(std::optional<PictureKey> key);
  [[nodiscard]] bool wants(const PictureKey& key) const { return wanted_ && *wanted_ == key; }
  [[nodiscard]] bool isWanting() const { return wanted_.has_value(); }
  /// Draws for about so long; returns whether the wanted picture is complete now and was not before.
  bool goOn(const SceneContent& scene, double ms);
  /// What has been begun is not wanted any more.
  void dropUnfinished();
  /// Nor is the complete picture to be shown again.
  void forget();

  /// Copies the complete picture to a frame buffer, if it was drawn from there; returns whether it did.
  bool copyTo(GLuint frame, const SceneCamera& camera);
  /// How long the last complete picture took; 0 before the first.
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
  std::int64_t goSize_ = 1024;  ///< of one go
  double stillMs_ = 0, nextMs_ = 0, wholeMs_ = 0;
};

}  // namespace footfall::ui
