// The preview of another radius.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/poll.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/previews/edit_preview.hpp"
#include "ui/view/previews/preview_borders.hpp"

namespace footfall::ui {

/// The parts of a mesh near its borders, as seen from above and straight across its triangles.
class BorderStrips {
 public:
  /// Distances are known up to `limit`.
  BorderStrips(std::shared_ptr<const NavigationMesh> mesh, double limit, Poll poll);

  [[nodiscard]] const std::shared_ptr<const NavigationMesh>& mesh() const { return mesh_; }
  /// The nearer parts, as triangles that may overlap; round corners are a little too wide. Empty where there would be
  /// too many triangles to preview.
  [[nodiscard]] NavigationMesh within(double distance) const;

 private:
  struct Pair {
    std::uint32_t border = 0, triangle = 0;
    float least = 0;  ///< least distance of both
  };
  void add(NavigationMesh& soup, const Pair& pair, double distance) const;

  std::shared_ptr<const NavigationMesh> mesh_;
  std::vector<PreviewBorder> borders_;
  std::vector<Pair> pairs_;  ///< sorted by `least`
  bool tooMany_ = false;
};

/// RadiusFilter: margins grow over the remaining area, or areas reappear up to the next margin. It works only where
/// walls and ledges have one distance, because only a run can distinguish them. Radii are known up to twice that of the
/// run. Links count as borders although they are none, and thin walls do not count from behind.
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
