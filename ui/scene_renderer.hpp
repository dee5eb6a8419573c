// Draws an environment and what is walkable on it with vertex buffers and the programs of shaders/.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMatrix4x4>
#include <QOpenGLBuffer>
#include <QOpenGLExtraFunctions>
#include <QOpenGLFramebufferObject>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>
#include <QString>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "ui/cell_renderer.hpp"
#include "ui/render_geometry.hpp"

namespace footfall {

/// What to draw of the scene; the legend and the View menu switch these.
struct SceneParts {
  bool environment = true;
  bool walkable = true;
  bool removed = true;
  bool obstacleEdges = true;
  bool connections = true;
  bool outlines = true;  ///< creases of the environment and outlines of the walkable area
  bool cells = false;    ///< of a parallel block, over everything that faces up
  bool operator==(const SceneParts&) const = default;
};

struct SceneCamera {
  QMatrix4x4 modelViewProjection;
  QVector3D eye, viewDirection;
  bool orthographic = false;
  QSize viewport;  ///< device pixels
  float devicePixelRatio = 1;
  float cut = std::numeric_limits<float>::max();  ///< what is higher is left out
  bool operator==(const SceneCamera&) const = default;
};

/// Cells that stand out.
struct MarkedCells {
  std::optional<std::size_t> hovered, selected;
  bool operator==(const MarkedCells&) const = default;
};

/// Every member but those that begin with "set" needs the OpenGL context of initialize() to be current.
class SceneRenderer : protected QOpenGLExtraFunctions {
 public:
  /// Returns an empty text, or why the programs cannot be built, in one line.
  QString initialize();
  void release();
  /// For others that draw lines in the same context.
  [[nodiscard]] QOpenGLShaderProgram& lineProgram() { return lineProgram_; }

  /// Uploaded with the next draw(). Null: nothing.
  void setEnvironment(std::shared_ptr<const EnvironmentGeometry> geometry);
  void setContent(ViewContent content);
  void setCells(std::shared_ptr<const CellGeometry> geometry, CellColours colours);
  void setCellColours(CellColours colours) { cells_.setColours(std::move(colours)); }
  void setMarkedCells(const MarkedCells& marked) { marked_ = marked; }

  /// `moving`: the camera will be elsewhere in the next frame. While it rests, pictures of the environment alone and of
  /// it with the content and the cells, but without changes and marks, are drawn once and kept: frames after that cost
  /// only what is new.
  void draw(const SceneCamera& camera, const SceneParts& parts, bool moving);

 private:
  /// A vertex array with its buffer.
  struct Batch {
    QOpenGLVertexArrayObject array;
    QOpenGLBuffer buffer{QOpenGLBuffer::VertexBuffer};
    int count = 0;  ///< vertices of a surface, instances of lines
  };
  using BatchPtr = std::shared_ptr<Batch>;
  using GeometryPtr = std::shared_ptr<const MeshGeometry>;
  struct MeshBatches {
    GeometryPtr geometry;  ///< what they were made of, which may come again with other content
    BatchPtr surface, creases, outline, obstacleEdges, connections;
  };

  /// All that the picture of the environment depends on.
  struct StillKey {
    std::shared_ptr<const EnvironmentGeometry> environment;
    SceneCamera camera;
    bool surface = false, creases = false;
    QVector4D floorPaint;
    float offset = 0;
    float pale = 0;
    bool operator==(const StillKey&) const = default;
  };
  /// All that the picture with the content depends on.
  struct ContentKey {
    StillKey still;
    SceneParts parts;
    std::vector<GeometryPtr> surfaces;
    std::shared_ptr<const CellGeometry> cells;
    int cellColours = 0;
    bool operator==(const ContentKey&) const = default;
  };
  /// Colour and depth of a frame.
  using Picture = std::unique_ptr<QOpenGLFramebufferObject>;

  void uploadPending();
  MeshBatches takeBatches(const GeometryPtr& geometry, bool withLines, const std::vector<MeshBatches>& known);
  [[nodiscard]] ContentKey contentKey(const StillKey& still, const SceneParts& parts) const;

  void useCamera(QOpenGLShaderProgram& program, const SceneCamera& camera);
  void drawStill(const StillKey& key);
  void drawContent(const SceneCamera& camera, const SceneParts& parts);
  void drawChanges(const SceneCamera& camera, const SceneParts& parts);
  [[nodiscard]] bool showsCells(const SceneParts& parts) const { return parts.cells && cells_.geometry(); }
  void drawCells(const SceneCamera& camera, const SceneParts& parts);
  void drawMarkedCells(const SceneCamera& camera, const SceneParts& parts);
  bool copyStill(const StillKey& key);
  bool copyContent(const ContentKey& key);
  bool copyToFrame(const QOpenGLFramebufferObject& picture, GLint frame);
  void beginSurfaces(const SceneCamera& camera, float pale = 0);
  void drawSurfaces(const SceneCamera& camera, const SceneParts& parts);
  void drawAllLines(const SceneCamera& camera, const SceneParts& parts);
  BatchPtr makeSurface(const std::vector<SurfaceVertex>& vertices);
  BatchPtr makeLines(const std::vector<LineSegment>& segments);
  void drawBackground();
  void drawSurface(const BatchPtr& batch, float offset);
  void beginLines(const SceneCamera& camera);
  void endLines();
  void drawLines(const BatchPtr& batch, const QColor& colour, float width, float lift);

  QOpenGLShaderProgram surfaceProgram_, lineProgram_, backgroundProgram_;
  QOpenGLVertexArrayObject emptyArray_;

  std::shared_ptr<const EnvironmentGeometry> environment_;
  ViewContent content_;
  bool environmentPending_ = false, contentPending_ = false;

  BatchPtr environmentSurface_, environmentCreases_;
  Picture still_;  ///< belongs to stillKey_
  StillKey stillKey_;
  Picture picture_;  ///< belongs to pictureKey_
  ContentKey pictureKey_;
  std::vector<MeshBatches> removed_, walkable_, changes_;
  CellRenderer cells_;
  MarkedCells marked_;
  bool bordersPending_ = false;
  BatchPtr cellBorders_;
};

}  // namespace footfall
