// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/rounding/known_places.hpp"

#include <bit>
#include <cstdint>
#include <optional>

#include "core/assembly/earlier_result.hpp"
#include "core/base/parallel.hpp"
#include "core/filters/rounding/rounded_mesh.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kVerticesPerTask = 1024;
constexpr std::size_t kPolled = 1 << 16;

/// Constructed vertices of an earlier mesh by their rounded scaled coordinates: where several share them, one of them.
class VertexTable {
 public:
  VertexTable(const std::vector<MeshVertex>& vertices, const RunContext& context)
      : vertices_(vertices), mask_(std::bit_ceil(2 * vertices.size() + 1) - 1), slots_(mask_ + 1, -1) {
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      if (v % kPolled == 0) context.checkCancelled();
      if (vertices[v].source < 0) slots_[slotOf(vertices[v])] = static_cast<Index>(v);
    }
  }
  /// The vertex at the same coordinates, or -1.
  [[nodiscard]] Index find(const MeshVertex& vertex) const { return slots_[slotOf(vertex)]; }

 private:
  [[nodiscard]] std::size_t slotOf(const MeshVertex& v) const {
    constexpr std::uint64_t kFactor = 0x9E3779B97F4A7C15U;
    std::uint64_t hash = std::bit_cast<std::uint64_t>(v.x) * kFactor;
    hash = (std::rotl(hash, 32) ^ std::bit_cast<std::uint64_t>(v.y)) * kFactor;
    hash = (std::rotl(hash, 32) ^ std::bit_cast<std::uint64_t>(v.z)) * kFactor;
    const auto isSamePlace = [&](const MeshVertex& w) { return v.x == w.x && v.y == w.y && v.z == w.z; };
    std::size_t slot = (hash >> 32U) & mask_;
    while (slots_[slot] >= 0 && !isSamePlace(vertices_[slots_[slot]])) slot = (slot + 1) & mask_;
    return slot;
  }

  const std::vector<MeshVertex>& vertices_;
  std::size_t mask_;
  std::vector<Index> slots_;
};

}  // namespace

RoundedPlaces roundVertices(const PlanKernel& kernel, const std::vector<MeshVertex>& vertices, const KnownPlaces& known,
                            RunContext& context) {
  RoundedPlaces result;
  const bool isRounded = known.state && known.state->mesh && known.rounded &&
                         known.rounded->places.size() == known.state->mesh->vertices.size();
  const auto earlier = isRounded ? EarlierResult::relate(known.state, kernel) : std::nullopt;
  if (!earlier) {
    result.places = roundVertices(kernel, vertices, result.exact, context);
    return result;
  }
  const std::vector<MeshVertex>& before = known.state->mesh->vertices;
  const VertexTable table(before, context);
  result.places.resize(vertices.size());
  result.exact.assign(vertices.size(), 1);
  parallelRanges(vertices.size(), kVerticesPerTask, [&](const auto& range) {
    context.checkCancelled();
    for (std::size_t v = range.begin(); v != range.end(); ++v) {
      const MeshVertex& vertex = vertices[v];
      if (vertex.source >= 0) {
        result.places[v] = kernel.mesh().vertices[vertex.source];
        continue;
      }
      const Index then = table.find(vertex);
      if (then >= 0 && earlier->isSame(before[then], vertex)) {
        result.places[v] = known.rounded->places[then];
        result.exact[v] = known.rounded->exact[then];
        continue;
      }
      bool isExact = true;
      result.places[v] = kernel.roundedPosition(vertex.point, vertex.face, &isExact);
      result.exact[v] = static_cast<char>(isExact);
    }
  });
  return result;
}

}  // namespace footfall::detail
