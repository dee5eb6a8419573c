// Draws the cells of a parallel block over a scene: all of them, their borders, and those that stand out.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <set>

#include "ui/view/cell_renderer.hpp"
#include "ui/view/line_painter.hpp"
#include "ui/view/scene_content.hpp"
#include "ui/view/scene_rule.hpp"

namespace footfall::ui {

/// Cells that stand out.
struct MarkedCells {
  std::optional<std::size_t> hovered, selected;
  bool operator==(const MarkedCells&) const = default;
};

/// Members that begin with "set" need no OpenGL context.
class CellPainter {
 public:
  CellPainter(SceneStrokes& strokes, LinePainter& lines) : strokes_(strokes), lines_(lines) {}

  /// Returns an empty text, or why the program cannot be built.
  QString initialize();
  void release();

  void setCells(std::shared_ptr<const CellGeometry> geometry, CellColours colours);
  void setColours(CellColours colours) { cells_.setColours(std::move(colours)); }
  void setMarked(const MarkedCells& marked) { marked_ = marked; }
  [[nodiscard]] const std::shared_ptr<const CellGeometry>& geometry() const { return cells_.geometry(); }
  /// Another number after every change of the colours.
  [[nodiscard]] int version() const { return cells_.version(); }
  [[nodiscard]] bool isShown(const SceneParts& parts) const { return parts.cells && geometry(); }

  /// Uploads borders of cells that have been set. To be called before each frame.
  void uploadBorders();
  /// Over the surfaces and under their lines: what is walkable can still be seen by its outline.
  void draw(const SceneContent& scene, const SceneCamera& camera, bool outlines);
  /// Through everything, so that a cell behind a wall is found as well.
  void drawMarked(const SceneCamera& camera);

 private:
  /// All that decides which floors of cells are hidden.
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
