// The overlay of a tool: lines, surfaces, marks and texts at places of the environment, drawn over the scene.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <array>
#include <vector>

#include "footfall/environment.hpp"

namespace footfall::ui {

/// All places are in the environment's coordinates, all widths and sizes in logical pixels.
struct ViewOverlay {
  struct Lines {
    std::vector<std::array<Vec3, 2>> segments;
    QColor colour;
    float width = 2;
    QColor rim = {};  ///< colour of one more pixel on each side, so that it is visible on any background; invalid: none
  };
  struct Surface {
    std::vector<std::array<Vec3, 3>> triangles;
    QColor colour;  ///< with its alpha
  };
  struct Mark {
    Vec3 at;
    QColor colour;
    float size = 9;
  };
  struct Label {
    Vec3 at;
    QString text;
  };
  std::vector<Surface> surfaces;
  std::vector<Lines> lines;
  std::vector<Mark> marks;    ///< visible through everything
  std::vector<Label> labels;  ///< visible through everything, beside their place
  /// True for handles, and for obstacles behind others: parts behind walls are visible as well.
  bool throughWalls = false;
};

}  // namespace footfall::ui
