// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene_renderer.hpp"

#include <QOpenGLContext>
#include <algorithm>
#include <utility>

#include "ui/appearance.hpp"

namespace footfall {
namespace {

QString buildProgram(QOpenGLShaderProgram& program, const QString& name) {
  const QString path = QStringLiteral(":/shaders/") + name;
  if (program.addShaderFromSourceFile(QOpenGLShader::Vertex, path + QStringLiteral(".vert")) &&
      program.addShaderFromSourceFile(QOpenGLShader::Fragment, path + QStringLiteral(".frag")) && program.link()) {
    return {};
  }
  return QStringLiteral("shader %1: %2; update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1")
      .arg(name, program.log().simplified());
}

// Returns whether the picture is new.
bool preparePicture(std::unique_ptr<QOpenGLFramebufferObject>& picture, const QSize& size) {
  if (picture && picture->isValid() && picture->size() == size) return false;
  picture = std::make_unique<QOpenGLFramebufferObject>(size, QOpenGLFramebufferObject::CombinedDepthStencil);
  return true;
}

std::vector<std::uint32_t> pickedLayers(const std::vector<std::uint32_t>& layers,
                                        const std::vector<std::uint32_t>& triangles) {
  std::vector<std::uint32_t> picked;
  if (layers.empty()) return picked;
  picked.reserve(triangles.size());
  for (const std::uint32_t triangle : triangles) picked.push_back(layers[triangle]);
  return picked;
}

QVector3D toVector(const QColor& colour) { return {colour.redF(), colour.greenF(), colour.blueF()}; }

}  // namespace

QString SceneRenderer::initialize() {
  initializeOpenGLFunctions();
  for (const auto& [program, name] : {std::pair{&surfaceProgram_, "surface"}, std::pair{&lineProgram_, "line"},
                                      std::pair{&backgroundProgram_, "background"},
                                      std::pair{&cells_.program(), "cell"}, std::pair{&fieldProgram_, "field"}}) {
    const QString problem = buildProgram(*program, QString::fromLatin1(name));
    if (!problem.isEmpty()) return problem;
  }
  emptyArray_.create();
  cells_.initialize();
  batches_.initialize();
  polygonMode_ =
      reinterpret_cast<decltype(polygonMode_)>(QOpenGLContext::currentContext()->getProcAddress("glPolygonMode"));
  environmentPending_ = environment_ != nullptr;
  contentPending_ = true;
  return {};
}

void SceneRenderer::release() {
  environmentSurface_.reset();
  environmentCreases_.reset();
  environmentCoarse_.reset();
  removed_.clear();
  walkable_.clear();
  changes_.clear();
  cellBorders_.reset();
  fieldSurface_.reset();
  sourceBatches_ = {};
  if (scaleTexture_ != 0) glDeleteTextures(1, &scaleTexture_);
  scaleTexture_ = 0;
  batches_.release();
  cells_.release();
  still_.reset();
  picture_.reset();
  emptyArray_.destroy();
  for (QOpenGLShaderProgram* program : {&surfaceProgram_, &lineProgram_, &backgroundProgram_, &fieldProgram_}) {
    program->removeAllShaders();
  }
}

void SceneRenderer::setEnvironment(std::shared_ptr<const EnvironmentGeometry> geometry) {
  environment_ = std::move(geometry);
  environmentPending_ = true;
}

void SceneRenderer::setContent(ViewContent content) {
  content_ = std::move(content);
  contentPending_ = true;
}

void SceneRenderer::setCells(std::shared_ptr<const CellGeometry> geometry, CellColours colours) {
  cells_.setGeometry(std::move(geometry));
  cells_.setColours(std::move(colours));
  marked_ = {};
  bordersPending_ = true;
}

void SceneRenderer::setField(std::shared_ptr<const FieldGeometry> field) {
  field_ = std::move(field);
  fieldPending_ = true;
}

void SceneRenderer::setSources(std::shared_ptr<const MeshGeometry> sources) {
  sources_ = std::move(sources);
  sourcesPending_ = true;
}

void SceneRenderer::setHiddenLayers(const std::set<std::uint32_t>& hidden) { batches_.setHiddenLayers(hidden); }

// The same geometry comes again and again while a run goes on: what is there already stays.
SceneRenderer::MeshBatches SceneRenderer::takeBatches(const GeometryPtr& geometry, bool withLines,
                                                      const std::vector<MeshBatches>& known) {
  const auto found = std::ranges::find(known, geometry, &MeshBatches::geometry);
  if (found != known.end()) return *found;
  MeshBatches batches{geometry, batches_.makeSurface(geometry->surface), {}, {}, {}, {}, {}};
  batches_.setSurfaceLayers(batches.surface, geometry->surfaceLayers);
  if (!geometry->coarse.surface.empty()) {
    batches.coarse = batches_.makeSurface(geometry->coarse.surface);
    batches_.setSurfaceLayers(batches.coarse, pickedLayers(geometry->surfaceLayers, geometry->coarse.triangles));
  }
  if (!withLines) return batches;
  const auto lines = [this](const std::vector<LineSegment>& segments, const std::vector<LineLayers>& layers) {
    const BatchPtr batch = batches_.makeLines(segments);
    batches_.setLineLayers(batch, layers);
    return batch;
  };
  batches.creases = lines(geometry->creases, geometry->creaseLayers);
  batches.outline = lines(geometry->outline, geometry->outlineLayers);
  batches.obstacleEdges = lines(geometry->obstacleEdges, geometry->obstacleEdgeLayers);
  batches.connections = lines(geometry->connections, geometry->connectionLayers);
  return batches;
}

// The layers of the environment's triangles come with results.
void SceneRenderer::uploadEnvironmentLayers() {
  shownEnvironmentLayers_ = content_.environmentLayers;
  if (!environment_) return;
  static const EnvironmentLayers kNone;
  const EnvironmentLayers& known = shownEnvironmentLayers_ ? *shownEnvironmentLayers_ : kNone;
  const bool fits = known.size() * 3 == environment_->surface.size();
  batches_.setSurfaceLayers(environmentSurface_, fits ? known : kNone);
  batches_.setSurfaceLayers(environmentCoarse_, fits ? pickedLayers(known, environment_->coarse.triangles) : kNone);
  const auto layerOf = [&](std::uint32_t triangle) { return triangle < known.size() ? known[triangle] : kNoLayer; };
  std::vector<LineLayers> creases;
  if (fits) {
    creases.reserve(environment_->creaseTriangles.size());
    for (const auto& [a, b] : environment_->creaseTriangles) creases.push_back({layerOf(a), layerOf(b)});
  }
  batches_.setLineLayers(environmentCreases_, creases);
  if (!field_) return;
  std::vector<std::uint32_t> field;
  if (shownEnvironmentLayers_) {
    field.reserve(field_->sources.size());
    for (const std::uint32_t source : field_->sources) field.push_back(layerOf(source));
  }
  batches_.setSurfaceLayers(fieldSurface_, field);
}

void SceneRenderer::uploadPending() {
  bool layersPending = environmentPending_ || fieldPending_;
  if (environmentPending_) {
    environmentPending_ = false;
    environmentSurface_ = environment_ ? batches_.makeSurface(environment_->surface) : nullptr;
    const bool large = environment_ && !environment_->coarse.surface.empty();
    environmentCoarse_ = large ? batches_.makeSurface(environment_->coarse.surface) : nullptr;
    environmentCreases_ = environment_ ? batches_.makeLines(environment_->creases) : nullptr;
  }
  if (bordersPending_) {
    bordersPending_ = false;
    cellBorders_ = cells_.geometry() ? batches_.makeLines(cells_.geometry()->borders) : nullptr;
  }
  if (fieldPending_) {
    fieldPending_ = false;
    fieldSurface_ = field_ ? batches_.makeField(field_->surface) : nullptr;
  }
  if (sourcesPending_) {
    sourcesPending_ = false;
    sourceBatches_ = sources_ ? takeBatches(sources_, true, {}) : MeshBatches{};
  }
  if (contentPending_ && shownEnvironmentLayers_ != content_.environmentLayers) layersPending = true;
  if (layersPending) uploadEnvironmentLayers();
  if (!contentPending_) return;
  contentPending_ = false;
  std::vector<MeshBatches> removed, walkable, changes;
  for (const ViewContent::Removed& r : content_.removed) removed.push_back(takeBatches(r.before, false, removed_));
  for (const GeometryPtr& mesh : content_.walkable) walkable.push_back(takeBatches(mesh, true, walkable_));
  for (const GeometryPtr& mesh : content_.changes) changes.push_back(takeBatches(mesh, false, changes_));
  removed_ = std::move(removed);
  walkable_ = std::move(walkable);
  changes_ = std::move(changes);
}

SceneRenderer::ContentKey SceneRenderer::contentKey(const StillKey& still, const SceneParts& parts) const {
  ContentKey key{still, parts, {}, {}, 0, nullptr, {}};
  if (isHeatMap(parts.mode)) {
    key.field = field_;
    key.scale = fieldScale_;
  }
  if (parts.mode == ViewMode::SourceTriangles) key.surfaces = {sources_, nullptr};
  if (showsCells(parts)) {
    key.cells = cells_.geometry();
    key.cellColours = cells_.version();
  }
  for (const auto* batches : {&removed_, &walkable_}) {
    for (const MeshBatches& mesh : *batches) key.surfaces.push_back(mesh.geometry);
    key.surfaces.push_back(nullptr);  // where one list ends
  }
  return key;
}

bool SceneRenderer::copyToFrame(const QOpenGLFramebufferObject& picture, GLint frame) {
  const QSize size = picture.size();
  glBindFramebuffer(GL_READ_FRAMEBUFFER, picture.handle());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(frame));
  while (glGetError() != GL_NO_ERROR) {
  }
  glBlitFramebuffer(0, 0, size.width(), size.height(), 0, 0, size.width(), size.height(),
                    GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  const bool copied = glGetError() == GL_NO_ERROR;
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(frame));
  return copied;
}

