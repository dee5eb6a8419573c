// Draws an environment and what is walkable on it with vertex buffers and the programs of shaders/.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMatrix4x4>
#include <QOpenGLExtraFunctions>
#include <QOpenGLFramebufferObject>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>
#include <QString>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "ui/view/appearance.hpp"
#include "ui/view/cell_renderer.hpp"
#include "ui/view/clip_planes.hpp"
#include "ui/view/drawing_slice.hpp"
#include "ui/view/field_geometry.hpp"
#include "ui/view/render_geometry.hpp"
#include "ui/view/scene_content.hpp"
#include "ui/view/scene_rule.hpp"

namespace footfall::ui {

struct SceneCamera {
  QMatrix4x4 modelViewProjection;
  QVector3D eye, viewDirection;
  bool orthographic = false;
  QSize viewport;  ///< device pixels
  float devicePixelRatio = 1;
  ClipPlanes clip;
  bool operator==(const SceneCamera&) const = default;
};

/// By which content on an environment, which may be null, is drawn.
[[nodiscard]] SceneRule sceneRule(const SceneParts& parts, const ViewContent& content,
                                  const EnvironmentGeometry* environment, const QVector3D& viewDirection);

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

  /// Without content. Null: nothing. Here and below: what is set is uploaded by draw() and advance(), and shown once
  /// all of it is there.
  void setEnvironment(std::shared_ptr<const EnvironmentGeometry> geometry);
  /// An edit of what is shown, which stays until then.
  void replaceEnvironment(std::shared_ptr<const EnvironmentGeometry> geometry);
  void setContent(ViewContent content);
  void setCells(std::shared_ptr<const CellGeometry> geometry, CellColours colours);
  void setCellColours(CellColours colours);
  void setMarkedCells(const MarkedCells& marked) { marked_ = marked; }
  /// For heat maps. Null: none yet.
  void setField(std::shared_ptr<const FieldGeometry> field);
  void setFieldScale(const FieldScale& scale);
  /// For ViewMode::SourceTriangles, in place of the walkable surfaces. Null: none yet.
  void setSources(std::shared_ptr<const NavigationMeshGeometry> sources);
  /// By number; lines between two of them go with them.
  void setHiddenLayers(const std::set<std::uint32_t>& hidden);

  struct Haste {
    bool moving = false;   ///< the camera will be elsewhere in the next frame
    bool hurried = false;  ///< no outlines and creases; large environments coarse, and what is on them as paint
    double ms = 0;         ///< to go on with a picture that is to be kept
  };
  /// While the camera rests, pictures of the environment alone and of it with the content and the cells, but without
  /// changes and marks, are drawn once and kept: frames after that cost only what is new. Returns whether the frame
  /// shows what it is to show; otherwise it shows the picture before, or, where one looks from elsewhere, what
  /// `hurried` leaves: call advance() until it returns true, and draw again.
  bool draw(const SceneCamera& camera, const SceneParts& parts, const Haste& haste);
  /// Draws on for about so long at the picture that the last draw() lacked; returns whether it is complete.
  bool advance(double ms);
  /// What the last complete picture took; 0 before the first.
  [[nodiscard]] double wholeMs() const { return wholeMs_; }

 private:
  using BatchPtr = SceneBatchPtr;
  using GeometryPtr = std::shared_ptr<const NavigationMeshGeometry>;

  /// All that the picture of the environment depends on.
  struct StillKey {
    std::shared_ptr<const EnvironmentGeometry> environment;
    std::shared_ptr<const EnvironmentLayers> layers;
    std::set<std::uint32_t> hidden;
    SceneCamera camera;
    ViewMode mode = ViewMode::Result;
    SceneRule::Environment drawn = SceneRule::Environment::None;
    bool backs = true, covers = true, creases = false;
    Paint floorPaint;
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

  SceneContent& coming();
  bool uploadComing(double ms);
  void takeComing(const ContentKey& key);
  void uploadBorders();
  [[nodiscard]] SceneRule rule(const SceneCamera& camera, const SceneParts& parts) const;
  [[nodiscard]] StillKey stillKey(const SceneCamera& camera, const SceneParts& parts) const;
  [[nodiscard]] ContentKey contentKey(const StillKey& still, const SceneParts& parts) const;

  static constexpr float kUnderCells = 0.9F;  ///< pale: colours of cells are to look as in their legend

