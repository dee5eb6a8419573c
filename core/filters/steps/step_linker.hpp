// Finds where an agent steps from one border of a walkable mesh to another: where they coincide in the plan, or across
// a gap.
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

class EarlierResult;  // declared in core/assembly/earlier_result.hpp

/// Links steps on the mesh of a state. Both borders of a link get vertices at its ends, and wherever the other border
/// has one, so that links are pairs of whole edges.
class StepLinker {
 public:
  /// The state must have a mesh, and its kernel the levels that link() or relink() gets. `faces` (may be null) has an
  /// entry for each source triangle and selects the borders to link.
  StepLinker(const WalkableState& state, RunContext& context, const std::vector<char>* faces = nullptr);

  /// Reuses the results of an earlier run of the same filter for borders that have not changed. `before` is of the
  /// state that `earlier` relates to; its step, height and gap are those of link(). Called before link().
  void reuse(const StepMemory& before, const EarlierResult& earlier);

  /// Links the borders that can be stepped over, and those that the state's mesh links already. `gap` is at least 0
  /// (environment units). `memory` (may be null) receives the data for reuse(); with `linksGaps` false, gaps go into
  /// `memory` only.
  std::shared_ptr<const WalkableMesh> link(double step, double height, double gap, StepMemory* memory = nullptr,
                                           bool linksGaps = true);

  /// The step and height of an agent, as levels of the kernel.
  struct Limits {
    double step = 0, height = 0;
  };
  /// Restores the links of `earlier` where both borders still exist. With limits, it restores a link only where no
  /// obstacle blocks it. The vertices of `earlier` are those of the state's kernel.
  std::shared_ptr<const WalkableMesh> relink(const WalkableMesh& earlier, const std::optional<Limits>& limits);

  /// The kernel of the resulting mesh: that of the state, or one with further places of the plan.
  [[nodiscard]] const std::shared_ptr<const PlanKernel>& kernel() const { return splits_.kernel(); }
  [[nodiscard]] const ExactFallbacks& fallbacks() const { return fallbacks_; }
  /// The number of pairs of borders, and pieces of gaps, whose links have no provable end; they are not linked.
  [[nodiscard]] std::size_t undecided() const { return undecided_; }
  /// The number of gaps that link() left out, because they lead to no other floor.
  [[nodiscard]] std::size_t leftOut() const { return leftOut_; }

 private:
  using Stretch = StepStretch;
  /// Working memory for trying pairs of borders; one for each thread.
  struct Worker {
    MeshGeometry geometry;
    StepConditions conditions;
    GapConditions gaps;
    GapLines lines;
    StepFindings found;
  };

  /// The vector from a border's first vertex to its last in the plan, and the errors of both.
  struct Direction {
    double x = 0, y = 0, error = 0;
  };

  [[nodiscard]] Direction directionOf(const MeshBorder& border) const;
  /// Returns whether two borders may run in opposite directions, as those of a link do. False is certain.
  [[nodiscard]] bool mayBeOpposite(Index first, Index second) const;
  [[nodiscard]] Worker makeWorker(const Limits& limits, double gap) const;
  [[nodiscard]] BoxTree<3>::Bounds boundsOf(const MeshBorder& border) const;
  /// Returns whether reuse() has the results between this border and all others for which this is true as well.
  [[nodiscard]] bool isKnown(Index border) const { return !numberBefore_.empty() && numberBefore_[border] >= 0; }
  /// Finds the stretches between all pairs of borders that are near each other, in their order.
  [[nodiscard]] StepFindings findStretches(const Limits& limits, double gap);
  /// Finds steps between two borders. Returns whether they lie on one line in the plan.
  bool tryPair(Index first, Index second, Worker& worker) const;
  /// Adds the parts of a stretch that can be stepped over, as stretches of their own.
  void addFree(const Stretch& whole, int axis, int direction, Worker& worker) const;
  /// Adds the remainders of the two borders of a link, which run against each other. `worker` may be null: obstacles
  /// are not tested then.
  void addRemains(const WalkableMesh& earlier, const MeshBorder& from, const MeshBorder& to, bool isGap,
                  Worker* worker);
  void addGap(Index first, Index second, const WalkableMesh& earlier, const std::array<MeshBorder, 2>& edges,
              Worker* worker);
  [[nodiscard]] std::vector<Index> remainsOf(const WalkableMesh& earlier, const MeshBorder& old);
  void splitAtSteps();
  /// Splits at gaps, like splitAtSteps(). Where gaps are lost that others rely on, those are added, until nothing
  /// changes.
  void splitAtGaps();
  void spreadSplits(const std::vector<Index>& changed);
  void addStepLinks(std::vector<MeshLink>& links);
  [[nodiscard]] std::shared_ptr<const WalkableMesh> makeMesh();

  const WalkableState& state_;
  RunContext& context_;
  BorderSplits splits_;
  std::optional<GapLinker> gaps_;
  std::optional<NeedlessGaps> needless_;  ///< gaps that link() left out
  std::vector<Direction> directions_;     ///< by border
  std::vector<Index> numberBefore_;  ///< by border, its number in an earlier run; -1: not known, or something changed
  StepFindings known_;               ///< findings of the earlier run
  std::vector<Stretch> stretches_;
  std::unordered_map<Index, std::vector<std::size_t>> stretchesAt_;  ///< by edge
  ExactFallbacks fallbacks_;
  std::size_t undecided_ = 0, leftOut_ = 0;
};

}  // namespace footfall::detail
