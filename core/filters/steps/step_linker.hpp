// Finding where an agent steps from one border of a walkable mesh to another one that coincides with it in the plan.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <unordered_map>
#include <vector>

#include "core/assembly/walkable_state.hpp"
#include "core/base/box_tree.hpp"
#include "core/filters/steps/step_conditions.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// The mesh of a state with steps linked: both borders of a link get vertices where it ends, and wherever the other one
/// has one, so that links are pairs of whole edges.
class StepLinker {
 public:
  /// The state must have a mesh.
  StepLinker(const WalkableState& state, RunContext& context);

  /// The state's kernel must have the levels of `step` and `height` (environment units).
  std::shared_ptr<const WalkableMesh> link(double step, double height);
  /// Links what `earlier` links, where there is still a border. Its vertices are those of the state's kernel.
  std::shared_ptr<const WalkableMesh> relink(const WalkableMesh& earlier);

  [[nodiscard]] const ExactFallbacks& fallbacks() const { return fallbacks_; }
  /// Pairs of borders of which it is not known where the link ends: they are not linked.
  [[nodiscard]] std::size_t undecided() const { return undecided_; }

 private:
  /// A side of a triangle that cannot be crossed.
  struct Border {
    Index side = -1, edge = -1;  ///< edge of the topology
    Index from = -1, to = -1;    ///< vertices
    Index face = -1;
  };
  /// Two borders, and the stretch of line, in the direction of the first one, over which one steps.
  struct Stretch {
    Index first = -1, second = -1;
    MeshVertex begin, end;
  };

  /// What pairs of borders are tried with; one for each thread.
  struct Worker {
    MeshGeometry geometry;
    StepConditions conditions;
    std::vector<Stretch> stretches;
  };

  void findBorders();
  void buildTree();
  void findStretches(double step, double height);
  void addStretches(const WalkableMesh& earlier, const Border& from, const Border& to);
  void tryPair(Index first, Index second, Worker& worker) const;
  [[nodiscard]] std::vector<KnownLine> linesOf(const Border& border, MeshGeometry& geometry) const;
  void splitEdges();
  /// False when there was a vertex already.
  bool insertSplit(Index edge, const MeshVertex& place);
  /// The splits of an edge strictly between two places of its line.
  [[nodiscard]] std::vector<MeshVertex> splitsBetween(Index edge, const MeshVertex& a, const MeshVertex& b);
  [[nodiscard]] std::shared_ptr<const WalkableMesh> makeMesh();

  const WalkableState& state_;
  const PlanKernel& kernel_;
  const WalkableMesh& mesh_;
  RunContext& context_;
  std::shared_ptr<const Adjacency> topology_;
  std::vector<Border> borders_;
  BoxTree<3> tree_;  ///< of the borders
  std::vector<Stretch> stretches_;
  std::unordered_map<Index, std::vector<MeshVertex>> splits_;  ///< of edges, in the order of their line
  MeshGeometry geometry_;
  ExactFallbacks fallbacks_;
  std::size_t undecided_ = 0;
};

}  // namespace footfall::detail
