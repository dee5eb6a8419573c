// The drawing order of a scene in each mode.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLVertexArrayObject>
#include <vector>

#include "ui/view/cells/cell_painter.hpp"
#include "ui/view/scene/field_painter.hpp"
#include "ui/view/scene/line_painter.hpp"
#include "ui/view/scene/scene_content.hpp"
#include "ui/view/scene/scene_rule.hpp"
#include "ui/view/scene/surface_painter.hpp"

namespace footfall::ui {

/// The rule by which content on an environment, which may be null, is drawn.
[[nodiscard]] SceneRule sceneRule(const SceneParts& parts, const ViewContent& content,
                                  const EnvironmentGeometry* environment, const QVector3D& viewDirection);

/// The look of an environment without content.
struct StillLook {
  SceneCamera camera;
  ViewMode mode = ViewMode::Result;
  SceneRule::Environment drawn = SceneRule::Environment::None;
  bool backs = true, covers = true, creases = false;
  bool dark = false;  ///< the theme of the background
  Paint floorPaint;
  float offset = 0;      ///< steps of polygon offset behind everything that may be drawn on top
  float pale = 0;        ///< as for SurfacePainter::begin()
  bool hurried = false;  ///< a backdrop is drawn coarse
  bool operator==(const StillLook&) const = default;
};

/// Draws into the current frame. Members that begin with "set" need no OpenGL context.
class ScenePainter {
 public:
  explicit ScenePainter(SceneBatches& batches) : strokes_(batches) {}

  /// Returns an empty text, or the reason why the programs cannot be built, in one line.
  QString initialize();
  void release();

  [[nodiscard]] SceneStrokes& strokes() { return strokes_; }
  [[nodiscard]] LinePainter& lines() { return lines_; }
  [[nodiscard]] CellPainter& cells() { return cells_; }
  [[nodiscard]] const CellPainter& cells() const { return cells_; }
  void setFieldScale(const FieldScale& scale) { fieldScale_ = scale; }
  [[nodiscard]] const FieldScale& fieldScale() const { return fieldScale_; }

  /// Sets the state that all drawing here expects and restores.
  void prepareState();
  [[nodiscard]] StillLook stillLook(const SceneContent& scene, const SceneCamera& camera,
                                    const SceneParts& parts) const;
  /// Draws the background and the environment; `surface` stands for all of it.
  void drawStill(const SceneContent& scene, const StillLook& look, const SceneBatchPtr& surface);
  /// Draws the content of the environment, except changes and marks.
  void drawContent(const SceneContent& scene, const SceneCamera& camera, const SceneParts& parts);
  /// Draws changes nearer than everything that they replace, each nearer than the one before.
  void drawChanges(const SceneContent& scene, const SceneCamera& camera, const SceneParts& parts,
                   const std::vector<MeshBatches>& changes);

 private:
  void drawBackground();
  void drawBackdrop(const SceneContent& scene, const StillLook& look);
  void beginSurfaces(const SceneContent& scene, const SceneCamera& camera, float pale = 0);
  void drawSurfaces(const SceneContent& scene, const SceneCamera& camera, const SceneParts& parts,
                    const SceneRule& rule);
  void drawUnseen(const SceneContent& scene, const SceneRule& rule);
  void drawWalkable(const SceneContent& scene, const SceneCamera& camera, ViewMode mode, const SceneRule& rule);
  void drawLines(const SceneContent& scene, const SceneCamera& camera, const SceneParts& parts);

  SceneStrokes strokes_;
  SurfacePainter surfaces_{strokes_};
  LinePainter lines_{strokes_};
  FieldPainter fields_{strokes_};
  CellPainter cells_{strokes_, lines_};
  QOpenGLShaderProgram backgroundProgram_;
  QOpenGLVertexArrayObject emptyArray_;
  FieldScale fieldScale_;
};

}  // namespace footfall::ui
