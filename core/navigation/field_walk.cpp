// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/navigation/field_walk.hpp"

#include <algorithm>

namespace footfall::detail {

std::optional<FieldWalk::Exit> FieldWalk::exit() const {
  for (int side = 0; side < 3; ++side) {
    if (side == entered_ || isLeft(side) || !isLeft(side + 1)) continue;
    const FieldVector a = surface_.corner(face_, side), b = surface_.corner(face_, side + 1);
    if (cross(b - a, to_ - a) >= 0) return std::nullopt;
    const double right = asideOf(side), left = asideOf(side + 1);
    return Exit{side, a + (b - a) * std::clamp(right / (right - left), 0.0, 1.0)};
  }
  // Roundings may have put the start beside its face.
  return entered_ < 0 ? towardsTarget() : std::nullopt;
}

std::optional<FieldWalk::Exit> FieldWalk::towardsTarget() const {
  Exit exit;
  double farthest = 0;
  for (int side = 0; side < 3; ++side) {
    const FieldVector a = surface_.corner(face_, side), b = surface_.corner(face_, side + 1), way = b - a;
    const double length = lengthOf(way), outside = length > 0 ? cross(to_ - a, way) / length : 0;
    if (outside <= farthest || surface_.edgeOf(face_, side).isBorder()) continue;
    farthest = outside;
    exit = {side, a + way * std::clamp(dot(from_ - a, way) / (length * length), 0.0, 1.0)};
  }
  if (farthest > 0) return exit;
  return std::nullopt;
}

bool FieldWalk::leave(const Exit& exit) {
  const std::uint32_t half = surface_.halves[face_][exit.side];
  const FieldEdge& edge = surface_.edges[half >> 1];
  if (edge.isBorder()) return false;
  const int beyond = (half & 1) != 0 ? 0 : 1;
  face_ = edge.faces[beyond];
  entered_ = edge.sides[beyond];
  return true;
}

}  // namespace footfall::detail
