// The preview of another step or gap.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/base/poll.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/previews/edit_preview.hpp"
#include "ui/view/previews/preview_borders.hpp"

namespace footfall::ui {

/// StepFilter: links that the new values do not allow disappear, and borders that they join get one. The distance of
/// borders is measured in doubles in the middle of their common stretch; obstacles are tested along one line only.
/// Steps are known up to twice the step of the run, and gaps up to the larger of its step and twice its gap.
class LinkPreview : public EditPreview {
 public:
  LinkPreview(const EditedStep& step, const Environment& environment, const Vec3& centre, Poll poll);

  [[nodiscard]] Surfaces changes(const Values& from, const Values& to) const override;
  [[nodiscard]] bool suits(const EditedStep& step) const override;

 private:
  /// Two edges that are, or would be, linked: the first with the area on its left, the second opposite to it.
  struct Pair {
    std::array<Vec3, 2> first, second;
    double height = 0, width = 0;  ///< in the plan
    [[nodiscard]] bool fits(const Values& values) const;
  };
  static std::optional<Pair> pairOf(const PreviewBorder& a, const PreviewBorder& b);
  void findPairs(const Environment& environment, Poll poll);
  [[nodiscard]] EditPreview::Surfaces painted(const std::vector<const Pair*>& pairs, const Paint& paint) const;

  std::shared_ptr<const NavigationMesh> result_;
  Vec3 centre_;
  Values values_, limits_;
  double strip_;                      ///< width of links drawn on the floors that they join
  std::vector<Pair> links_, others_;  ///< links of the run, and pairs that it has not linked
};

}  // namespace footfall::ui
