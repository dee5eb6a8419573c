// The frame of a file: which of its axes points up, by what name, and how places turn into the Z-up frame inside and
// back.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "footfall/geometry.hpp"

namespace footfall {

/// All up axes, in the order in which a user is offered them.
inline constexpr std::array<UpAxis, 6> kUpAxes{UpAxis::Y,         UpAxis::Z,         UpAxis::X,
                                               UpAxis::NegativeY, UpAxis::NegativeZ, UpAxis::NegativeX};

/// The names of all up axes, for the help of command lines.
inline constexpr const char* kUpAxisNames = "y|z|x|-y|-z|-x";

/// The name in files, statistics and on command lines: "y", "-z".
std::string_view nameOf(UpAxis up);

/// The name for people: "Y", "-Z".
std::string shownName(UpAxis up);

/// The axis of that name, in letters of either case; empty for anything else.
std::optional<UpAxis> upAxisFrom(std::string_view name);

/// One axis of a file (0, 1, 2), taken forwards (1) or backwards (-1).
struct FileAxis {
  std::size_t axis = 0;
  double sign = 1;
};

/// The axes of a file for X, Y and Z inside. Each is a turn, never a mirror image, so faces keep their winding; signs
/// are all that numbers change by, so turning and turning back is exact.
constexpr std::array<FileAxis, 3> fileAxes(UpAxis up) {
  switch (up) {
    case UpAxis::Y:
      return {{{0, 1}, {2, -1}, {1, 1}}};
    case UpAxis::X:  // meaning of X up in Collada: the file's -Y points right
      return {{{1, -1}, {2, -1}, {0, 1}}};
    case UpAxis::NegativeY:
      return {{{0, 1}, {2, 1}, {1, -1}}};
    case UpAxis::NegativeZ:
      return {{{0, 1}, {1, -1}, {2, -1}}};
    case UpAxis::NegativeX:
      return {{{1, 1}, {2, -1}, {0, -1}}};
    case UpAxis::Z:
      break;
  }
  return {{{0, 1}, {1, 1}, {2, 1}}};
}

/// A place of a file turned to Z up. Exact; a zero is +0 afterwards, so that equal positions also have equal bits.
inline Vec3 fromFileFrame(const Vec3& place, UpAxis up) {
  const std::array<double, 3> in{place.x, place.y, place.z};
  const auto axes = fileAxes(up);
  return {axes[0].sign * in[axes[0].axis] + 0.0, axes[1].sign * in[axes[1].axis] + 0.0,
          axes[2].sign * in[axes[2].axis] + 0.0};
}

/// The other way round, as exact.
inline Vec3 inFileFrame(const Vec3& place, UpAxis up) {
  const auto axes = fileAxes(up);
  std::array<double, 3> out{};
  out[axes[0].axis] = axes[0].sign * place.x + 0.0;
  out[axes[1].axis] = axes[1].sign * place.y + 0.0;
  out[axes[2].axis] = axes[2].sign * place.z + 0.0;
  return {out[0], out[1], out[2]};
}

}  // namespace footfall
