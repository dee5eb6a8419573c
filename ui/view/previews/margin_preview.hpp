// The preview of another radius.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/poll.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/previews/edit_preview.hpp"
#include "ui/view/previews/margin_parts.hpp"

namespace footfall::ui {

/// RadiusFilter: margins grow over the remaining area, or areas reappear up to the next margin. It works only where
/// walls and ledges have one distance: with two, the nearest border does not decide, and only a run can distinguish
/// them. Radii are known up to 1, and up to three times the radius of the run for which it was made.
class MarginPreview : public EditPreview {
 public:
  MarginPreview(const EditedStep& step, const Vec3& centre, Poll poll);

  [[nodiscard]] Surfaces changes(const Values& from, const Values& to) const override;
  [[nodiscard]] bool suits(const EditedStep& step) const override;

 private:
  std::shared_ptr<const NavigationMesh> before_;
  MarginParts parts_;
};

}  // namespace footfall::ui
