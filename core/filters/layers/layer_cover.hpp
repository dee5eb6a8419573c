// Finds the layers to which a piece of the walkable area may go. Made for pieces so much above each other that a list
// of all overlapping pairs would be far longer than the mesh.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/filters/layers/growing_triangles.hpp"
#include "core/mesh/mesh_geometry.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// Layers to which pieces are added one after another. A question about a piece and a layer is decided exactly, by
/// looking up the piece's triangles among the layer's. Most are answered without: a piece remembers some squares of a
/// quadtree over the plan that lie inside it, and a layer with a square of its own inside such a square, or around it,
/// overlaps the piece. Layers are kept as runs of numbers, so that a tower of equal floors costs next to nothing.
class LayerCover {
 public:
  LayerCover(const PlanKernel& kernel, const WalkableMesh& mesh, RunContext& context);

  /// A square of the quadtree, of its level.
  struct Square {
    int level = 0;
    std::uint32_t x = 0, y = 0;
  };
  struct Piece {
    std::span<const Index> triangles;
    std::vector<Square> inside;  ///< squares of which every point lies inside the piece
  };
  /// The span must outlive the piece.
  [[nodiscard]] Piece pieceOf(std::span<const Index> triangles) const;

  [[nodiscard]] std::uint32_t layerCount() const { return static_cast<std::uint32_t>(layers_.size()); }
  /// True when the piece overlaps nothing of the layer in the plan.
  [[nodiscard]] bool isFree(const Piece& piece, std::uint32_t layer);
  /// The first layer of which the piece overlaps nothing; layerCount() when there is none.
  [[nodiscard]] std::uint32_t firstFree(const Piece& piece);
  /// Adds the piece to a layer of which it overlaps nothing, or to a new one.
  void add(const Piece& piece, std::uint32_t layer);

  [[nodiscard]] const ExactFallbacks& fallbacks() const { return geometry_.fallbacks; }

 private:
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
  [[nodiscard]] bool isInside(const Square& square, const PlanTriangle& triangle) const;
  [[nodiscard]] static std::uint64_t keyOf(const Square& square);
  /// The first layer from `layer` on of which the squares do not prove that it overlaps the piece.
  [[nodiscard]] std::uint32_t firstInDoubt(const std::vector<const Runs*>& known, std::uint32_t layer) const;
  [[nodiscard]] std::vector<const Runs*> knownFor(const Piece& piece) const;
  [[nodiscard]] bool overlaps(const Piece& piece, const GrowingTriangles& layer);

  const PlanKernel& kernel_;
  const WalkableMesh& mesh_;
  RunContext& context_;
  MeshGeometry geometry_;
  std::vector<GrowingTriangles> layers_;
  std::unordered_map<std::uint64_t, Node> nodes_;
};

}  // namespace footfall::detail
