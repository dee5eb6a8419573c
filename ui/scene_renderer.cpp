// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene_renderer.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "ui/appearance.hpp"

#ifndef GL_CLIP_DISTANCE0
#define GL_CLIP_DISTANCE0 0x3000  // the headers of OpenGL ES do not know it
#endif

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

constexpr float kUnderCells = 0.9F;  // colours of cells are to look as in their legend

QVector3D toVector(const QColor& colour) { return {colour.redF(), colour.greenF(), colour.blueF()}; }

}  // namespace

QString SceneRenderer::initialize() {
  initializeOpenGLFunctions();
  for (const auto& [program, name] :
       {std::pair{&surfaceProgram_, "surface"}, std::pair{&lineProgram_, "line"},
        std::pair{&backgroundProgram_, "background"}, std::pair{&cells_.program(), "cell"}}) {
    const QString problem = buildProgram(*program, QString::fromLatin1(name));
    if (!problem.isEmpty()) return problem;
  }
  emptyArray_.create();
  cells_.initialize();
  environmentPending_ = environment_ != nullptr;
  contentPending_ = true;
  return {};
}

void SceneRenderer::release() {
  environmentSurface_.reset();
  environmentCreases_.reset();
  removed_.clear();
  walkable_.clear();
  changes_.clear();
  cellBorders_.reset();
  cells_.release();
  still_.reset();
  picture_.reset();
  emptyArray_.destroy();
  for (QOpenGLShaderProgram* program : {&surfaceProgram_, &lineProgram_, &backgroundProgram_}) {
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

SceneRenderer::BatchPtr SceneRenderer::makeSurface(const std::vector<SurfaceVertex>& vertices) {
  auto batch = std::make_shared<Batch>();
  batch->count = static_cast<int>(vertices.size());
  if (vertices.empty()) return batch;
  batch->array.create();
  const QOpenGLVertexArrayObject::Binder bound(&batch->array);
  batch->buffer.create();
  batch->buffer.bind();
  batch->buffer.allocate(vertices.data(), static_cast<int>(vertices.size() * sizeof(SurfaceVertex)));
  const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
  constexpr int kStride = sizeof(SurfaceVertex);
  for (GLuint location = 0; location < 3; ++location) glEnableVertexAttribArray(location);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(SurfaceVertex, position)));
  glVertexAttribPointer(1, 4, GL_BYTE, GL_TRUE, kStride, offset(offsetof(SurfaceVertex, normal)));
  glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, offset(offsetof(SurfaceVertex, colour)));
  batch->buffer.release();
  return batch;
}

SceneRenderer::BatchPtr SceneRenderer::makeLines(const std::vector<LineSegment>& segments) {
  auto batch = std::make_shared<Batch>();
  batch->count = static_cast<int>(segments.size());
  if (segments.empty()) return batch;
  batch->array.create();
  const QOpenGLVertexArrayObject::Binder bound(&batch->array);
  batch->buffer.create();
  batch->buffer.bind();
  batch->buffer.allocate(segments.data(), static_cast<int>(segments.size() * sizeof(LineSegment)));
  for (GLuint location = 0; location < 2; ++location) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, sizeof(LineSegment),
                          reinterpret_cast<const void*>(location * sizeof(LineSegment::from)));
    glVertexAttribDivisor(location, 1);
  }
  batch->buffer.release();
  return batch;
}

// The same geometry comes again and again while a run goes on: what is there already stays.
SceneRenderer::MeshBatches SceneRenderer::takeBatches(const GeometryPtr& geometry, bool withLines,
                                                      const std::vector<MeshBatches>& known) {
  const auto found = std::ranges::find(known, geometry, &MeshBatches::geometry);
  if (found != known.end()) return *found;
  MeshBatches batches{geometry, makeSurface(geometry->surface), {}, {}, {}, {}};
  if (withLines) {
    batches.creases = makeLines(geometry->creases);
    batches.outline = makeLines(geometry->outline);
    batches.obstacleEdges = makeLines(geometry->obstacleEdges);
    batches.connections = makeLines(geometry->connections);
  }
  return batches;
}

