// Triangles of walkable area that a filter over all cells took away before cells run once more.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/byte_stream.hpp"
#include "core/tiles/tile.hpp"

namespace footfall::detail {

/// Triangles have the number of their face in the environment, and their place among the remainder that local filters
/// leave of it: cells that have the whole face have the same triangles in the same order.
class DroppedTriangles {
 public:
  /// Adds the triangles of a tile whose region is not kept.
  void add(const Tile& tile, const std::vector<Index>& regionOf, const std::vector<char>& keeps) {
    std::size_t t = 0;
    for (const TileFace& face : tile.faces)
      for (std::uint32_t place = 0; place < face.triangles; ++place, ++t)
        if (keeps[static_cast<std::size_t>(regionOf[t])] == 0) keys_.push_back(keyOf(face.source, place));
  }
  /// Call this when all are added.
  void sort() {
    std::sort(keys_.begin(), keys_.end());
    keys_.shrink_to_fit();
  }
  [[nodiscard]] bool contains(std::uint32_t source, std::uint32_t place) const {
    return std::binary_search(keys_.begin(), keys_.end(), keyOf(source, place));
  }
  /// Sorted ones as bytes, and back. Reading throws BadBytes.
  void write(ByteWriter& out) const {
    out.number(keys_.size());
    std::uint64_t before = 0;
    for (const std::uint64_t key : keys_) out.number(key - std::exchange(before, key));
  }
  void read(ByteReader& in) {
    keys_.resize(in.count(1));
    std::uint64_t before = 0;
    for (std::uint64_t& key : keys_) before = key = before + in.number();
  }
  [[nodiscard]] std::uint64_t bytes() const { return keys_.size() * sizeof(std::uint64_t); }

 private:
  static std::uint64_t keyOf(std::uint32_t source, std::uint32_t place) { return std::uint64_t{source} << 32 | place; }
  std::vector<std::uint64_t> keys_;
};

}  // namespace footfall::detail
