// Proves early that obstacles cover a whole floor together, from the signs that were found of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/exact/source_mesh.hpp"
#include "core/filters/clearance/clearance_candidate.hpp"

namespace footfall::detail {

/// One object for each thread.
class ClosedCover {
 public:
  explicit ClosedCover(const SourceMesh& mesh) : mesh_(mesh) {}

  /// Returns true when some of the candidates cover the whole face together, so that each of their edges over it has
  /// one of them on either side. Only candidates that take all that lies under them count, without floors in the face's
  /// plane. More candidates never make a cover less of one, and their order does not matter.
  ///
  /// Proof. A candidate that has an edge over the face with no other candidate on the far side is taken away, again and
  /// again. Those that are left have both sides of each such edge covered. So the border of their union, inside the
  /// face, is at most a finite number of points, the corners of candidates. The inside of the face without these points
  /// is connected, so the union has all of it or nothing. Each candidate that is left overlaps the face, so it is all.
  [[nodiscard]] bool covers(std::span<const ClearanceCandidate> candidates);

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
  struct Edge {
    std::uint64_t ends = 0;  ///< both plan ids, the smaller one first
    std::uint32_t owner = 0;
    std::uint8_t side = 0;    ///< of the edge from the smaller plan id, on which its owner lies
    std::uint32_t group = 0;  ///< number of the edges with these ends
  };
  void addEdges(const ClearanceCandidate& candidate, std::uint32_t owner);

  const SourceMesh& mesh_;
  std::vector<Edge> edges_;
  std::vector<std::array<std::uint32_t, 2>> counts_;  ///< of each group's edges that are left, by side
  std::vector<std::uint32_t> firsts_;                 ///< first edge of each group
  std::vector<std::uint32_t> byOwner_;                ///< three edges of each candidate, or kNone
  std::vector<char> isLeft_;
  std::vector<std::uint32_t> waiting_;
};

}  // namespace footfall::detail
