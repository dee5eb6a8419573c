// Vertex buffers of surfaces, lines and heat maps, and which layers of them are shown.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLBuffer>
#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>
#include <memory>
#include <set>
#include <vector>

#include "ui/field_geometry.hpp"
#include "ui/render_geometry.hpp"

namespace footfall {

/// A vertex array with its buffers.
struct SceneBatch {
  QOpenGLVertexArrayObject array;
  QOpenGLBuffer buffer{QOpenGLBuffer::VertexBuffer}, layers{QOpenGLBuffer::VertexBuffer};
  int count = 0;  ///< vertices of a surface, instances of lines
};
using SceneBatchPtr = std::shared_ptr<SceneBatch>;

/// Needs a current OpenGL context from initialize() to release().
class SceneBatches : protected QOpenGLExtraFunctions {
 public:
  void initialize();
  void release();

  SceneBatchPtr makeSurface(const std::vector<SurfaceVertex>& vertices);
  SceneBatchPtr makeField(const std::vector<FieldVertex>& vertices);
  SceneBatchPtr makeLines(const std::vector<LineSegment>& segments);
  /// One for each triangle of a surface or a field; empty: they belong to no layer.
  void setSurfaceLayers(const SceneBatchPtr& batch, const std::vector<std::uint32_t>& layers);
  /// One for each line; empty: they belong to no layer.
  void setLineLayers(const SceneBatchPtr& batch, const std::vector<LineLayers>& layers);

  void setHiddenLayers(const std::set<std::uint32_t>& hidden);
  [[nodiscard]] const std::set<std::uint32_t>& hiddenLayers() const { return hidden_; }
  /// Before a program draws the batch: what of it is hidden. Uses the texture unit 1.
  void useLayers(QOpenGLShaderProgram& program, const SceneBatch& batch);

 private:
  void removeLayers(SceneBatch& batch, GLuint location);

  std::set<std::uint32_t> hidden_;
  bool hiddenPending_ = true;
  GLuint texture_ = 0;
};

}  // namespace footfall
