// Welds and splits the outlines of face parts so that they meet in whole edges.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/filters/assembly_memory.hpp"
#include "core/filters/earlier_result.hpp"
#include "core/filters/face_mesh.hpp"
#include "core/filters/walkable_state.hpp"
#include "core/pipeline/run_context.hpp"

namespace footfall {

/// Collects the parts of all faces (in any fixed order), then joins them. One object for one mesh.
class MeshJoiner {
 public:
  explicit MeshJoiner(const PlanKernel& kernel);

  /// Makes room for at most so many faces that nothing cuts, and triangles and points of parts.
  void reserve(std::size_t wholeFaces, std::size_t partTriangles, std::size_t partPoints);

  /// A face that nothing cuts.
  void addWholeFace(Index face, std::uint8_t obstacleEdges);
  /// The walkable parts of a face.
  void addParts(Index face, const FaceMesh& parts);

  /// What lies on what need not be found again between faces that are not in `changed` (ascending).
  void reuse(const EarlierResult& earlier, std::vector<Index> changed);

  /// Joins everything that was added. To be called once.
  WalkableMesh join(RunContext& context);

  /// How it was joined, for reuse().
  JoinMemory takeMemory();

  [[nodiscard]] const ExactFallbacks& fallbacks() const { return fallbacks_; }

 private:
  /// An edge of a part's outline: other parts may meet it.
  struct Outline {
    Index from = -1, to = -1;  ///< vertices
    Index triangle = -1;
    std::int8_t k = 0;
    Index face = -1;
    PlanLine line;                               ///< taken on `face`
    std::pair<Index, Index> sourceEdge{-1, -1};  ///< the source vertices of the face's edge that it lies on
  };
  using Incidence = JoinMemory::Incidence;
  /// Outlines between the same two vertices.
  struct Twins {
    std::vector<Index> first;  ///< of each set the smallest
    std::vector<Index> next;   ///< for each outline the next of its set, or -1
  };
  enum class Relation { Apart, AtStart, Between, AtEnd };

  void beginFace(Index face);
  Index sourceVertex(Index source, Index face);
  Index constructedVertex(Index face, const PlanPoint& point, const ApproximatePoint& approximate);
  void takeOver();
  /// The entries of faces that may meet a changed one; all of them when nothing is reused.
  [[nodiscard]] std::vector<Index> entriesToSearch() const;
  [[nodiscard]] Twins findTwins(const std::vector<Index>& entries, RunContext& context) const;
  void findIncidences(RunContext& context);
  Relation relate(Index vertex, const Outline& outline, ExactFallbacks& count) const;
  [[nodiscard]] bool liesOnSourceEdge(const MeshVertex& vertex, const std::pair<Index, Index>& edge) const;
  /// Compares x (axis 0) or y (axis 1); 0 may also mean "too close for doubles" unless `exactly`.
  int compareCoordinate(Index a, Index b, int axis, bool exactly, ExactFallbacks& count) const;
  /// Order of two vertices along an outline's direction.
  int compareAlong(const Outline& outline, Index a, Index b, ExactFallbacks& count) const;

  const PlanKernel& kernel_;
  const SourceMesh& mesh_;
  std::vector<MeshVertex> vertices_;
  std::vector<MeshTriangle> triangles_;
  std::vector<Outline> outlines_;
  std::vector<Index> ofSource_;  ///< vertex of a source vertex, or -1
  /// Constructed vertices on a source edge, by what they are in space.
  NumberedTable<PlanPoint> onSourceEdges_;
  std::vector<Index> ofSourceEdgePoint_;
  JoinMemory memory_;
  const EarlierResult* earlier_ = nullptr;
  std::vector<Index> changed_;
  std::vector<char> knownVertices_, knownOutlines_;  ///< their relations were taken over; empty: none
  ExactFallbacks fallbacks_;
};

}  // namespace footfall
