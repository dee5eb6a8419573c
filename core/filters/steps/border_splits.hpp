// The borders of a walkable mesh, and the vertices that links put on them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/assembly/walkable_state.hpp"
#include "core/base/box_tree.hpp"
#include "core/base/poll.hpp"
#include "core/filters/steps/step_conditions.hpp"
#include "core/mesh/mesh_geometry.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// A side of a triangle that cannot be crossed, with walkable area on its left.
struct MeshBorder {
  Index side = -1, edge = -1;  ///< edge of the topology; the other side of an obstacle edge has the same
  Index from = -1, to = -1;    ///< vertices
  Index face = -1;
};

/// Edges of borders with their new vertices, in the order of their lines, each place once. The mesh stays as it is
/// until makeMesh() makes another one.
class BorderSplits {
 public:
  /// The state must have a mesh; it must outlive this. `faces` (may be null) chooses whose borders there are: for each
  /// source triangle.
  BorderSplits(const WalkableState& state, RunContext& context, const std::vector<char>* faces = nullptr);

  [[nodiscard]] const WalkableMesh& mesh() const { return mesh_; }
  [[nodiscard]] const Adjacency& topology() const { return *topology_; }
  [[nodiscard]] const std::vector<MeshBorder>& borders() const { return borders_; }
  [[nodiscard]] const MeshBorder& border(Index number) const { return borders_[number]; }
  [[nodiscard]] const MeshVertex& vertex(Index number) const { return mesh_.vertices[number]; }
  /// Of the borders; scaled.
  [[nodiscard]] const BoxTree<3>& tree() const { return tree_; }
  /// Frees the tree, when no more borders are to be found.
  void dropTree() { tree_ = {}; }
  /// A box about two vertices and all that is between them; scaled.
  [[nodiscard]] static BoxTree<3>::Bounds boundsOf(const MeshVertex& a, const MeshVertex& b);

  /// The state's, or one that was put in its place.
  [[nodiscard]] const std::shared_ptr<const PlanKernel>& kernel() const { return kernel_; }
  /// One that has all points of the present one, and more.
  void replaceKernel(std::shared_ptr<const PlanKernel> kernel);
  [[nodiscard]] MeshGeometry& geometry() { return *geometry_; }
  [[nodiscard]] const ExactFallbacks& fallbacks() const { return fallbacks_; }

  /// What the border's vertices were made of, the edges of its triangle's face, and the lines that cut that face, as
  /// far as the border lies on them.
  [[nodiscard]] std::vector<KnownLine> linesOf(const MeshBorder& border, MeshGeometry& geometry) const;
  /// The same without the lines that cut the face, which are not looked at where there is another one.
  [[nodiscard]] std::vector<KnownLine> ownLinesOf(const MeshBorder& border, MeshGeometry& geometry) const;

  /// Puts a vertex strictly between the ends of an edge, on whose line it must lie. False when there was one already.
  bool insert(Index edge, const MeshVertex& place);
  /// The new vertices of an edge, from the begin of its first side on.
  [[nodiscard]] const std::vector<MeshVertex>& of(Index edge) const;
  /// Those strictly between two places of its line, in no particular order.
  [[nodiscard]] std::vector<MeshVertex> between(Index edge, const MeshVertex& a, const MeshVertex& b);

  /// The border has the direction of its edge's first side, as the new vertices of the edge have.
  [[nodiscard]] bool isForward(const MeshBorder& border) const;
  /// A border's vertices from its first to its last.
  [[nodiscard]] std::size_t chainLength(const MeshBorder& border) const { return of(border.edge).size() + 2; }
  [[nodiscard]] const MeshVertex& chainVertex(const MeshBorder& border, std::size_t i) const;
  /// Its number in the mesh that makeMesh() made.
  [[nodiscard]] Index chainNumber(const MeshBorder& border, std::size_t i) const;

  /// The mesh with all new vertices, without links.
  std::shared_ptr<WalkableMesh> makeMesh(Poll poll);

  /// A coordinate of the plan in which two vertices differ, the one in which they seem to differ most; -1 where they
  /// are one point of the plan.
  static int axisBetween(const MeshVertex& a, const MeshVertex& b, MeshGeometry& geometry);

 private:
  struct Line {
    int axis = 0, direction = 1;     ///< the coordinate that grows (1) or falls (-1) along the edge
    std::vector<MeshVertex> places;  ///< in its order
    Index first = -1;                ///< number of the first one, once the mesh is made
  };

  void findBorders(const std::vector<char>* faces, Poll poll);
  void buildTree(RunContext& context);
  [[nodiscard]] int order(const Line& line, const MeshVertex& a, const MeshVertex& b) {
    return line.direction * geometry_->compare(a, b, line.axis);
  }
  [[nodiscard]] Index beginOf(Index side) const { return mesh_.triangles[side / 3].corners[side % 3]; }

  const WalkableState& state_;
  std::shared_ptr<const PlanKernel> kernel_;
  const WalkableMesh& mesh_;
  std::shared_ptr<const Adjacency> topology_;
  std::vector<MeshBorder> borders_;
  BoxTree<3> tree_;
  std::unordered_map<Index, Line> lines_;  ///< of edges that were asked to have new vertices
  std::optional<MeshGeometry> geometry_;
  ExactFallbacks fallbacks_;
};

}  // namespace footfall::detail