  void useCamera(QOpenGLShaderProgram& program, const SceneCamera& camera);
  void beginClip(const SceneCamera& camera);
  void endClip();
  void drawStill(const StillKey& key, const BatchPtr& surface);
  void drawWires(const BatchPtr& batch, const SceneCamera& camera, const QColor& colour, bool ownColours);
  void drawContent(const SceneCamera& camera, const SceneParts& parts);
  void setSides(bool backs);
  void markCells();
  void drawChanges(const SceneCamera& camera, const SceneParts& parts, const std::vector<MeshBatches>& changes);
  static bool inPicture(const std::vector<MeshBatches>& changes);
  [[nodiscard]] bool showsCells(const SceneParts& parts) const { return parts.cells && cells_.geometry(); }
  void drawCells(const SceneCamera& camera, const SceneParts& parts);
  void drawMarkedCells(const SceneCamera& camera, const SceneParts& parts);
  void drawDirectly(StillKey key, SceneParts parts, bool hurried);
  void prepareState();
  void dropUnfinished();
  void goOnWithStill(const StillKey& key);
  bool goOnWithContent(const ContentKey& key);
  std::chrono::steady_clock::time_point beginGo(DrawingSlice& slice);
  bool endGo(std::chrono::steady_clock::time_point begun, double& sum);
  bool goOn(double ms);
  bool copyToFrame(const QOpenGLFramebufferObject& picture, GLuint frame);
  void beginSurfaces(const SceneCamera& camera, float pale = 0);
  void setOnlyPaint(const std::optional<Paint>& paint, bool unlit = false);
  void drawSurfaces(const SceneCamera& camera, const SceneParts& parts, const SceneRule& rule);
  void drawWalkable(const SceneCamera& camera, ViewMode mode, const SceneRule& rule);
  void drawUnseen(const SceneRule& rule);
  void setUnseenLayers(SceneRule::Unseen unseen, bool only = false);
  void drawField(const SceneCamera& camera);
  void drawAllLines(const SceneCamera& camera, const SceneParts& parts);
  void drawBackground();
  void drawSurface(const BatchPtr& batch, float offset);
  void beginLines(const SceneCamera& camera);
  void endLines();
  void drawLines(const BatchPtr& batch, const QColor& colour, float width, float lift, bool fadeShort = false);

  QOpenGLShaderProgram surfaceProgram_, lineProgram_, backgroundProgram_, fieldProgram_;
  SceneBatches batches_;
  /// Not in OpenGL ES; null where it is missing: wires are then filled.
  void(QOPENGLF_APIENTRYP polygonMode_)(GLenum face, GLenum mode) = nullptr;
  GLuint scaleTexture_ = 0;
  QOpenGLVertexArrayObject emptyArray_;

  SceneContent scene_;                  ///< what is shown
  std::optional<SceneContent> coming_;  ///< what will be, once its buffers are full
  bool comingMade_ = false;             ///< its batches have been made
  bool afresh_ = false;                 ///< nothing of what is shown may be seen with what comes
  FieldScale fieldScale_;

  Picture still_;  ///< belongs to stillKey_
  StillKey stillKey_;
  bool stillComplete_ = false;
  bool keepsPictures_ = true;  ///< until OpenGL turns out not to be able to
  Picture picture_;            ///< belongs to pictureKey_, complete
  ContentKey pictureKey_;
  Picture next_;  ///< belongs to nextKey_, not complete
  ContentKey nextKey_;
  std::optional<ContentKey> wanted_;  ///< the picture that advance() draws
  DrawingSlice whole_, stillSlice_, nextSlice_;
  DrawingSlice* slice_ = &whole_;  ///< that what is drawn now belongs to
  std::int64_t goSize_ = 1024;     ///< of one go
  double stillMs_ = 0, nextMs_ = 0, wholeMs_ = 0;
  std::vector<MeshBatches> shownChanges_;  ///< over picture_, while no others are there
  CellRenderer cells_;
  MarkedCells marked_;
  bool leaveCovers_ = false;  ///< of what is drawn now
  /// All that decides which floors of cells are hidden.
  struct CellKinds {
    std::shared_ptr<const EnvironmentGeometry> environment;
    std::shared_ptr<const EnvironmentLayers> layers;
    std::set<std::uint32_t> hidden;
    bool operator==(const CellKinds&) const = default;
  };
  CellKinds cellKinds_;
  bool bordersPending_ = false;
  BatchPtr cellBorders_;
};

}  // namespace footfall::ui
