// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/scene/scene_strokes.hpp"

#ifndef GL_CLIP_DISTANCE0
#define GL_CLIP_DISTANCE0 0x3000  // the headers of OpenGL ES lack it
#endif

namespace footfall::ui {

QString buildProgram(QOpenGLShaderProgram& program, const QString& name) {
  const QString path = QStringLiteral(":/shaders/") + name;
  if (program.addShaderFromSourceFile(QOpenGLShader::Vertex, path + QStringLiteral(".vert")) &&
      program.addShaderFromSourceFile(QOpenGLShader::Fragment, path + QStringLiteral(".frag")) && program.link()) {
    return {};
  }
  return QStringLiteral("shader %1: %2; update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1")
      .arg(name, program.log().simplified());
}

QVector3D toVector(const QColor& colour) { return {colour.redF(), colour.greenF(), colour.blueF()}; }

QVector4D toVector(const Paint& paint) { return {toVector(paint.colour), static_cast<float>(paint.pattern) / 127.0F}; }

void SceneStrokes::setSides(bool backs) {
  if (backs) {
    glDisable(GL_CULL_FACE);
  } else {
    glEnable(GL_CULL_FACE);
  }
}

void SceneStrokes::beginClip(const SceneCamera& camera) {
  if (!camera.clip.active()) return;
  for (GLenum i = 0; i < 3; ++i) glEnable(GL_CLIP_DISTANCE0 + i);
}

void SceneStrokes::endClip() {
  for (GLenum i = 0; i < 3; ++i) glDisable(GL_CLIP_DISTANCE0 + i);
}

void SceneStrokes::useCamera(QOpenGLShaderProgram& program, const SceneCamera& camera) const {
  program.bind();
  program.setUniformValue("modelViewProjection", camera.modelViewProjection);
  camera.clip.setTo(program);
  program.setUniformValue("layered", false);
  program.setUniformValue("leaveCovers", leaveCovers_);
}

}  // namespace footfall::ui
