// The ways in which the view shows a level.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace footfall::ui {

enum class ViewMode : std::uint8_t {
  Result,           ///< what is walkable, and why the rest is not
  Wireframe,        ///< edges of all triangles, nothing hides anything
  HiddenLine,       ///< edges of what is in front
  WalkableOnly,     ///< without the environment
  RejectedBy,       ///< the filter that removed a place stands out
  Slope,            ///< floors by their angle
  Clearance,        ///< floors by the free height above them
  SourceTriangles,  ///< walkable pieces by the triangle that they come from
};

inline constexpr std::array kViewModes = {ViewMode::Result,       ViewMode::Wireframe,      ViewMode::HiddenLine,
                                          ViewMode::WalkableOnly, ViewMode::RejectedBy,     ViewMode::Slope,
                                          ViewMode::Clearance,    ViewMode::SourceTriangles};

/// "slope": in command names, sessions and --mode.
std::string_view nameOf(ViewMode mode);
std::optional<ViewMode> viewModeFrom(std::string_view name);
QString labelOf(ViewMode mode);
/// One sentence.
QString helpOf(ViewMode mode);
/// Whether there is nothing to show before a run has finished.
bool needsResult(ViewMode mode);
/// Floors have the colours of a scale.
inline bool isHeatMap(ViewMode mode) { return mode == ViewMode::Slope || mode == ViewMode::Clearance; }

}  // namespace footfall::ui
