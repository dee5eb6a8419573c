// Finding where an agent drops from a border of a walkable mesh to a lower place (model, Drops).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two kinds of landings are looked for, in the plan straight outwards from a ledge: straight below it, and on borders
// at which a floor begins within the reach. Straight below everything is decided by exact signs (edge_signs.hpp).
// Across a gap distances are square roots: there everything but the heights of level floors is computed in doubles, and
// a drop must have a margin of 2^-40 of the largest coordinate to spare. That is far above what rounding does: numbers
// are relative to the edge, and no more than a few dozen operations lead to each.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/assembly/walkable_state.hpp"
#include "core/base/box_tree.hpp"
#include "core/filters/steps/border_kinds.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// Levels of a kernel; step may be 0.
struct DropLevels {
  Index step = 0, height = 0, depth = 0;
};

class DropFinder {
 public:
  /// The state must have a mesh, and its kernel the levels.
  DropFinder(const WalkableState& state, const DropLevels& levels, RunContext& context);

  /// All drops, ascending. `reach` in the environment's units.
  [[nodiscard]] std::vector<MeshDrop> find(double reach);

  [[nodiscard]] const ExactFallbacks& fallbacks() const { return fallbacks_; }

 private:
  using Tree = BoxTree<3>;
  /// A side of a triangle that cannot be crossed.
  struct Border {
    Index from = -1, to = -1;  ///< vertices
    Index triangle = -1;
    bool isLinked = false;  ///< one steps over it
  };
  /// The data for trying edges; one for each thread.
  struct Worker {
    BorderKinds kinds;
    std::vector<MeshDrop> drops;
  };

  void findBorders();
  void buildTrees();
  [[nodiscard]] Tree::Bounds boundsOf(Index a, Index b) const;
  [[nodiscard]] BorderEdge edgeOf(const Border& border) const;
  void tryBorder(const Border& border, double reach, Worker& worker) const;
  void dropStraight(const Border& border, const std::vector<EdgePiece>& ledges, Worker& worker) const;
  void dropAcross(const Border& border, const Border& other, const std::vector<EdgePiece>& ledges, double reach,
                  Worker& worker) const;
  [[nodiscard]] bool isLevel(Index face) const;
  /// The height of a face's plane at a scaled place: the nearest double.
  [[nodiscard]] double heightAt(Index face, const Vec3& place) const;

  const WalkableState& state_;
  const PlanKernel& kernel_;
  const WalkableMesh& mesh_;
  DropLevels levels_;
  RunContext& context_;
  std::vector<Vec3> places_;  ///< places of the mesh's vertices: the nearest doubles, scaled
  std::vector<Border> borders_;
  Tree borderTree_, triangleTree_;
  ExactFallbacks fallbacks_;
};

}  // namespace footfall::detail
