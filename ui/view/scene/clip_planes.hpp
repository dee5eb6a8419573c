// The clip planes of the programs of shaders/, which remove everything behind one of three planes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLShaderProgram>
#include <QVector4D>
#include <array>

namespace footfall::ui {

struct ShownSpace;

/// A place p of the scene is kept where dot(plane, (p, 1)) >= 0 for each plane. The default planes keep everything.
struct ClipPlanes {
  std::array<QVector4D, 3> planes{QVector4D(0, 0, 0, 1), QVector4D(0, 0, 0, 1), QVector4D(0, 0, 0, 1)};
  bool operator==(const ClipPlanes&) const = default;

  [[nodiscard]] bool active() const { return !(*this == ClipPlanes()); }
  void setTo(QOpenGLShaderProgram& program) const {
    program.setUniformValueArray("clipPlanes", planes.data(), static_cast<int>(planes.size()));
  }
};

/// The planes of heights and cut plane; ShownSpace::shows is not included.
ClipPlanes clipPlanes(const ShownSpace& shown);

}  // namespace footfall::ui
