// The pieces of a region that lie above one another while the region is divided (layer_pieces.hpp). Pairs that are
// known to overlap, or not to, decide where they can; others are searched for when a decision needs them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "core/filters/layers/growing_boxes.hpp"
#include "core/filters/layers/layer_pieces.hpp"
#include "core/filters/layers/member_tree.hpp"
#include "core/mesh/mesh_geometry.hpp"

namespace footfall::detail {

/// Pairs of pieces that overlap, kept while pieces are united.
class KnownConflicts {
 public:
  explicit KnownConflicts(std::size_t pieces) : others_(pieces) {}

  void add(Index p, Index q) {
    others_[p].insert(q);
    others_[q].insert(p);
  }
  [[nodiscard]] bool contain(Index p, Index q) const { return others_[p].contains(q); }
  void unite(Index into, Index from);

 private:
  std::vector<std::set<Index>> others_;
};

/// Looks up triangles among those of a piece. Takes no memory for pairs of triangles, of which a spiral of n turns has
/// n times as many as triangles.
class PieceConflicts {
 public:
  /// `piece` is the piece of each triangle, negative for those without; all must outlive it.
  PieceConflicts(const LayerInput& input, std::span<const Index> triangles, std::vector<Index>& piece,
                 RunContext& context);

  // While one piece after another grows:

  void begin(Index piece);
  /// True when a triangle without a piece overlaps the piece that grows.
  bool isBlocked(Index triangle);
  /// Adds a triangle to the piece that grows.
  void take(Index triangle);

  // While pieces are united:

  void beginUniting(std::size_t pieces);
  bool overlap(Index p, Index q);
  void unite(Index into, Index from);

  // While single triangles move:

  void beginMoving(std::size_t pieces) { listMembers(pieces); }
  /// True when the triangle overlaps one of the piece.
  bool overlapsPiece(Index triangle, Index piece);
  void move(Index triangle, Index to);

  /// Call it once.
  [[nodiscard]] SearchCounts takeCounts();

 private:
  using Bounds = MemberTree::Bounds;

  /// The triangles of a piece. Most are of its main group; the others are listed.
  struct Members {
    std::vector<Index> all;
    Index main = -1;
    std::vector<Index> others;
    std::unique_ptr<GrowingBoxes> tree;  ///< of all, once it was needed
    int lookUps = 0;                     ///< number of them without the tree
  };

  [[nodiscard]] bool isOf(Index group, Index triangle) const { return group >= 0 && input_.group[triangle] == group; }
  [[nodiscard]] Index groupOf(Index triangle) const { return input_.group.empty() ? -1 : input_.group[triangle]; }
  [[nodiscard]] bool knowsAllOf(Index triangle) const { return input_.knowsAll || groupOf(triangle) == kSettled; }
  [[nodiscard]] const Bounds& boundsOf(Index triangle) const { return input_.plan->boundsOf(triangle); }
  bool test(Index triangle, Index other);
  void addToTree(Index triangle);
  void chooseMain(Index group);
  void place(Index triangle);
  /// Visits members of the main group that are in no tree, or puts them there. Returns whether a visit did.
  template <class Visit>
  bool visitLate(const Visit& visit);

  void addTo(GrowingBoxes& tree, std::span<const Index> triangles);
  void listMembers(std::size_t pieces);
  void add(Index triangle, Members& members);
  /// True when the triangle overlaps a member that `counts`.
  template <class Counts>
  bool overlapsAny(Index triangle, Members& members, const Counts& counts);

  const LayerInput& input_;
  std::span<const Index> triangles_;
  std::vector<Index>& piece_;
  RunContext& context_;
  std::optional<MeshGeometry> geometry_;
  SearchCounts counts_;
  // The piece that grows:
  Index growing_ = -1, main_ = -1;
  std::vector<Index> sizes_;  ///< number of members of each group
  std::vector<Index> late_;   ///< members of the main group that are in no tree yet
  int lookUps_ = 0;           ///< number of them among `late_`
  MemberTree tree_;           ///< with members of the main group, or all where there are no groups
  GrowingBoxes others_;       ///< all other members
  std::vector<Index> taken_;  ///< all members, where there are groups
  // All pieces:
  std::vector<Members> members_;
  KnownConflicts known_{0};
};

}  // namespace footfall::detail
