// Reading packed environments. They open in milliseconds at any size, and their blocks are read as they are needed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/io/input_file.hpp"
#include "core/io/packed/coarse_faces.hpp"
#include "core/io/packed/packed_format.hpp"
#include "footfall/environment.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// The arrays of a block.
struct BlockArrays {
  std::shared_ptr<const std::uint64_t[]> owner;   ///< memory that the spans refer to
  std::span<const std::array<double, 3>> places;  ///< in the file's own frame
  std::span<const std::uint32_t> vertices;        ///< numbers of the vertices
  std::span<const std::uint32_t> faces;           ///< numbers of the faces
  std::span<const std::uint32_t> parts;           ///< parts of the faces; empty without parts
  std::span<const std::array<std::uint16_t, 3>> corners;
};

/// Faces of an environment with the vertices that they need, both in the order of their numbers.
struct PackedFaces {
  TriangleSoup soup;                                      ///< Z up; indices into its own vertices
  std::vector<std::uint32_t> vertexNumbers, faceNumbers;  ///< numbers in the environment
  std::vector<std::uint32_t> partOf;                      ///< empty without parts
};

/// A face of a block that a caller may choose.
struct BlockFace {
  std::size_t block = 0, place = 0;  ///< the block, and the face's place in it
  std::uint32_t number = 0;          ///< number in the environment
  std::uint32_t part = 0;            ///< index into Environment::parts; 0 without parts
  std::array<Vec3, 3> corners;       ///< Z up
};
/// The box around the face's corners.
Box boxOf(const BlockFace& face);

/// The default size of the cache of blocks, in bytes.
inline constexpr std::uint64_t kKeptBlocks = std::uint64_t{4} << 20;

/// An open packed environment. Blocks are checked (their check sum, and that all numbers are in range) whenever they
/// are read, so a file that is truncated or overwritten while it is open is reported as damaged.
///
/// All functions throw InputError "PATH: what; what to do" where the file is no packed environment, of another version,
/// truncated or damaged. Any number of threads may use one object.
class PackedEnvironment {
 public:
  /// Reads the header, the description and the table of blocks.
  explicit PackedEnvironment(const std::string& path, const ImportOptions& options = {});
  ~PackedEnvironment();
  PackedEnvironment(const PackedEnvironment&) = delete;
  PackedEnvironment& operator=(const PackedEnvironment&) = delete;

  /// Everything except the geometry, as importing with these options gives it.
  [[nodiscard]] const Environment& head() const { return head_; }
  [[nodiscard]] std::uint64_t vertexCount() const { return header_.vertices; }
  [[nodiscard]] std::uint64_t faceCount() const { return header_.faces; }
  [[nodiscard]] std::span<const PackedBlock> blocks() const { return blocks_; }
  /// The check sum that identifies the geometry.
  [[nodiscard]] const CheckSum& tableSum() const { return header_.tableSum; }
  /// The box of a block, Z up.
  [[nodiscard]] Box boxOf(std::size_t block) const;
  /// The number of bytes of the file that were read so far.
  [[nodiscard]] std::uint64_t bytesRead() const { return bytesRead_.load(std::memory_order_relaxed); }
  /// Calls visit(block, corners), Z up, for all coarse faces (coarseFaces()), one block after the other; blocks() has
  /// their number for each block. A file of version 1 has none.
  void forCoarseFaces(const std::function<void(std::size_t, const CoarseFace&)>& visit) const;

  /// The blocks with faces whose boxes touch this one (Z up, closed).
  [[nodiscard]] std::vector<std::size_t> blocksTouching(const Box& box) const;
  [[nodiscard]] BlockArrays block(std::size_t number) const;
  /// Calls visit(face) for each face of a block.
  void forFaces(std::size_t block, const std::function<void(const BlockFace&)>& visit) const;
  /// The faces of `blocks` for which `isWanted` is true.
  [[nodiscard]] PackedFaces facesOf(std::span<const std::size_t> blocks,
                                    const std::function<bool(const BlockFace&)>& isWanted,
                                    RunContext* context = nullptr) const;
  /// Sets the size of the cache of blocks, at first kKeptBlocks bytes.
  void keepBlocks(std::uint64_t bytes) const;
  /// Frees the memory of all blocks; they are read again when they are needed.
  void forgetBlocks() const;
  /// The faces whose own boxes touch this one (Z up, closed). Reads only blocksTouching().
  [[nodiscard]] PackedFaces facesTouching(const Box& box, RunContext* context = nullptr) const;
  /// The whole environment, bit by bit the one that was packed.
  [[nodiscard]] Environment readAll(RunContext* context = nullptr) const;

 private:
  class RecentBlocks;
  using Bytes = std::shared_ptr<const std::uint64_t[]>;
  /// A vertex that belongs to another block.
  struct Copy {
    std::uint32_t vertex = 0;
    Vec3 place;
  };

  void read(std::uint64_t offset, char* bytes, std::size_t size) const;
  [[nodiscard]] std::string bytesAt(std::uint64_t offset, std::uint64_t size) const;
  void readHeader();
  void readDescription(const ImportOptions& options);
  void readTable();
  [[nodiscard]] BlockArrays readBlock(std::size_t number) const;
  [[nodiscard]] BlockArrays arraysOf(const PackedBlock& block, const Bytes& bytes) const;
  /// Returns copies whose places other blocks must confirm.
  std::vector<Copy> fill(std::size_t number, Environment& environment, std::atomic<std::uint64_t>* vertices,
                         std::atomic<std::uint64_t>* faces) const;
  [[noreturn]] void failDamaged() const;

  std::string path_;
  InputFile file_;
  std::unique_ptr<RecentBlocks> recent_;
  PackedHeader header_;
  Environment head_;
  std::vector<PackedBlock> blocks_;
  PackedCoarse coarse_;
  mutable std::atomic<std::uint64_t> bytesRead_{0};
};

/// Imports a packed environment.
Environment readPacked(const std::string& path, const ImportOptions& options, RunContext* context);

}  // namespace footfall::detail
