// The data that a clearance filter keeps beside its result, so that a later run need not compute it again.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <memory_resource>
#include <utility>
#include <vector>

#include "core/assembly/face_mesh.hpp"

namespace footfall::detail {

/// The vertices that lie on each outline. Faces are identified by their number, their parts by the place among the
/// face's own parts: nothing here depends on other faces.
struct JoinMemory {
  /// One face that was joined: its number, where its points begin, and where its outlines begin. A face that nothing
  /// cuts has three points, and no outlines of its own: its edges say all.
  struct Entry {
    Index face = -1;
    Index firstPoint = 0;
    Index firstOutline = 0;
  };
  struct Incidence {
    Index outline = -1;  ///< or edgeOfWhole()
    Index vertex = -1;
  };
  /// Edge k of a face that nothing cuts, beside the numbers of outlines; -1 means none.
  [[nodiscard]] static constexpr Index edgeOfWhole(Index entry, int k) { return -2 - (3 * entry + k); }
  /// The entry and the edge of such a number.
  [[nodiscard]] static constexpr std::pair<Index, int> wholeOf(Index number) {
    return {(-2 - number) / 3, (-2 - number) % 3};
  }
  std::vector<Entry> entries;   ///< and one more, with the ends
  std::vector<Index> vertexOf;  ///< vertex of each point of each entry, or -1
  Index vertexCount = 0;
  std::vector<Incidence> between;              ///< the vertex lies strictly inside the outline
  std::vector<std::pair<Index, Index>> equal;  ///< vertices at one place
};

/// The data kept of a face under many obstacles, so that an edit cuts it anew only near the change.
struct LargeFace {
  std::vector<ApproximatePoint> points;    ///< those of its cuts, relative to its first vertex
  std::array<std::uint64_t, 64> depths{};  ///< depth of obstacles over each of its parts
  std::size_t areas = 0;                   ///< number of obstacles that are no walls
};

struct AssemblyMemory {
  /// One entry per source triangle; null where nothing cuts it.
  FaceMeshes meshes;
  /// The triangles in the clearance above each source triangle that overlap it in the plan, ascending; null: none, or
  /// no floor.
  std::vector<std::shared_ptr<const std::pmr::vector<Index>>> candidates;
  /// Some source triangles under many obstacles.
  std::map<Index, std::shared_ptr<const LargeFace>> large;
  double clearance = 0;
  JoinMemory join;
};

}  // namespace footfall::detail
