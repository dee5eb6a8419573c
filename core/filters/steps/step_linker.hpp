// Finding where an agent steps from one border of a walkable mesh to another one: over it in the plan, or across a gap.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/filters/steps/border_splits.hpp"
#include "core/filters/steps/gap_linker.hpp"
#include "core/filters/steps/step_conditions.hpp"

namespace footfall::detail {

/// The mesh of a state with steps linked: both borders of a link get vertices where it ends, and wherever the other one
/// has one, so that links are pairs of whole edges.
class StepLinker {
 public:
  /// The state must have a mesh, and its kernel the levels of what is asked about.
  StepLinker(const WalkableState& state, RunContext& context);

  /// Links what can be stepped over, and what the state's mesh links already. `gap` is at least 0 (environment units).
  std::shared_ptr<const WalkableMesh> link(double step, double height, double gap);

  /// An agent's step and height, levels of the kernel.
  struct Limits {
    double step = 0, height = 0;
  };
  /// Links what `earlier` links, where there is still a border on both sides; with limits, where nothing is in the way
  /// by them. The vertices of `earlier` are those of the state's kernel.
  std::shared_ptr<const WalkableMesh> relink(const WalkableMesh& earlier, const std::optional<Limits>& limits);

  /// The state's, or one that knows further places of the plan: that of the mesh that was made.
  [[nodiscard]] const std::shared_ptr<const PlanKernel>& kernel() const { return splits_.kernel(); }
  [[nodiscard]] const ExactFallbacks& fallbacks() const { return fallbacks_; }
  /// Pairs of borders, and pieces of gaps, of which it is not known where the link ends: they are not linked.
  [[nodiscard]] std::size_t undecided() const { return undecided_; }

 private:
  /// Two borders, and the stretch of line, in the direction of the first one, over which one steps.
  struct Stretch {
    Index first = -1, second = -1;
    MeshVertex begin, end;
  };
  /// What pairs of borders are tried with; one for each thread.
  struct Worker {
    MeshGeometry geometry;
    StepConditions conditions;
    GapConditions gaps;
    std::vector<Stretch> stretches;
    std::vector<GapStretch> gapStretches;
  };

  [[nodiscard]] Worker makeWorker(const Limits& limits, double gap) const;
  void findStretches(const Limits& limits, double gap);
  void tryPair(Index first, Index second, Worker& worker) const;
  /// The places of a stretch that can be stepped over, as stretches of their own.
  void addFree(const Stretch& whole, int axis, int direction, Worker& worker) const;
  void take(Worker& worker);
  /// What is left of the two borders of a link, which run against each other. `worker` may be null: nothing is asked.
  void addRemains(const WalkableMesh& earlier, const MeshBorder& from, const MeshBorder& to, bool isGap,
                  Worker* worker);
  void addGap(Index first, Index second, const WalkableMesh& earlier, const std::array<MeshBorder, 2>& edges,
              Worker* worker);
  [[nodiscard]] std::vector<Index> remainsOf(const WalkableMesh& earlier, const MeshBorder& old);
  void splitAtSteps();
  void spreadSplits(const std::vector<Index>& changed);
  void addStepLinks(std::vector<MeshLink>& links);
  [[nodiscard]] std::shared_ptr<const WalkableMesh> makeMesh();

  const WalkableState& state_;
  RunContext& context_;
  BorderSplits splits_;
  std::optional<GapLinker> gaps_;
  std::vector<Stretch> stretches_;
  std::unordered_map<Index, std::vector<std::size_t>> stretchesAt_;  ///< of edges
  ExactFallbacks fallbacks_;
  std::size_t undecided_ = 0;
};

}  // namespace footfall::detail
