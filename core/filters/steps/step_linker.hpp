// Finding where an agent steps from one border of a walkable mesh to another one: over it in the plan, or across a gap.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/assembly/walkable_state.hpp"
#include "core/base/box_tree.hpp"
#include "core/filters/steps/gap_conditions.hpp"
#include "core/filters/steps/step_conditions.hpp"
#include "core/filters/steps/step_memory.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

class EarlierResult;  // core/assembly/earlier_result.hpp

/// The mesh of a state with steps linked: both borders of a link get vertices where it ends, and wherever the other one
/// has one, so that links are pairs of whole edges. Across a gap the other one's place is where a line at a right angle
/// to the bisector of both borders meets it; such lines lead through places of the plan, which the kernel gets.
class StepLinker {
 public:
  /// The state must have a mesh.
  StepLinker(const WalkableState& state, RunContext& context);

  /// Takes over what an earlier run of the same filter found between borders that are what they were. `before` is of
  /// the state that `earlier` relates to; its step, height and gap are those of link(). Before link().
  void reuse(const StepMemory& before, const EarlierResult& earlier);
  /// The state's kernel must have the levels of `step` and `height`; `gap` is at least 0 (environment units).
  /// `memory` (may be null) gets what reuse() needs.
  std::shared_ptr<const WalkableMesh> link(double step, double height, double gap, StepMemory* memory = nullptr);
  /// Links what `earlier` links, where there is still a border. Its vertices are those of the state's kernel.
  std::shared_ptr<const WalkableMesh> relink(const WalkableMesh& earlier);

  /// The state's, or one that knows further places of the plan: that of the mesh that was made.
  [[nodiscard]] const std::shared_ptr<const PlanKernel>& kernel() const { return kernel_; }
  [[nodiscard]] const ExactFallbacks& fallbacks() const { return fallbacks_; }
  /// Pairs of borders, and pieces of gaps, of which it is not known where the link ends: they are not linked.
  [[nodiscard]] std::size_t undecided() const { return undecided_; }

 private:
  using Border = StepBorder;
  using Stretch = StepStretch;
  /// A place at which an edge is to be split, and the line across it that says where.
  struct Cut {
    Index border = -1;
    std::array<Vec3, 2> line;
  };
  /// Of a gap on one of its borders, low and high.
  using Corners = std::array<const MeshVertex*, 2>;
  struct Cuts {
    std::vector<Cut> list;
    std::unordered_map<Index, std::vector<Vec3>> places;  ///< where they cut each edge
  };

  /// What pairs of borders are tried with; one for each thread.
  struct Worker {
    MeshGeometry geometry;
    StepConditions conditions;
    GapConditions gaps;
    StepFindings found;
  };

  void findBorders();
  void buildTree();
  [[nodiscard]] BoxTree<3>::Bounds boundsOf(const Border& border) const;
  /// Whether reuse() knows what is between this border and all others of which that is true as well.
  [[nodiscard]] bool isKnown(Index border) const { return !numberBefore_.empty() && numberBefore_[border] >= 0; }
  void findStretches(double step, double height, double gap, StepMemory* memory);
  void addStretches(const WalkableMesh& earlier, const Border& from, const Border& to, bool isGap);
  void tryPair(Index first, Index second, Worker& worker) const;
  void tryGap(Index first, Index second, Worker& worker) const;
  void findGapBorders();
  [[nodiscard]] GapBorder gapBorderOf(const Border& border) const;
  [[nodiscard]] std::vector<KnownLine> linesOf(const Border& border, MeshGeometry& geometry) const;
  /// The same without the lines that cut the face, which are not looked at where there is another one.
  [[nodiscard]] std::vector<KnownLine> ownLinesOf(const Border& border, MeshGeometry& geometry) const;
  void splitEdges();
  void splitAtSteps();
  void splitAtGaps();
  void spreadSplits(Index edge);
  void planCuts(Cuts& cuts);
  void planCut(GapStretch& stretch, Index border, double along, Cuts& cuts);
  void makeCuts(const std::vector<Cut>& cuts);
  /// Proves of all gaps what the cuts made of them; draws in ends that an obstacle reaches. False when one was.
  bool proveGaps();
  [[nodiscard]] bool isProven(const GapStretch& stretch, int& end, bool& isOverlap);
  [[nodiscard]] bool isWider(const MeshVertex& a, const MeshVertex& b) const;
  [[nodiscard]] bool isOutside(Index obstacle, const Corners& p, const Corners& q, int end);
  /// The vertex of a border, or of its splits, at a place along a frame; null when there is none.
  [[nodiscard]] const MeshVertex* vertexAt(const Border& border, const GapFrame& frame, double along) const;
  void addGapLinks(WalkableMesh& result, const GapStretch& stretch, const std::vector<Index>& from,
                   const std::vector<Index>& to);
  /// False when there was a vertex already.
  bool insertSplit(Index edge, const MeshVertex& place);
  /// The splits of an edge strictly between two places of its line.
  [[nodiscard]] std::vector<MeshVertex> splitsBetween(Index edge, const MeshVertex& a, const MeshVertex& b);
  [[nodiscard]] std::shared_ptr<const WalkableMesh> makeMesh();

  const WalkableState& state_;
  std::shared_ptr<const PlanKernel> kernel_;
  const WalkableMesh& mesh_;
  RunContext& context_;
  std::shared_ptr<const Adjacency> topology_;
  std::vector<Border> borders_;
  std::vector<GapBorder> gapBorders_;  ///< the same, once gaps are looked for
  BoxTree<3> tree_;                    ///< of the borders
  std::vector<Index> numberBefore_;    ///< of borders, in an earlier run; -1: not known, or something changed
  StepFindings known_;                 ///< from there
  std::vector<Stretch> stretches_;
  std::vector<GapStretch> gaps_;
  double gap_ = 0;                                                   ///< how wide they may be
  std::unordered_map<Index, std::vector<MeshVertex>> splits_;        ///< of edges, in the order of their line
  std::unordered_map<Index, std::vector<std::size_t>> stretchesAt_;  ///< of edges, once they are asked for
  std::optional<MeshGeometry> geometry_;
  ExactFallbacks fallbacks_;
  std::size_t undecided_ = 0;
};

}  // namespace footfall::detail
