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
#include "ui/view/scene/backdrop.hpp"

namespace footfall::ui {

/// Tests make these limits small.
struct PackedLimits {
  /// The most triangles of an environment that opens whole: runs over it take some 700 MB for each million.
  std::uint64_t whole = 2'000'000;
  /// The most triangles of a part that runs use: an edit then shows its result within seconds.
  std::size_t part = 250'000;
  /// The most triangles of the first part, which should open at once.
  std::size_t first = 50'000;
  /// The most triangles around the part that the view shows in full: 120 bytes each, half of them in the graphics
  /// memory.
  std::uint64_t shown = 2'000'000;
};

/// A square of the plan (the environment's coordinates, Z up), over all heights.
struct PartPlace {
  double x = 0, y = 0, half = 0;
  bool operator==(const PartPlace&) const = default;
};
/// The box of a place; triangles that touch it belong to the part.
detail::Box boxOf(const PartPlace& place);

/// An open packed environment that is large, and the part of it that is the level. The part has everything over and
/// under its square, so headroom inside the square is that of the whole environment.
struct PackedPart {
  std::shared_ptr<const detail::PackedEnvironment> environment;
  PackedLimits limits;
  PartPlace place;
  bool isSmaller = false;  ///< smaller than requested, because it had too many triangles
  std::shared_ptr<const WholeBounds> whole;
  BackdropPiecePtr coarse;
  std::vector<std::size_t> firstCoarse;      ///< the first coarse triangle of each block, and their number
  std::vector<std::uint8_t> isCoarseInPart;  ///< 1: the coarse triangle stands for triangles of the part
};

/// The drawn triangles of a loaded block: all except those of the part.
BackdropPiecePtr makeBlockPiece(const PackedPart& part, std::size_t block);

/// Whether a block lies in the part completely, and whether some of it may.
bool isInPart(const PackedPart& part, std::size_t block);
bool touchesPart(const PackedPart& part, std::size_t block);

/// An environment with the triangles of a part, and all other content of the file.
struct OpenedPart {
  PackedPart part;
  Environment environment;
};
/// Returns whether pieces of the blocks are the same, except for the triangles of the parts.
bool isSameFile(const PackedPart& a, const PackedPart& b);
/// Opens the part at a place (empty: in the middle), smaller where it would have more triangles than the limit.
/// `centre` is that of the scene, else the middle of the environment. The coarse surface of `before` is used again
/// where it is of the same file. Throws as PackedEnvironment does, InputError where there are no triangles or too many
/// at the place, and Cancelled.
OpenedPart openPart(std::shared_ptr<const detail::PackedEnvironment> environment, const PackedLimits& limits,
                    const std::optional<PartPlace>& place, const std::optional<Vec3>& centre, RunContext& context,
                    const PackedPart* before = nullptr);

}  // namespace footfall::ui
