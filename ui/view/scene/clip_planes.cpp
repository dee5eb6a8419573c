// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/scene/clip_planes.hpp"

#include "ui/view/scene/scene_picker.hpp"

namespace footfall::ui {

ClipPlanes clipPlanes(const ShownSpace& shown) {
  constexpr HeightRange kAll;
  ClipPlanes clip;
  if (shown.heights.upper < kAll.upper) clip.planes[0] = {0, 0, -1, static_cast<float>(shown.heights.upper)};
  if (shown.heights.lower > kAll.lower) clip.planes[1] = {0, 0, 1, static_cast<float>(-shown.heights.lower)};
  if (shown.cut) {
    clip.planes[2] = {static_cast<float>(-shown.cut->nx), static_cast<float>(-shown.cut->ny), 0,
                      static_cast<float>(shown.cut->at)};
  }
  return clip;
}

}  // namespace footfall::ui
