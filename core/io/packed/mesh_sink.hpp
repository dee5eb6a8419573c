// The target of the readers of core/io/packed/streams.hpp: a packer, or an environment in memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/index_and_box.hpp"
#include "footfall/environment.hpp"

namespace footfall::detail {

class MeshSink {
 public:
  MeshSink() = default;
  MeshSink(const MeshSink&) = delete;
  MeshSink& operator=(const MeshSink&) = delete;
  virtual ~MeshSink() = default;

  /// Adds a vertex in the file's own frame; coordinates are finite.
  virtual void addVertex(const Vec3& place) = 0;
  [[nodiscard]] virtual std::uint64_t vertexCount() const = 0;
  /// Returns a vertex that was added.
  [[nodiscard]] virtual Vec3 vertex(std::uint32_t number) const = 0;
  /// Adds a face. Corners may be vertices that are added later. `part` is 0 where there are no parts.
  virtual void addFace(const Triangle& corners, std::uint32_t part) = 0;

  /// True where the numbers of the file are floats, or were placed by matrices.
  bool areFloats = false;
};

}  // namespace footfall::detail
