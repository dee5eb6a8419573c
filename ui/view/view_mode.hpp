// The modes of the view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace footfall::ui {

enum class ViewMode : std::uint8_t {
  Result,           ///< walkable area, and the reasons why the rest is not
  Wireframe,        ///< edges of all triangles, nothing hides anything
  HiddenLine,       ///< edges of visible triangles
  WalkableOnly,     ///< without the environment
  RejectedBy,       ///< places by the filter that removed them
  Slope,            ///< floors by their angle
  Clearance,        ///< floors by the free height above them
  SourceTriangles,  ///< walkable pieces by the triangle that they come from
};

inline constexpr std::array kViewModes = {ViewMode::Result,       ViewMode::Wireframe,      ViewMode::HiddenLine,
                                          ViewMode::WalkableOnly, ViewMode::RejectedBy,     ViewMode::Slope,
                                          ViewMode::Clearance,    ViewMode::SourceTriangles};

/// The name in commands, sessions and --mode: "slope".
std::string_view nameOf(ViewMode mode);
std::optional<ViewMode> viewModeFrom(std::string_view name);
QString labelOf(ViewMode mode);
/// One sentence that explains the mode.
QString helpOf(ViewMode mode);
/// Returns whether the mode needs a finished run.
bool needsResult(ViewMode mode);
/// Returns whether floors have the colours of a scale.
inline bool isHeatMap(ViewMode mode) { return mode == ViewMode::Slope || mode == ViewMode::Clearance; }

}  // namespace footfall::ui
