// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/previews/margin_preview.hpp"

#include <algorithm>
#include <utility>

#include "footfall/filter_type.hpp"

namespace footfall::ui {
namespace {

constexpr double kLeastKnown = 1;  // radii up to it are known after any run
constexpr double kKnownReach = 3, kSuitableReach = 1.5;

}  // namespace

MarginPreview::MarginPreview(const EditedStep& step, const Vec3& centre, Poll poll)
    : before_(step.before),
      parts_(step.product ? *step.product : *step.before, std::max(kLeastKnown, kKnownReach * step.values[0]), centre,
             poll) {}

bool MarginPreview::suits(const EditedStep& step) const {
  return step.before == before_ && kSuitableReach * step.values[0] <= parts_.bound();
}

EditPreview::Surfaces MarginPreview::changes(const Values& from, const Values& to) const {
  const bool isOne = from[0] == from[1] && to[0] == to[1] && std::equal(from.begin() + 2, from.end(), to.begin() + 2);
  if (!isOne || !(std::max(from[0], to[0]) <= parts_.bound())) return {};
  const Paint removed = removalStyle(FilterType::Radius)->paint;
  Surfaces surfaces;
  const auto add = [&surfaces](std::shared_ptr<const NavigationMeshGeometry> surface) {
    if (surface) surfaces.push_back(std::move(surface));
  };
  if (to[0] > from[0]) {
    add(parts_.between(from[0], to[0], removed));
    return surfaces;
  }
  add(parts_.between(to[0], from[0], walkablePaint()));
  if (!surfaces.empty()) add(parts_.below(to[0], from[0], removed));
  return surfaces;
}

}  // namespace footfall::ui
