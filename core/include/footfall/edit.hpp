// Changing a loaded environment: obstacles that come, move and go, so that only what they touch is computed again.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "footfall/environment.hpp"

namespace footfall {

/// The origins of the elements of an edited environment. Kept elements come first, in the order of the base.
struct EnvironmentEdit {
  std::weak_ptr<const Environment> base;
  std::vector<std::uint32_t> keptVertices;   ///< numbers in the base, ascending
  std::vector<std::uint32_t> keptTriangles;  ///< numbers in the base, ascending
};

/// `base` without the triangles `removed` (ascending numbers) and with `added` at its end, rounded to the grid of
/// `base` where it has one. Vertices that no triangle uses any more go with them. Triangles keep their parts and roles;
/// those that were added belong to a part without names, where there are parts at all, and have no role. Throws
/// InputError when a number is out of range or a coordinate is not finite.
std::shared_ptr<const Environment> editEnvironment(const std::shared_ptr<const Environment>& base,
                                                   const std::vector<std::uint32_t>& removed,
                                                   const TriangleSoup& added);

/// `base` without the triangles `removed` (ascending, valid numbers), for callers that change more before they share
/// it.
std::shared_ptr<Environment> editedCopy(const std::shared_ptr<const Environment>& base,
                                        const std::vector<std::uint32_t>& removed, const TriangleSoup& added = {});

/// The name of an obstacle in its EditableEnvironment; none is given twice.
using ObstacleId = std::uint32_t;

/// A level with obstacles that are moved about. Every change makes a new environment; runPipeline() with the cache of
/// earlier runs then computes only what the change can affect, and the result is that of a run from nothing. One thread
/// at a time may change it; the environments that it gives never change, and any thread may use them.
class EditableEnvironment {
 public:
  explicit EditableEnvironment(std::shared_ptr<const Environment> level) : current_(std::move(level)) {}

  /// The environment as it is now.
  [[nodiscard]] const std::shared_ptr<const Environment>& environment() const { return current_; }

  /// Coordinates are in the level's units, Z up. Throws InputError for a soup with wrong indices or coordinates;
  /// nothing changes then.
  ObstacleId add(const TriangleSoup& obstacle);
  /// Puts `obstacle` where the one with this id was: moved, turned, scaled or another shape altogether. Throws
  /// InputError as add() does, and for an id that is not there.
  void replace(ObstacleId id, const TriangleSoup& obstacle);
  /// Throws InputError for an id that is not there.
  void remove(ObstacleId id);

 private:
  void edit(const std::vector<std::uint32_t>& removed, const TriangleSoup& added);

  std::shared_ptr<const Environment> current_;
  std::map<ObstacleId, std::vector<std::uint32_t>> triangles_;  ///< ascending numbers in the environment as it is now
  ObstacleId next_ = 0;
};

}  // namespace footfall
