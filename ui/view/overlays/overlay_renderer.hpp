// Draws the overlays of tools: their surfaces and lines with OpenGL, marks and labels with QPainter.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMatrix4x4>
#include <QOpenGLBuffer>
#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>
#include <QPainter>
#include <QPointF>
#include <QRectF>
#include <QSize>
#include <map>
#include <optional>
#include <vector>

#include "ui/view/overlays/view_overlay.hpp"

namespace footfall::ui {

/// Overlays are small and change with the mouse, so they are uploaded in every frame. draw() needs the OpenGL context
/// of initialize() to be current.
class OverlayRenderer : protected QOpenGLExtraFunctions {
 public:
  struct Look {
    QMatrix4x4 modelViewProjection;
    QSize viewport;  ///< device pixels
    float devicePixelRatio = 1;
    Vec3 centre;  ///< the scene's origin, in the environment's coordinates
  };

  /// `lines` is the program of shaders/line.*; returns the reason why the other program cannot be built, or an empty
  /// text.
  QString initialize(QOpenGLShaderProgram& lines);
  void release();

  void draw(const std::map<QString, ViewOverlay>& overlays, const Look& look);
  /// Called after draw(), with a painter of the view. Labels avoid `covered`, in logical pixels, and each other.
  static void paint(QPainter& painter, const std::map<QString, ViewOverlay>& overlays, const Look& look,
                    std::vector<QRectF> covered);
  /// Logical pixels from the upper left corner; empty for places behind the eye.
  static std::optional<QPointF> project(const Vec3& place, const Look& look);

 private:
  void drawSurface(const ViewOverlay::Surface& surface, const Look& look, float opacity);
  void drawLines(const ViewOverlay::Lines& lines, const Look& look, float opacity);

  QOpenGLShaderProgram* lineProgram_ = nullptr;
  QOpenGLShaderProgram surfaceProgram_;
  QOpenGLVertexArrayObject surfaceArray_, lineArray_;
  QOpenGLBuffer surfaceBuffer_{QOpenGLBuffer::VertexBuffer}, lineBuffer_{QOpenGLBuffer::VertexBuffer};
};

}  // namespace footfall::ui
