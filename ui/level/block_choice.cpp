// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/block_choice.hpp"

#include <QVector4D>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace footfall::ui {
namespace {

// The least size on the screen of a block in full. A block has some 16,000 triangles and a few hundred coarse ones,
// which are smaller than a pixel at this size.
constexpr double kLeastPixels = 80, kLeastPixelsOfLoaded = 60;

std::array<QVector4D, 8> cornersOf(const SceneBox& box) {
  std::array<QVector4D, 8> corners;
  for (unsigned i = 0; i < 8; ++i)
    corners[i] = {static_cast<float>((i & 1U) != 0 ? box.upper.x : box.lower.x),
                  static_cast<float>((i & 2U) != 0 ? box.upper.y : box.lower.y),
                  static_cast<float>((i & 4U) != 0 ? box.upper.z : box.lower.z), 1};
  return corners;
}

// Returns whether all corners are on the far side of a plane.
bool isBehind(const std::array<QVector4D, 8>& corners, const QVector4D& plane) {
  return std::ranges::all_of(corners,
                             [&](const QVector4D& corner) { return QVector4D::dotProduct(plane, corner) < 0; });
}

}  // namespace

double pixelsOf(const SceneBox& box, const SceneCamera& camera) {
  const std::array<QVector4D, 8> corners = cornersOf(box);
  for (const QVector4D& plane : camera.clip.planes)
    if (isBehind(corners, plane)) return 0;
  std::array<QVector4D, 8> seen;
  std::ranges::transform(corners, seen.begin(),
                         [&](const QVector4D& corner) { return camera.modelViewProjection * corner; });
  for (const QVector4D& side : {QVector4D(1, 0, 0, 1), QVector4D(-1, 0, 0, 1), QVector4D(0, 1, 0, 1),
                                QVector4D(0, -1, 0, 1), QVector4D(0, 0, 0, 1)})
    if (isBehind(seen, side)) return 0;
  std::array<double, 2> lower{1, 1}, upper{-1, -1};
  for (const QVector4D& corner : seen) {
    if (!(corner.w() > 0)) return std::max(camera.viewport.width(), camera.viewport.height());  // beside the eye
    const std::array<double, 2> place{corner.x() / corner.w(), corner.y() / corner.w()};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      lower[axis] = std::min(lower[axis], std::max(place[axis], -1.0));
      upper[axis] = std::max(upper[axis], std::min(place[axis], 1.0));
    }
  }
  return std::max((upper[0] - lower[0]) / 2 * camera.viewport.width(),
                  (upper[1] - lower[1]) / 2 * camera.viewport.height());
}

std::vector<std::size_t> chooseBlocks(std::span<const BlockInView> blocks, const SceneCamera& camera,
                                      std::uint64_t most, const std::set<std::size_t>& loaded) {
  struct Candidate {
    double pixels = 0, away = 0;
    const BlockInView* block = nullptr;
  };
  std::vector<Candidate> candidates;
  for (const BlockInView& block : blocks) {
    const double pixels = pixelsOf(block.box, camera);
    if (pixels < (loaded.contains(block.block) ? kLeastPixelsOfLoaded : kLeastPixels)) continue;
    const Vec3 &a = block.box.lower, &b = block.box.upper;
    const QVector3D middle(static_cast<float>((a.x + b.x) / 2), static_cast<float>((a.y + b.y) / 2),
                           static_cast<float>((a.z + b.z) / 2));
    candidates.push_back({pixels, (middle - camera.eye).length(), &block});
  }
  std::ranges::sort(candidates, [](const Candidate& a, const Candidate& b) {
    if (a.pixels != b.pixels) return a.pixels > b.pixels;
    return a.away != b.away ? a.away < b.away : a.block->block < b.block->block;
  });
  std::vector<std::size_t> chosen;
  std::uint64_t triangles = 0;
  for (const Candidate& candidate : candidates) {
    if (triangles + candidate.block->triangles > most) break;
    triangles += candidate.block->triangles;
    chosen.push_back(candidate.block->block);
  }
  return chosen;
}

}  // namespace footfall::ui
