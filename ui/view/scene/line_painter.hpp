// Draws lines of a scene (shaders/line.vert).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/view/scene/scene_strokes.hpp"

namespace footfall::ui {

class LinePainter {
 public:
  explicit LinePainter(SceneStrokes& strokes) : strokes_(strokes) {}

  /// Returns an empty text, or the reason why the program cannot be built.
  QString initialize() { return buildProgram(program_, QStringLiteral("line")); }
  void release() { program_.removeAllShaders(); }
  /// The program, for other classes that draw lines in the same context.
  [[nodiscard]] QOpenGLShaderProgram& program() { return program_; }

  /// Lines are drawn between begin() and end(), with both sides and blending.
  void begin(const SceneCamera& camera);
  void end();
  /// `width` is in device pixels; `lift` moves towards the eye, in normalized depth.
  void draw(const SceneBatchPtr& batch, const QColor& colour, float width, float lift);

 private:
  SceneStrokes& strokes_;
  QOpenGLShaderProgram program_;
};

}  // namespace footfall::ui
