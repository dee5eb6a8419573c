// Shared by the painters of a scene: the context's functions, the batches, and the slice that is being drawn.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QString>
#include <QVector3D>
#include <QVector4D>

#include "ui/view/scene/appearance.hpp"
#include "ui/view/scene/drawing_slice.hpp"
#include "ui/view/scene/scene_batches.hpp"
#include "ui/view/scene/scene_camera.hpp"

namespace footfall::ui {

/// Builds the program of shaders/NAME.vert and NAME.frag. Returns an empty text, or the reason why it cannot be built,
/// in one line.
QString buildProgram(QOpenGLShaderProgram& program, const QString& name);

QVector3D toVector(const QColor& colour);
/// The colour in rgb, and the pattern as shaders/surface.vert reads it.
QVector4D toVector(const Paint& paint);

/// Draws batches a slice at a time. Needs a current OpenGL context from initialize() on, as all painters do.
class SceneStrokes : public QOpenGLExtraFunctions {
 public:
  explicit SceneStrokes(SceneBatches& batches) : batches_(batches) { whole_.beginWhole(); }

  void initialize() { initializeOpenGLFunctions(); }
  /// Later drawing belongs to `slice`; null: to a picture that is drawn in one pass.
  void setSlice(DrawingSlice* slice) { slice_ = slice ? slice : &whole_; }
  [[nodiscard]] DrawingSlice& slice() { return *slice_; }
  [[nodiscard]] SceneBatches& batches() { return batches_; }

  /// Sets whether later drawing omits covers of closed levels.
  void setLeaveCovers(bool leave) { leaveCovers_ = leave; }
  [[nodiscard]] bool leaveCovers() const { return leaveCovers_; }
  /// Sets whether faces seen from behind are drawn.
  void setSides(bool backs);
  void beginClip(const SceneCamera& camera);
  void endClip();
  /// Binds a program and sets its camera parameters.
  void useCamera(QOpenGLShaderProgram& program, const SceneCamera& camera) const;
  /// Draws the primitives of a batch, which may be null, that the slice allows; `prepare` sets the parameters of the
  /// program first.
  template <typename Prepare>
  void draw(QOpenGLShaderProgram& program, const SceneBatchPtr& batch, Prepare prepare) {
    if (!batch || batch->count == 0) return;
    drawPart(program, *batch, 0, batch->count, prepare);
  }
  /// Draws `count` of its primitives from `first` on.
  template <typename Prepare>
  void drawPart(QOpenGLShaderProgram& program, SceneBatch& batch, int first, int count, Prepare prepare) {
    const DrawingSlice::Range range = slice_->take(count);
    if (range.count == 0) return;
    prepare();
    batches_.useLayers(program, batch);
    batches_.draw(batch, first + range.first, range.count);
  }

 private:
  SceneBatches& batches_;
  DrawingSlice whole_;
  DrawingSlice* slice_ = &whole_;
  bool leaveCovers_ = false;
};

}  // namespace footfall::ui
