// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/scene/scene_batches.hpp"

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <algorithm>
#include <cstddef>
#include <utility>

namespace footfall::ui {
namespace {

constexpr int kTextureWidth = 1024;
constexpr GLuint kSurfaceLayer = 3, kLineLayer = 3;  // locations

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

// Null: no context is current, and its objects are deleted with it.
QOpenGLExtraFunctions* currentFunctions() {
  QOpenGLContext* const context = QOpenGLContext::currentContext();
  return context ? context->extraFunctions() : nullptr;
}

// `perPrimitive` elements for each triangle or line.
template <typename Element>
SceneBatch::Bytes bytesOf(const SceneBatches::Owner& owner, const std::vector<Element>& elements,
                          std::size_t perPrimitive) {
  return [owner, data = elements.data(), perPrimitive](std::size_t first, std::size_t count) {
    return QByteArray::fromRawData(reinterpret_cast<const char*>(data + first * perPrimitive),
                                   static_cast<qsizetype>(count * perPrimitive * sizeof(Element)));
  };
}

template <typename Element>
std::size_t sizeOf(const SceneBatches::Joined<Element>& joined) {
  std::size_t size = 0;
  for (const auto& [owner, elements] : joined) size += elements->size();
  return size;
}

template <typename Element>
SceneBatch::Bytes bytesOf(const SceneBatches::Joined<Element>& joined, std::size_t perPrimitive) {
  return [joined, perPrimitive](std::size_t first, std::size_t count) {
    std::size_t skip = first * perPrimitive;
    std::size_t left = count * perPrimitive;
    QByteArray bytes;
    bytes.reserve(static_cast<qsizetype>(left * sizeof(Element)));
    for (const auto& [owner, elements] : joined) {
      const std::size_t from = std::min(skip, elements->size());
      const std::size_t taken = std::min(left, elements->size() - from);
      bytes.append(reinterpret_cast<const char*>(elements->data() + from),
                   static_cast<qsizetype>(taken * sizeof(Element)));
      skip -= from;
      left -= taken;
    }
    return bytes;
  };
}

// The bytes of triangles, some of which are covers.
template <typename Element>
SceneBatch::Bytes withCovers(SceneBatch::Bytes plain, const SceneBatches::CoversPtr& covers) {
  if (!covers) return plain;
  return [plain = std::move(plain), covers](std::size_t first, std::size_t count) {
    QByteArray bytes = plain(first, count);
    auto* const vertices = reinterpret_cast<Element*>(bytes.data());
    for (std::size_t i = 0; i < count; ++i) {
      if (!(*covers)[first + i]) continue;
      for (std::size_t k = 3 * i; k < 3 * i + 3; ++k) vertices[k].normal[3] |= kCover;
    }
    return bytes;
  };
}

template <typename Element, typename ElementOf>
SceneBatch::Bytes bytesOf(const ElementOf& elementOf, std::size_t perPrimitive) {
  return [elementOf, perPrimitive](std::size_t first, std::size_t count) {
    QByteArray bytes;
    bytes.reserve(static_cast<qsizetype>(count * perPrimitive * sizeof(Element)));
    for (std::size_t i = first; i < first + count; ++i) {
      const Element element = elementOf(i);
      for (std::size_t k = 0; k < perPrimitive; ++k)
        bytes.append(reinterpret_cast<const char*>(&element), sizeof(Element));
    }
    return bytes;
  };
}

}  // namespace

SceneBuffer::~SceneBuffer() {
  QOpenGLExtraFunctions* const functions = name_ != 0 ? currentFunctions() : nullptr;
  if (functions) functions->glDeleteBuffers(1, &name_);
}

void SceneBuffer::bind() const { currentFunctions()->glBindBuffer(GL_ARRAY_BUFFER, name_); }

void SceneBuffer::fill(const QByteArray& bytes) {
  currentFunctions()->glGenBuffers(1, &name_);
  bind();
  currentFunctions()->glBufferData(GL_ARRAY_BUFFER, bytes.size(), bytes.constData(), GL_STATIC_DRAW);
}

SceneArray::~SceneArray() {
  QOpenGLExtraFunctions* const functions = name_ != 0 ? currentFunctions() : nullptr;
  if (functions) functions->glDeleteVertexArrays(1, &name_);
}

void SceneArray::bind() {
  if (name_ == 0) currentFunctions()->glGenVertexArrays(1, &name_);
  currentFunctions()->glBindVertexArray(name_);
}

void SceneBatches::initialize() {
  initializeOpenGLFunctions();
  glGenTextures(1, &texture_);
}

void SceneBatches::release() {
  uploads_.clear();
  if (texture_ != 0) glDeleteTextures(1, &texture_);
  texture_ = 0;
}

// --- Batches

SceneBatchPtr SceneBatches::queue(SceneBatch batch) {
  for (int first = 0; first < batch.count; first += SceneBatch::kPiece) {
    const auto number = static_cast<std::size_t>(first / SceneBatch::kPiece);
    if (batch.pieces.size() == number) batch.pieces.emplace_back().vertices = std::make_shared<SceneBuffer>();
    if (batch.layers) batch.pieces[number].layers = std::make_shared<SceneBuffer>();
  }
  const auto made = std::make_shared<SceneBatch>(std::move(batch));
  if (made->count > 0) uploads_.push_back({made});
  return made;
}

SceneBatchPtr SceneBatches::makeSurface(const Owner& owner, const std::vector<SurfaceVertex>& vertices,
                                        const CoversPtr& covers) {
  return queue({SceneBatch::Kind::Surface,
                static_cast<int>(vertices.size() / 3),
                withCovers<SurfaceVertex>(bytesOf(owner, vertices, 3), covers),
                {},
                {}});
}

SceneBatchPtr SceneBatches::makeSurface(const Joined<SurfaceVertex>& vertices, const CoversPtr& covers) {
  return queue({SceneBatch::Kind::Surface,
                static_cast<int>(sizeOf(vertices) / 3),
                withCovers<SurfaceVertex>(bytesOf(vertices, 3), covers),
                {},
                {}});
}

SceneBatchPtr SceneBatches::makeLines(const Joined<LineSegment>& segments) {
  return queue({SceneBatch::Kind::Lines, static_cast<int>(sizeOf(segments)), bytesOf(segments, 1), {}, {}});
}

SceneBatchPtr SceneBatches::makeField(const Owner& owner, const std::vector<FieldVertex>& vertices,
                                      const CoversPtr& covers) {
  return queue({SceneBatch::Kind::Field,
                static_cast<int>(vertices.size() / 3),
                withCovers<FieldVertex>(bytesOf(owner, vertices, 3), covers),
                {},
                {}});
}

SceneBatchPtr SceneBatches::makeLines(const Owner& owner, const std::vector<LineSegment>& segments) {
  return queue({SceneBatch::Kind::Lines, static_cast<int>(segments.size()), bytesOf(owner, segments, 1), {}, {}});
}

SceneBatchPtr SceneBatches::withLayers(const SceneBatchPtr& batch, const LayerOf& layerOf) {
  SceneBatch::Bytes layers;
  if (layerOf) layers = bytesOf<std::uint32_t>(layerOf, 3);  // one for each corner
  return sharing(*batch, std::move(layers));
}

SceneBatchPtr SceneBatches::withLineLayers(const SceneBatchPtr& batch, const LayersOf& layersOf) {
  SceneBatch::Bytes layers;
  if (layersOf) layers = bytesOf<LineLayers>(layersOf, 1);
  return sharing(*batch, std::move(layers));
}

SceneBatchPtr SceneBatches::sharing(const SceneBatch& batch, SceneBatch::Bytes layers) {
  SceneBatch made{batch.kind, batch.count, batch.vertices, std::move(layers), {}};
  for (const SceneBatch::Piece& piece : batch.pieces) made.pieces.emplace_back().vertices = piece.vertices;
  return queue(std::move(made));
}

// --- Uploading

void SceneBatches::uploadPiece(SceneBatch& batch, std::size_t number) {
  SceneBatch::Piece& piece = batch.pieces[number];
  const std::size_t first = number * SceneBatch::kPiece;
  const std::size_t count = std::min<std::size_t>(SceneBatch::kPiece, static_cast<std::size_t>(batch.count) - first);
  piece.array.bind();
  if (!piece.vertices->filled()) piece.vertices->fill(batch.vertices(first, count));
  if (piece.layers && !piece.layers->filled()) piece.layers->fill(batch.layers(first, count));
  const bool lines = batch.kind == SceneBatch::Kind::Lines;
  const GLuint layer = lines ? kLineLayer : kSurfaceLayer;
  for (GLuint location = 0; location < (piece.layers ? layer + 1 : layer); ++location) {
    glEnableVertexAttribArray(location);
    if (lines) glVertexAttribDivisor(location, 1);
  }
  piece.vertices->bind();
  if (lines) {
    beginLinesAt(piece, 0);
  } else if (batch.kind == SceneBatch::Kind::Surface) {
    constexpr int kStride = sizeof(SurfaceVertex);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(SurfaceVertex, position)));
    glVertexAttribPointer(1, 4, GL_BYTE, GL_TRUE, kStride, offset(offsetof(SurfaceVertex, normal)));
    glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, offset(offsetof(SurfaceVertex, colour)));
  } else {
    constexpr int kStride = sizeof(FieldVertex);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(FieldVertex, position)));
    glVertexAttribPointer(1, 1, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(FieldVertex, value)));
    glVertexAttribPointer(2, 4, GL_BYTE, GL_TRUE, kStride, offset(offsetof(FieldVertex, normal)));
  }
  if (piece.layers && !lines) {
    piece.layers->bind();
    glVertexAttribIPointer(layer, 1, GL_UNSIGNED_INT, sizeof(std::uint32_t), nullptr);
  }
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glBindVertexArray(0);
}

