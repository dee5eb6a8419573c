// What one sees of an edit at once, before any filter has run again.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "core/base/poll.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/render_geometry.hpp"

namespace footfall::ui {

/// What there is to know of a finished run about one of its steps.
struct EditedStep {
  FilterType filter{};
  std::vector<double> values;
  std::shared_ptr<const NavigationMesh> before;  ///< what was walkable before it
  std::shared_ptr<const NavigationMesh> result;  ///< of the whole run
};

/// Shows edits of one filter's values; prepared after a run, so that an edit costs what it changes. Values are doubles:
/// what lies within rounding of a threshold may be shown either way, until the run decides exactly. What is shown is
/// true of the filter with the new values, before any later filter, as far as the preview says. Immutable.
class EditPreview {
 public:
  using Surfaces = std::vector<std::shared_ptr<const NavigationMeshGeometry>>;
  using Values = std::vector<double>;

  virtual ~EditPreview() = default;
  /// To be drawn over the last result (ViewContent::changes) when the values, as many as the filter has, go from those
  /// of the run to others. Empty when that changes nothing, when only the run can tell what, or when it is more than
  /// kMostPreviewed triangles.
  [[nodiscard]] virtual Surfaces changes(const Values& from, const Values& to) const = 0;
  /// Whether it serves after a later run too, of the same steps before this one.
  [[nodiscard]] virtual bool suits(const EditedStep& step) const = 0;
};

/// The window's thread makes what is drawn of an edit: a few milliseconds for so many.
inline constexpr std::size_t kMostPreviewed = 100'000;

/// Null for filters of which only a run tells anything. `poll` is called now and then and may throw.
std::shared_ptr<const EditPreview> makeEditPreview(const EditedStep& step,
                                                   const std::shared_ptr<const Environment>& environment,
                                                   const Vec3& centre, Poll poll);

}  // namespace footfall::ui
