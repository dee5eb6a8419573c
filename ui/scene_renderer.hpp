// Draws an environment and what is walkable on it with vertex buffers and the programs of shaders/.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMatrix4x4>
#include <QOpenGLExtraFunctions>
#include <QOpenGLFramebufferObject>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>
#include <QString>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "ui/cell_renderer.hpp"
#include "ui/clip_planes.hpp"
#include "ui/field_geometry.hpp"
#include "ui/render_geometry.hpp"
#include "ui/scene_batches.hpp"
#include "ui/view_mode.hpp"

namespace footfall {

/// What to draw of the scene; the legend and the View menu switch these.
struct SceneParts {
  bool environment = true;
  bool walkable = true;
  bool removed = true;
  bool obstacleEdges = true;
  bool connections = true;
  bool outlines = true;              ///< creases of the environment and outlines of the walkable area
  bool cells = false;                ///< of a parallel block, over everything that faces up
  ViewMode mode = ViewMode::Result;  ///< LevelView::setMode() knows better than who switches parts
  bool operator==(const SceneParts&) const = default;
};

struct SceneCamera {
  QMatrix4x4 modelViewProjection;
  QVector3D eye, viewDirection;
  bool orthographic = false;
  QSize viewport;  ///< device pixels
  float devicePixelRatio = 1;
  ClipPlanes clip;
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
  /// For heat maps. Null: none yet.
  void setField(std::shared_ptr<const FieldGeometry> field);
  void setFieldScale(const FieldScale& scale) { fieldScale_ = scale; }
  /// For ViewMode::SourceTriangles, in place of the walkable surfaces. Null: none yet.
  void setSources(std::shared_ptr<const MeshGeometry> sources);
  /// By number; lines between two of them go with them.
  void setHiddenLayers(const std::set<std::uint32_t>& hidden);

  /// `moving`: the camera will be elsewhere in the next frame. While it rests, pictures of the environment alone and of
  /// it with the content and the cells, but without changes and marks, are drawn once and kept: frames after that cost
  /// only what is new.
  /// `coarse`: of large surfaces, those with fewer triangles.
  void draw(const SceneCamera& camera, const SceneParts& parts, bool moving, bool coarse);

 private:
  using BatchPtr = SceneBatchPtr;
  using GeometryPtr = std::shared_ptr<const MeshGeometry>;
  struct MeshBatches {
    GeometryPtr geometry;  ///< what they were made of, which may come again with other content
    BatchPtr surface, creases, outline, obstacleEdges, connections;
    BatchPtr coarse;  ///< null for surfaces that are small
  };

  /// All that the picture of the environment depends on.
  struct StillKey {
    std::shared_ptr<const EnvironmentGeometry> environment;
    std::shared_ptr<const EnvironmentLayers> layers;
    std::set<std::uint32_t> hidden;
    SceneCamera camera;
    ViewMode mode = ViewMode::Result;
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
    std::shared_ptr<const FieldGeometry> field;
    FieldScale scale;
    bool operator==(const ContentKey&) const = default;
  };
  /// Colour and depth of a frame.
  using Picture = std::unique_ptr<QOpenGLFramebufferObject>;

  void uploadPending();
  void uploadEnvironmentLayers();
  MeshBatches takeBatches(const GeometryPtr& geometry, bool withLines, const std::vector<MeshBatches>& known);
  [[nodiscard]] ContentKey contentKey(const StillKey& still, const SceneParts& parts) const;

  static constexpr float kUnderCells = 0.9F;  ///< pale: colours of cells are to look as in their legend

  void useCamera(QOpenGLShaderProgram& program, const SceneCamera& camera);
  void beginClip(const SceneCamera& camera);
  void endClip();
  void drawStill(const StillKey& key);
  void drawWires(const BatchPtr& batch, const SceneCamera& camera, const QColor& colour, bool ownColours);
  void drawContent(const SceneCamera& camera, const SceneParts& parts);
  void drawChanges(const SceneCamera& camera, const SceneParts& parts);
  [[nodiscard]] bool showsCells(const SceneParts& parts) const { return parts.cells && cells_.geometry(); }
  void drawCells(const SceneCamera& camera, const SceneParts& parts);
  void drawMarkedCells(const SceneCamera& camera, const SceneParts& parts);
  bool copyStill(const StillKey& key);
  bool copyContent(const ContentKey& key);
  bool copyToFrame(const QOpenGLFramebufferObject& picture, GLint frame);
  void beginSurfaces(const SceneCamera& camera, float pale = 0);
  void setOnlyPaint(const std::optional<Paint>& paint, bool unlit = false);
  void drawSurfaces(const SceneCamera& camera, const SceneParts& parts);
  void drawWalkable(const SceneCamera& camera, ViewMode mode);
  void drawField(const SceneCamera& camera);
  void drawAllLines(const SceneCamera& camera, const SceneParts& parts);
  void drawBackground();
  [[nodiscard]] const BatchPtr& surfaceOf(const MeshBatches& mesh) const {
    return coarse_ && mesh.coarse ? mesh.coarse : mesh.surface;
  }
  void drawSurface(const BatchPtr& batch, float offset);
  void beginLines(const SceneCamera& camera);
  void endLines();
  void drawLines(const BatchPtr& batch, const QColor& colour, float width, float lift);

  QOpenGLShaderProgram surfaceProgram_, lineProgram_, backgroundProgram_, fieldProgram_;
  SceneBatches batches_;
  /// Not in OpenGL ES; null where it is missing: wires are then filled.
  void(QOPENGLF_APIENTRYP polygonMode_)(GLenum face, GLenum mode) = nullptr;
  GLuint scaleTexture_ = 0;
  QOpenGLVertexArrayObject emptyArray_;

  std::shared_ptr<const EnvironmentGeometry> environment_;
  ViewContent content_;
  bool environmentPending_ = false, contentPending_ = false;
  std::shared_ptr<const EnvironmentLayers> shownEnvironmentLayers_;
  std::shared_ptr<const FieldGeometry> field_;
  bool fieldPending_ = false, sourcesPending_ = false;
  FieldScale fieldScale_;
  BatchPtr fieldSurface_;
  GeometryPtr sources_;
  MeshBatches sourceBatches_;

  BatchPtr environmentSurface_, environmentCreases_, environmentCoarse_;
  bool coarse_ = false;  ///< in this frame
  Picture still_;        ///< belongs to stillKey_
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
