// Packing an environment of any size in bounded memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/environment/coordinate_grid.hpp"
#include "core/environment/edge_splitting.hpp"
#include "core/io/output_files.hpp"
#include "core/io/packed/mesh_sink.hpp"
#include "footfall/environment.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// Bounds of the packer's memory. Tests make them small.
struct PackingMemory {
  std::size_t scratch = std::size_t{32} << 20;  ///< bytes of vertices, and as many of faces, before they go to the disk
  std::size_t cachedPages = 1024;               ///< pages of 2,048 vertices that are kept for further look-ups
  std::size_t sortedFaces = std::size_t{1} << 20;  ///< faces, of 104 bytes each, that are sorted at a time
  std::size_t merged = std::size_t{64} << 20;      ///< bytes that are read ahead of all sorted runs together
  /// The most faces that are put on a grid in memory. Tests alone set less, because splits differ beyond it.
  std::uint64_t facesOnGrid = kMostSplitTriangles;
  std::size_t weldedVertices = std::size_t{1} << 23;  ///< vertices, of 24 bytes each, that welding holds at a time
};

/// Counts of a packed environment.
struct PackedCounts {
  std::uint64_t vertices = 0, faces = 0, blocks = 0, bytes = 0;
};

/// Takes vertices and faces in the order of the file and keeps them in nameless files beside the target. It sorts the
/// faces along a Hilbert curve by merging sorted runs, and writes block by block. Memory: the bounds of PackingMemory,
/// about 400 MB, and one bit for each vertex. Disk, until it ends: 24 bytes for each vertex, 120 for each face. The
/// same input gives the same bytes.
///
/// All functions throw RunError when the disk is full or cannot be written, InputError "PATH: what; what to do" for
/// more than 4294967295 vertices or faces (PATH is the input), and Cancelled.
class EnvironmentPacker : public MeshSink {
 public:
  /// finish() writes `target`, which must not be the input. `context` may be null.
  EnvironmentPacker(const std::string& input, const std::string& target, RunContext* context,
                    const PackingMemory& memory = {});
  ~EnvironmentPacker() override;

  /// Removes all vertices and faces.
  void restart();
  void addVertex(const Vec3& place) override;
  [[nodiscard]] std::uint64_t vertexCount() const override { return vertexCount_; }
  [[nodiscard]] std::uint64_t faceCount() const { return faceCount_; }
  [[nodiscard]] Vec3 vertex(std::uint32_t number) const override;
  void addFace(const Triangle& corners, std::uint32_t part) override;

  /// Puts all vertices on the grid that `options` choose, as importing the file does (core/environment/
  /// coordinate_grid.hpp), and returns the grid. It is called last before finish(). `up` is the axis of the frame in
  /// which importing rounds. It reads all faces twice, and all vertices once for each PackingMemory::weldedVertices of
  /// them.
  CoordinateGrid putOnGrid(const ImportOptions& options, UpAxis up, double metresPerUnit);

  /// Sorts and writes. `head` has everything except the geometry (encodeDescription()); faces have no parts where it
  /// has none.
  PackedCounts finish(const Environment& head);

 private:
  struct Face;
  struct Run;
  class VertexPages;

  [[nodiscard]] Face placed(std::uint32_t number, const std::uint32_t* corners) const;
  void sortChunk(std::vector<Face>& chunk);
  std::vector<Run> sortRuns(std::vector<Face>& last);
  template <class Take>
  void mergeRuns(const std::vector<Run>& runs, const Take& take);
  template <class Take>
  void forEachVertex(const Take& take) const;
  template <class Take>
  void forEachFace(const Take& take) const;
  CoordinateGrid putOnGridInMemory(double step);
  [[nodiscard]] WeldedPlaces findWelds(double step) const;
  void poll() const;
  void progress(double done) const;

  std::string input_, target_;
  RunContext* context_;
  PackingMemory memory_;
  ScratchFile vertices_, faces_, sorted_;
  std::unique_ptr<VertexPages> pages_;
  std::uint64_t vertexCount_ = 0, faceCount_ = 0;
  Vec3 lower_, upper_;  ///< bounds of all vertices
  std::optional<GridRounding> rounding_;
  UpAxis up_ = UpAxis::Z;  ///< axis of the rounding
};

}  // namespace footfall::detail
