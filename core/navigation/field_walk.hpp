// A straight walk over the faces of a clearance field, in doubles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "core/mesh/field_surface.hpp"

namespace footfall::detail {

/// Finds the faces that the line from one place to another one crosses. Each corner lies on the left or on the right of
/// the line, as one formula says; so neighbouring faces agree, and the walk comes through, wherever roundings put
/// corners that are next to the line.
class FieldWalk {
 public:
  FieldWalk(const FieldSurface& surface, std::uint32_t face, FieldVector from, FieldVector to)
      : surface_(surface), face_(face), from_(from), to_(to) {}

  struct Exit {
    int side = 0;
    FieldVector place;
  };
  /// The place at which the walk leaves its face; nothing where it ends there.
  [[nodiscard]] std::optional<Exit> exit() const;
  /// Goes on behind an exit. False at a border.
  bool leave(const Exit& exit);
  [[nodiscard]] std::uint32_t face() const { return face_; }

 private:
  [[nodiscard]] std::optional<Exit> towardsTarget() const;
  [[nodiscard]] double asideOf(int corner) const { return cross(to_ - from_, surface_.corner(face_, corner) - from_); }
  [[nodiscard]] bool isLeft(int corner) const { return asideOf(corner) >= 0; }

  const FieldSurface& surface_;
  std::uint32_t face_;
  int entered_ = -1;  ///< the side by which it came
  FieldVector from_, to_;
};

}  // namespace footfall::detail
