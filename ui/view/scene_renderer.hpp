// Draws an environment and what is walkable on it with vertex buffers and the programs of shaders/.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLExtraFunctions>
#include <QString>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "ui/view/scene_content.hpp"
#include "ui/view/scene_painter.hpp"
#include "ui/view/scene_pictures.hpp"

namespace footfall::ui {

/// Every member but those that begin with "set" needs the OpenGL context of initialize() to be current.
class SceneRenderer : protected QOpenGLExtraFunctions {
 public:
  /// Returns an empty text, or why the programs cannot be built, in one line.
  QString initialize();
  void release();
  /// The program of lines, for others that draw some in the same context.
  [[nodiscard]] QOpenGLShaderProgram& lineProgram() { return painter_.lines().program(); }

  /// Shows another environment (null: none), without content. Here and below: what is set is uploaded by draw() and
  /// advance(), and shown once all of it is there.
  void setEnvironment(std::shared_ptr<const EnvironmentGeometry> geometry);
  /// Shows an edit of the environment; the one before stays in sight until its buffers are full.
  void replaceEnvironment(std::shared_ptr<const EnvironmentGeometry> geometry);
  /// Shows a backdrop behind the environment (null: none); the one before stays in sight until its buffers are full.
  void setBackdrop(BackdropPtr backdrop);
  void setContent(ViewContent content);
  void setCells(std::shared_ptr<const CellGeometry> geometry, CellColours colours);
  void setCellColours(CellColours colours);
  void setMarkedCells(const MarkedCells& marked) { painter_.cells().setMarked(marked); }
  /// Heat maps show this field. Null: there is none yet.
  void setField(std::shared_ptr<const FieldGeometry> field);
  void setFieldScale(const FieldScale& scale);
  /// ViewMode::SourceTriangles shows this in place of the walkable surfaces. Null: there is none yet.
  void setSources(std::shared_ptr<const NavigationMeshGeometry> sources);
  /// Layers by number; lines between two of them go with them.
  void setHiddenLayers(const std::set<std::uint32_t>& hidden);

  struct Haste {
    bool moving = false;   ///< the camera will be elsewhere in the next frame
    bool hurried = false;  ///< no outlines and creases; large environments coarse, and what is on them as paint
    double ms = 0;         ///< to go on with a picture that is to be kept
  };
  /// While the camera rests, pictures (ScenePictures) are drawn once and kept: frames after that cost only what is new.
  /// Returns whether the frame shows what it is to show; otherwise it shows the picture before, or, where one looks
  /// from elsewhere, what `hurried` leaves: call advance() until it returns true, and draw again.
  bool draw(const SceneCamera& camera, const SceneParts& parts, const Haste& haste);
  /// Draws for about so long at the picture that the last draw() lacked; returns whether it is complete.
  bool advance(double ms);
  /// How long the last complete picture took; 0 before the first.
  [[nodiscard]] double wholeMs() const { return pictures_.wholeMs(); }

 private:
  SceneContent& coming();
  bool uploadComing(double ms);
  void takeComing(const PictureKey& key);
  void drawDirectly(StillLook look, SceneParts parts, bool hurried);

  SceneBatches batches_;
  ScenePainter painter_{batches_};
  ScenePictures pictures_{painter_, batches_};
  SceneContent scene_;                     ///< what is shown
  std::optional<SceneContent> coming_;     ///< what will be, once its buffers are full
  bool comingMade_ = false;                ///< its batches have been made
  bool afresh_ = false;                    ///< nothing of what is shown may be seen with what comes
  std::vector<MeshBatches> shownChanges_;  ///< over the kept picture, while no others are there
};

}  // namespace footfall::ui
