// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/scene/surface_painter.hpp"

#include <QOpenGLContext>

#ifndef GL_LINE
#define GL_LINE 0x1B01  // the headers of OpenGL ES lack these
#define GL_FILL 0x1B02
#endif
#ifndef GL_POLYGON_OFFSET_LINE
#define GL_POLYGON_OFFSET_LINE 0x2A02
#endif

namespace footfall::ui {

QString SurfacePainter::initialize() {
  polygonMode_ =
      reinterpret_cast<decltype(polygonMode_)>(QOpenGLContext::currentContext()->getProcAddress("glPolygonMode"));
  return buildProgram(program_, QStringLiteral("surface"));
}

void SurfacePainter::begin(const SceneCamera& camera, bool hatchBacks, float pale) {
  strokes_.glEnable(GL_POLYGON_OFFSET_FILL);
  strokes_.useCamera(program_, camera);
  program_.setUniformValue("eye", camera.eye);
  program_.setUniformValue("pale", pale);
  program_.setUniformValue("viewDirection", camera.viewDirection);
  program_.setUniformValue("orthographic", camera.orthographic);
  program_.setUniformValue("patternScale", camera.devicePixelRatio);
  program_.setUniformValue("plainFloor", toVector(undecidedPaint()));
  program_.setUniformValue("hatchBacks", hatchBacks);
  program_.setUniformValue("floorsOnly", false);
  program_.setUniformValue("lower", toVector(backgroundLower()));
  program_.setUniformValue("upper", toVector(backgroundUpper()));
  program_.setUniformValue("viewHeight", static_cast<float>(camera.viewport.height()));
  setAsBackground(false);
  setUnseenLayers(SceneRule::Unseen::LeftOut);
  setOnlyPaint(std::nullopt);
}

void SurfacePainter::end() { strokes_.glDisable(GL_POLYGON_OFFSET_FILL); }

void SurfacePainter::draw(const SceneBatchPtr& batch, float offset) {
  strokes_.draw(program_, batch, [&] { strokes_.glPolygonOffset(offset, 4 * offset); });
}

void SurfacePainter::drawPart(const SceneBatchPtr& batch, int first, int count, float offset) {
  if (batch && count > 0)
    strokes_.drawPart(program_, *batch, first, count, [&] { strokes_.glPolygonOffset(offset, 4 * offset); });
}

void SurfacePainter::setOnlyPaint(const std::optional<Paint>& paint, bool unlit) {
  program_.setUniformValue("only", paint.has_value());
  program_.setUniformValue("unlit", unlit);
  if (paint) program_.setUniformValue("onlyPaint", toVector(*paint));
}

void SurfacePainter::setFloors(const Paint& paint, bool only) {
  program_.setUniformValue("floorPaint", toVector(paint));
  program_.setUniformValue("floorsOnly", only);
}

void SurfacePainter::endFloors() { program_.setUniformValue("floorsOnly", false); }

void SurfacePainter::setUnseenLayers(SceneRule::Unseen unseen, bool only) {
  program_.setUniformValue("unseenLayers", only ? 2 : unseen == SceneRule::Unseen::Plain ? 1 : 0);
}

void SurfacePainter::drawWires(const SceneBatchPtr& batch, const SceneCamera& camera,
                               const std::optional<QColor>& colour) {
  if (!batch || batch->count == 0 || !polygonMode_) return;
  begin(camera, false);
  end();
  setOnlyPaint(colour ? std::optional(Paint{*colour}) : std::nullopt, true);
  polygonMode_(GL_FRONT_AND_BACK, GL_LINE);
  strokes_.glLineWidth(camera.devicePixelRatio);
  // Edges of triangles lie under those of the walkable area, which have their own colours.
  strokes_.glEnable(GL_POLYGON_OFFSET_LINE);
  draw(batch, colour ? 0.5F : 0);
  strokes_.glDisable(GL_POLYGON_OFFSET_LINE);
  strokes_.glLineWidth(1);
  polygonMode_(GL_FRONT_AND_BACK, GL_FILL);
  setOnlyPaint(std::nullopt);
}

}  // namespace footfall::ui
