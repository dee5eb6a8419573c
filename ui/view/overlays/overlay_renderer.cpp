// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/overlays/overlay_renderer.hpp"

#include <QFontMetricsF>
#include <QVector4D>
#include <utility>
#include <vector>

#include "ui/view/geometry/render_geometry.hpp"
#include "ui/view/overlays/label_layout.hpp"
#include "ui/view/scene/clip_planes.hpp"
#include "ui/view/scene/gl_state.hpp"

namespace footfall::ui {
namespace {

constexpr float kHidden = 0.35F;  // opacity of parts behind walls

using Point = std::array<float, 3>;

Point toScene(const Vec3& p, const Vec3& centre) {
  return {static_cast<float>(p.x - centre.x), static_cast<float>(p.y - centre.y), static_cast<float>(p.z - centre.z)};
}

QVector4D toVector(const QColor& colour, float opacity) {
  return {colour.redF(), colour.greenF(), colour.blueF(), colour.alphaF() * opacity};
}

}  // namespace

QString OverlayRenderer::initialize(QOpenGLShaderProgram& lines) {
  initializeOpenGLFunctions();
  lineProgram_ = &lines;
  const QString path = QStringLiteral(":/shaders/overlay");
  if (!surfaceProgram_.addShaderFromSourceFile(QOpenGLShader::Vertex, path + QStringLiteral(".vert")) ||
      !surfaceProgram_.addShaderFromSourceFile(QOpenGLShader::Fragment, path + QStringLiteral(".frag")) ||
      !surfaceProgram_.link())
    return QStringLiteral("shader overlay: ") + surfaceProgram_.log().simplified();
  for (QOpenGLVertexArrayObject* array : {&surfaceArray_, &lineArray_}) array->create();
  for (QOpenGLBuffer* buffer : {&surfaceBuffer_, &lineBuffer_}) {
    buffer->create();
    buffer->setUsagePattern(QOpenGLBuffer::StreamDraw);
  }
  return {};
}

void OverlayRenderer::release() {
  for (QOpenGLVertexArrayObject* array : {&surfaceArray_, &lineArray_}) array->destroy();
  for (QOpenGLBuffer* buffer : {&surfaceBuffer_, &lineBuffer_}) buffer->destroy();
  surfaceProgram_.removeAllShaders();
}

void OverlayRenderer::drawSurface(const ViewOverlay::Surface& surface, const Look& look, float opacity) {
  if (surface.triangles.empty()) return;
  std::vector<Point> points;
  points.reserve(surface.triangles.size() * 3);
  for (const auto& triangle : surface.triangles) {
    for (const Vec3& corner : triangle) points.push_back(toScene(corner, look.centre));
  }
  surfaceProgram_.bind();
  surfaceProgram_.setUniformValue("modelViewProjection", look.modelViewProjection);
  surfaceProgram_.setUniformValue("colour", toVector(surface.colour, opacity));
  const QOpenGLVertexArrayObject::Binder bound(&surfaceArray_);
  surfaceBuffer_.bind();
  surfaceBuffer_.allocate(points.data(), static_cast<int>(points.size() * sizeof(Point)));
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Point), nullptr);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(-4, -16);  // above the surface that it lies on
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(points.size()));
  glDisable(GL_POLYGON_OFFSET_FILL);
  surfaceBuffer_.release();
  surfaceProgram_.release();
}

