// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/scene/field_painter.hpp"

#include <QVector2D>
#include <cstdint>
#include <utility>
#include <vector>

namespace footfall::ui {

void FieldPainter::release() {
  if (colours_ != 0) strokes_.glDeleteTextures(1, &colours_);
  colours_ = 0;
  program_.removeAllShaders();
}

void FieldPainter::bindColours() {
  constexpr int kColours = 256;
  const bool known = colours_ != 0;
  if (!known) strokes_.glGenTextures(1, &colours_);
  strokes_.glActiveTexture(GL_TEXTURE0);
  strokes_.glBindTexture(GL_TEXTURE_2D, colours_);
  if (known) return;
  std::vector<std::uint8_t> colours;
  for (int i = 0; i < kColours; ++i) {
    const QColor colour = heatColour(i / (kColours - 1.0));
    for (const int part : {colour.red(), colour.green(), colour.blue(), 255})
      colours.push_back(static_cast<std::uint8_t>(part));
  }
  strokes_.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kColours, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, colours.data());
  strokes_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  strokes_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  strokes_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
}

void FieldPainter::draw(const SceneBatchPtr& batch, const SceneCamera& camera, const FieldScale& scale) {
  strokes_.draw(program_, batch, [&] {
    strokes_.useCamera(program_, camera);
    bindColours();
    const bool descending = scale.aboveIsRejected;  // light colours are good to walk on
    const auto ends = descending ? std::pair{scale.upper, scale.lower} : std::pair{scale.lower, scale.upper};
    program_.setUniformValue("scale", 0);
    program_.setUniformValue("range", QVector2D(static_cast<float>(ends.first), static_cast<float>(ends.second)));
    const float sign = !scale.limit ? 0.0F : scale.aboveIsRejected ? 1.0F : -1.0F;
    program_.setUniformValue("limit", QVector2D(static_cast<float>(scale.limit.value_or(0)), sign));
    program_.setUniformValue("tolerance", static_cast<float>(1e-4 * (scale.upper - scale.lower)));
    program_.setUniformValue("patternScale", camera.devicePixelRatio);
  });
  strokes_.glBindTexture(GL_TEXTURE_2D, 0);
  program_.release();
}

}  // namespace footfall::ui
