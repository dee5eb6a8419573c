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

#include "core/filters/mesh_topology.hpp"
#include "core/filters/region_simplifier.hpp"
#include "core/pipeline/run_context.hpp"

namespace footfall {

class Simplifier {
 public:
  /// Exact unless `approximate` says otherwise. `topology` is that of `mesh`; all must outlive this.
  Simplifier(const PlanKernel& kernel, const WalkableMesh& mesh, const MeshTopology& topology,
             const ApproximateSimplification& approximate, RunContext& context)
      : kernel_(kernel),
        given_(mesh),
        topology_(topology),
        approximate_(approximate),
        context_(context),
        mesh_{mesh.vertices, mesh.triangles, {}, {}, {}, {}} {}

  WalkableMesh run();

  [[nodiscard]] const ExactFallbacks& fallbacks() const { return fallbacks_; }

 private:
  /// Groups one after another in flat lists, those with most triangles first.
  struct Groups {
    std::vector<Index> firstTriangle{0}, triangles;  ///< ascending within a group
    std::vector<Index> firstVertex{0}, vertices;     ///< that may go; ascending within a group
    std::vector<Index> firstOfTask{0};               ///< groups that one task works on
  };

  void findInnerEdges();
  [[nodiscard]] bool isInner(std::span<const Index> sides) const;
  [[nodiscard]] bool mayJoin(Index face, Index other);
  /// Chooses vertices inside a region or in the middle of a straight piece of outline. Taking others away changes
  /// neither: a straight piece stays straight when its ends move along it.
  std::vector<char> findCandidates();
  Groups findGroups(const std::vector<char>& candidates) const;
  WalkableMesh compact() const;

  const PlanKernel& kernel_;
  const WalkableMesh& given_;
  const MeshTopology& topology_;
  ApproximateSimplification approximate_;
  RunContext& context_;
  SimplifiedMesh mesh_;
  ExactFallbacks fallbacks_;
};

}  // namespace footfall
