// Triangles as three vertex numbers each, wherever a mesh keeps them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/index_and_box.hpp"
#include "core/mesh/walkable_mesh.hpp"

namespace footfall::detail {

/// A view of a list of triangles, which must stay as it is while the view is used.
class TriangleCorners {
 public:
  TriangleCorners(const std::vector<MeshTriangle>& triangles)
      : first_(reinterpret_cast<const std::byte*>(triangles.data()) + offsetof(MeshTriangle, corners)),
        stride_(sizeof(MeshTriangle)),
        count_(static_cast<Index>(triangles.size())) {}
  TriangleCorners(const std::vector<Triangle>& triangles)
      : first_(reinterpret_cast<const std::byte*>(triangles.data())),
        stride_(sizeof(Triangle)),
        count_(static_cast<Index>(triangles.size())) {}

  [[nodiscard]] Index size() const { return count_; }
  /// The three vertices of a triangle. An unsigned number may be read as the signed one.
  [[nodiscard]] const Index* operator[](Index triangle) const {
    return reinterpret_cast<const Index*>(first_ + static_cast<std::size_t>(triangle) * stride_);
  }
  /// The ends of a side: from corner `side % 3` of triangle `side / 3` to the next one.
  [[nodiscard]] Index beginOf(Index side) const { return (*this)[side / 3][side % 3]; }
  [[nodiscard]] Index endOf(Index side) const { return (*this)[side / 3][side % 3 == 2 ? 0 : side % 3 + 1]; }

 private:
  const std::byte* first_;
  std::size_t stride_;
  Index count_;
};

}  // namespace footfall::detail
