// Welds and splits the outlines of face parts so that they meet in whole edges.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/assembly/assembly_memory.hpp"
#include "core/assembly/earlier_result.hpp"
#include "core/assembly/face_mesh.hpp"
#include "core/assembly/walkable_state.hpp"
#include "core/base/unfilled_array.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

struct FloatBox;

/// A face to be joined with others.
struct FaceToJoin {
  Index face = -1;
  std::uint8_t obstacleEdges = 0;   ///< obstacle edges of a face that nothing cuts
  const FaceMesh* parts = nullptr;  ///< its walkable parts; null: nothing cuts it
};

/// Rounding of a sum or product of coordinates, generously.
inline constexpr double kCoordinateRounding = 8 * 0x1p-53;

/// Collects the parts of all faces, then joins them. One object for one mesh.
class MeshJoiner {
 public:
  explicit MeshJoiner(const PlanKernel& kernel) : kernel_(kernel), mesh_(kernel.mesh()) {}

  /// All faces, in any fixed order, by which everything is numbered; on all threads. Their parts are not needed any
  /// more afterwards. To be called once.
  void addFaces(std::span<const FaceToJoin> faces, RunContext& context);

  /// Copies from an earlier result which vertices lie on which outlines, between faces that are not in `changed`
  /// (ascending).
  void reuse(const EarlierResult& earlier, std::vector<Index> changed);

  /// Joins everything that was added. To be called once.
  WalkableMesh join(RunContext& context);

  /// The vertices on each outline, for reuse().
  JoinMemory takeMemory();

  [[nodiscard]] const ExactFallbacks& fallbacks() const { return fallbacks_; }

 private:
  /// An edge of a part's outline: other parts may meet it. Only those of faces that something cuts are stored.
  struct Outline {
    Index from = -1, to = -1;  ///< vertices
    Index triangle = -1;
    std::int8_t k = 0;
    Index face = -1;
    PlanLine line;                               ///< taken on `face`
    std::pair<Index, Index> sourceEdge{-1, -1};  ///< the source vertices of the face's edge that it lies on
  };
  using Incidence = JoinMemory::Incidence;
  enum class Relation { Apart, AtStart, Between, AtEnd };
  /// The data with which vertices are looked up.
  struct Search;
  /// New vertices on one edge of a triangle, in its direction.
  struct Split {
    Index triangle = -1;
    int k = 0;
    std::vector<Index> inner;
  };

  /// Faces whose points are in the order in which their triangles use them first: what addFaces() numbers.
  struct Additions;
  void layOut(Additions& additions, RunContext& context);
  Index listUses(std::size_t entry, Additions& additions);
  /// A point that has the same name in all faces at a source edge, and a face that uses it.
  struct SharedPoint;
  struct SharedUse;
  struct SharedUses;
  [[nodiscard]] SharedPoint sharedPoint(const FaceToJoin& given, Index point, Index name) const;
  /// Also notes first uses, but those of shared points, which it lists.
  void nameUses(std::size_t entry, Index first, Index last, Additions& additions, std::vector<SharedUse>& shared,
                ExactFallbacks& fallbacks) const;
  void listAllUses(Additions& additions, RunContext& context);
  /// Calls work(entry, place) for each of these places that has a point.
  template <class Work>
  void forUses(const Additions& additions, std::size_t first, std::size_t last, Work work) const;
  void findUsesOfShared(Additions& additions, RunContext& context);
  void numberUses(Additions& additions, RunContext& context);
  void fillVertices(const Additions& additions, RunContext& context);
  void fillTriangles(const Additions& additions, RunContext& context);
  /// The entry to which the point at this place belongs.
  [[nodiscard]] std::size_t entryOfPoint(std::size_t place) const;
  [[nodiscard]] MeshVertex sourceVertex(Index source, Index face) const;
  void copyEarlier();
  /// The entries of faces that may meet a changed one; all of them when nothing is reused.
  [[nodiscard]] std::vector<Index> entriesToSearch() const;
  /// True when nothing cuts the face of an entry.
  [[nodiscard]] bool isWhole(Index entry) const;
  /// True when the unchanged part of a vertex's incidences was copied.
  [[nodiscard]] bool isKnown(Index vertex) const;
  /// An outline by its number, or that of an edge of a whole face.
  [[nodiscard]] Outline outlineOf(Index number) const;
  /// Marks the vertices on outlines of the entries.
  [[nodiscard]] std::vector<char> verticesOn(const std::vector<Index>& entries, RunContext& context) const;
  void fillBoxes(const std::vector<char>& isSearched, Search& search, RunContext& context) const;
  void buildTree(const std::vector<Index>& entries, Search& search, RunContext& context) const;
  void findIncidences(RunContext& context);
  /// The incidences that one thread finds.
  struct Found;
  /// Vertices that lie near each other.
  struct Group;
  /// Finds what some vertices lie on, unless too many faces are around them: then it returns false.
  bool findTogether(std::span<const Index> vertices, const Search& search, Found& found, RunContext& context) const;
  void findOnWholeFace(Index entry, const Group& group, const Search& search, Found& found, RunContext& context) const;
  void findOnOutline(Index number, const FloatBox& box, const Group& group, Found& found, RunContext& context) const;
  void findOnCrowded(std::span<const Index> vertices, const Search& search, Found& found, RunContext& context) const;
  [[nodiscard]] Box boxAroundAll(std::span<const Index> vertices) const;
  void compare(Index vertex, Index number, const Outline& outline, Found& found, RunContext& context) const;
  void uniteVertices(RunContext& context);
  /// The vertex that stands for all at its place.
  [[nodiscard]] Index firstAt(Index vertex) const { return sameAs_.empty() ? vertex : sameAs_[vertex]; }
  /// The vertices on outlines, by triangle and edge.
  [[nodiscard]] std::vector<Split> findSplits(RunContext& context);
  [[nodiscard]] std::vector<MeshTriangle> splitTriangles(std::span<const Split> splits, RunContext& context) const;
  WalkableMesh assemble(std::span<const Split> splits, RunContext& context);
  /// True when a vertex is certainly not on the line through two others, by their rounded coordinates.
  [[nodiscard]] bool isFar(Index vertex, Index from, Index to) const;
  /// The position of a vertex on an outline from which it is not isFar().
  Relation relate(Index vertex, const Outline& outline, ExactFallbacks& count) const;
  [[nodiscard]] bool liesOnSourceEdge(const MeshVertex& vertex, const std::pair<Index, Index>& edge) const;
  /// Compares x (axis 0) or y (axis 1); 0 may also mean "too close for doubles" unless `exactly`.
  int compareCoordinate(Index a, Index b, int axis, bool exactly, ExactFallbacks& count) const;
  /// Order of two vertices along an outline's direction.
  int compareAlong(const Outline& outline, Index a, Index b, ExactFallbacks& count) const;

  const PlanKernel& kernel_;
  const SourceMesh& mesh_;
  UnfilledArray<MeshVertex> vertices_;
  UnfilledArray<MeshTriangle> triangles_;
  UnfilledArray<Outline> outlines_;
  std::vector<Index> firstTriangle_;  ///< first triangle of each entry, and the end
  std::vector<Index> sameAs_;         ///< first vertex at the same place, of each vertex; empty: itself
  JoinMemory memory_;
  const EarlierResult* earlier_ = nullptr;
  std::vector<Index> changed_;
  /// Their relations were copied from earlier; empty: none. Of entries, those of whole faces.
  std::vector<char> knownVertices_, knownOutlines_, knownEntries_;
  ExactFallbacks fallbacks_;
};

}  // namespace footfall::detail