bool SceneBatches::upload(double ms) {
  QElapsedTimer clock;
  clock.start();
  while (!uploads_.empty()) {
    Upload& next = uploads_.front();
    if (next.batch.use_count() == 1 || next.next == next.batch->pieces.size()) {  // no longer needed, or done
      uploads_.pop_front();
      continue;
    }
    if (static_cast<double>(clock.nsecsElapsed()) * 1e-6 > ms) return false;
    uploadPiece(*next.batch, next.next++);
  }
  return true;
}

void SceneBatches::uploadNow(SceneBatch& batch) {
  for (std::size_t piece = 0; piece < batch.pieces.size(); ++piece) uploadPiece(batch, piece);
}

// --- Drawing

// Called with the array bound.
void SceneBatches::beginLinesAt(SceneBatch::Piece& piece, int first) {
  const auto skipped = static_cast<std::size_t>(first);
  piece.vertices->bind();
  const auto pointTo = [&](GLuint location, GLint numbers, std::size_t member) {
    glVertexAttribPointer(location, numbers, GL_FLOAT, GL_FALSE, sizeof(LineSegment),
                          offset(skipped * sizeof(LineSegment) + member));
  };
  pointTo(0, 3, offsetof(LineSegment, from));
  pointTo(1, 3, offsetof(LineSegment, to));
  pointTo(2, 2, offsetof(LineSegment, crowd));
  if (piece.layers) {
    piece.layers->bind();
    glVertexAttribIPointer(kLineLayer, 2, GL_UNSIGNED_INT, sizeof(LineLayers), offset(skipped * sizeof(LineLayers)));
  }
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  piece.firstLine = first;
}

