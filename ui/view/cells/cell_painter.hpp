// Draws the cells of a parallel block over a scene: all cells, their borders, and the highlighted ones.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <set>

#include "ui/view/cells/cell_renderer.hpp"
#include "ui/view/scene/line_painter.hpp"
#include "ui/view/scene/scene_content.hpp"
#include "ui/view/scene/scene_rule.hpp"

namespace footfall::ui {

/// Highlighted cells.
struct MarkedCells {
  std::optional<std::size_t> hovered, selected;
  bool operator==(const MarkedCells&) const = default;
};

/// Members that begin with "set" need no OpenGL context.
class CellPainter {
 public:
  CellPainter(SceneStrokes& strokes, LinePainter& lines) : strokes_(strokes), lines_(lines) {}

  /// Returns an empty text, or the reason why the program cannot be built.
  QString initialize();
  void release();

  void setCells(std::shared_ptr<const CellGeometry> geometry, CellColours colours);
  void setColours(CellColours colours) { cells_.setColours(std::move(colours)); }
  void setMarked(const MarkedCells& marked) { marked_ = marked; }
  [[nodiscard]] const std::shared_ptr<const CellGeometry>& geometry() const { return cells_.geometry(); }
  /// A number that differs after every change of the colours.
  [[nodiscard]] int version() const { return cells_.version(); }
  [[nodiscard]] bool isShown(const SceneParts& parts) const { return parts.cells && geometry(); }

  /// Uploads borders of cells that have been set. Called before each frame.
  void uploadBorders();
  /// Draws over the surfaces and under their lines, so that outlines of the walkable area stay visible.
  void draw(const SceneContent& scene, const SceneCamera& camera, bool outlines);
  /// Draws through everything, so that a cell behind a wall is visible as well.
  void drawMarked(const SceneCamera& camera);

 private:
  /// The state that determines which floors of cells are hidden.
  struct Kinds {
    std::shared_ptr<const EnvironmentGeometry> environment;
    std::shared_ptr<const EnvironmentLayers> layers;
    std::set<std::uint32_t> hidden;
    bool operator==(const Kinds&) const = default;
  };

  void updateKinds(const SceneContent& scene);

  SceneStrokes& strokes_;
  LinePainter& lines_;
  CellRenderer cells_;
  MarkedCells marked_;
  Kinds kinds_;
  bool bordersPending_ = false;
  SceneBatchPtr borders_;
};

}  // namespace footfall::ui
