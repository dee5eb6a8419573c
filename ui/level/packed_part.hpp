// Parts of packed environments that are too large to be opened as a whole.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/io/packed/packed_environment.hpp"
#include "ui/view/backdrop.hpp"

namespace footfall::ui {

/// Tests make them small.
struct PackedLimits {
  /// An environment of so many triangles opens as any other: runs over it take some 700 MB for each million.
  std::uint64_t whole = 2'000'000;
  /// Triangles that runs go over in a larger one: an edit shows its result within seconds.
  std::size_t part = 250'000;
  /// Of the part that is there at first: it is to be opened at once.
  std::size_t first = 50'000;
  /// Triangles that the view has in full around them: 120 bytes each, half of them in the graphics memory.
  std::uint64_t shown = 2'000'000;
};

/// A square of the plan (the environment's coordinates, Z up), over all heights.
struct PartPlace {
  double x = 0, y = 0, half = 0;
  bool operator==(const PartPlace&) const = default;
};
/// What touches it belongs to the part.
detail::Box boxOf(const PartPlace& place);

/// A large packed environment that is open, and the part of it that is the level. Where the part is, everything that
/// stands over or under its square is in it: headroom inside the square is that of the whole environment.
struct PackedPart {
  std::shared_ptr<const detail::PackedEnvironment> environment;
  PackedLimits limits;
  PartPlace place;
  bool isSmaller = false;  ///< than asked for: it had too many triangles
  std::shared_ptr<const WholeBounds> whole;
  BackdropPiecePtr coarse;
  std::vector<std::size_t> firstCoarse;      ///< of each block its first coarse triangle, and their number
  std::vector<std::uint8_t> isCoarseInPart;  ///< 1: what it stands for belongs to the part
};

/// What is drawn of a block that is loaded: all but what belongs to the part.
BackdropPiecePtr makeBlockPiece(const PackedPart& part, std::size_t block);

/// Whether a block lies in the part with all that it has, and whether something of it may.
bool isInPart(const PackedPart& part, std::size_t block);
bool touchesPart(const PackedPart& part, std::size_t block);

/// An environment with the triangles of a part, and all that the file says besides.
struct OpenedPart {
  PackedPart part;
  Environment environment;
};
/// Whether pieces of the blocks are the same, but for what belongs to the parts.
bool isSameFile(const PackedPart& a, const PackedPart& b);
/// The part at a place (nothing: in the middle), smaller where it would have more triangles than the limit. `centre`:
/// of the scene, else the middle of the environment. `before`: a part whose coarse surface is used again where it is of
/// the same file. Throws as PackedEnvironment does, InputError where nothing or too
/// much stands at the place, and Cancelled.
OpenedPart openPart(std::shared_ptr<const detail::PackedEnvironment> environment, const PackedLimits& limits,
                    const std::optional<PartPlace>& place, const std::optional<Vec3>& centre, RunContext& context,
                    const PackedPart* before = nullptr);

}  // namespace footfall::ui
