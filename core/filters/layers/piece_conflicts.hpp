// The pieces of a region that lie above one another while the region is divided (layer_pieces.hpp). They are found by
// lists of all overlapping pairs of triangles, or by a search when a decision needs them; both give the same answers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <set>
#include <span>
#include <vector>

#include "core/filters/layers/growing_triangles.hpp"
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

/// Answers from lists. `piece` is the piece of each triangle, negative for those without; both must outlive it.
class ListedConflicts {
 public:
  ListedConflicts(const IndexLists& overlaps, std::vector<Index>& piece) : overlaps_(overlaps), piece_(piece) {}

  // While one piece after another grows:

  void begin() {}
  /// True when a triangle without a piece overlaps the piece that grows.
  bool isBlocked(Index /*triangle*/) { return false; }  // all of them are marked already
  /// Adds a triangle to the piece that grows, and may write `mark` for triangles without a piece that overlap it.
  void take(Index triangle, Index mark) {
    for (const Index o : overlaps_[triangle])
      if (piece_[o] < 0) piece_[o] = mark;
  }

  // While pieces are united:

  void beginUniting(std::span<const Index> triangles, std::size_t pieces);
  bool overlap(Index p, Index q) { return known_.contain(p, q); }
  void unite(Index into, Index from) { known_.unite(into, from); }

  // While single triangles move:

  void beginMoving(std::span<const Index> /*triangles*/, std::size_t /*pieces*/) {}
  /// True when the triangle overlaps one of the piece.
  bool overlapsPiece(Index triangle, Index piece) const;
  void move(Index /*triangle*/, Index /*to*/) {}

 private:
  const IndexLists& overlaps_;
  std::vector<Index>& piece_;
  KnownConflicts known_{0};
};

/// Looks up triangles among those of a piece. Takes no memory for pairs of triangles, of which a spiral of n turns has
/// n times as many as triangles. The functions are those of ListedConflicts.
class SearchedConflicts {
 public:
  /// `number` is that of each of the region's `triangles` among them.
  SearchedConflicts(const PlanKernel& kernel, const WalkableMesh& mesh, std::span<const Index> triangles,
                    const std::vector<Index>& number, std::vector<Index>& piece, RunContext& context);

  void begin() { growing_.clear(); }
  bool isBlocked(Index triangle);
  void take(Index triangle, Index /*mark*/) { growing_.insert(number_[triangle]); }

  void beginUniting(std::span<const Index> triangles, std::size_t pieces);
  bool overlap(Index p, Index q);
  void unite(Index into, Index from);

  void beginMoving(std::span<const Index> triangles, std::size_t pieces) { listMembers(triangles, pieces); }
  bool overlapsPiece(Index triangle, Index piece);
  void move(Index triangle, Index to) { of(to).add({&triangle, 1}, context_); }

  [[nodiscard]] SearchCounts counts() const { return {tested_, geometry_.fallbacks}; }

 private:
  /// True when the triangle overlaps one of the set that `counts`.
  template <class Counts>
  bool overlapsAny(Index triangle, const GrowingTriangles& set, const Counts& counts);
  void listMembers(std::span<const Index> triangles, std::size_t pieces);
  /// The triangles of a piece, put into trees when they are needed first.
  GrowingTriangles& of(Index piece);

  const WalkableMesh& mesh_;
  const std::vector<Index>& number_;
  std::vector<Index>& piece_;
  RunContext& context_;
  MeshGeometry geometry_;
  std::size_t tested_ = 0;
  // One entry for each of the region's triangles:
  std::vector<PlanTriangle> plans_;
  std::vector<MemberTree::Bounds> bounds_;
  MemberTree growing_;  ///< with the piece that grows as members
  IndexLists members_;
  std::vector<std::unique_ptr<GrowingTriangles>> trees_;  ///< one for each piece that was looked up
  KnownConflicts known_{0};
};

}  // namespace footfall::detail
