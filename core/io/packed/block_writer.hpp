// Writing a packed environment block by block from faces in their order.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/base/digest.hpp"
#include "core/io/output_files.hpp"
#include "core/io/packed/packed_format.hpp"

namespace footfall::detail {

/// A face with all data that its block stores.
struct PackedFace {
  std::uint32_t number = 0, part = 0;
  Triangle corners{};
  std::array<Vec3, 3> places;
};

class BlockWriter {
 public:
  /// `vertices` and `faces` are the totals of the environment; `poll` must live as long as the writer.
  BlockWriter(const std::string& target, std::uint64_t vertices, std::uint64_t faces, bool hasParts, Poll poll);

  void add(const PackedFace& face);
  /// Called after the last face. Writes the vertices that no face has, whose places `vertexAt` returns, and the
  /// remaining tables, and renames the file.
  PackedHeader finish(const std::string& description, const std::function<Vec3(std::uint32_t)>& vertexAt);

 private:
  std::uint32_t localOf(std::uint32_t vertex, const Vec3& place);
  void flush();
  void addLoneVertices(const std::function<Vec3(std::uint32_t)>& vertexAt);
  void orderOwnFirst();
  void writeBlock();
  void addCoarse(PackedBlock& block);
  PackedCoarse writeCoarse();

  GrowingFile file_;
  ScratchFile coarse_;  ///< holds PackedCoarseFaces
  std::uint64_t vertexCount_, faceCount_;
  std::size_t mostCoarse_;  ///< for each block
  Digest coarseSum_;
  bool hasParts_;
  Poll poll_;
  std::vector<std::uint64_t> isWritten_;  ///< a bit for each vertex that a block owns
  std::vector<PackedBlock> table_;

  // The block that is being filled.
  std::vector<Vec3> places_;
  std::vector<std::uint32_t> vertices_, faces_, parts_;
  std::vector<std::array<std::uint16_t, 3>> corners_;
  std::uint32_t own_ = 0;
  std::vector<std::uint32_t> slots_;  ///< an open hash table of its vertices
  std::string bytes_;
};

}  // namespace footfall::detail
