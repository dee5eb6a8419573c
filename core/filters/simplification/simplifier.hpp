// Taking away the vertices of a walkable mesh that its outline does not need.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vertices go one by one: those inside a coplanar region, and those in the middle of a straight piece of its outline.
// What is left has no vertex that could go, and the number of triangles follows from Euler's formula. A last pass flips
// edges inside regions towards Delaunay.
//
// Regions that share no vertex that may go are independent of each other. So the triangles fall into groups: a region,
// or several that meet in the middle of straight pieces of their outlines. Each group's result follows from its own
// triangles alone, and groups are worked on by all threads.
#pragma once

#include <vector>

#include "core/assembly/mesh_relation.hpp"
#include "core/filters/simplification/region_simplifier.hpp"
#include "core/mesh/mesh_topology.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// The input of a simplification, kept so that a later one can copy groups that did not change.
struct SimplifierMemory {
  std::shared_ptr<const WalkableMesh> given;
  std::vector<Index> neighbors;         ///< neighbors as in SimplifiedMesh, before anything went
  std::vector<char> candidates;         ///< one flag per vertex: it may go
  std::vector<Index> groupOf;           ///< group of each triangle, or -1
  std::vector<MeshTriangle> triangles;  ///< triangles after all, before they moved together
  std::vector<char> alive;
};

class Simplifier {
 public:
  /// The result is exact unless `approximate` is set. `topology` is that of `mesh`; all arguments must outlive this
  /// object.
  Simplifier(const PlanKernel& kernel, const WalkableMesh& mesh, const Adjacency& topology,
             const ApproximateSimplification& approximate, RunContext& context)
      : kernel_(kernel),
        given_(mesh),
        topology_(topology),
        approximate_(approximate),
        context_(context),
        mesh_{mesh.vertices, mesh.triangles, {}, {}, {}, {}} {}

  /// Groups whose triangles are all related to those of one earlier group, joined alike, become what that one became.
  /// `before` and `earlier` must outlive this.
  void reuse(const SimplifierMemory& before, const EarlierResult& earlier) {
    before_ = &before;
    earlier_ = &earlier;
  }

  /// `memory` (may be null) receives what reuse() needs, except the given mesh.
  WalkableMesh run(SimplifierMemory* memory = nullptr);

  [[nodiscard]] const ExactFallbacks& fallbacks() const { return fallbacks_; }

 private:
  /// Groups one after another in flat lists, those with most triangles first.
  struct Groups {
    std::vector<Index> firstTriangle{0}, triangles;  ///< ascending within a group
    std::vector<Index> firstVertex{0}, vertices;     ///< vertices that may go; within a group in the order of their
                                                     ///< first use
    std::vector<Index> firstOfTask{0};               ///< groups that one task works on
    std::vector<Index> of;                           ///< group of each triangle, or -1

    [[nodiscard]] std::span<const Index> trianglesOf(Index group) const {
      return {triangles.data() + firstTriangle[group], triangles.data() + firstTriangle[group + 1]};
    }
    [[nodiscard]] std::span<const Index> verticesOf(Index group) const {
      return {vertices.data() + firstVertex[group], vertices.data() + firstVertex[group + 1]};
    }
  };

  void findInnerEdges();
  [[nodiscard]] bool isInner(std::span<const Index> sides) const;
  [[nodiscard]] bool mayJoin(Index face, Index other);
  /// Chooses vertices that may go: any but ends of links, and exactly, only those of findStraight().
  std::vector<char> findCandidates();
  /// Vertices inside a region or in the middle of a straight piece of outline. Taking others away changes neither: a
  /// straight piece stays straight when its ends move along it.
  std::vector<char> findStraight(Index count);
  Groups findGroups(const std::vector<char>& candidates) const;
  /// True when the group equals an earlier one.
  [[nodiscard]] bool isKnown(std::span<const Index> triangles, const std::vector<char>& candidates) const;
  void copyEarlier(std::span<const Index> triangles);
  /// The triangles that are left, over the same vertices.
  void copyAlive(WalkableMesh& result) const;
  WalkableMesh compact() const;

  const PlanKernel& kernel_;
  const WalkableMesh& given_;
  const Adjacency& topology_;
  ApproximateSimplification approximate_;
  RunContext& context_;
  SimplifiedMesh mesh_;
  const SimplifierMemory* before_ = nullptr;
  const EarlierResult* earlier_ = nullptr;
  MeshRelation relation_;          ///< relation to the earlier mesh
  std::vector<Index> sizeBefore_;  ///< size of each earlier group
  /// The edges that are not inner, in blocks, in their order; between findInnerEdges() and findCandidates().
  std::vector<std::vector<std::array<Index, 2>>> outlines_;
  ExactFallbacks fallbacks_;
};

}  // namespace footfall::detail
