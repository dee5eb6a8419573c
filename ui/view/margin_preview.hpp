// What one sees at once of another radius.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/poll.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/edit_preview.hpp"
#include "ui/view/preview_borders.hpp"

namespace footfall::ui {

/// What of a mesh is near its borders, as seen from above and straight across its triangles.
class BorderStrips {
 public:
  /// Knows distances up to `limit`.
  BorderStrips(std::shared_ptr<const NavigationMesh> mesh, double limit, Poll poll);

  [[nodiscard]] const std::shared_ptr<const NavigationMesh>& mesh() const { return mesh_; }
  /// What is nearer than that, in triangles that may overlap; round corners are a little wider. None where they would
  /// be too many to be previewed.
  [[nodiscard]] NavigationMesh within(double distance) const;

 private:
  struct Pair {
    std::uint32_t border = 0, triangle = 0;
    float least = 0;  ///< how far they are apart at least
  };
  void add(NavigationMesh& soup, const Pair& pair, double distance) const;

  std::shared_ptr<const NavigationMesh> mesh_;
  std::vector<PreviewBorder> borders_;
  std::vector<Pair> pairs_;  ///< ascending by `least`
  bool tooMany_ = false;
};

/// RadiusFilter: margins grow over what was left, or what was there before them comes back as far as another margin
/// leaves it. Only where walls and ledges have one distance, as what is a ledge only a run can tell. Knows radii up to
/// twice the one of the run. Links count as borders that are none, and thin walls not as walls from behind.
class MarginPreview : public EditPreview {
 public:
  MarginPreview(const EditedStep& step, const Vec3& centre, Poll poll);

  [[nodiscard]] Surfaces changes(const Values& from, const Values& to) const override;
  [[nodiscard]] bool suits(const EditedStep& step) const override;

 private:
  Vec3 centre_;
  double radius_;
  BorderStrips left_, before_;
};

}  // namespace footfall::ui
