// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/scene/scene_painter.hpp"

#include <cstddef>
#include <optional>

#include "ui/base/look/theme.hpp"
#include "ui/view/scene/appearance.hpp"

namespace footfall::ui {
namespace {

constexpr float kUnderCells = 0.9F;  // paleness: colours of cells must look as in their legend

SceneRule ruleOf(const SceneContent& scene, const SceneCamera& camera, const SceneParts& parts) {
  return sceneRule(parts, scene.content, scene.environment.get(), camera.viewDirection);
}

bool isOfWires(ViewMode mode) { return mode == ViewMode::Wireframe || mode == ViewMode::HiddenLine; }

}  // namespace

SceneRule sceneRule(const SceneParts& parts, const ViewContent& content, const EnvironmentGeometry* environment,
                    const QVector3D& viewDirection) {
  SceneFacts facts;
  facts.reasons = content.firstRemoval != nullptr;
  facts.bothSides = environment && environment->bothSides;
  facts.down = -static_cast<double>(viewDirection.z());
  return {parts, facts};
}

QString ScenePainter::initialize() {
  strokes_.initialize();
  emptyArray_.create();
  QString problem = surfaces_.initialize();
  if (problem.isEmpty()) problem = lines_.initialize();
  if (problem.isEmpty()) problem = buildProgram(backgroundProgram_, QStringLiteral("background"));
  if (problem.isEmpty()) problem = cells_.initialize();
  if (problem.isEmpty()) problem = fields_.initialize();
  return problem;
}

void ScenePainter::release() {
  cells_.release();
  fields_.release();
  lines_.release();
  surfaces_.release();
  backgroundProgram_.removeAllShaders();
  emptyArray_.destroy();
}

void ScenePainter::prepareState() {
  strokes_.glDisable(GL_BLEND);
  strokes_.glDisable(GL_CULL_FACE);
  strokes_.glEnable(GL_DEPTH_TEST);
  strokes_.glDepthFunc(GL_LEQUAL);
}

StillLook ScenePainter::stillLook(const SceneContent& scene, const SceneCamera& camera, const SceneParts& parts) const {
  const SceneRule rule = ruleOf(scene, camera, parts);
  Paint floor = undecidedPaint();
  if (rule.reasons && parts.shows(*scene.content.firstRemoval))
    floor = parts.mode == ViewMode::RejectedBy ? scene.content.firstRemoval->vivid : scene.content.firstRemoval->paint;
  // The offset lies behind everything that may be drawn on top. It has a step for each surface, rounded up so that a
  // few more or less do not change it.
  constexpr std::size_t kSteps = 4;
  const auto offset = static_cast<float>((scene.removed.size() / kSteps + 1) * kSteps);
  const bool creases = rule.environment == SceneRule::Environment::All && parts.outlines && !rule.wires;
  StillLook look;
  look.camera = camera;
  look.mode = parts.mode;
  look.drawn = rule.environment;
  look.backs = rule.backs;
  look.covers = rule.covers;
  look.creases = creases;
  look.dark = isDarkTheme();
  look.floorPaint = floor;
  look.offset = offset;
  look.pale = cells_.isShown(parts) ? kUnderCells : 0;
  return look;
}

void ScenePainter::drawBackground() {
  if (strokes_.slice().take(1).count == 0) return;
  strokes_.glDisable(GL_DEPTH_TEST);
  strokes_.glDepthMask(GL_FALSE);
  backgroundProgram_.bind();
  backgroundProgram_.setUniformValue("lower", toVector(backgroundLower()));
  backgroundProgram_.setUniformValue("upper", toVector(backgroundUpper()));
  const QOpenGLVertexArrayObject::Binder bound(&emptyArray_);
  strokes_.glDrawArrays(GL_TRIANGLES, 0, 3);
  strokes_.glDepthMask(GL_TRUE);
  strokes_.glEnable(GL_DEPTH_TEST);
}

void ScenePainter::drawStill(const SceneContent& scene, const StillLook& look, const SceneBatchPtr& surface) {
  drawBackground();
  strokes_.beginClip(look.camera);
  strokes_.setSides(look.backs);
  strokes_.setLeaveCovers(!look.covers);
  const bool surfaces = look.drawn != SceneRule::Environment::None;
  if (surfaces && look.mode != ViewMode::Wireframe) {
    beginSurfaces(scene, look.camera, look.pale);
    if (isOfWires(look.mode)) surfaces_.setOnlyPaint(Paint{hiddenLineFill()}, true);
    surfaces_.setFloors(look.floorPaint, look.drawn == SceneRule::Environment::Floors);
    surfaces_.draw(surface, look.offset);
    if (scene.backdrop) {
      surfaces_.setFloors(undecidedPaint(), look.drawn == SceneRule::Environment::Floors);
      drawBackdrop(scene, look);
    }
    surfaces_.endFloors();
    surfaces_.setOnlyPaint(std::nullopt);
    surfaces_.end();
  }
  if (surfaces && isOfWires(look.mode)) {
    surfaces_.drawWires(surface, look.camera, wireColour());
    for (const BackdropBatch& block : scene.backdropBlocks)
      surfaces_.drawWires(block.surface, look.camera, wireColour());
  }
  if (look.creases) {
    lines_.begin(look.camera);
    lines_.draw(scene.environmentCreases, creaseColour(), 1.0F * look.camera.devicePixelRatio, 3e-5F);
    lines_.end();
  }
  strokes_.setSides(true);
  strokes_.endClip();
}

// The floors of a backdrop have no states.
void ScenePainter::drawBackdrop(const SceneContent& scene, const StillLook& look) {
  const BackdropBatch& coarse = scene.coarseBackdrop;
  for (const auto& [first, count] : look.hurried ? scene.backdrop->coarseAlone : scene.backdrop->shownCoarse)
    surfaces_.drawPart(coarse.surface, static_cast<int>(first), static_cast<int>(count), look.offset);
  if (look.hurried) return;
  for (const BackdropBatch& block : scene.backdropBlocks) surfaces_.draw(block.surface, look.offset);
}

void ScenePainter::beginSurfaces(const SceneContent& scene, const SceneCamera& camera, float pale) {
  surfaces_.begin(camera, camera.clip.active() && scene.environment && !scene.environment->bothSides, pale);
}

// Draws pieces that are not shown as walkable, but hide what lies under them.
void ScenePainter::drawUnseen(const SceneContent& scene, const SceneRule& rule) {
  const bool all = rule.unseen != SceneRule::Unseen::LeftOut;
  const bool gap = (all ? rule.unseen : rule.unseenLayer) == SceneRule::Unseen::Gap;
  if (!all && (!gap || strokes_.batches().hiddenLayers().empty())) return;
  surfaces_.setAsBackground(gap);
  surfaces_.setOnlyPaint(undecidedPaint());
  for (const MeshBatches& mesh : scene.walkable) {
    const bool layered = mesh.surface && mesh.surface->layers;
    if (all) {
      surfaces_.setUnseenLayers(SceneRule::Unseen::Plain);
      surfaces_.draw(mesh.surface, 0);
    } else if (layered) {
      surfaces_.setUnseenLayers(SceneRule::Unseen::Gap, true);
      surfaces_.draw(mesh.surface, 0);
    }
  }
  surfaces_.setUnseenLayers(SceneRule::Unseen::LeftOut);
  surfaces_.setOnlyPaint(std::nullopt);
  surfaces_.setAsBackground(false);
}

void ScenePainter::drawWalkable(const SceneContent& scene, const SceneCamera& camera, ViewMode mode,
                                const SceneRule& rule) {
  surfaces_.setUnseenLayers(rule.unseenLayer);
  if (mode == ViewMode::SourceTriangles && scene.sourceMesh.surface) {
    surfaces_.draw(scene.sourceMesh.surface, 0);
    surfaces_.setUnseenLayers(SceneRule::Unseen::LeftOut);
    return;
  }
  if (mode == ViewMode::RejectedBy) surfaces_.setOnlyPaint(paleWalkablePaint());
  for (const MeshBatches& mesh : scene.walkable) {
    if (isOfWires(mode)) {
      surfaces_.drawWires(mesh.surface, camera, std::nullopt);
    } else {
      surfaces_.draw(mesh.surface, 0);
    }
  }
  surfaces_.setUnseenLayers(SceneRule::Unseen::LeftOut);
  surfaces_.setOnlyPaint(std::nullopt);
}

void ScenePainter::drawSurfaces(const SceneContent& scene, const SceneCamera& camera, const SceneParts& parts,
                                const SceneRule& rule) {
  beginSurfaces(scene, camera, cells_.isShown(parts) ? kUnderCells : 0);
  drawUnseen(scene, rule);
  if (rule.walkable) drawWalkable(scene, camera, parts.mode, rule);
  const bool vivid = parts.mode == ViewMode::RejectedBy;
  // Coplanar surfaces with different triangles: each later one is nearer by one step of polygon offset. The nearest are
  // drawn first, so that hidden parts are not painted.
  for (std::size_t i = scene.removed.size(); rule.reasons && i-- > 0;) {
    const RemovalStyle& style = *scene.content.removed[i].style;
    const bool plain = !parts.shows(style);
    surfaces_.setOnlyPaint(plain ? std::optional(undecidedPaint()) : vivid ? std::optional(style.vivid) : std::nullopt);
    surfaces_.draw(scene.removed[i].surface, static_cast<float>(scene.removed.size() - i));
  }
  surfaces_.setOnlyPaint(std::nullopt);
  surfaces_.end();
}

void ScenePainter::drawContent(const SceneContent& scene, const SceneCamera& camera, const SceneParts& parts) {
  const SceneRule rule = ruleOf(scene, camera, parts);
  strokes_.beginClip(camera);
  strokes_.setSides(rule.backs);
  strokes_.setLeaveCovers(!rule.covers);
  if (rule.field) {
    fields_.draw(scene.fieldSurface, camera, fieldScale_);  // replaces all other floors
  } else {
    drawSurfaces(scene, camera, parts, rule);
  }
  if (cells_.isShown(parts)) cells_.draw(scene, camera, parts.outlines);
  strokes_.setSides(true);
  drawLines(scene, camera, parts);
  strokes_.endClip();
}

void ScenePainter::drawChanges(const SceneContent& scene, const SceneCamera& camera, const SceneParts& parts,
                               const std::vector<MeshBatches>& changes) {
  if (changes.empty() || !parts.walkable || parts.mode > ViewMode::RejectedBy) return;
  strokes_.beginClip(camera);
  const SceneRule rule = ruleOf(scene, camera, parts);
  strokes_.setSides(rule.backs);
  strokes_.setLeaveCovers(!rule.covers);
  beginSurfaces(scene, camera);
  float offset = 0;
  for (const MeshBatches& mesh : changes) surfaces_.draw(mesh.surface, offset -= 1);
  surfaces_.end();
  strokes_.setSides(true);
  strokes_.endClip();
}

void ScenePainter::drawLines(const SceneContent& scene, const SceneCamera& camera, const SceneParts& parts) {
  lines_.begin(camera);
  const float pixel = camera.devicePixelRatio;
  const auto drawRimmed = [&](const SceneBatchPtr& batch, const QColor& colour, float rim, float width, float lift) {
    lines_.draw(batch, outlineColour(), rim * pixel, lift);
    lines_.draw(batch, colour, width * pixel, lift + 1e-5F);
  };
  if (parts.mode == ViewMode::SourceTriangles && parts.walkable && parts.outlines)
    lines_.draw(scene.sourceMesh.creases, outlineColour(), 1.0F * pixel, 5e-5F);
  for (const MeshBatches& mesh : scene.walkable) {
    if (parts.walkable && parts.outlines && !isOfWires(parts.mode)) {
      lines_.draw(mesh.creases, creaseColour(), 1.0F * pixel, 3e-5F);
      lines_.draw(mesh.outline, outlineColour(), 1.3F * pixel, 8e-5F);
    }
    if (parts.connections) drawRimmed(mesh.connections, connectionColour(), 4.5F, 2.5F, 1.1e-4F);
    if (parts.steps) drawRimmed(mesh.steps, stepColour(), 4.0F, 2.2F, 1.3e-4F);
    if (parts.gaps) drawRimmed(mesh.gaps, gapColour(), 4.0F, 2.2F, 1.3e-4F);
    if (parts.drops) drawRimmed(mesh.drops, dropColour(), 4.4F, 2.4F, 1.3e-4F);
    if (parts.obstacleEdges) lines_.draw(mesh.obstacleEdges, obstacleEdgeColour(), 2.8F * pixel, 1.6e-4F);
  }
  lines_.end();
}

}  // namespace footfall::ui
