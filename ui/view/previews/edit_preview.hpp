// Previews of edits that are shown before any filter has run again.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "core/base/poll.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/geometry/render_geometry.hpp"

namespace footfall::ui {

/// The data of a finished run about one of its steps.
struct EditedStep {
  FilterType filter{};
  std::vector<double> values;
  std::shared_ptr<const NavigationMesh> before;  ///< walkable area before it
  std::shared_ptr<const NavigationMesh> result;  ///< result of the whole run
  /// The result of a run of the steps before it, for RadiusFilter: `before` has no links, and thin walls in it divide
  /// nothing. Null: `before` is used.
  std::shared_ptr<const NavigationMesh> product = nullptr;
};

/// Shows edits of one filter's values. It is prepared after a run, so that the cost of an edit is that of its changes.
/// Values are doubles: triangles within rounding of a threshold may be on either side, until the run decides exactly.
/// The preview shows the result of the filter with the new values, before any later filter. Immutable.
class EditPreview {
 public:
  using Surfaces = std::vector<std::shared_ptr<const NavigationMeshGeometry>>;
  using Values = std::vector<double>;

  virtual ~EditPreview() = default;
  /// Surfaces to draw over the last result (ViewContent::changes) when the values, as many as the filter has, change
  /// from those of the run to others. Empty when nothing changes, when only the run can compute the change, or when it
  /// has too many triangles: more than kMostPreviewed, for margins ten times as many.
  [[nodiscard]] virtual Surfaces changes(const Values& from, const Values& to) const = 0;
  /// Returns whether the preview also suits a later run with the same steps before this one.
  [[nodiscard]] virtual bool suits(const EditedStep& step) const = 0;
};

/// The most triangles of a preview, which the window's thread builds in a few milliseconds.
inline constexpr std::size_t kMostPreviewed = 100'000;

/// Null for filters that only a run can evaluate. `poll` is called from time to time and may throw.
std::shared_ptr<const EditPreview> makeEditPreview(const EditedStep& step,
                                                   const std::shared_ptr<const Environment>& environment,
                                                   const Vec3& centre, Poll poll);

}  // namespace footfall::ui
