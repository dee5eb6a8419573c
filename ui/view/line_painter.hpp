// Draws lines of a scene (shaders/line.vert).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/view/scene_strokes.hpp"

namespace footfall::ui {

class LinePainter {
 public:
  explicit LinePainter(SceneStrokes& strokes) : strokes_(strokes) {}

  /// Returns an empty text, or why the program cannot be built.
  QString initialize() { return buildProgram(program_, QStringLiteral("line")); }
  void release() { program_.removeAllShaders(); }
  /// The program, for others that draw lines in the same context.
  [[nodiscard]] QOpenGLShaderProgram& program() { return program_; }

  /// Lines are drawn between these two, with both sides and blending.
  void begin(const SceneCamera& camera);
  void end();
  /// `width` in device pixels; `lift` towards the eye, in normalized depth.
  void draw(const SceneBatchPtr& batch, const QColor& colour, float width, float lift);

 private:
  SceneStrokes& strokes_;
  QOpenGLShaderProgram program_;
};

}  // namespace footfall::ui
