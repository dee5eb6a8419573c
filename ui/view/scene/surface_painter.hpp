// Draws surfaces of a scene with their paints and patterns (shaders/surface.vert), and the edges of their triangles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "ui/view/scene/scene_rule.hpp"
#include "ui/view/scene/scene_strokes.hpp"

namespace footfall::ui {

class SurfacePainter {
 public:
  explicit SurfacePainter(SceneStrokes& strokes) : strokes_(strokes) {}

  /// Returns an empty text, or the reason why the program cannot be built.
  QString initialize();
  void release() { program_.removeAllShaders(); }

  /// Surfaces are drawn between begin() and end(), each in its own paint until another is set. `hatchBacks`: backs that
  /// a cut reveals are hatched. `pale`: from 0 (the paints' own colours) to 1 (hardly any colour).
  void begin(const SceneCamera& camera, bool hatchBacks, float pale = 0);
  void end();
  /// `offset` is in steps of polygon offset away from the eye; coplanar surfaces with different triangles need one
  /// each.
  void draw(const SceneBatchPtr& batch, float offset);
  /// Draws some of its triangles.
  void drawPart(const SceneBatchPtr& batch, int first, int count, float offset);

  /// Sets one paint for everything; empty: each surface has its own. `unlit`: without shading.
  void setOnlyPaint(const std::optional<Paint>& paint, bool unlit = false);
  /// The paint of floors of the environment, and whether only these are drawn of it.
  void setFloors(const Paint& paint, bool only);
  void endFloors();
  /// Sets the drawing of pieces of hidden layers whose triangle of the environment stays; with `only`, nothing else is
  /// drawn.
  void setUnseenLayers(SceneRule::Unseen unseen, bool only = false);
  /// Sets whether everything has the colour of the background.
  void setAsBackground(bool on) { program_.setUniformValue("asBackground", on); }

  /// Draws the edges of all triangles of a surface, in one colour or, if empty, in the paints of the triangles.
  /// Restores the state of begin() without hatching.
  void drawWires(const SceneBatchPtr& batch, const SceneCamera& camera, const std::optional<QColor>& colour);

 private:
  SceneStrokes& strokes_;
  QOpenGLShaderProgram program_;
  /// Missing in OpenGL ES; null where it is missing: there are no wires then.
  void(QOPENGLF_APIENTRYP polygonMode_)(GLenum face, GLenum mode) = nullptr;
};

}  // namespace footfall::ui
