// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/scene/scene_pictures.hpp"

#include <algorithm>
#include <utility>

namespace footfall::ui {
namespace {

constexpr double kGoMs = 12;            // aimed time of one pass, between two readings of the clock
constexpr std::int64_t kLeastGo = 256;  // in units of DrawingSlice
constexpr std::int64_t kMostGo = 4'000'000;
constexpr int kManyChanges = 60'000;  // triangles: more become part of the picture

// Returns whether the picture is new.
bool preparePicture(std::unique_ptr<QOpenGLFramebufferObject>& picture, const QSize& size) {
  if (picture && picture->isValid() && picture->size() == size) return false;
  picture = std::make_unique<QOpenGLFramebufferObject>(size, QOpenGLFramebufferObject::CombinedDepthStencil);
  return true;
}

double msSince(std::chrono::steady_clock::time_point begun) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
}

}  // namespace

void ScenePictures::release() {
  for (Picture* picture : {&still_, &next_, &picture_}) picture->reset();
  stillKey_ = {};
  nextKey_ = pictureKey_ = {};
}

PictureKey ScenePictures::keyOf(const SceneContent& scene, const SceneCamera& camera, const SceneParts& parts) const {
  PictureKey key;
  key.still = {scene.environment, scene.backdrop, scene.content.environmentLayers, batches_.hiddenLayers(),
               painter_.stillLook(scene, camera, parts)};
  key.parts = parts;
  if (isHeatMap(parts.mode)) {
    key.field = scene.field;
    key.scale = painter_.fieldScale();
  }
  if (parts.mode == ViewMode::SourceTriangles) key.surfaces = {scene.sources, nullptr};
  const CellPainter& cells = std::as_const(painter_).cells();
  if (cells.isShown(parts)) {
    key.cells = cells.geometry();
    key.cellColours = cells.version();
  }
  std::vector<const std::vector<MeshBatches>*> lists{&scene.removed, &scene.walkable};
  if (holds(scene.changes)) lists.push_back(&scene.changes);
  for (const auto* batches : lists) {
    for (const MeshBatches& mesh : *batches)
      key.surfaces.insert(key.surfaces.end(), mesh.geometries.begin(), mesh.geometries.end());
    key.surfaces.push_back(nullptr);  // marks the end of a list
  }
  return key;
}

bool ScenePictures::holds(const std::vector<MeshBatches>& changes) {
  int triangles = 0;
  for (const MeshBatches& mesh : changes) triangles += mesh.surface->count;
  return triangles > kManyChanges;
}

void ScenePictures::want(std::optional<PictureKey> key) {
  wanted_.reset();
  if (key && !(pictureKey_ == *key)) wanted_ = std::move(key);
}

void ScenePictures::dropUnfinished() {
  wanted_.reset();
  nextKey_ = {};
  if (!stillComplete_) stillKey_ = {};
}

void ScenePictures::forget() { pictureKey_ = nextKey_ = {}; }

bool ScenePictures::copyTo(GLuint frame, const SceneCamera& camera) {
  return canKeep_ && picture_ && pictureKey_.still.look.camera == camera && copy(*picture_, frame);
}

bool ScenePictures::copy(const QOpenGLFramebufferObject& picture, GLuint frame) {
  const QSize size = picture.size();
  glBindFramebuffer(GL_READ_FRAMEBUFFER, picture.handle());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, frame);
  while (glGetError() != GL_NO_ERROR) {
  }
  glBlitFramebuffer(0, 0, size.width(), size.height(), 0, 0, size.width(), size.height(),
                    GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  const bool copied = glGetError() == GL_NO_ERROR;
  glBindFramebuffer(GL_FRAMEBUFFER, frame);
  return copied;
}

// Draws one pass of the picture of the environment alone.
void ScenePictures::goOnWithStill(const SceneContent& scene, const PictureKey::Still& key) {
  const bool made = preparePicture(still_, key.look.camera.viewport);
  canKeep_ = still_->bind();
  if (!canKeep_) return;
  if (made || !(stillKey_ == key)) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    stillKey_ = key;
    stillComplete_ = false;
    stillMs_ = 0;
    stillSlice_.restart();
  }
  const Clock::time_point begun = beginGo(stillSlice_);
  painter_.drawStill(scene, key.look, scene.environmentSurface);
  stillComplete_ = endGo(begun, stillSlice_, stillMs_);
}

// Draws one pass of the content; returns whether it is complete.
bool ScenePictures::goOnWithContent(const SceneContent& scene, const PictureKey& key) {
  const SceneCamera& camera = key.still.look.camera;
  const bool made = preparePicture(next_, camera.viewport);
  canKeep_ = next_->bind();
  if (!canKeep_) return false;
  if (made || !(nextKey_ == key)) {
    nextKey_ = {};
    canKeep_ = copy(*still_, next_->handle());
    if (!canKeep_) return false;
    nextKey_ = key;
    nextMs_ = 0;
    nextSlice_.restart();
  }
  const Clock::time_point begun = beginGo(nextSlice_);
  painter_.drawContent(scene, camera, key.parts);
  if (holds(scene.changes)) painter_.drawChanges(scene, camera, key.parts, scene.changes);
  return endGo(begun, nextSlice_, nextMs_);
}

ScenePictures::Clock::time_point ScenePictures::beginGo(DrawingSlice& slice) {
  painter_.strokes().setSlice(&slice);
  slice.begin(goSize_);
  return Clock::now();
}

bool ScenePictures::endGo(Clock::time_point begun, DrawingSlice& slice, double& sum) {
  const bool complete = slice.end();
  painter_.strokes().setSlice(nullptr);
  glFinish();  // software OpenGL continues after the call
  const double ms = msSince(begun);
  sum += ms;
  // The size approaches the aim cautiously, because the next primitives may be larger.
  const double factor = ms > 0 ? std::clamp(kGoMs / ms, 0.1, 2.0) : 2.0;
  if (slice.spent() >= goSize_ || factor < 1)
    goSize_ = std::clamp(static_cast<std::int64_t>(static_cast<double>(goSize_) * factor), kLeastGo, kMostGo);
  return complete;
}

bool ScenePictures::goOn(const SceneContent& scene, double ms) {
  if (!wanted_) return false;
  const Clock::time_point begun = Clock::now();
  GLint frame = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &frame);
  GLint viewport[4];
  glGetIntegerv(GL_VIEWPORT, viewport);
  const QSize size = wanted_->still.look.camera.viewport;
  glViewport(0, 0, size.width(), size.height());
  painter_.prepareState();
  do {
    if (!stillComplete_ || !(stillKey_ == wanted_->still)) {
      goOnWithStill(scene, wanted_->still);
    } else if (goOnWithContent(scene, *wanted_)) {
      std::swap(picture_, next_);
      pictureKey_ = std::exchange(nextKey_, {});
      wholeMs_ = stillMs_ + nextMs_;
      wanted_.reset();
    }
    if (!canKeep_) wanted_.reset();
  } while (wanted_ && msSince(begun) < ms);
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(frame));
  glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  return !wanted_;
}

}  // namespace footfall::ui