void OverlayRenderer::drawLines(const ViewOverlay::Lines& lines, const Look& look, float opacity) {
  if (lines.segments.empty()) return;
  std::vector<LineSegment> segments;
  segments.reserve(lines.segments.size());
  for (const auto& [from, to] : lines.segments)
    segments.push_back({toScene(from, look.centre), toScene(to, look.centre)});
  lineProgram_->bind();
  lineProgram_->setUniformValue("modelViewProjection", look.modelViewProjection);
  ClipPlanes().setTo(*lineProgram_);
  lineProgram_->setUniformValue("layered", false);
  lineProgram_->setUniformValue(
      "viewport", QVector2D(static_cast<float>(look.viewport.width()), static_cast<float>(look.viewport.height())));
  const QOpenGLVertexArrayObject::Binder bound(&lineArray_);
  lineBuffer_.bind();
  lineBuffer_.allocate(segments.data(), static_cast<int>(segments.size() * sizeof(LineSegment)));
  for (GLuint location = 0; location < 2; ++location) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, sizeof(LineSegment),
                          reinterpret_cast<const void*>(location * sizeof(LineSegment::from)));
    glVertexAttribDivisor(location, 1);
  }
  const auto pass = [&](const QColor& colour, float width, float lift) {
    lineProgram_->setUniformValue("colour", toVector(colour, opacity));
    lineProgram_->setUniformValue("width", width * look.devicePixelRatio);
    lineProgram_->setUniformValue("lift", lift);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(segments.size()));
  };
  if (lines.rim.isValid()) pass(lines.rim, lines.width + 2, 2.0e-4F);
  pass(lines.colour, lines.width, 2.2e-4F);
  lineBuffer_.release();
  lineProgram_->release();
}

void OverlayRenderer::draw(const std::map<QString, ViewOverlay>& overlays, const Look& look) {
  if (overlays.empty()) return;
  const GlStateKeeper keeper;
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);  // keeps the window opaque
  glDepthMask(GL_FALSE);
  for (const auto& [name, overlay] : overlays) {
    const auto pass = [&](float opacity) {
      for (const ViewOverlay::Surface& surface : overlay.surfaces) drawSurface(surface, look, opacity);
      for (const ViewOverlay::Lines& lines : overlay.lines) drawLines(lines, look, opacity);
    };
    if (overlay.throughWalls) {
      glDisable(GL_DEPTH_TEST);
      pass(kHidden);
      glEnable(GL_DEPTH_TEST);
    }
    pass(1);
  }
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

std::optional<QPointF> OverlayRenderer::project(const Vec3& place, const Look& look) {
  const Point p = toScene(place, look.centre);
  const QVector4D clip = look.modelViewProjection * QVector4D(p[0], p[1], p[2], 1);
  if (clip.w() <= 0) return std::nullopt;
  const QSizeF size = QSizeF(look.viewport) / static_cast<qreal>(look.devicePixelRatio);
  return QPointF((0.5 + 0.5 * static_cast<qreal>(clip.x() / clip.w())) * size.width(),
                 (0.5 - 0.5 * static_cast<qreal>(clip.y() / clip.w())) * size.height());
}

void OverlayRenderer::paint(QPainter& painter, const std::map<QString, ViewOverlay>& overlays, const Look& look,
                            std::vector<QRectF> covered) {
  painter.setRenderHint(QPainter::Antialiasing);
  for (const auto& [name, overlay] : overlays) {
    for (const ViewOverlay::Mark& mark : overlay.marks) {
      const std::optional<QPointF> at = project(mark.at, look);
      if (!at) continue;
      const qreal radius = static_cast<qreal>(mark.size) / 2;
      painter.setPen(QPen(outlineColour(), 1.5));
      painter.setBrush(mark.colour);
      painter.drawEllipse(*at, radius, radius);
      covered.emplace_back(at->x() - radius, at->y() - radius, 2 * radius, 2 * radius);
    }
  }
  LabelLayout layout(QSizeF(look.viewport) / static_cast<qreal>(look.devicePixelRatio), std::move(covered));
  const QFontMetricsF metrics(painter.font());
  for (const auto& [name, overlay] : overlays) {
    for (const ViewOverlay::Label& label : overlay.labels) {
      const std::optional<QPointF> at = project(label.at, look);
      if (!at) continue;
      const QRectF words = metrics.boundingRect(QRectF(0, 0, 400, 400), Qt::AlignLeft, label.text);
      const QRectF box = layout.place(words.adjusted(-6, -3, 6, 3).size(), *at);
      painter.setPen(QPen(outlineColour(), 1));
      painter.setBrush(QColor(255, 255, 255, 230));
      painter.drawRoundedRect(box, 3, 3);
      painter.setPen(outlineColour());
      painter.drawText(box.adjusted(6, 3, -6, -3), Qt::AlignLeft | Qt::AlignVCenter, label.text);
    }
  }
}

}  // namespace footfall::ui
