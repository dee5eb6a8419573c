// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/scene/scene_renderer.hpp"

#include <QElapsedTimer>
#include <limits>
#include <utility>

#include "ui/view/geometry/coarse_geometry.hpp"
#include "ui/view/scene/gl_state.hpp"

namespace footfall::ui {

QString SceneRenderer::initialize() {
  initializeOpenGLFunctions();
  const QString problem = painter_.initialize();
  if (!problem.isEmpty()) return problem;
  pictures_.initialize();
  batches_.initialize();
  // All buffers are made again in another context.
  const SceneContent known = coming_ ? *coming_ : scene_;
  scene_ = {};
  coming_.reset();
  coming().environment = known.environment;
  coming().backdrop = known.backdrop;
  coming().content = known.content;
  coming().field = known.field;
  coming().sources = known.sources;
  return {};
}

void SceneRenderer::release() {
  scene_ = {};
  coming_.reset();
  shownChanges_.clear();
  painter_.release();
  batches_.release();
  pictures_.release();
}

// The present content stays until the new buffers are full.
SceneContent& SceneRenderer::coming() {
  if (!coming_) coming_ = scene_;
  comingMade_ = false;
  return *coming_;
}

void SceneRenderer::setEnvironment(std::shared_ptr<const EnvironmentGeometry> geometry) {
  coming().environment = std::move(geometry);
  coming().content = {};
  coming().field = nullptr;
  coming().sources = nullptr;
  afresh_ = true;
}

void SceneRenderer::replaceEnvironment(std::shared_ptr<const EnvironmentGeometry> geometry) {
  coming().environment = std::move(geometry);
}

void SceneRenderer::setBackdrop(BackdropPtr backdrop) { coming().backdrop = std::move(backdrop); }

void SceneRenderer::setContent(ViewContent content) { coming().content = std::move(content); }

void SceneRenderer::setCells(std::shared_ptr<const CellGeometry> geometry, CellColours colours) {
  painter_.cells().setCells(std::move(geometry), std::move(colours));
  pictures_.dropUnfinished();
}

void SceneRenderer::setCellColours(CellColours colours) {
  painter_.cells().setColours(std::move(colours));
  pictures_.dropUnfinished();
}

void SceneRenderer::setFieldScale(const FieldScale& scale) {
  painter_.setFieldScale(scale);
  pictures_.dropUnfinished();
}

void SceneRenderer::setField(std::shared_ptr<const FieldGeometry> field) { coming().field = std::move(field); }

void SceneRenderer::setSources(std::shared_ptr<const NavigationMeshGeometry> sources) {
  coming().sources = std::move(sources);
}

void SceneRenderer::setHiddenLayers(const std::set<std::uint32_t>& hidden) {
  batches_.setHiddenLayers(hidden);
  pictures_.dropUnfinished();
}

// Returns whether the new content can be shown.
bool SceneRenderer::uploadComing(double ms) {
  if (std::exchange(afresh_, false)) {
    scene_ = {};
    pictures_.forget();
    shownChanges_.clear();
  }
  if (!coming_) return true;
  if (!std::exchange(comingMade_, true)) coming_->makeBatches(batches_, scene_);
  return batches_.upload(ms);
}

bool SceneRenderer::advance(double ms) {
  const GlStateKeeper kept;
  QElapsedTimer clock;
  clock.start();
  const bool uploaded = uploadComing(ms);
  return (!pictures_.isWanting() && uploaded) ||
         pictures_.goOn(scene_, ms - static_cast<double>(clock.nsecsElapsed()) * 1e-6);
}

// `key` is that of the shown content. An unfinished picture of it is completed first, because frequent changes would
// otherwise never let one be shown; the changes of an edit are shown at once.
void SceneRenderer::takeComing(const PictureKey& key) {
  if (pictures_.wants(key)) {
    scene_.content.changes = coming_->content.changes;
    scene_.changes = coming_->changes;
    return;
  }
  scene_ = std::move(*coming_);
  coming_.reset();
}

// While hurried, a large environment is drawn coarse with its content as paint, and everything else without its lines.
void SceneRenderer::drawDirectly(StillLook look, SceneParts parts, bool hurried) {
  const CoarseBatches& coarse = scene_.coarse;
  look.hurried = hurried;
  if (hurried && coarse.plain && look.drawn == SceneRule::Environment::All && parts.walkable) {
    const bool vivid = parts.mode == ViewMode::RejectedBy;
    const bool allReasons = parts.removed && parts.plainRemovals == 0;
    const CoarsePaints paints = !allReasons ? CoarsePaints::WalkableOnly
                                : vivid     ? CoarsePaints::Vivid
                                            : CoarsePaints::Result;
    const SceneBatchPtr& painted = coarse.painted[static_cast<std::size_t>(paints)];
    look.creases = false;
    painter_.drawStill(scene_, look, painted && (vivid || parts.mode == ViewMode::Result) ? painted : coarse.plain);
    return;
  }
  parts.outlines = parts.outlines && !hurried;
  look.creases = look.creases && !hurried;
  painter_.drawStill(scene_, look, scene_.environmentSurface);
  painter_.drawContent(scene_, look.camera, parts);
}

bool SceneRenderer::draw(const SceneCamera& camera, const SceneParts& parts, const Haste& haste) {
  const GlStateKeeper keeper;
  painter_.cells().uploadBorders();
  painter_.prepareState();
  bool whole = false;
  for (;;) {
    const bool uploaded = uploadComing(haste.ms);
    PictureKey key = pictures_.keyOf(scene_, camera, parts);
    if (coming_ && uploaded) {
      takeComing(key);
      key = pictures_.keyOf(scene_, camera, parts);
    }
    pictures_.want(!haste.moving && pictures_.canKeep() ? std::optional(std::move(key)) : std::nullopt);
    pictures_.goOn(scene_, haste.ms);
    whole = !pictures_.isWanting() && !coming_;
    // Without haste, content that arrived after the unfinished picture is waited for as well.
    if (whole || haste.ms < std::numeric_limits<double>::infinity()) break;
  }
  GLint frame = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &frame);
  // Until a picture is complete, the previous one is shown if the camera is the same.
  const bool copied = !haste.moving && pictures_.copyTo(static_cast<GLuint>(frame), camera);
  if (!copied)
    drawDirectly(painter_.stillLook(scene_, camera, parts), parts, haste.hurried && (haste.moving || !whole));
  const bool before = copied && !whole && scene_.changes.empty();
  const std::vector<MeshBatches>& changes = before ? shownChanges_ : scene_.changes;
  if (!copied || !ScenePictures::holds(changes)) painter_.drawChanges(scene_, camera, parts, changes);
  if (!before) shownChanges_ = scene_.changes;
  if (painter_.cells().isShown(parts)) painter_.cells().drawMarked(camera);
  return whole;
}

}  // namespace footfall::ui
