// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/surface_topology.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "core/exact/source_predicates.hpp"
#include "core/mesh/adjacency.hpp"
#include "core/mesh/surface_relation.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kPolled = 4096;

std::uint32_t sideFrom(const Triangle& t, std::uint32_t vertex) { return t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2; }

/// Finds which sides can be crossed, and then what follows from that.
class TopologyMaker {
 public:
  TopologyMaker(const NavigationMesh& mesh, Poll poll) : mesh_(mesh), poll_(poll), takesPart_(mesh.triangles.size()) {
    const std::size_t count = mesh.triangles.size();
    made_.neighbours.assign(count, {kNoElement, kNoElement, kNoElement});
    made_.across.assign(count, {0, 0, 0});
  }

  SurfaceTopology make() {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (t % kPolled == 0) poll_();
      takesPart_[t] = facesUp(t);
    }
    const Adjacency adjacency = findEdges(TriangleCorners(mesh_.triangles), mesh_.vertices.size(), poll_);
    for (Index e = 0; e < adjacency.edgeCount(); ++e) addEdge(adjacency.sidesOf(e));
    return finish();
  }

  SurfaceTopology follow(const SurfaceTopology& before, const NavigationMesh& meshBefore,
                         const SurfaceRelation& relation) {
    before_ = &before;
    relation_ = &relation;
    const std::vector<char> isNew = verticesOfNewTriangles(meshBefore);
    std::vector<std::pair<std::uint64_t, Index>> sides;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (t % kPolled == 0) poll_();
      const std::uint32_t o = relation.triangleBefore[t];
      if (o == kNoElement) {
        takesPart_[t] = facesUp(t);
      } else {
        takesPart_[t] = static_cast<char>(before.components[o] != kNoElement);
        copySides(o, t);
      }
      const Triangle& corners = mesh_.triangles[t];
      if (isNew[corners[0]] + isNew[corners[1]] + isNew[corners[2]] < 2) continue;
      for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t a = corners[i], b = corners[(i + 1) % 3];
        if (a != b && (isNew[a] == 0 || isNew[b] == 0)) continue;
        sides.emplace_back(std::uint64_t{std::min(a, b)} << 32 | std::max(a, b), static_cast<Index>(3 * t + i));
        made_.neighbours[t][i] = kNoElement;
        made_.across[t][i] = 0;
        uncertain_.push_back(3 * t + i);
      }
    }
    addEdges(std::move(sides));
    return finish();
  }

 private:
  [[nodiscard]] char facesUp(std::uint32_t t) const {
    const Triangle& f = mesh_.triangles[t];
    return static_cast<char>(facing(mesh_.vertices[f[0]], mesh_.vertices[f[1]], mesh_.vertices[f[2]]) > 0);
  }

  /// Both ends of an edge that triangles came to or went from are marked. All triangles at any other edge are those of
  /// before.
  [[nodiscard]] std::vector<char> verticesOfNewTriangles(const NavigationMesh& meshBefore) const {
    std::vector<char> isNew(mesh_.vertices.size(), 0);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      if (relation_->triangleBefore[t] == kNoElement)
        for (const std::uint32_t corner : mesh_.triangles[t]) isNew[corner] = 1;
    for (std::size_t o = 0; o < meshBefore.triangles.size(); ++o)
      if (relation_->triangleNow[o] == kNoElement)
        for (const std::uint32_t corner : meshBefore.triangles[o])
          if (relation_->vertexNow[corner] != kNoElement) isNew[relation_->vertexNow[corner]] = 1;
    return isNew;
  }

  /// Takes over the neighbours of a triangle, except over steps.
  void copySides(std::uint32_t o, std::uint32_t t) {
    const auto& then = before_->neighbours[o];
    const auto& across = before_->across[o];
    for (std::uint32_t i = 0; i < 3; ++i) {
      if ((across[i] & SurfaceTopology::kStep) != 0) {
        uncertain_.push_back(3 * t + i);
      } else if (then[i] != kNoElement) {
        made_.neighbours[t][i] = relation_->triangleNow[then[i]];
        made_.across[t][i] = across[i];
      }
    }
  }

  void addEdges(std::vector<std::pair<std::uint64_t, Index>> sides) {
    std::sort(sides.begin(), sides.end());
    std::vector<Index> together;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      together.push_back(sides[i].second);
      if (i + 1 < sides.size() && sides[i + 1].first == sides[i].first) continue;
      addEdge(together);
      together.clear();
    }
  }

  /// `sides` are all sides with the same two vertices.
  void addEdge(std::span<const Index> sides) {
    Index found[2] = {0, 0};
    int count = 0;
    for (const Index side : sides) {
      if (takesPart_[side / 3] == 0) continue;
      if (count == 2) return;
      found[count++] = side;
    }
    if (count != 2) return;
    const Index a = found[0] / 3, i = found[0] % 3, b = found[1] / 3, j = found[1] % 3;
    if (mesh_.triangles[a][i] == mesh_.triangles[b][j]) return;
    join(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(b),
         static_cast<std::uint32_t>(j));
  }

  void join(std::uint32_t a, std::uint32_t i, std::uint32_t b, std::uint32_t j, std::uint8_t step = 0) {
    made_.neighbours[a][i] = b;
    made_.neighbours[b][j] = a;
    made_.across[a][i] = static_cast<std::uint8_t>(j | step);
    made_.across[b][j] = static_cast<std::uint8_t>(i | step);
  }

  void addSteps() {
    for (const StepLink& link : mesh_.links) {
      const std::uint32_t a = link.fromTriangle, b = link.toTriangle;
      if (takesPart_[a] == 0 || takesPart_[b] == 0) continue;
      const std::uint32_t i = sideFrom(mesh_.triangles[a], link.from[0]), j = sideFrom(mesh_.triangles[b], link.to[0]);
      const auto samePlace = [&](std::uint32_t v, std::uint32_t w) {
        return mesh_.vertices[v].x == mesh_.vertices[w].x && mesh_.vertices[v].y == mesh_.vertices[w].y;
      };
      if (made_.neighbours[a][i] != kNoElement || made_.neighbours[b][j] != kNoElement ||
          !samePlace(link.from[0], link.to[1]) || !samePlace(link.from[1], link.to[0]))
        continue;
      join(a, i, b, j, SurfaceTopology::kStep);
      if (before_ != nullptr) uncertain_.insert(uncertain_.end(), {3 * a + i, 3 * b + j});
    }
  }

  SurfaceTopology finish() {
    poll_();
    addSteps();
    poll_();
    addComponents();
    poll_();
    addFans();
    return std::move(made_);
  }

  void addComponents() {
    made_.components.assign(mesh_.triangles.size(), kNoElement);
    std::vector<std::uint32_t> open;
    for (std::uint32_t first = 0; first < mesh_.triangles.size(); ++first) {
      if (takesPart_[first] == 0 || made_.components[first] != kNoElement) continue;
      const std::uint32_t component = made_.componentCount++;
      made_.components[first] = component;
      open.push_back(first);
      while (!open.empty()) {
        const std::uint32_t t = open.back();
        open.pop_back();
        for (const std::uint32_t next : made_.neighbours[t]) {
          if (next == kNoElement || made_.components[next] != kNoElement) continue;
          made_.components[next] = component;
          open.push_back(next);
        }
      }
    }
  }

  void addFans() {
    made_.fans.assign(mesh_.triangles.size(), {kNoElement, kNoElement, kNoElement});
    made_.fanVertices.reserve(mesh_.vertices.size());
    made_.isOpen.reserve(mesh_.vertices.size());
    std::vector<std::uint32_t> numbers;  // of earlier fans, as far as they are known
    if (before_ != nullptr) numbers = unchangedFans();
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (takesPart_[t] == 0) continue;
      const std::uint32_t o = before_ != nullptr ? relation_->triangleBefore[t] : kNoElement;
      for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t then = o != kNoElement ? before_->fans[o][i] : kNoElement;
        if (then == kNoElement || numbers[then] == kChanged) {
          if (made_.fans[t][i] == kNoElement) addFan(t, i);
          continue;
        }
        if (numbers[then] == kUnnumbered) {
          numbers[then] = static_cast<std::uint32_t>(made_.fanVertices.size());
          made_.fanVertices.push_back(mesh_.triangles[t][i]);
          made_.isOpen.push_back(before_->isOpen[then]);
        }
        made_.fans[t][i] = numbers[then];
      }
    }
  }

  static constexpr std::uint32_t kChanged = kNoElement, kUnnumbered = kNoElement - 1;

  /// kChanged for each earlier fan that has a corner of a triangle that is gone, or a side with another neighbour;
  /// kUnnumbered for all others.
  [[nodiscard]] std::vector<std::uint32_t> unchangedFans() const {
    std::vector<std::uint32_t> numbers(before_->fanVertices.size(), kUnnumbered);
    const auto change = [&](std::uint32_t fan) {
      if (fan != kNoElement) numbers[fan] = kChanged;
    };
    for (std::size_t o = 0; o < before_->fans.size(); ++o)
      if (relation_->triangleNow[o] == kNoElement)
        for (const std::uint32_t fan : before_->fans[o]) change(fan);
    for (const std::uint32_t side : uncertain_) {
      const std::uint32_t t = side / 3, i = side % 3, o = relation_->triangleBefore[t];
      if (o == kNoElement) continue;
      const std::uint32_t then = before_->neighbours[o][i];
      const std::uint32_t expected = then == kNoElement ? kNoElement : relation_->triangleNow[then];
      if (made_.neighbours[t][i] == expected &&
          (expected == kNoElement || ((made_.across[t][i] ^ before_->across[o][i]) & ~SurfaceTopology::kStep) == 0))
        continue;
      change(before_->fans[o][i]);
      change(before_->fans[o][(i + 1) % 3]);
    }
    return numbers;
  }

  /// Goes around a corner, one way until a border or the start, and from a border the other way.
  void addFan(std::uint32_t first, std::uint32_t firstCorner) {
    const auto fan = static_cast<std::uint32_t>(made_.fanVertices.size());
    made_.fanVertices.push_back(mesh_.triangles[first][firstCorner]);
    for (std::uint32_t t = first, i = firstCorner;;) {
      made_.fans[t][i] = fan;
      const std::uint32_t side = (i + 2) % 3, next = made_.neighbours[t][side];
      if (next == kNoElement) break;
      i = made_.across[t][side] & 3U;
      t = next;
      if (t == first && i == firstCorner) {
        made_.isOpen.push_back(0);
        return;
      }
    }
    made_.isOpen.push_back(1);
    for (std::uint32_t t = first, i = firstCorner;;) {
      const std::uint32_t next = made_.neighbours[t][i];
      if (next == kNoElement) return;
      i = ((made_.across[t][i] & 3U) + 1) % 3;
      t = next;
      made_.fans[t][i] = fan;
    }
  }

  const NavigationMesh& mesh_;
  Poll poll_;
  std::vector<char> takesPart_;
  const SurfaceTopology* before_ = nullptr;  ///< null: nothing is known
  const SurfaceRelation* relation_ = nullptr;
  std::vector<std::uint32_t> uncertain_;  ///< sides that may have another neighbour than before
  SurfaceTopology made_;
};

}  // namespace

SurfaceTopology makeSurfaceTopology(const NavigationMesh& mesh, Poll poll) { return TopologyMaker(mesh, poll).make(); }

SurfaceTopology followSurfaceTopology(const NavigationMesh& mesh, const SurfaceTopology& before,
                                      const NavigationMesh& meshBefore, const SurfaceRelation& relation, Poll poll) {
  // Sorting the edges of most triangles takes longer than findEdges() with all of them.
  if (relation.related < mesh.triangles.size() / 2) return makeSurfaceTopology(mesh, poll);
  return TopologyMaker(mesh, poll).follow(before, meshBefore, relation);
}

}  // namespace footfall::detail
