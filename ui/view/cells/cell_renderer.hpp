// Draws floors in the colours of their cells, with the program of shaders/cell.*.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QMatrix4x4>
#include <QOpenGLBuffer>
#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "ui/view/cells/cell_geometry.hpp"
#include "ui/view/scene/clip_planes.hpp"
#include "ui/view/scene/drawing_slice.hpp"

namespace footfall::ui {

/// A colour for each cell; empty where the cell has no figure yet.
using CellColours = std::vector<std::optional<QColor>>;

/// All members except setColours() and setGeometry() need the OpenGL context of initialize() to be current.
class CellRenderer : protected QOpenGLExtraFunctions {
 public:
  /// The camera and state of a frame.
  struct Look {
    QMatrix4x4 modelViewProjection;
    ClipPlanes clip;
    float devicePixelRatio = 1;
    bool leaveCovers = false;
  };

  void initialize();
  void release();
  [[nodiscard]] QOpenGLShaderProgram& program() { return program_; }

  /// The geometry is uploaded with the next draw. Null: no cells.
  void setGeometry(std::shared_ptr<const CellGeometry> geometry);
  void setColours(CellColours colours);
  [[nodiscard]] const std::shared_ptr<const CellGeometry>& geometry() const { return geometry_; }
  /// Returns the flags of a triangle of the environment that is a cover or hidden: kCellOnCover, kCellHidden, or both.
  using KindOf = std::function<std::uint32_t(std::uint32_t source)>;
  void setKinds(KindOf kindOf);
  /// A number that differs after every change of the colours.
  [[nodiscard]] int version() const { return version_; }

  /// Draws all cells over the present picture, or the part of their triangles that the slice allows.
  void draw(const Look& look, DrawingSlice& slice);
  /// Draws one cell again, in a colour of its own.
  void drawCell(const Look& look, std::size_t cell, const QColor& colour, float opacity);

 private:
  void upload();
  void uploadColours();
  void drawRange(const Look& look, std::size_t first, std::size_t count, const QVector4D& onlyColour, float opacity);

  QOpenGLShaderProgram program_;
  QOpenGLVertexArrayObject array_;
  QOpenGLBuffer buffer_{QOpenGLBuffer::VertexBuffer};
  GLuint texture_ = 0;
  std::shared_ptr<const CellGeometry> geometry_;
  CellColours colours_;
  KindOf kindOf_;
  bool geometryPending_ = false, coloursPending_ = false;
  int version_ = 0;
};

}  // namespace footfall::ui
