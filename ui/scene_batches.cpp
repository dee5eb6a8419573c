// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene_batches.hpp"

#include <cstddef>

namespace footfall {
namespace {

constexpr int kTextureWidth = 1024;
constexpr GLuint kSurfaceLayer = 3, kLineLayer = 2;  // locations

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

template <typename Element>
void fill(QOpenGLBuffer& buffer, const std::vector<Element>& elements) {
  if (!buffer.isCreated()) buffer.create();
  buffer.bind();
  buffer.allocate(elements.data(), static_cast<int>(elements.size() * sizeof(Element)));
}

}  // namespace

void SceneBatches::initialize() {
  initializeOpenGLFunctions();
  glGenTextures(1, &texture_);
}

void SceneBatches::release() {
  if (texture_ != 0) glDeleteTextures(1, &texture_);
  texture_ = 0;
}

SceneBatchPtr SceneBatches::makeSurface(const std::vector<SurfaceVertex>& vertices) {
  auto batch = std::make_shared<SceneBatch>();
  batch->count = static_cast<int>(vertices.size());
  if (vertices.empty()) return batch;
  batch->array.create();
  const QOpenGLVertexArrayObject::Binder bound(&batch->array);
  fill(batch->buffer, vertices);
  constexpr int kStride = sizeof(SurfaceVertex);
  for (GLuint location = 0; location < 3; ++location) glEnableVertexAttribArray(location);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(SurfaceVertex, position)));
  glVertexAttribPointer(1, 4, GL_BYTE, GL_TRUE, kStride, offset(offsetof(SurfaceVertex, normal)));
  glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, offset(offsetof(SurfaceVertex, colour)));
  batch->buffer.release();
  return batch;
}

SceneBatchPtr SceneBatches::makeField(const std::vector<FieldVertex>& vertices) {
  auto batch = std::make_shared<SceneBatch>();
  batch->count = static_cast<int>(vertices.size());
  if (vertices.empty()) return batch;
  batch->array.create();
  const QOpenGLVertexArrayObject::Binder bound(&batch->array);
  fill(batch->buffer, vertices);
  constexpr int kStride = sizeof(FieldVertex);
  for (GLuint location = 0; location < 3; ++location) glEnableVertexAttribArray(location);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(FieldVertex, position)));
  glVertexAttribPointer(1, 1, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(FieldVertex, value)));
  glVertexAttribPointer(2, 4, GL_BYTE, GL_TRUE, kStride, offset(offsetof(FieldVertex, normal)));
  batch->buffer.release();
  return batch;
}

SceneBatchPtr SceneBatches::makeLines(const std::vector<LineSegment>& segments) {
  auto batch = std::make_shared<SceneBatch>();
  batch->count = static_cast<int>(segments.size());
  if (segments.empty()) return batch;
  batch->array.create();
  const QOpenGLVertexArrayObject::Binder bound(&batch->array);
  fill(batch->buffer, segments);
  for (GLuint location = 0; location < 2; ++location) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, sizeof(LineSegment),
                          offset(location * sizeof(LineSegment::from)));
    glVertexAttribDivisor(location, 1);
  }
  batch->buffer.release();
  return batch;
}

void SceneBatches::removeLayers(SceneBatch& batch, GLuint location) {
  if (!batch.layers.isCreated()) return;
  const QOpenGLVertexArrayObject::Binder bound(&batch.array);
  glDisableVertexAttribArray(location);
  batch.layers.destroy();
}

void SceneBatches::setSurfaceLayers(const SceneBatchPtr& batch, const std::vector<std::uint32_t>& layers) {
  if (!batch || batch->count == 0) return;
  if (layers.size() * 3 != static_cast<std::size_t>(batch->count)) {
    removeLayers(*batch, kSurfaceLayer);
    return;
  }
  std::vector<std::uint32_t> corners;
  corners.reserve(layers.size() * 3);
  for (const std::uint32_t layer : layers) corners.insert(corners.end(), 3, layer);
  const QOpenGLVertexArrayObject::Binder bound(&batch->array);
  fill(batch->layers, corners);
  glEnableVertexAttribArray(kSurfaceLayer);
  glVertexAttribIPointer(kSurfaceLayer, 1, GL_UNSIGNED_INT, sizeof(std::uint32_t), nullptr);
  batch->layers.release();
}

void SceneBatches::setLineLayers(const SceneBatchPtr& batch, const std::vector<LineLayers>& layers) {
  if (!batch || batch->count == 0) return;
  if (layers.size() != static_cast<std::size_t>(batch->count)) {
    removeLayers(*batch, kLineLayer);
    return;
  }
  const QOpenGLVertexArrayObject::Binder bound(&batch->array);
  fill(batch->layers, layers);
  glEnableVertexAttribArray(kLineLayer);
  glVertexAttribIPointer(kLineLayer, 2, GL_UNSIGNED_INT, sizeof(LineLayers), nullptr);
  glVertexAttribDivisor(kLineLayer, 1);
  batch->layers.release();
}

void SceneBatches::setHiddenLayers(const std::set<std::uint32_t>& hidden) {
  hidden_ = hidden;
  hiddenPending_ = true;
}

void SceneBatches::useLayers(QOpenGLShaderProgram& program, const SceneBatch& batch) {
  const bool layered = !hidden_.empty() && batch.layers.isCreated();
  program.setUniformValue("layered", layered);
  program.setUniformValue("shownLayers", 1);
  if (!layered) return;
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, texture_);
  if (hiddenPending_) {
    hiddenPending_ = false;
    // Every layer that a batch may name: results have a few hundred at most, and a row more costs nothing.
    const int rows = static_cast<int>(*hidden_.rbegin()) / kTextureWidth + 2;
    std::vector<std::uint8_t> shown(static_cast<std::size_t>(rows) * kTextureWidth, 255);
    for (const std::uint32_t layer : hidden_) shown[layer] = 0;
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, kTextureWidth, rows, 0, GL_RED, GL_UNSIGNED_BYTE, shown.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }
  glActiveTexture(GL_TEXTURE0);
}

}  // namespace footfall
