// Draws heat maps (shaders/field.vert).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/view/geometry/field_geometry.hpp"
#include "ui/view/scene/scene_strokes.hpp"

namespace footfall::ui {

class FieldPainter {
 public:
  explicit FieldPainter(SceneStrokes& strokes) : strokes_(strokes) {}

  /// Returns an empty text, or the reason why the program cannot be built.
  QString initialize() { return buildProgram(program_, QStringLiteral("field")); }
  void release();

  /// Draws floors in the colours of their numbers; places that the scale's limit rejects are hatched.
  void draw(const SceneBatchPtr& batch, const SceneCamera& camera, const FieldScale& scale);

 private:
  void bindColours();

  SceneStrokes& strokes_;
  QOpenGLShaderProgram program_;
  GLuint colours_ = 0;  ///< a texture of one row
};

}  // namespace footfall::ui
