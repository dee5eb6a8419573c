// SPDX-License-Identifier: GPL-3.0-or-later
// SceneRenderer's pictures: kept ones, and how they are made a slice at a time.
#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

#include "ui/view/coarse_geometry.hpp"
#include "ui/view/gl_state.hpp"
#include "ui/view/scene_renderer.hpp"

namespace footfall::ui {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kGoMs = 12;            // aim of one go: what comes between two looks at the clock
constexpr std::int64_t kLeastGo = 256;  // as DrawingSlice counts
constexpr std::int64_t kMostGo = 4'000'000;
constexpr int kManyChanges = 60'000;  // triangles: more become part of the picture

// Returns whether the picture is new.
bool preparePicture(std::unique_ptr<QOpenGLFramebufferObject>& picture, const QSize& size) {
  if (picture && picture->isValid() && picture->size() == size) return false;
  picture = std::make_unique<QOpenGLFramebufferObject>(size, QOpenGLFramebufferObject::CombinedDepthStencil);
  return true;
}

double msSince(Clock::time_point begun) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
}

}  // namespace

SceneRenderer::ContentKey SceneRenderer::contentKey(const StillKey& still, const SceneParts& parts) const {
  ContentKey key{still, parts, {}, {}, 0, nullptr, {}};
  if (isHeatMap(parts.mode)) {
    key.field = scene_.field;
    key.scale = fieldScale_;
  }
  if (parts.mode == ViewMode::SourceTriangles) key.surfaces = {scene_.sources, nullptr};
  if (showsCells(parts)) {
    key.cells = cells_.geometry();
    key.cellColours = cells_.version();
  }
  std::vector<const std::vector<MeshBatches>*> lists{&scene_.removed, &scene_.walkable};
  if (inPicture(scene_.changes)) lists.push_back(&scene_.changes);
  for (const auto* batches : lists) {
    for (const MeshBatches& mesh : *batches)
      key.surfaces.insert(key.surfaces.end(), mesh.geometries.begin(), mesh.geometries.end());
    key.surfaces.push_back(nullptr);  // where one list ends
  }
  return key;
}

bool SceneRenderer::copyToFrame(const QOpenGLFramebufferObject& picture, GLuint frame) {
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

bool SceneRenderer::inPicture(const std::vector<MeshBatches>& changes) {
  int triangles = 0;
  for (const MeshBatches& mesh : changes) triangles += mesh.surface->count;
  return triangles > kManyChanges;
}

void SceneRenderer::dropUnfinished() {
  wanted_.reset();
  nextKey_ = {};
  if (!stillComplete_) stillKey_ = {};
}

// One go at the picture of the environment alone.
void SceneRenderer::goOnWithStill(const StillKey& key) {
  const bool made = preparePicture(still_, key.camera.viewport);
  keepsPictures_ = still_->bind();
  if (!keepsPictures_) return;
  if (made || !(stillKey_ == key)) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    stillKey_ = key;
    stillComplete_ = false;
    stillMs_ = 0;
    stillSlice_.restart();
  }
  const Clock::time_point begun = beginGo(stillSlice_);
  drawStill(key, scene_.environmentSurface);
  stillComplete_ = endGo(begun, stillMs_);
}

// The same for what is on it; returns whether that is complete.
bool SceneRenderer::goOnWithContent(const ContentKey& key) {
  const bool made = preparePicture(next_, key.still.camera.viewport);
  keepsPictures_ = next_->bind();
  if (!keepsPictures_) return false;
  if (made || !(nextKey_ == key)) {
    nextKey_ = {};
    keepsPictures_ = copyToFrame(*still_, next_->handle());
    if (!keepsPictures_) return false;
    nextKey_ = key;
    nextMs_ = 0;
    nextSlice_.restart();
  }
  const Clock::time_point begun = beginGo(nextSlice_);
  drawContent(key.still.camera, key.parts);
  if (inPicture(scene_.changes)) drawChanges(key.still.camera, key.parts, scene_.changes);
  return endGo(begun, nextMs_);
}

Clock::time_point SceneRenderer::beginGo(DrawingSlice& slice) {
  slice_ = &slice;
  slice.begin(goSize_);
  return Clock::now();
}

bool SceneRenderer::endGo(Clock::time_point begun, double& sum) {
  const bool complete = slice_->end();
  glFinish();  // software OpenGL works on after the call
  const double ms = msSince(begun);
  sum += ms;
  // Towards the aim, but carefully: the next primitives may be larger.
  const double factor = ms > 0 ? std::clamp(kGoMs / ms, 0.1, 2.0) : 2.0;
  if (slice_->spent() >= goSize_ || factor < 1)
    goSize_ = std::clamp(static_cast<std::int64_t>(static_cast<double>(goSize_) * factor), kLeastGo, kMostGo);
  slice_ = &whole_;
  return complete;
}

void SceneRenderer::prepareState() {
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
}

bool SceneRenderer::advance(double ms) {
  const GlStateKeeper kept;
  const Clock::time_point begun = Clock::now();
  const bool uploaded = uploadComing(ms);
  return (!wanted_ && uploaded) || goOn(ms - msSince(begun));
}

