// SPDX-License-Identifier: GPL-3.0-or-later
// SceneRenderer's strokes: what each mode draws, and how.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "ui/view/appearance.hpp"
#include "ui/view/scene_renderer.hpp"

#ifndef GL_CLIP_DISTANCE0
#define GL_CLIP_DISTANCE0 0x3000  // the headers of OpenGL ES do not know these
#endif
#ifndef GL_LINE
#define GL_LINE 0x1B01
#define GL_FILL 0x1B02
#endif
#ifndef GL_POLYGON_OFFSET_LINE
#define GL_POLYGON_OFFSET_LINE 0x2A02
#endif

namespace footfall::ui {
namespace {

constexpr int kScaleColours = 256;

QVector3D toVector(const QColor& colour) { return {colour.redF(), colour.greenF(), colour.blueF()}; }

QVector4D toVector(const Paint& paint) { return {toVector(paint.colour), static_cast<float>(paint.pattern) / 127.0F}; }

}  // namespace

void SceneRenderer::beginClip(const SceneCamera& camera) {
  if (!camera.clip.active()) return;
  for (GLenum i = 0; i < 3; ++i) glEnable(GL_CLIP_DISTANCE0 + i);
}

void SceneRenderer::endClip() {
  for (GLenum i = 0; i < 3; ++i) glDisable(GL_CLIP_DISTANCE0 + i);
}

void SceneRenderer::drawBackground() {
  if (slice_->take(1).count == 0) return;
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
  const auto [first, count] = slice_->take(batch->count);
  if (count == 0) return;
  glPolygonOffset(offset, 4 * offset);
  batches_.useLayers(surfaceProgram_, *batch);
  batches_.draw(*batch, first, count);
}

void SceneRenderer::drawLines(const BatchPtr& batch, const QColor& colour, float width, float lift, bool fadeShort) {
  if (!batch || batch->count == 0) return;
  const auto [first, count] = slice_->take(batch->count);
  if (count == 0) return;
  lineProgram_.setUniformValue("colour", QVector4D(toVector(colour), 1));
  lineProgram_.setUniformValue("width", width);
  lineProgram_.setUniformValue("lift", lift);
  lineProgram_.setUniformValue("fadeShort", fadeShort);
  batches_.useLayers(lineProgram_, *batch);
  batches_.draw(*batch, first, count);
}

void SceneRenderer::useCamera(QOpenGLShaderProgram& program, const SceneCamera& camera) {
  program.bind();
  program.setUniformValue("modelViewProjection", camera.modelViewProjection);
  camera.clip.setTo(program);
  program.setUniformValue("layered", false);
  program.setUniformValue("leaveCovers", leaveCovers_);
}

// The environment without anything on it; `surface` stands for all of it.
void SceneRenderer::drawStill(const StillKey& key, const BatchPtr& surface) {
  drawBackground();
  beginClip(key.camera);
  setSides(key.backs);
  leaveCovers_ = !key.covers;
  const bool surfaces = key.drawn != SceneRule::Environment::None;
  const bool wires = key.mode == ViewMode::Wireframe || key.mode == ViewMode::HiddenLine;
  if (surfaces && key.mode != ViewMode::Wireframe) {
    beginSurfaces(key.camera, key.pale);
    if (wires) setOnlyPaint(Paint{hiddenLineFill()}, true);
    surfaceProgram_.setUniformValue("floorPaint", toVector(key.floorPaint));
    surfaceProgram_.setUniformValue("floorsOnly", key.drawn == SceneRule::Environment::Floors);
    drawSurface(surface, key.offset);
    surfaceProgram_.setUniformValue("floorsOnly", false);
    setOnlyPaint(std::nullopt);
    glDisable(GL_POLYGON_OFFSET_FILL);
  }
  if (surfaces && wires) drawWires(surface, key.camera, wireColour(), false);
  if (key.creases) {
    beginLines(key.camera);
    drawLines(scene_.environmentCreases, creaseColour(), 1.0F * key.camera.devicePixelRatio, 3e-5F);
    endLines();
  }
  setSides(true);
  endClip();
}

// Whether faces are drawn that are seen from behind.
void SceneRenderer::setSides(bool backs) {
  if (backs) {
    glDisable(GL_CULL_FACE);
  } else {
    glEnable(GL_CULL_FACE);
  }
}

// The edges of all triangles of a surface.
void SceneRenderer::drawWires(const BatchPtr& batch, const SceneCamera& camera, const QColor& colour, bool ownColours) {
  if (!batch || batch->count == 0 || !polygonMode_) return;
  beginSurfaces(camera);
  glDisable(GL_POLYGON_OFFSET_FILL);
  surfaceProgram_.setUniformValue("hatchBacks", false);
  surfaceProgram_.setUniformValue("unlit", true);
  if (!ownColours) setOnlyPaint(Paint{colour}, true);
  polygonMode_(GL_FRONT_AND_BACK, GL_LINE);
  glLineWidth(camera.devicePixelRatio);
  // Under the edges of what is walkable.
  glEnable(GL_POLYGON_OFFSET_LINE);
  drawSurface(batch, ownColours ? 0 : 0.5F);
  glDisable(GL_POLYGON_OFFSET_LINE);
  glLineWidth(1);
  polygonMode_(GL_FRONT_AND_BACK, GL_FILL);
  setOnlyPaint(std::nullopt);
}

void SceneRenderer::setOnlyPaint(const std::optional<Paint>& paint, bool unlit) {
  surfaceProgram_.setUniformValue("only", paint.has_value());
  surfaceProgram_.setUniformValue("unlit", unlit);
  if (paint) surfaceProgram_.setUniformValue("onlyPaint", toVector(*paint));
}

void SceneRenderer::beginSurfaces(const SceneCamera& camera, float pale) {
  glEnable(GL_POLYGON_OFFSET_FILL);
  useCamera(surfaceProgram_, camera);
  surfaceProgram_.setUniformValue("eye", camera.eye);
  surfaceProgram_.setUniformValue("pale", pale);
  surfaceProgram_.setUniformValue("viewDirection", camera.viewDirection);
  surfaceProgram_.setUniformValue("orthographic", camera.orthographic);
  surfaceProgram_.setUniformValue("patternScale", camera.devicePixelRatio);
  surfaceProgram_.setUniformValue("plainFloor", toVector(undecidedPaint()));
  surfaceProgram_.setUniformValue("hatchBacks",
                                  camera.clip.active() && scene_.environment && !scene_.environment->bothSides);
  surfaceProgram_.setUniformValue("floorsOnly", false);
  surfaceProgram_.setUniformValue("asBackground", false);
  surfaceProgram_.setUniformValue("lower", toVector(backgroundLower()));
  surfaceProgram_.setUniformValue("upper", toVector(backgroundUpper()));
  surfaceProgram_.setUniformValue("viewHeight", static_cast<float>(camera.viewport.height()));
  setUnseenLayers(SceneRule::Unseen::LeftOut);
  setOnlyPaint(std::nullopt);
}

// What becomes of pieces of hidden layers whose triangle of the environment stays.
void SceneRenderer::setUnseenLayers(SceneRule::Unseen unseen, bool only) {
  surfaceProgram_.setUniformValue("unseenLayers", only ? 2 : unseen == SceneRule::Unseen::Plain ? 1 : 0);
}

// What is not to be seen as walkable, and yet hides what lies under it.
void SceneRenderer::drawUnseen(const SceneRule& rule) {
  const bool all = rule.unseen != SceneRule::Unseen::LeftOut;
  const bool gap = (all ? rule.unseen : rule.unseenLayer) == SceneRule::Unseen::Gap;
  if (!all && (!gap || batches_.hiddenLayers().empty())) return;
  surfaceProgram_.setUniformValue("asBackground", gap);
  setOnlyPaint(undecidedPaint());
  for (const MeshBatches& mesh : scene_.walkable) {
    const bool layered = mesh.surface && mesh.surface->layers;
    if (all) {
      setUnseenLayers(SceneRule::Unseen::Plain);
      drawSurface(mesh.surface, 0);
    } else if (layered) {
      setUnseenLayers(SceneRule::Unseen::Gap, true);
      drawSurface(mesh.surface, 0);
    }
  }
  setUnseenLayers(SceneRule::Unseen::LeftOut);
  setOnlyPaint(std::nullopt);
  surfaceProgram_.setUniformValue("asBackground", false);
}

void SceneRenderer::drawWalkable(const SceneCamera& camera, ViewMode mode, const SceneRule& rule) {
  setUnseenLayers(rule.unseenLayer);
  if (mode == ViewMode::SourceTriangles && scene_.sourceMesh.surface) {
    drawSurface(scene_.sourceMesh.surface, 0);
    setUnseenLayers(SceneRule::Unseen::LeftOut);
    return;
  }
  if (mode == ViewMode::RejectedBy) setOnlyPaint(paleWalkablePaint());
  for (const MeshBatches& mesh : scene_.walkable) {
    if (mode == ViewMode::Wireframe || mode == ViewMode::HiddenLine) {
      drawWires(mesh.surface, camera, {}, true);
    } else {
      drawSurface(mesh.surface, 0);
    }
  }
  setUnseenLayers(SceneRule::Unseen::LeftOut);
  setOnlyPaint(std::nullopt);
}

void SceneRenderer::drawSurfaces(const SceneCamera& camera, const SceneParts& parts, const SceneRule& rule) {
  beginSurfaces(camera, showsCells(parts) ? kUnderCells : 0);
  drawUnseen(rule);
  if (rule.walkable) drawWalkable(camera, parts.mode, rule);
  const bool vivid = parts.mode == ViewMode::RejectedBy;
  // Coplanar surfaces with different triangles: the later is the nearer, by one step of polygon offset each. The
  // nearest come first, so that what they hide is not painted.
  for (std::size_t i = scene_.removed.size(); rule.reasons && i-- > 0;) {
    if (vivid) setOnlyPaint(scene_.content.removed[i].style->vivid);
    drawSurface(scene_.removed[i].surface, static_cast<float>(scene_.removed.size() - i));
  }
  setOnlyPaint(std::nullopt);
  glDisable(GL_POLYGON_OFFSET_FILL);
}

// In place of all other floors.
void SceneRenderer::drawField(const SceneCamera& camera) {
  if (!scene_.fieldSurface || scene_.fieldSurface->count == 0) return;
  const auto [first, count] = slice_->take(scene_.fieldSurface->count);
  if (count == 0) return;
  useCamera(fieldProgram_, camera);
  glActiveTexture(GL_TEXTURE0);
  if (scaleTexture_ == 0) {
    std::vector<std::uint8_t> colours;
    for (int i = 0; i < kScaleColours; ++i) {
      const QColor colour = heatColour(i / (kScaleColours - 1.0));
      for (const int part : {colour.red(), colour.green(), colour.blue(), 255})
        colours.push_back(static_cast<std::uint8_t>(part));
    }
    glGenTextures(1, &scaleTexture_);
    glBindTexture(GL_TEXTURE_2D, scaleTexture_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kScaleColours, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, colours.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  }
  glBindTexture(GL_TEXTURE_2D, scaleTexture_);
  const bool descending = fieldScale_.aboveIsRejected;  // light is good to walk on
  const auto ends =
      descending ? std::pair{fieldScale_.upper, fieldScale_.lower} : std::pair{fieldScale_.lower, fieldScale_.upper};
  fieldProgram_.setUniformValue("scale", 0);
  fieldProgram_.setUniformValue("range", QVector2D(static_cast<float>(ends.first), static_cast<float>(ends.second)));
  const float sign = !fieldScale_.limit ? 0.0F : fieldScale_.aboveIsRejected ? 1.0F : -1.0F;
  fieldProgram_.setUniformValue("limit", QVector2D(static_cast<float>(fieldScale_.limit.value_or(0)), sign));
  fieldProgram_.setUniformValue("tolerance", static_cast<float>(1e-4 * (fieldScale_.upper - fieldScale_.lower)));
  fieldProgram_.setUniformValue("patternScale", camera.devicePixelRatio);
  batches_.useLayers(fieldProgram_, *scene_.fieldSurface);
  batches_.draw(*scene_.fieldSurface, first, count);
  glBindTexture(GL_TEXTURE_2D, 0);
  fieldProgram_.release();
}

void SceneRenderer::drawContent(const SceneCamera& camera, const SceneParts& parts) {
  const SceneRule rule = this->rule(camera, parts);
  beginClip(camera);
  setSides(rule.backs);
  leaveCovers_ = !rule.covers;
  if (rule.field) {
    drawField(camera);
  } else {
    drawSurfaces(camera, parts, rule);
  }
  if (showsCells(parts)) drawCells(camera, parts);
  setSides(true);
  drawAllLines(camera, parts);
  endClip();
}

// Nearer than everything that they change, each nearer than the one before.
void SceneRenderer::drawChanges(const SceneCamera& camera, const SceneParts& parts,
                                const std::vector<MeshBatches>& changes) {
  if (changes.empty() || !parts.walkable || parts.mode > ViewMode::RejectedBy) return;
  beginClip(camera);
  const SceneRule rule = this->rule(camera, parts);
  setSides(rule.backs);
  leaveCovers_ = !rule.covers;
  beginSurfaces(camera);
  float offset = 0;
  for (const MeshBatches& mesh : changes) drawSurface(mesh.surface, offset -= 1);
  glDisable(GL_POLYGON_OFFSET_FILL);
  setSides(true);
  endClip();
}

void SceneRenderer::markCells() {
  CellKinds kinds{scene_.environment, scene_.content.environmentLayers, batches_.hiddenLayers()};
  if (kinds == cellKinds_) return;
  cellKinds_ = std::move(kinds);
  cells_.setKinds([kinds = cellKinds_](std::uint32_t source) {
    const bool cover = kinds.environment && kinds.environment->isCover(source);
    const bool hidden = kinds.layers && source < kinds.layers->size() && kinds.hidden.contains((*kinds.layers)[source]);
    return (cover ? kCellOnCover : 0) | (hidden ? kCellHidden : 0);
  });
}

// Over the surfaces and under their lines: what is walkable can still be told by its outline.
void SceneRenderer::drawCells(const SceneCamera& camera, const SceneParts& parts) {
  markCells();
  cells_.draw({camera.modelViewProjection, camera.clip, camera.devicePixelRatio, leaveCovers_}, *slice_);
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
    beginClip(camera);
    cells_.drawCell({camera.modelViewProjection, camera.clip, camera.devicePixelRatio}, *cell, colour, 0.35F);
    endClip();
    const std::vector<LineSegment> box = edgesOf(cells_.geometry()->boxes[*cell]);
    const BatchPtr edges = batches_.makeLines(nullptr, box);
    batches_.uploadNow(*edges);
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
  const bool wires = parts.mode == ViewMode::Wireframe || parts.mode == ViewMode::HiddenLine;
  if (parts.mode == ViewMode::SourceTriangles && parts.walkable && parts.outlines)
    drawLines(scene_.sourceMesh.creases, outlineColour(), 1.0F * pixel, 5e-5F, true);
  for (const MeshBatches& mesh : scene_.walkable) {
    if (parts.walkable && parts.outlines && !wires) {
      drawLines(mesh.creases, creaseColour(), 1.0F * pixel, 3e-5F);
      drawLines(mesh.outline, outlineColour(), 1.3F * pixel, 8e-5F);
    }
    if (parts.connections) {
      drawLines(mesh.connections, outlineColour(), 4.5F * pixel, 1.1e-4F);
      drawLines(mesh.connections, connectionColour(), 2.5F * pixel, 1.2e-4F);
    }
    if (parts.steps) {
      drawLines(mesh.steps, outlineColour(), 4.0F * pixel, 1.3e-4F);
      drawLines(mesh.steps, stepColour(), 2.2F * pixel, 1.4e-4F);
    }
    if (parts.gaps) {
      drawLines(mesh.gaps, outlineColour(), 4.0F * pixel, 1.3e-4F);
      drawLines(mesh.gaps, gapColour(), 2.2F * pixel, 1.4e-4F);
    }
    if (parts.drops) {
      drawLines(mesh.drops, outlineColour(), 4.4F * pixel, 1.3e-4F);
      drawLines(mesh.drops, dropColour(), 2.4F * pixel, 1.4e-4F);
    }
    if (parts.obstacleEdges) drawLines(mesh.obstacleEdges, obstacleEdgeColour(), 2.8F * pixel, 1.6e-4F);
  }
  endLines();
}

void SceneRenderer::beginLines(const SceneCamera& camera) {
  setSides(true);  // their strips face either way
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

}  // namespace footfall::ui
