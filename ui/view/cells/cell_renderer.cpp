// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/cells/cell_renderer.hpp"

#include <cstddef>

#include "ui/view/cells/cell_colours.hpp"

namespace footfall::ui {
namespace {

constexpr std::size_t kTextureWidth = 256;
// The surface under the colours stays visible, and the colours still look as in the legend.
constexpr float kOpacity = 0.86F;

}  // namespace

void CellRenderer::initialize() {
  initializeOpenGLFunctions();
  array_.create();
  buffer_.create();
  glGenTextures(1, &texture_);
  geometryPending_ = coloursPending_ = true;
}

void CellRenderer::release() {
  buffer_.destroy();
  array_.destroy();
  glDeleteTextures(1, &texture_);
  program_.removeAllShaders();
}

void CellRenderer::setGeometry(std::shared_ptr<const CellGeometry> geometry) {
  geometry_ = std::move(geometry);
  geometryPending_ = true;
}

void CellRenderer::setKinds(KindOf kindOf) {
  kindOf_ = std::move(kindOf);
  geometryPending_ = true;
}

void CellRenderer::setColours(CellColours colours) {
  colours_ = std::move(colours);
  coloursPending_ = true;
  ++version_;
}

void CellRenderer::uploadColours() {
  const std::size_t count = geometry_->boxes.size();
  if (count == 0) return;
  const std::size_t width = std::min(count, kTextureWidth);
  const std::size_t height = (count + width - 1) / width;
  std::vector<std::uint8_t> texels(width * height * 4, 0);
  for (std::size_t i = 0; i < count && i < colours_.size(); ++i) {
    if (!colours_[i]) continue;
    texels[4 * i] = static_cast<std::uint8_t>(colours_[i]->red());
    texels[4 * i + 1] = static_cast<std::uint8_t>(colours_[i]->green());
    texels[4 * i + 2] = static_cast<std::uint8_t>(colours_[i]->blue());
    texels[4 * i + 3] = 255;
  }
  glBindTexture(GL_TEXTURE_2D, texture_);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, static_cast<GLsizei>(width), static_cast<GLsizei>(height), 0, GL_RGBA,
               GL_UNSIGNED_BYTE, texels.data());
  glBindTexture(GL_TEXTURE_2D, 0);
}

void CellRenderer::upload() {
  if (geometryPending_) {
    geometryPending_ = false;
    coloursPending_ = true;
    const QOpenGLVertexArrayObject::Binder bound(&array_);
    buffer_.bind();
    if (geometry_) {
      std::vector<CellVertex> surface = geometry_->surface;
      for (std::size_t v = 0; kindOf_ && v < surface.size(); ++v) surface[v].cell |= kindOf_(geometry_->sources[v / 3]);
      buffer_.allocate(surface.data(), static_cast<int>(surface.size() * sizeof(CellVertex)));
    } else {
      buffer_.allocate(0);
    }
    for (GLuint location = 0; location < 2; ++location) glEnableVertexAttribArray(location);
    const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(CellVertex), offset(offsetof(CellVertex, position)));
    glVertexAttribIPointer(1, 1, GL_UNSIGNED_INT, sizeof(CellVertex), offset(offsetof(CellVertex, cell)));
    buffer_.release();
  }
  if (!coloursPending_ || !geometry_) return;
  coloursPending_ = false;
  uploadColours();
}

void CellRenderer::drawRange(const Look& look, std::size_t first, std::size_t count, const QVector4D& onlyColour,
                             float opacity) {
  if (count == 0) return;
  program_.bind();
  program_.setUniformValue("modelViewProjection", look.modelViewProjection);
  look.clip.setTo(program_);
  program_.setUniformValue("patternScale", look.devicePixelRatio);
  program_.setUniformValue("opacity", opacity);
  program_.setUniformValue("leaveCovers", look.leaveCovers);
  program_.setUniformValue("colours", 0);
  program_.setUniformValue("onlyColour", onlyColour);
  const QColor unfinished = unfinishedColour();
  program_.setUniformValue("unfinished", QVector4D(unfinished.redF(), unfinished.greenF(), unfinished.blueF(), 1));
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);  // keeps the window opaque
  glDepthMask(GL_FALSE);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(-1, -4);  // above the floors in the same planes
  const QOpenGLVertexArrayObject::Binder bound(&array_);
  glDrawArrays(GL_TRIANGLES, static_cast<GLint>(first), static_cast<GLsizei>(count));
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glBindTexture(GL_TEXTURE_2D, 0);
  program_.release();
}

void CellRenderer::draw(const Look& look, DrawingSlice& slice) {
  if (!geometry_) return;
  upload();
  const auto [first, count] = slice.take(static_cast<int>(geometry_->surface.size() / 3));
  drawRange(look, 3 * static_cast<std::size_t>(first), 3 * static_cast<std::size_t>(count), {}, kOpacity);
}

void CellRenderer::drawCell(const Look& look, std::size_t cell, const QColor& colour, float opacity) {
  if (!geometry_ || cell >= geometry_->boxes.size()) return;
  upload();
  const std::size_t first = geometry_->firstVertex[cell];
  drawRange(look, first, geometry_->firstVertex[cell + 1] - first,
            QVector4D(colour.redF(), colour.greenF(), colour.blueF(), 1), opacity);
}

}  // namespace footfall::ui