// Into the frame, from the picture that is kept, which is made first where it is another. False: it cannot be kept.
bool SceneRenderer::copyStill(const StillKey& key) {
  GLint frame = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &frame);
  const bool made = preparePicture(still_, key.camera.viewport);
  if (!still_->isValid()) return false;
  if (made || !(stillKey_ == key)) {
    still_->bind();
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    drawStill(key);
    stillKey_ = key;
  }
  return copyToFrame(*still_, frame);
}

// The same with what is on the environment.
bool SceneRenderer::copyContent(const ContentKey& key) {
  GLint frame = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &frame);
  const bool made = preparePicture(picture_, key.still.camera.viewport);
  if (!picture_->isValid()) return false;
  if (made || !(pictureKey_ == key)) {
    pictureKey_ = {};  // until it is there
    picture_->bind();
    const bool copied = copyStill(key.still);
    if (copied) drawContent(key.still.camera, key.parts);
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(frame));
    if (!copied) return false;
    pictureKey_ = key;
  }
  return copyToFrame(*picture_, frame);
}

void SceneRenderer::draw(const SceneCamera& camera, const SceneParts& parts, bool moving, bool coarse) {
  coarse_ = coarse;
  uploadPending();
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  const bool reasons = content_.firstRemoval && parts.removed;
  const bool vivid = parts.mode == ViewMode::RejectedBy;
  Paint floor = undecidedPaint();
  if (reasons && (parts.mode == ViewMode::Result || vivid))
    floor = vivid ? content_.firstRemoval->vivid : content_.firstRemoval->paint;
  // Behind everything that may come on top: a step for each of it, but the same for a few more or less.
  constexpr std::size_t kSteps = 4;
  const auto offset = static_cast<float>((removed_.size() / kSteps + 1) * kSteps);
  const bool surface = parts.environment && parts.mode != ViewMode::WalkableOnly;
  const bool wires = parts.mode == ViewMode::Wireframe || parts.mode == ViewMode::HiddenLine;
  const StillKey key{environment_,
                     content_.environmentLayers,
                     batches_.hiddenLayers(),
                     camera,
                     parts.mode,
                     surface,
                     surface && parts.outlines && !wires,
                     QVector4D(toVector(floor.colour), static_cast<float>(floor.pattern) / 127.0F),
                     offset,
                     showsCells(parts) ? kUnderCells : 0};
  if (moving || !copyContent(contentKey(key, parts))) {
    drawStill(key);
    drawContent(camera, parts);
  }
  if (parts.mode <= ViewMode::RejectedBy) drawChanges(camera, parts);
  drawMarkedCells(camera, parts);
}

}  // namespace footfall