// With the picture that is wanted; returns whether one is complete now that was not before.
bool SceneRenderer::goOn(double ms) {
  if (!wanted_) return false;
  const Clock::time_point begun = Clock::now();
  GLint frame = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &frame);
  GLint viewport[4];
  glGetIntegerv(GL_VIEWPORT, viewport);
  const QSize size = wanted_->still.camera.viewport;
  glViewport(0, 0, size.width(), size.height());
  prepareState();
  do {
    if (!stillComplete_ || !(stillKey_ == wanted_->still)) {
      goOnWithStill(wanted_->still);
    } else if (goOnWithContent(*wanted_)) {
      std::swap(picture_, next_);
      pictureKey_ = std::exchange(nextKey_, {});
      wholeMs_ = stillMs_ + nextMs_;
      wanted_.reset();
    }
    if (!keepsPictures_) wanted_.reset();
  } while (wanted_ && msSince(begun) < ms);
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(frame));
  glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  return !wanted_;
}

// `key`: of what is shown now. A picture of it that has been begun is finished first, or changes that come quickly
// would never let one be seen; what an edit changes is shown at once.
void SceneRenderer::takeComing(const ContentKey& key) {
  if (wanted_ && *wanted_ == key) {
    scene_.content.changes = coming_->content.changes;
    scene_.changes = coming_->changes;
    return;
  }
  scene_ = std::move(*coming_);
  coming_.reset();
}

SceneRule sceneRule(const SceneParts& parts, const ViewContent& content, const EnvironmentGeometry* environment,
                    const QVector3D& viewDirection) {
  SceneFacts facts;
  facts.reasons = content.firstRemoval != nullptr;
  facts.bothSides = environment && environment->bothSides;
  facts.down = -static_cast<double>(viewDirection.z());
  return {parts, facts};
}

SceneRule SceneRenderer::rule(const SceneCamera& camera, const SceneParts& parts) const {
  return sceneRule(parts, scene_.content, scene_.environment.get(), camera.viewDirection);
}

SceneRenderer::StillKey SceneRenderer::stillKey(const SceneCamera& camera, const SceneParts& parts) const {
  const SceneRule rule = this->rule(camera, parts);
  Paint floor = undecidedPaint();
  if (rule.reasons) {
    floor =
        parts.mode == ViewMode::RejectedBy ? scene_.content.firstRemoval->vivid : scene_.content.firstRemoval->paint;
  }
  // Behind everything that may come on top: a step for each of it, but the same for a few more or less.
  constexpr std::size_t kSteps = 4;
  const auto offset = static_cast<float>((scene_.removed.size() / kSteps + 1) * kSteps);
  const bool creases = rule.environment == SceneRule::Environment::All && parts.outlines && !rule.wires;
  return {scene_.environment,
          scene_.content.environmentLayers,
          batches_.hiddenLayers(),
          camera,
          parts.mode,
          rule.environment,
          rule.backs,
          rule.covers,
          creases,
          floor,
          offset,
          showsCells(parts) ? kUnderCells : 0};
}

// Hurried, a large environment is drawn coarse, with what is on it as paint; all else without its lines.
void SceneRenderer::drawDirectly(StillKey key, SceneParts parts, bool hurried) {
  const CoarseBatches& coarse = scene_.coarse;
  if (hurried && coarse.plain && key.drawn == SceneRule::Environment::All && parts.walkable) {
    const bool vivid = parts.mode == ViewMode::RejectedBy;
    const CoarsePaints paints = !parts.removed ? CoarsePaints::WalkableOnly
                                : vivid        ? CoarsePaints::Vivid
                                               : CoarsePaints::Result;
    const BatchPtr& painted = coarse.painted[static_cast<std::size_t>(paints)];
    key.creases = false;
    drawStill(key, painted && (vivid || parts.mode == ViewMode::Result) ? painted : coarse.plain);
    return;
  }
  parts.outlines = parts.outlines && !hurried;
  key.creases = key.creases && !hurried;
  drawStill(key, scene_.environmentSurface);
  drawContent(key.camera, parts);
}

bool SceneRenderer::draw(const SceneCamera& camera, const SceneParts& parts, const Haste& haste) {
  const GlStateKeeper keeper;
  uploadBorders();
  prepareState();
  const bool kept = !haste.moving && keepsPictures_;
  bool whole = false;
  StillKey still;
  for (;;) {
    const bool uploaded = uploadComing(haste.ms);
    still = stillKey(camera, parts);
    ContentKey key = contentKey(still, parts);
    if (coming_ && uploaded) {
      takeComing(key);
      still = stillKey(camera, parts);
      key = contentKey(still, parts);
    }
    wanted_.reset();
    if (kept && !(pictureKey_ == key)) wanted_ = std::move(key);
    goOn(haste.ms);
    whole = !wanted_ && !coming_;
    // Without haste, what came after the picture that had been begun is waited for as well.
    if (whole || haste.ms < std::numeric_limits<double>::infinity()) break;
  }
  GLint frame = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &frame);
  // Until a picture is complete, the one before stands for it, if one looks from the same place.
  const bool copied = kept && keepsPictures_ && picture_ && pictureKey_.still.camera == camera &&
                      copyToFrame(*picture_, static_cast<GLuint>(frame));
  if (!copied) {
    drawDirectly(still, parts, haste.hurried && (haste.moving || !whole));
  }
  const bool before = copied && !whole && scene_.changes.empty();
  const std::vector<MeshBatches>& changes = before ? shownChanges_ : scene_.changes;
  if (!copied || !inPicture(changes)) drawChanges(camera, parts, changes);
  if (!before) shownChanges_ = scene_.changes;
  drawMarkedCells(camera, parts);
  return whole;
}

}  // namespace footfall::ui
