// Finding where an agent steps from one border of a walkable mesh to another one: over it in the plan, or across a gap.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/filters/steps/border_splits.hpp"
#include "core/filters/steps/gap_corners.hpp"
#include "core/filters/steps/gap_linker.hpp"
#include "core/filters/steps/step_conditions.hpp"
#include "core/filters/steps/step_memory.hpp"

namespace footfall::detail {

class EarlierResult;  // core/assembly/earlier_result.hpp

/// The mesh of a state with steps linked: both borders of a link get vertices where it ends, and wherever the other one
/// has one, so that links are pairs of whole edges.
class StepLinker {
 public:
  /// The state must have a mesh, and its kernel the levels of what is asked about. `faces` (may be null) chooses whose
  /// borders are linked: for each source triangle.
  StepLinker(const WalkableState& state, RunContext& context, const std::vector<char>* faces = nullptr);

  /// Takes over what an earlier run of the same filter found between borders that are what they were. `before` is of
  /// the state that `earlier` relates to; its step, height and gap are those of link(). Before link().
  void reuse(const StepMemory& before, const EarlierResult& earlier);

  /// Links what can be stepped over, and what the state's mesh links already. `gap` is at least 0 (environment units).
  /// `memory` (may be null) gets what reuse() needs; with `linksGaps` false, gaps that are found go nowhere else.
  std::shared_ptr<const WalkableMesh> link(double step, double height, double gap, StepMemory* memory = nullptr,
                                           bool linksGaps = true);

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
  /// Gaps that link() left out, as they lead nowhere else.
  [[nodiscard]] std::size_t leftOut() const { return leftOut_; }

 private:
  using Stretch = StepStretch;
  /// What pairs of borders are tried with; one for each thread.
  struct Worker {
    MeshGeometry geometry;
    StepConditions conditions;
    GapConditions gaps;
    GapLines lines;
    StepFindings found;
  };

  /// From a border's first vertex to its last one in the plan, and what each of both is off by.
  struct Direction {
    double x = 0, y = 0, error = 0;
  };

  [[nodiscard]] Direction directionOf(const MeshBorder& border) const;
  /// Whether two borders may run against each other, as those of a link do. False is certain.
  [[nodiscard]] bool mayBeOpposite(Index first, Index second) const;
  [[nodiscard]] Worker makeWorker(const Limits& limits, double gap) const;
  [[nodiscard]] BoxTree<3>::Bounds boundsOf(const MeshBorder& border) const;
  /// Whether reuse() knows what is between this border and all others of which that is true as well.
  [[nodiscard]] bool isKnown(Index border) const { return !numberBefore_.empty() && numberBefore_[border] >= 0; }
  /// Between all pairs of borders that are near each other, in their order.
  [[nodiscard]] StepFindings findStretches(const Limits& limits, double gap);
  /// Finds steps between two borders, if they lie on one line in the plan, which it returns.
  bool tryPair(Index first, Index second, Worker& worker) const;
  /// The places of a stretch that can be stepped over, as stretches of their own.
  void addFree(const Stretch& whole, int axis, int direction, Worker& worker) const;
  /// What is left of the two borders of a link, which run against each other. `worker` may be null: nothing is asked.
  void addRemains(const WalkableMesh& earlier, const MeshBorder& from, const MeshBorder& to, bool isGap,
                  Worker* worker);
  void addGap(Index first, Index second, const WalkableMesh& earlier, const std::array<MeshBorder, 2>& edges,
              Worker* worker);
  [[nodiscard]] std::vector<Index> remainsOf(const WalkableMesh& earlier, const MeshBorder& old);
  void splitAtSteps();
  /// The same at gaps: where some are lost on which others rested, these are added, until nothing changes.
  void splitAtGaps();
  void spreadSplits(const std::vector<Index>& changed);
  void addStepLinks(std::vector<MeshLink>& links);
  [[nodiscard]] std::shared_ptr<const WalkableMesh> makeMesh();

  const WalkableState& state_;
  RunContext& context_;
  BorderSplits splits_;
  std::optional<GapLinker> gaps_;
  std::optional<NeedlessGaps> needless_;  ///< of what link() found
  std::vector<Direction> directions_;     ///< of borders
  std::vector<Index> numberBefore_;       ///< of borders, in an earlier run; -1: not known, or something changed
  StepFindings known_;                    ///< from there
  std::vector<Stretch> stretches_;
  std::unordered_map<Index, std::vector<std::size_t>> stretchesAt_;  ///< of edges
  ExactFallbacks fallbacks_;
  std::size_t undecided_ = 0, leftOut_ = 0;
};

}  // namespace footfall::detail