void SceneRenderer::uploadPending() {
  if (environmentPending_) {
    environmentPending_ = false;
    environmentSurface_ = environment_ ? makeSurface(environment_->surface) : nullptr;
    environmentCreases_ = environment_ ? makeLines(environment_->creases) : nullptr;
  }
  if (bordersPending_) {
    bordersPending_ = false;
    cellBorders_ = cells_.geometry() ? makeLines(cells_.geometry()->borders) : nullptr;
  }
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

void SceneRenderer::drawBackground() {
  glDisable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  backgroundProgram_.bind();
  backgroundProgram_.setUniformValue("lower", toVector(backgroundLower()));
  backgroundProgram_.setUniformValue("upper", toVector(backgroundUpper()));
  const QOpenGLVertexArrayObject::Binder bound(&emptyArray_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDepthMask(GL_TRUE);
  glEnable(GL_DEPTH_TEST);
}

void SceneRenderer::drawSurface(const BatchPtr& batch, float offset) {
  if (!batch || batch->count == 0) return;
  glPolygonOffset(offset, 4 * offset);
  const QOpenGLVertexArrayObject::Binder bound(&batch->array);
  glDrawArrays(GL_TRIANGLES, 0, batch->count);
}

void SceneRenderer::drawLines(const BatchPtr& batch, const QColor& colour, float width, float lift) {
  if (!batch || batch->count == 0) return;
  lineProgram_.setUniformValue("colour", QVector4D(toVector(colour), 1));
  lineProgram_.setUniformValue("width", width);
  lineProgram_.setUniformValue("lift", lift);
  const QOpenGLVertexArrayObject::Binder bound(&batch->array);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, batch->count);
}

void SceneRenderer::useCamera(QOpenGLShaderProgram& program, const SceneCamera& camera) {
  program.bind();
  program.setUniformValue("modelViewProjection", camera.modelViewProjection);
  program.setUniformValue("cut", camera.cut);
}

// The environment without anything on it.
void SceneRenderer::drawStill(const StillKey& key) {
  drawBackground();
  glEnable(GL_CLIP_DISTANCE0);
  if (key.surface) {
    beginSurfaces(key.camera, key.pale);
    surfaceProgram_.setUniformValue("floorPaint", key.floorPaint);
    drawSurface(environmentSurface_, key.offset);
    glDisable(GL_POLYGON_OFFSET_FILL);
  }
  if (key.creases) {
    beginLines(key.camera);
    drawLines(environmentCreases_, creaseColour(), 1.0F * key.camera.devicePixelRatio, 3e-5F);
    endLines();
  }
  glDisable(GL_CLIP_DISTANCE0);
}

SceneRenderer::ContentKey SceneRenderer::contentKey(const StillKey& still, const SceneParts& parts) const {
  ContentKey key{still, parts, {}, {}, 0};
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

void SceneRenderer::beginSurfaces(const SceneCamera& camera, float pale) {
  glEnable(GL_POLYGON_OFFSET_FILL);
  useCamera(surfaceProgram_, camera);
  surfaceProgram_.setUniformValue("eye", camera.eye);
  surfaceProgram_.setUniformValue("pale", pale);
  surfaceProgram_.setUniformValue("viewDirection", camera.viewDirection);
  surfaceProgram_.setUniformValue("orthographic", camera.orthographic);
  surfaceProgram_.setUniformValue("patternScale", camera.devicePixelRatio);
}

void SceneRenderer::drawSurfaces(const SceneCamera& camera, const SceneParts& parts) {
  beginSurfaces(camera, showsCells(parts) ? kUnderCells : 0);
  if (parts.walkable) {
    for (const MeshBatches& mesh : walkable_) drawSurface(mesh.surface, 0);
  }
  // Coplanar surfaces with different triangles: the later is the nearer, by one step of polygon offset each. The
  // nearest come first, so that what they hide is not painted.
  for (std::size_t i = removed_.size(); i-- > 0;) {
    if (parts.removed && parts.environment) drawSurface(removed_[i].surface, static_cast<float>(removed_.size() - i));
  }
  glDisable(GL_POLYGON_OFFSET_FILL);
}

void SceneRenderer::drawContent(const SceneCamera& camera, const SceneParts& parts) {
  glEnable(GL_CLIP_DISTANCE0);
  drawSurfaces(camera, parts);
  if (showsCells(parts)) drawCells(camera, parts);
  drawAllLines(camera, parts);
  glDisable(GL_CLIP_DISTANCE0);
}

// Nearer than everything that they change, each nearer than the one before.
void SceneRenderer::drawChanges(const SceneCamera& camera, const SceneParts& parts) {
  if (changes_.empty() || !parts.walkable) return;
  glEnable(GL_CLIP_DISTANCE0);
  beginSurfaces(camera);
  float offset = 0;
  for (const MeshBatches& mesh : changes_) drawSurface(mesh.surface, offset -= 1);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDisable(GL_CLIP_DISTANCE0);
}

// Over the surfaces and under their lines: what is walkable can still be told by its outline.
void SceneRenderer::drawCells(const SceneCamera& camera, const SceneParts& parts) {
  cells_.draw({camera.modelViewProjection, camera.cut, camera.devicePixelRatio});
  beginLines(camera);
  // Many cells have thin borders, or there would be nothing else to see.
  constexpr float kMany = 40;
  const auto cells = static_cast<float>(cells_.geometry()->boxes.size());
  const float pixel = camera.devicePixelRatio * std::clamp(std::sqrt(kMany / cells), 0.35F, 1.0F);
  if (parts.outlines) drawLines(cellBorders_, outlineColour(), 3.6F * pixel, 1.1e-4F);
  drawLines(cellBorders_, cellBorderColour(), 2.0F * pixel, 1.2e-4F);
  endLines();
}

// Through everything, so that a cell behind a wall is found as well.
void SceneRenderer::drawMarkedCells(const SceneCamera& camera, const SceneParts& parts) {
  if (!showsCells(parts)) return;
  for (const auto& [cell, colour] :
       {std::pair{marked_.selected, selectedCellColour()}, std::pair{marked_.hovered, hoveredCellColour()}}) {
    if (!cell || *cell >= cells_.geometry()->boxes.size()) continue;
    glEnable(GL_CLIP_DISTANCE0);
    cells_.drawCell({camera.modelViewProjection, camera.cut, camera.devicePixelRatio}, *cell, colour, 0.35F);
    glDisable(GL_CLIP_DISTANCE0);
    const BatchPtr edges = makeLines(edgesOf(cells_.geometry()->boxes[*cell]));
    glDisable(GL_DEPTH_TEST);
    beginLines(camera);
    drawLines(edges, outlineColour(), 4.4F * camera.devicePixelRatio, 0);
    drawLines(edges, colour, 2.4F * camera.devicePixelRatio, 0);
    endLines();
    glEnable(GL_DEPTH_TEST);
  }
}

void SceneRenderer::drawAllLines(const SceneCamera& camera, const SceneParts& parts) {
  beginLines(camera);
  const float pixel = camera.devicePixelRatio;
  for (const MeshBatches& mesh : walkable_) {
    if (parts.walkable && parts.outlines) {
      drawLines(mesh.creases, creaseColour(), 1.0F * pixel, 3e-5F);
      drawLines(mesh.outline, outlineColour(), 1.3F * pixel, 8e-5F);
    }
    if (parts.connections) {
      drawLines(mesh.connections, outlineColour(), 4.5F * pixel, 1.1e-4F);
      drawLines(mesh.connections, connectionColour(), 2.5F * pixel, 1.2e-4F);
    }
    if (parts.obstacleEdges) drawLines(mesh.obstacleEdges, obstacleEdgeColour(), 2.8F * pixel, 1.6e-4F);
  }
  endLines();
}

void SceneRenderer::beginLines(const SceneCamera& camera) {
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);  // the window stays opaque
  glDepthMask(GL_FALSE);  // soft edges must not hide what is drawn later
  useCamera(lineProgram_, camera);
  lineProgram_.setUniformValue(
      "viewport", QVector2D(static_cast<float>(camera.viewport.width()), static_cast<float>(camera.viewport.height())));
}

void SceneRenderer::endLines() {
  lineProgram_.release();
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

void SceneRenderer::draw(const SceneCamera& camera, const SceneParts& parts, bool moving) {
  uploadPending();
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  const Paint floor = content_.firstRemoval && parts.removed ? content_.firstRemoval->paint : undecidedPaint();
  // Behind everything that may come on top: a step for each of it, but the same for a few more or less.
  constexpr std::size_t kSteps = 4;
  const auto offset = static_cast<float>((removed_.size() / kSteps + 1) * kSteps);
  const StillKey key{environment_,
                     camera,
                     parts.environment,
                     parts.environment && parts.outlines,
                     QVector4D(toVector(floor.colour), static_cast<float>(floor.pattern) / 127.0F),
                     offset,
                     showsCells(parts) ? kUnderCells : 0};
  if (moving || !copyContent(contentKey(key, parts))) {
    drawStill(key);
    drawContent(camera, parts);
  }
  drawChanges(camera, parts);
  drawMarkedCells(camera, parts);
}

}  // namespace footfall
