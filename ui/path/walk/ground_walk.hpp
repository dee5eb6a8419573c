// Where somebody gets to who walks freely over the result.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "footfall/ground.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

/// A place on the walkable area that is moved along rays over the ground: over edges, steps and gaps, along borders
/// that stop it, and down drops. It never leaves the area, and no wall is passed, however thin.
class GroundWalk {
 public:
  /// In the mesh's units: it keeps `margin` off borders that it walks against, where there is room; `gap` is the widest
  /// gap that is stepped over.
  GroundWalk(std::shared_ptr<const PathFinder> finder, double margin, double gap);

  /// Stands on the walkable place straight above or below, within `reach`, or else on the nearest one. False where
  /// nothing is walkable.
  bool standAt(const Vec3& place, double reach);
  /// Where it stands; nothing before standAt().
  [[nodiscard]] const std::optional<SurfacePlace>& place() const { return place_; }

  struct Fall {
    Vec3 from, to;
  };
  /// Goes so far in the plan, as far as it gets. Where that leads over a ledge with a drop, the place is the landing,
  /// and the fall is returned.
  std::optional<Fall> go(double x, double y);

 private:
  /// What stopped a way, and how much of it is left to be gone along that.
  struct Stop {
    double x = 0, y = 0;
    std::optional<Fall> fall;
  };
  [[nodiscard]] std::optional<Stop> goStraight(double x, double y);
  [[nodiscard]] std::optional<Fall> fallFrom(const GroundRay& ray) const;
  void goTo(double x, double y);

  std::shared_ptr<const PathFinder> finder_;
  double margin_, gap_;
  std::optional<SurfacePlace> place_;
};

}  // namespace footfall::ui
