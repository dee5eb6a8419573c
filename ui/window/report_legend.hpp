// The legend of a report's pictures.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <string>
#include <utility>
#include <vector>

#include "ui/view/geometry/render_geometry.hpp"
#include "ui/view/scene/scene_renderer.hpp"

namespace footfall::ui {

/// Captions are English, as reports are.
using CaptionedImage = std::pair<std::string, QImage>;

/// A swatch of each colour and line that the view shows of `content`; heat maps and other modes use their own names.
/// Needs the window's thread.
std::vector<CaptionedImage> reportLegend(const ViewContent& content, const SceneParts& parts);

}  // namespace footfall::ui
