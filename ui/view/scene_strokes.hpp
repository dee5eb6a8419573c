// What the painters of a scene share: the context's functions, the batches, and how much of a picture is drawn now.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QString>
#include <QVector3D>
#include <QVector4D>

#include "ui/view/appearance.hpp"
#include "ui/view/drawing_slice.hpp"
#include "ui/view/scene_batches.hpp"
#include "ui/view/scene_camera.hpp"

namespace footfall::ui {

/// Builds the program of shaders/NAME.vert and NAME.frag. Returns an empty text, or why it cannot be built, in one
/// line.
QString buildProgram(QOpenGLShaderProgram& program, const QString& name);

QVector3D toVector(const QColor& colour);
/// rgb, and the pattern as shaders/surface.vert reads it.
QVector4D toVector(const Paint& paint);

/// Draws batches a slice at a time. Needs a current OpenGL context from initialize() on, as all painters do.
class SceneStrokes : public QOpenGLExtraFunctions {
 public:
  explicit SceneStrokes(SceneBatches& batches) : batches_(batches) { whole_.beginWhole(); }

  void initialize() { initializeOpenGLFunctions(); }
  /// What is drawn from now on belongs to `slice`; null: to a picture that is drawn in one go.
  void setSlice(DrawingSlice* slice) { slice_ = slice ? slice : &whole_; }
  [[nodiscard]] DrawingSlice& slice() { return *slice_; }
  [[nodiscard]] SceneBatches& batches() { return batches_; }

  /// Whether covers of closed levels are left out of what is drawn from now on.
  void setLeaveCovers(bool leave) { leaveCovers_ = leave; }
  [[nodiscard]] bool leaveCovers() const { return leaveCovers_; }
  /// Whether faces are drawn that are seen from behind.
  void setSides(bool backs);
  void beginClip(const SceneCamera& camera);
  void endClip();
  /// Binds a program and sets what all of them take of a camera.
  void useCamera(QOpenGLShaderProgram& program, const SceneCamera& camera) const;
  /// Draws what the slice lets through of a batch, which may be null; `prepare` sets what the program takes, before.
  template <typename Prepare>
  void draw(QOpenGLShaderProgram& program, const SceneBatchPtr& batch, Prepare prepare) {
    if (!batch || batch->count == 0) return;
    drawPart(program, *batch, 0, batch->count, prepare);
  }
  /// The same for `count` of its primitives from `first` on.
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
