// Vertex buffers of surfaces, lines and heat maps, uploaded piece by piece, and the visibility of their layers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <deque>
#include <functional>
#include <memory>
#include <set>
#include <vector>

#include "ui/view/geometry/field_geometry.hpp"
#include "ui/view/geometry/render_geometry.hpp"

namespace footfall::ui {

/// A buffer in the current OpenGL context, which must be current again when it is destroyed. Qt's own classes keep
/// lists of all their buffers, and runs show thousands of small meshes.
class SceneBuffer {
 public:
  SceneBuffer() = default;
  ~SceneBuffer();
  SceneBuffer(const SceneBuffer&) = delete;
  SceneBuffer& operator=(const SceneBuffer&) = delete;

  [[nodiscard]] bool filled() const { return name_ != 0; }
  void fill(const QByteArray& bytes);
  void bind() const;

 private:
  GLuint name_ = 0;
};

/// A vertex array, with the same requirement as SceneBuffer.
class SceneArray {
 public:
  SceneArray() = default;
  ~SceneArray();
  SceneArray(const SceneArray&) = delete;
  SceneArray& operator=(const SceneArray&) = delete;

  void bind();

 private:
  GLuint name_ = 0;
};

/// Triangles or lines of one kind, in pieces that are uploaded one at a time. Batches may share vertices.
struct SceneBatch {
  enum class Kind { Surface, Field, Lines };
  /// Returns bytes without a copy where they already exist in this form.
  using Bytes = std::function<QByteArray(std::size_t first, std::size_t count)>;

  struct Piece {
    SceneArray array;
    std::shared_ptr<SceneBuffer> vertices;
    std::shared_ptr<SceneBuffer> layers;  ///< null: it belongs to no layer
    int firstLine = 0;                    ///< first line of the array: OpenGL 3.3 cannot draw from a first instance
  };
  static constexpr int kPiece = 1 << 15;  ///< primitives in each piece except the last

  Kind kind = Kind::Surface;
  int count = 0;  ///< triangles of a surface or a field, or lines
  Bytes vertices, layers;
  std::deque<Piece> pieces;
};
using SceneBatchPtr = std::shared_ptr<SceneBatch>;

/// Needs a current OpenGL context from initialize() to release(). Batches must not be drawn before upload() is done.
class SceneBatches : protected QOpenGLExtraFunctions {
 public:
  /// Keeps the uploaded data alive.
  using Owner = std::shared_ptr<const void>;
  /// Several lists that become one batch.
  template <typename Element>
  using Joined = std::vector<std::pair<Owner, const std::vector<Element>*>>;
  using LayerOf = std::function<std::uint32_t(std::size_t triangle)>;
  using LayersOf = std::function<LineLayers(std::size_t line)>;
  /// The triangles of a surface that are covers, beyond those marked by its vertices; null: none.
  using CoversPtr = std::shared_ptr<const std::vector<bool>>;

  void initialize();
  void release();

  /// These functions make batches that belong to no layer.
  SceneBatchPtr makeSurface(const Owner& owner, const std::vector<SurfaceVertex>& vertices,
                            const CoversPtr& covers = nullptr);
  SceneBatchPtr makeSurface(const Joined<SurfaceVertex>& vertices, const CoversPtr& covers = nullptr);
  SceneBatchPtr makeLines(const Joined<LineSegment>& segments);
  SceneBatchPtr makeField(const Owner& owner, const std::vector<FieldVertex>& vertices,
                          const CoversPtr& covers = nullptr);
  SceneBatchPtr makeLines(const Owner& owner, const std::vector<LineSegment>& segments);
  /// The same vertices with layers; without a function, of no layer.
  SceneBatchPtr withLayers(const SceneBatchPtr& batch, const LayerOf& layerOf);
  SceneBatchPtr withLineLayers(const SceneBatchPtr& batch, const LayersOf& layersOf);

  /// Continues for about `ms`; returns whether all batches that still exist can be drawn.
  bool upload(double ms);
  /// Uploads all of one batch.
  void uploadNow(SceneBatch& batch);

  /// Draws triangles of a surface or a field, or lines, counting from 0, with the current program.
  void draw(SceneBatch& batch, int first, int count);

  void setHiddenLayers(const std::set<std::uint32_t>& hidden);
  [[nodiscard]] const std::set<std::uint32_t>& hiddenLayers() const { return hidden_; }
  /// Sets the hidden layers before a program draws the batch. Uses the texture unit 1.
  void useLayers(QOpenGLShaderProgram& program, const SceneBatch& batch);

 private:
  struct Upload {
    SceneBatchPtr batch;
    std::size_t next = 0;  ///< piece
  };

  SceneBatchPtr queue(SceneBatch batch);
  SceneBatchPtr sharing(const SceneBatch& batch, SceneBatch::Bytes layers);
  void uploadPiece(SceneBatch& batch, std::size_t number);
  void beginLinesAt(SceneBatch::Piece& piece, int first);

  std::deque<Upload> uploads_;
  std::set<std::uint32_t> hidden_;
  bool hiddenPending_ = true;
  GLuint texture_ = 0;
};

}  // namespace footfall::ui
