// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/surface_relation.hpp"

#include <algorithm>
#include <bit>

#include "core/mesh/surface_topology.hpp"

namespace footfall::detail {
namespace {

// Triangles that went are passed by looking so far ahead among the earlier ones; less far once there is a table.
constexpr std::size_t kLookAhead = 32, kLookAheadWithTable = 4;
// The number of triangles that are not found so, from which on they are looked for at any place: layers that changed
// their order move many triangles at once.
constexpr std::size_t kFewLost = 64;
// A look-up in the table ends after so many places, so that thousands of equal triangles take no longer.
constexpr std::size_t kMostPlaces = 256;
constexpr std::uint32_t kPolled = 4096;

class SurfaceMatcher {
 public:
  SurfaceMatcher(const NavigationMesh& before, const NavigationMesh& now, SurfaceRelation& relation)
      : before_(before), now_(now), relation_(relation), vertexBefore_(now.vertices.size(), kNoElement) {
    relation_.triangleBefore.assign(now.triangles.size(), kNoElement);
    relation_.triangleNow.assign(before.triangles.size(), kNoElement);
    relation_.vertexNow.assign(before.vertices.size(), kNoElement);
  }

  void run(Poll poll) {
    std::vector<std::uint32_t> lost;
    std::uint32_t next = 0;  // the earlier triangle behind the last one that was found
    for (std::uint32_t t = 0; t < now_.triangles.size(); ++t) {
      if (t % kPolled == 0) poll();
      if (matchFrom(next, t)) continue;
      lost.push_back(t);
      if (lost.size() < kFewLost) continue;
      if (table_.empty()) fillTable(poll);
      if (const std::uint32_t found = findAnywhere(t); found != kNoElement) {
        next = found + 1;
        lost.pop_back();
      }
    }
    if (lost.empty() || relation_.related == before_.triangles.size()) return;
    if (table_.empty()) fillTable(poll);
    for (std::size_t i = 0; i < lost.size(); ++i) {
      if (i % kPolled == 0) poll();
      if (relation_.triangleBefore[lost[i]] == kNoElement) findAnywhere(lost[i]);
    }
  }

 private:
  bool matchFrom(std::uint32_t& next, std::uint32_t t) {
    const std::size_t end =
        std::min(before_.triangles.size(), next + (table_.empty() ? kLookAhead : kLookAheadWithTable));
    for (std::size_t o = next; o < end; ++o) {
      if (!match(static_cast<std::uint32_t>(o), t)) continue;
      next = static_cast<std::uint32_t>(o) + 1;
      return true;
    }
    return false;
  }

  /// The place of a triangle's corners in a table of the given size, a power of 2.
  static std::size_t placeOf(const NavigationMesh& mesh, std::uint32_t triangle, std::size_t size) {
    std::uint64_t key = 0;
    for (const std::uint32_t v : mesh.triangles[triangle]) {
      const Vec3& p = mesh.vertices[v];
      for (const double x : {p.x, p.y, p.z}) {
        key = (key ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9E3779B97F4A7C15U;  // -0 equals 0
        key ^= key >> 32;
      }
    }
    return static_cast<std::size_t>(key) & (size - 1);
  }

  void fillTable(const Poll& poll) {
    table_.assign(std::bit_ceil(2 * before_.triangles.size() + 1), kNoElement);
    for (std::uint32_t o = 0; o < before_.triangles.size(); ++o) {
      if (o % kPolled == 0) poll();
      if (relation_.triangleNow[o] != kNoElement) continue;
      const std::size_t first = placeOf(before_, o, table_.size());
      for (std::size_t i = 0; i < kMostPlaces; ++i) {
        std::uint32_t& entry = table_[(first + i) & (table_.size() - 1)];
        if (entry != kNoElement) continue;
        entry = o;
        break;
      }
    }
  }

  std::uint32_t findAnywhere(std::uint32_t t) {
    const std::size_t first = placeOf(now_, t, table_.size());
    for (std::size_t i = 0; i < kMostPlaces; ++i) {
      const std::uint32_t then = table_[(first + i) & (table_.size() - 1)];
      if (then == kNoElement) break;
      if (match(then, t)) return then;
    }
    return kNoElement;
  }

  [[nodiscard]] bool canCorrespond(std::uint32_t then, std::uint32_t vertex) const {
    if (relation_.vertexNow[then] != kNoElement || vertexBefore_[vertex] != kNoElement)
      return relation_.vertexNow[then] == vertex;
    return before_.vertices[then] == now_.vertices[vertex];
  }

  bool match(std::uint32_t o, std::uint32_t t) {
    if (relation_.triangleNow[o] != kNoElement) return false;
    const Triangle &then = before_.triangles[o], &triangle = now_.triangles[t];
    for (int k = 0; k < 3; ++k)
      if (!canCorrespond(then[k], triangle[k])) return false;
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < k; ++i)
        if ((then[k] == then[i]) != (triangle[k] == triangle[i])) return false;
    for (int k = 0; k < 3; ++k) {
      relation_.vertexNow[then[k]] = triangle[k];
      vertexBefore_[triangle[k]] = then[k];
    }
    relation_.triangleNow[o] = t;
    relation_.triangleBefore[t] = o;
    ++relation_.related;
    return true;
  }

  const NavigationMesh &before_, &now_;
  SurfaceRelation& relation_;
  std::vector<std::uint32_t> vertexBefore_;
  std::vector<std::uint32_t> table_;  ///< earlier triangles by their corners
};

}  // namespace

SurfaceRelation relateSurfaces(const NavigationMesh& before, const NavigationMesh& now, Poll poll) {
  SurfaceRelation relation;
  SurfaceMatcher(before, now, relation).run(poll);
  return relation;
}

}  // namespace footfall::detail
