// The preview of another vertical clearance.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "core/base/poll.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/previews/edit_preview.hpp"

namespace footfall::ui {

/// VerticalClearanceFilter: a floor loses the area under the parts of obstacles between the old and the new height
/// above it, or regains it where no lower obstacle is. Obstacles are those of the file. Heights are known up to twice
/// the clearance of the run.
class HeadroomPreview : public EditPreview {
 public:
  HeadroomPreview(const EditedStep& step, std::shared_ptr<const Environment> environment, const Vec3& centre,
                  Poll poll);

  [[nodiscard]] Surfaces changes(const Values& from, const Values& to) const override;
  [[nodiscard]] bool suits(const EditedStep& step) const override;

 private:
  /// An obstacle over a floor, and the heights at which it is there.
  struct Pair {
    std::uint32_t floor = 0, obstacle = 0;
    float low = 0, high = 0;
  };
  /// A corner of the remaining part of an obstacle: its place in the plan and its height above the plane of the floor.
  struct Corner {
    double x = 0, y = 0, height = 0;
  };
  /// A triangle clipped by three edges and two heights has at most eight corners, and a few more when rounding bends
  /// it.
  struct Polygon {
    std::array<Corner, 12> corners;
    std::size_t size = 0;
  };

  void findPairs(Poll poll);
  [[nodiscard]] std::array<Vec3, 3> cornersOf(const std::vector<Vec3>& vertices, const Triangle& triangle) const;
  [[nodiscard]] Polygon overlap(const Pair& pair, double low, double high) const;
  void addShadow(NavigationMesh& mesh, const Pair& pair, double low, double high) const;
  template <class DistanceOf>
  static void clip(Polygon& polygon, DistanceOf distanceOf);

  std::shared_ptr<const NavigationMesh> floors_;
  std::shared_ptr<const Environment> environment_;
  Vec3 centre_;
  double limit_;
  std::vector<Pair> pairs_;  ///< sorted by `low`
};

}  // namespace footfall::ui
