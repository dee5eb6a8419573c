// The borders of a walkable mesh, and the vertices that links add to them.
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

/// A side of a triangle that agents cannot cross, with walkable area on its left.
struct MeshBorder {
  Index side = -1, edge = -1;  ///< edge of the topology; both sides of an obstacle edge have the same one
  Index from = -1, to = -1;    ///< vertices
  Index face = -1;
};

/// Edges of borders with their new vertices, each place once and in the order along the edge. The mesh does not change;
/// makeMesh() makes another one.
class BorderSplits {
 public:
  /// The state must have a mesh; it must outlive this object. `faces` (may be null) has an entry for each source
  /// triangle and selects the borders of some of them.
  BorderSplits(const WalkableState& state, RunContext& context, const std::vector<char>* faces = nullptr);

  [[nodiscard]] const WalkableMesh& mesh() const { return mesh_; }
  [[nodiscard]] const Adjacency& topology() const { return *topology_; }
  [[nodiscard]] const std::vector<MeshBorder>& borders() const { return borders_; }
  [[nodiscard]] const MeshBorder& border(Index number) const { return borders_[number]; }
  [[nodiscard]] const MeshVertex& vertex(Index number) const { return mesh_.vertices[number]; }
  /// The tree of the borders; scaled.
  [[nodiscard]] const BoxTree<3>& tree() const { return tree_; }
  /// Frees the tree, when no more borders are looked up.
  void dropTree() { tree_ = {}; }
  /// A box around two vertices and everything between them; scaled.
  [[nodiscard]] static BoxTree<3>::Bounds boundsOf(const MeshVertex& a, const MeshVertex& b);

  /// The kernel of the state, or the one that replaced it.
  [[nodiscard]] const std::shared_ptr<const PlanKernel>& kernel() const { return kernel_; }
  /// Replaces the kernel by one that has all its points, and more.
  void replaceKernel(std::shared_ptr<const PlanKernel> kernel);
  [[nodiscard]] MeshGeometry& geometry() { return *geometry_; }
  [[nodiscard]] const ExactFallbacks& fallbacks() const { return fallbacks_; }

  /// The lines that the border is known to lie on: those of its vertices, the edges of its triangle's face, and the
  /// lines that cut that face.
  [[nodiscard]] std::vector<KnownLine> linesOf(const MeshBorder& border, MeshGeometry& geometry) const;
  /// The same lines; the lines that cut the face are computed only where no other line is known.
  [[nodiscard]] std::vector<KnownLine> ownLinesOf(const MeshBorder& border, MeshGeometry& geometry) const;

  /// Inserts a vertex strictly between the ends of an edge; it must lie on the edge's line. Returns false when there
  /// was one already.
  bool insert(Index edge, const MeshVertex& place);
  /// The new vertices of an edge, from the beginning of its first side on.
  [[nodiscard]] const std::vector<MeshVertex>& of(Index edge) const;
  /// The new vertices strictly between two places of the edge's line, in no particular order.
  [[nodiscard]] std::vector<MeshVertex> between(Index edge, const MeshVertex& a, const MeshVertex& b);

  /// Returns whether the border has the direction of its edge's first side, which is the order of the edge's new
  /// vertices.
  [[nodiscard]] bool isForward(const MeshBorder& border) const;
  /// The vertices of a border from its first to its last.
  [[nodiscard]] std::size_t chainLength(const MeshBorder& border) const { return of(border.edge).size() + 2; }
  [[nodiscard]] const MeshVertex& chainVertex(const MeshBorder& border, std::size_t i) const;
  /// The number of the vertex in the mesh that makeMesh() made.
  [[nodiscard]] Index chainNumber(const MeshBorder& border, std::size_t i) const;

  /// Makes the mesh with all new vertices, without links.
  std::shared_ptr<WalkableMesh> makeMesh(Poll poll);

  /// The coordinate of the plan in which two vertices differ, preferring the one in which their difference seems
  /// larger; -1 where they are the same point of the plan.
  static int axisBetween(const MeshVertex& a, const MeshVertex& b, MeshGeometry& geometry);

 private:
  struct Line {
    int axis = 0, direction = 1;     ///< the coordinate that grows (1) or falls (-1) along the edge
    std::vector<MeshVertex> places;  ///< in order along the edge
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
  std::unordered_map<Index, Line> lines_;  ///< edges that got new vertices, or may get them
  std::optional<MeshGeometry> geometry_;
  ExactFallbacks fallbacks_;
};

}  // namespace footfall::detail
