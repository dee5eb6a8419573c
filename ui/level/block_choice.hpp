// Chooses the blocks of a large environment that the view shows in full.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "ui/view/camera/camera_pose.hpp"
#include "ui/view/scene/scene_camera.hpp"

namespace footfall::ui {

struct BlockInView {
  std::size_t block = 0;
  std::uint64_t triangles = 0;
  SceneBox box;  ///< in the scene's coordinates
};

/// The size of a box on the screen, in device pixels, along its longer side there. It is 0 where the camera does not
/// see the box, where heights and the cut plane remove all of it, or where it lies behind the eye.
double pixelsOf(const SceneBox& box, const SceneCamera& camera);

/// The blocks that are large enough on the screen to be shown in full, the largest first, then the nearest, up to
/// `most` triangles together. Loaded blocks stay while they are a little smaller, so that a small movement of the
/// camera does not drop and read them again.
std::vector<std::size_t> chooseBlocks(std::span<const BlockInView> blocks, const SceneCamera& camera,
                                      std::uint64_t most, const std::set<std::size_t>& loaded);

}  // namespace footfall::ui
