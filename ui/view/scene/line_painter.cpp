// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/scene/line_painter.hpp"

#include <QVector2D>

namespace footfall::ui {

void LinePainter::begin(const SceneCamera& camera) {
  strokes_.setSides(true);  // line strips face either way
  strokes_.glEnable(GL_BLEND);
  strokes_.glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);  // keeps the window opaque
  strokes_.glDepthMask(GL_FALSE);  // soft edges must not hide later drawing
  strokes_.useCamera(program_, camera);
  program_.setUniformValue(
      "viewport", QVector2D(static_cast<float>(camera.viewport.width()), static_cast<float>(camera.viewport.height())));
}

void LinePainter::end() {
  program_.release();
  strokes_.glDepthMask(GL_TRUE);
  strokes_.glDisable(GL_BLEND);
}

void LinePainter::draw(const SceneBatchPtr& batch, const QColor& colour, float width, float lift) {
  strokes_.draw(program_, batch, [&] {
    program_.setUniformValue("colour", QVector4D(toVector(colour), 1));
    program_.setUniformValue("width", width);
    program_.setUniformValue("lift", lift);
  });
}

}  // namespace footfall::ui
