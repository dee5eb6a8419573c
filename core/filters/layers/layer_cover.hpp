// Finds the layers to which a piece of the walkable area may go.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/filters/layers/growing_boxes.hpp"
#include "core/filters/layers/layer_pieces.hpp"
#include "core/filters/layers/member_tree.hpp"
#include "core/mesh/mesh_geometry.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// Layers to which pieces are added one after another. A question about a piece and a layer is decided exactly, by
/// looking up the triangles of the piece among those of the layer's pieces whose boxes touch its own. Where there are
/// many layers, most are answered without: a piece has some squares of a quadtree over the plan that lie inside it, and
/// a layer with a square of its own inside such a square, or around it, overlaps the piece. Layers are kept as runs of
/// numbers, so that a tower of equal floors costs next to nothing.
class LayerCover {
 public:
  /// Each piece is a list of triangles. `overlaps` has the pieces that are known to overlap each one. All must outlive
  /// this.
  LayerCover(const LayerInput& input, const std::vector<std::span<const Index>>& pieces, const IndexLists& overlaps,
             RunContext& context);

  [[nodiscard]] std::uint32_t layerCount() const { return static_cast<std::uint32_t>(layers_.size()); }
  /// The first layer of which the piece overlaps nothing; layerCount() when there is none.
  [[nodiscard]] std::uint32_t firstFree(Index piece);
  /// True when the piece for which firstFree() was called last overlaps nothing of the layer in the plan.
  [[nodiscard]] bool isFree(std::uint32_t layer);
  /// Adds a piece to a layer of which it overlaps nothing, or to a new one.
  void add(Index piece, std::uint32_t layer);

  [[nodiscard]] ExactFallbacks fallbacks() const { return geometry_ ? geometry_->fallbacks : ExactFallbacks(); }
  /// Pairs of triangles that were found to overlap.
  [[nodiscard]] const std::vector<std::array<Index, 2>>& found() const { return found_; }

 private:
  /// A square of the quadtree, of its level.
  struct Square {
    int level = 0;
    std::uint32_t x = 0, y = 0;
  };
  /// Triangles among which others are looked up.
  struct Set {
    std::span<const Index> triangles;
    BoxTree<2> tree = {};     ///< of them, once it was needed
    std::size_t lookUps = 0;  ///< number of them so far
  };
  struct Piece {
    Set all;
    std::vector<Square> inside;  ///< squares of which every point lies inside the piece; none while layers are few
    BoxTree<2>::Bounds bounds;
    Index main = -1;  ///< the group of most triangles
    std::vector<Index> otherList;
    Set others;               ///< triangles that are not of it
    std::uint32_t layer = 0;  ///< of use once it was added
  };
  /// A set of numbers as runs: the first of each and the one behind its last.
  class Runs {
   public:
    void insert(std::uint32_t number);
    /// The first number from `number` on that is not in the set.
    [[nodiscard]] std::uint32_t firstMissing(std::uint32_t number) const;

   private:
    std::map<std::uint32_t, std::uint32_t> runs_;
  };
  struct Node {
    Runs around;  ///< layers that cover the whole square
    Runs within;  ///< layers that cover a square inside it
  };
  [[nodiscard]] Piece pieceOf(std::span<const Index> triangles) const;
  [[nodiscard]] std::vector<Square> squaresIn(std::span<const Index> triangles) const;
  /// Adds the largest square inside the triangle that holds a place; sides are at most `size`.
  void addSquareAt(double x, double y, const PlanTriangle& triangle, double size, std::vector<Square>& squares) const;
  void findSquares();
  void addSquares(const Piece& piece);
  [[nodiscard]] bool isInside(const Square& square, const PlanTriangle& triangle) const;
  [[nodiscard]] static std::uint64_t keyOf(const Square& square);
  /// The first layer from `layer` on of which the squares do not prove that it overlaps the piece.
  [[nodiscard]] std::uint32_t firstInDoubt(std::uint32_t layer) const;
  void lookUp(const Piece& piece);
  /// Lists the pieces of layers from `layer` on whose boxes have an inside in common with that of the piece.
  void findNear(std::uint32_t layer);
  void addNear(Index other);
  [[nodiscard]] bool overlapsAnyOf(std::uint32_t layer);
  /// Builds the tree of a set before so many look-ups, unless they are few.
  void needTree(Set& set, std::size_t lookUps);
  [[nodiscard]] bool overlap(Piece& piece, Piece& other);
  /// True when a triangle of one set overlaps one of the other.
  [[nodiscard]] bool overlap(Set& some, Set& others);
  /// True when one of some triangles overlaps one of a set.
  [[nodiscard]] bool overlapAny(std::span<const Index> triangles, Set& set);
  /// True when a middle of one of some triangles of a piece lies inside another piece, for sure. False has no meaning.
  [[nodiscard]] bool hasMiddleIn(const Piece& piece, const Piece& other);
  [[nodiscard]] bool holds(const PlanTriangle& triangle, double x, double y) const;
  [[nodiscard]] PlanTriangle planOf(Index triangle) const { return input_.plan->planOf(triangle); }
  [[nodiscard]] const BoxTree<2>::Bounds& boundsOf(Index triangle) const { return input_.plan->boundsOf(triangle); }

  const LayerInput& input_;
  const IndexLists& overlaps_;
  RunContext& context_;
  std::optional<MeshGeometry> geometry_;
  std::vector<std::array<Index, 2>> found_;
  std::vector<Piece> pieces_;
  MemberTree added_;                        ///< of the boxes of pieces
  std::vector<std::vector<Index>> layers_;  ///< pieces of each
  std::unordered_map<std::uint64_t, Node> nodes_;
  // The piece for which firstFree() was called:
  Index piece_ = -1;
  std::vector<const Runs*> known_;  ///< sets of layers that it overlaps
  std::vector<Index> blockedFor_;   ///< for each layer the last piece that is known to overlap one of its pieces
  /// A piece whose box has an inside in common with its own, in the list of a layer.
  struct Near {
    Index piece = -1;
    Index next = -1;  ///< number of the list's next one, or -1
  };
  std::vector<Near> near_;
  std::vector<Index> nearOf_;  ///< for each layer the first of its list, or -1
};

}  // namespace footfall::detail
