// Floors with a number at each place, for heat maps of slopes and free heights.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/poll.hpp"
#include "footfall/environment.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

/// A vertex of 20 bytes; locations 0, 1 and 2 of shaders/field.vert.
struct FieldVertex {
  std::array<float, 3> position{};
  float value = 0;
  std::array<std::int8_t, 4> normal{};
};

struct FieldGeometry {
  std::vector<FieldVertex> surface;    ///< three for each triangle, relative to the environment's centre
  std::vector<std::uint32_t> sources;  ///< the triangle of the environment, for each of them
};

/// The scale of the colours.
struct FieldScale {
  double lower = 0, upper = 1;   ///< at the ends of the colours; values beyond have the colour of the end
  std::optional<double> limit;   ///< limit of the filter
  bool aboveIsRejected = false;  ///< else values below the limit are
  bool operator==(const FieldScale&) const = default;
};

/// Angles to the ground in degrees, of all triangles that face up and are no walls. They have display precision;
/// SlopeFilter decides exactly what is walkable. `poll` is called often and may throw to cancel.
std::shared_ptr<const FieldGeometry> makeSlopeField(const Environment& environment, const Vec3& centre, Poll poll);

/// Free heights above all triangles that face up and are no walls, limited to `cap` (units, above 0). Floors are cut
/// into smaller pieces where the height changes, about `budget` pieces in all. Runs in parallel.
std::shared_ptr<const FieldGeometry> makeClearanceField(const std::shared_ptr<const Environment>& environment,
                                                        const Vec3& centre, double cap, std::size_t budget, Poll poll);

}  // namespace footfall::ui
