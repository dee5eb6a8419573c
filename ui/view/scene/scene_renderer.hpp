// Draws an environment and the walkable area on it with vertex buffers and the programs of shaders/.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLExtraFunctions>
#include <QString>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "ui/view/scene/scene_content.hpp"
#include "ui/view/scene/scene_painter.hpp"
#include "ui/view/scene/scene_pictures.hpp"

namespace footfall::ui {

/// All members except those that begin with "set" need the OpenGL context of initialize() to be current.
class SceneRenderer : protected QOpenGLExtraFunctions {
 public:
  /// Returns an empty text, or the reason why the programs cannot be built, in one line.
  QString initialize();
  void release();
  /// The program of lines, for other classes that draw lines in the same context.
  [[nodiscard]] QOpenGLShaderProgram& lineProgram() { return painter_.lines().program(); }

  /// Shows another environment (null: none), without content. For all setters: draw() and advance() upload new content,
  /// which is shown once all of it is uploaded.
  void setEnvironment(std::shared_ptr<const EnvironmentGeometry> geometry);
  /// Shows an edit of the environment; the previous one stays visible until the new buffers are full.
  void replaceEnvironment(std::shared_ptr<const EnvironmentGeometry> geometry);
  /// Shows a backdrop behind the environment (null: none); the previous one stays visible until the new buffers are
  /// full.
  void setBackdrop(BackdropPtr backdrop);
  void setContent(ViewContent content);
  void setCells(std::shared_ptr<const CellGeometry> geometry, CellColours colours);
  void setCellColours(CellColours colours);
  void setMarkedCells(const MarkedCells& marked) { painter_.cells().setMarked(marked); }
  /// Sets the field of heat maps. Null: there is none yet.
  void setField(std::shared_ptr<const FieldGeometry> field);
  void setFieldScale(const FieldScale& scale);
  /// Sets the surfaces that ViewMode::SourceTriangles shows instead of the walkable ones. Null: there are none yet.
  void setSources(std::shared_ptr<const NavigationMeshGeometry> sources);
  /// Hides layers by number; lines between two hidden layers are hidden too.
  void setHiddenLayers(const std::set<std::uint32_t>& hidden);

  struct Haste {
    bool moving = false;   ///< the camera will be elsewhere in the next frame
    bool hurried = false;  ///< no outlines and creases; large environments coarse, and their content as paint
    double ms = 0;         ///< time to continue a picture that will be kept
  };
  /// While the camera rests, pictures (ScenePictures) are drawn once and kept, so that later frames cost only what is
  /// new. Returns whether the frame shows everything that it should. Otherwise it shows the previous picture or, after
  /// a movement, the reduced one of `hurried`: call advance() until it returns true, and draw again.
  bool draw(const SceneCamera& camera, const SceneParts& parts, const Haste& haste);
  /// Continues for about `ms` the picture that the last draw() lacked; returns whether it is complete.
  bool advance(double ms);
  /// Time of the last complete picture; 0 before the first.
  [[nodiscard]] double wholeMs() const { return pictures_.wholeMs(); }

 private:
  SceneContent& coming();
  bool uploadComing(double ms);
  void takeComing(const PictureKey& key);
  void drawDirectly(StillLook look, SceneParts parts, bool hurried);

  SceneBatches batches_;
  ScenePainter painter_{batches_};
  ScenePictures pictures_{painter_, batches_};
  SceneContent scene_;                     ///< the shown content
  std::optional<SceneContent> coming_;     ///< the next content, until its buffers are full
  bool comingMade_ = false;                ///< its batches have been made
  bool afresh_ = false;                    ///< no present content may be shown together with the next
  std::vector<MeshBatches> shownChanges_;  ///< changes over the kept picture, while there are no others
};

}  // namespace footfall::ui