void SceneBatches::draw(SceneBatch& batch, int first, int count) {
  while (count > 0) {
    SceneBatch::Piece& piece = batch.pieces[static_cast<std::size_t>(first / SceneBatch::kPiece)];
    const int begin = first % SceneBatch::kPiece;
    const int here = std::min(count, SceneBatch::kPiece - begin);
    piece.array.bind();
    if (batch.kind == SceneBatch::Kind::Lines) {
      if (piece.firstLine != begin) beginLinesAt(piece, begin);
      glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, here);
    } else {
      glDrawArrays(GL_TRIANGLES, 3 * begin, 3 * here);
    }
    first += here;
    count -= here;
  }
  glBindVertexArray(0);
}

// --- Layers

void SceneBatches::setHiddenLayers(const std::set<std::uint32_t>& hidden) {
  hidden_ = hidden;
  hiddenPending_ = true;
}

void SceneBatches::useLayers(QOpenGLShaderProgram& program, const SceneBatch& batch) {
  const bool layered = !hidden_.empty() && batch.layers != nullptr;
  program.setUniformValue("layered", layered);
  program.setUniformValue("shownLayers", 1);
  if (!layered) return;
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, texture_);
  if (hiddenPending_) {
    hiddenPending_ = false;
    // The texture covers every layer that a batch may name: results have a few hundred at most, and a row more costs
    // nothing.
    const int rows = static_cast<int>(*hidden_.rbegin()) / kTextureWidth + 2;
    std::vector<std::uint8_t> shown(static_cast<std::size_t>(rows) * kTextureWidth, 255);
    for (const std::uint32_t layer : hidden_) shown[layer] = 0;
    static_assert(kTextureWidth % 4 == 0);  // rows of bytes are aligned as OpenGL expects it
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, kTextureWidth, rows, 0, GL_RED, GL_UNSIGNED_BYTE, shown.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }
  glActiveTexture(GL_TEXTURE0);
}

}  // namespace footfall::ui
