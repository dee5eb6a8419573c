// Draws surfaces of a scene with their paints and patterns (shaders/surface.vert), and the edges of their triangles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "ui/view/scene_rule.hpp"
#include "ui/view/scene_strokes.hpp"

namespace footfall::ui {

class SurfacePainter {
 public:
  explicit SurfacePainter(SceneStrokes& strokes) : strokes_(strokes) {}

  /// Returns an empty text, or why the program cannot be built.
  QString initialize();
  void release() { program_.removeAllShaders(); }

  /// Surfaces are drawn between these two, each in its own paint until another is set. `hatchBacks`: what a cut shows
  /// from behind is hatched. `pale`: from 0, the paints' own colours, to 1, hardly any.
  void begin(const SceneCamera& camera, bool hatchBacks, float pale = 0);
  void end();
  /// `offset`: steps of polygon offset away from the eye; coplanar surfaces with different triangles need one each.
  void draw(const SceneBatchPtr& batch, float offset);
  /// The same for some of its triangles.
  void drawPart(const SceneBatchPtr& batch, int first, int count, float offset);

  /// The paint of everything; nothing: each its own. `unlit`: without light and shade.
  void setOnlyPaint(const std::optional<Paint>& paint, bool unlit = false);
  /// The paint of floors of the environment, and whether only these are drawn of it.
  void setFloors(const Paint& paint, bool only);
  void endFloors();
  /// What becomes of pieces of hidden layers whose triangle of the environment stays; with `only`, nothing else is
  /// drawn.
  void setUnseenLayers(SceneRule::Unseen unseen, bool only = false);
  /// Whether everything has the colour of the background.
  void setAsBackground(bool on) { program_.setUniformValue("asBackground", on); }

  /// The edges of all triangles of a surface, in one colour or, without, in the paints of the triangles. Ends with
  /// begin() as it was without hatching.
  void drawWires(const SceneBatchPtr& batch, const SceneCamera& camera, const std::optional<QColor>& colour);

 private:
  SceneStrokes& strokes_;
  QOpenGLShaderProgram program_;
  /// Not in OpenGL ES; null where it is missing: no wires then.
  void(QOPENGLF_APIENTRYP polygonMode_)(GLenum face, GLenum mode) = nullptr;
};

}  // namespace footfall::ui
