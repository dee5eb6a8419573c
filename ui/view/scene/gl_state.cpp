// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/scene/gl_state.hpp"

#include <QOpenGLContext>

namespace footfall::ui {

GlStateKeeper::GlStateKeeper() : gl_(*QOpenGLContext::currentContext()->extraFunctions()) {
  for (std::size_t i = 0; i < kSwitches.size(); ++i) on_[i] = gl_.glIsEnabled(kSwitches[i]);
  const auto get = [this](GLenum name, GLint& value) { gl_.glGetIntegerv(name, &value); };
  get(GL_ACTIVE_TEXTURE, activeTexture_);
  for (std::size_t i = 0; i < kUnits; ++i) {
    gl_.glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
    get(GL_TEXTURE_BINDING_2D, textures_[i]);
  }
  gl_.glActiveTexture(static_cast<GLenum>(activeTexture_));
  get(GL_CURRENT_PROGRAM, program_);
  get(GL_VERTEX_ARRAY_BINDING, array_);
  get(GL_ARRAY_BUFFER_BINDING, buffer_);
  get(GL_READ_FRAMEBUFFER_BINDING, readFrame_);
  get(GL_DRAW_FRAMEBUFFER_BINDING, drawFrame_);
  get(GL_DEPTH_FUNC, depthFunc_);
  get(GL_CULL_FACE_MODE, cullFace_);
  get(GL_UNPACK_ALIGNMENT, unpackAlignment_);
  get(GL_BLEND_SRC_RGB, blend_[0]);
  get(GL_BLEND_DST_RGB, blend_[1]);
  get(GL_BLEND_SRC_ALPHA, blend_[2]);
  get(GL_BLEND_DST_ALPHA, blend_[3]);
  gl_.glGetIntegerv(GL_VIEWPORT, viewport_.data());
  gl_.glGetBooleanv(GL_COLOR_WRITEMASK, colourMask_.data());
  gl_.glGetBooleanv(GL_DEPTH_WRITEMASK, &depthMask_);
  gl_.glGetFloatv(GL_POLYGON_OFFSET_FACTOR, &offsetFactor_);
  gl_.glGetFloatv(GL_POLYGON_OFFSET_UNITS, &offsetUnits_);
  gl_.glGetFloatv(GL_LINE_WIDTH, &lineWidth_);
}

GlStateKeeper::~GlStateKeeper() {
  for (std::size_t i = 0; i < kSwitches.size(); ++i) {
    if (on_[i] != GL_FALSE) {
      gl_.glEnable(kSwitches[i]);
    } else {
      gl_.glDisable(kSwitches[i]);
    }
  }
  for (std::size_t i = 0; i < kUnits; ++i) {
    gl_.glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
    gl_.glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(textures_[i]));
  }
  gl_.glActiveTexture(static_cast<GLenum>(activeTexture_));
  gl_.glUseProgram(static_cast<GLuint>(program_));
  gl_.glBindVertexArray(static_cast<GLuint>(array_));
  gl_.glBindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(buffer_));
  gl_.glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(readFrame_));
  gl_.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(drawFrame_));
  gl_.glDepthFunc(static_cast<GLenum>(depthFunc_));
  gl_.glCullFace(static_cast<GLenum>(cullFace_));
  gl_.glPixelStorei(GL_UNPACK_ALIGNMENT, unpackAlignment_);
  gl_.glBlendFuncSeparate(static_cast<GLenum>(blend_[0]), static_cast<GLenum>(blend_[1]),
                          static_cast<GLenum>(blend_[2]), static_cast<GLenum>(blend_[3]));
  gl_.glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
  gl_.glColorMask(colourMask_[0], colourMask_[1], colourMask_[2], colourMask_[3]);
  gl_.glDepthMask(depthMask_);
  gl_.glPolygonOffset(offsetFactor_, offsetUnits_);
  gl_.glLineWidth(lineWidth_);
}

}  // namespace footfall::ui
