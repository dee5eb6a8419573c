// Finds which vertices of several tiles are one.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <unordered_map>

#include "core/tiles/tile.hpp"

namespace footfall::detail {

/// Numbers of vertices by their names.
class BorderNames {
 public:
  /// The number that was given to that name; `next` where it is new.
  Index numberOf(const Vec3& place, const TileBorder& border, Index next) {
    return numbers_.try_emplace({place, border.face, border.exact}, next).first->second;
  }
  [[nodiscard]] bool contains(const Vec3& place, const TileBorder& border) const {
    return numbers_.contains({place, border.face, border.exact});
  }
  Index numberOf(const TileOutside& vertex, Index next) {
    return numbers_.try_emplace({vertex.place, vertex.face, vertex.exact}, next).first->second;
  }
  [[nodiscard]] std::size_t size() const { return numbers_.size(); }

 private:
  struct Name {
    Vec3 place;
    std::uint32_t face = 0;
    std::string exact;
    bool operator==(const Name&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Name& name) const {
      std::uint64_t hash = name.face;
      for (const double x : {name.place.x, name.place.y, name.place.z})
        hash = std::rotl((hash ^ std::bit_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15U, 29);
      return static_cast<std::size_t>(hash ^ (hash >> 32));
    }
  };
  std::unordered_map<Name, Index, Hash> numbers_;
};

}  // namespace footfall::detail
