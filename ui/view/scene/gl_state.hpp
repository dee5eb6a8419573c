// Restores OpenGL state after drawing, because libQGLViewer, QPainter and Qt's compositor draw in the same context.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLExtraFunctions>
#include <array>

namespace footfall::ui {

/// Its destructor restores the state that drawing of the view changes: bindings, tests and masks, blending, clipping,
/// offsets, and pixel storage. The same OpenGL context must be current during its whole life.
class GlStateKeeper {
 public:
  GlStateKeeper();
  ~GlStateKeeper();
  GlStateKeeper(const GlStateKeeper&) = delete;
  GlStateKeeper& operator=(const GlStateKeeper&) = delete;

 private:
  static constexpr std::array<GLenum, 12> kSwitches = {GL_BLEND,
                                                       GL_CULL_FACE,
                                                       GL_DEPTH_TEST,
                                                       GL_SCISSOR_TEST,
                                                       GL_STENCIL_TEST,
                                                       GL_POLYGON_OFFSET_FILL,
                                                       0x2A02 /* GL_POLYGON_OFFSET_LINE */,
                                                       0x3000 /* GL_CLIP_DISTANCE0 */,
                                                       0x3001,
                                                       0x3002,
                                                       GL_DITHER,
                                                       GL_SAMPLE_ALPHA_TO_COVERAGE};
  static constexpr std::size_t kUnits = 2;  ///< texture units that the view uses

  QOpenGLExtraFunctions& gl_;
  std::array<GLboolean, kSwitches.size()> on_{};
  std::array<GLint, kUnits> textures_{};
  std::array<GLint, 4> viewport_{}, blend_{};
  std::array<GLboolean, 4> colourMask_{};
  GLint activeTexture_ = 0, program_ = 0, array_ = 0, buffer_ = 0, readFrame_ = 0, drawFrame_ = 0, depthFunc_ = 0,
        cullFace_ = 0, unpackAlignment_ = 0;
  GLboolean depthMask_ = GL_TRUE;
  GLfloat offsetFactor_ = 0, offsetUnits_ = 0, lineWidth_ = 1;
};

}  // namespace footfall::ui
