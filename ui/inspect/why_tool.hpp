// The tool "Why?": a click in the view explains a place, and the triangles of the explanation are highlighted.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QPoint>
#include <array>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "footfall/inspect.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/level_units.hpp"
#include "ui/view/overlays/view_overlay.hpp"
#include "ui/view/view_tool.hpp"

namespace footfall::ui {

class WhyTool : public ViewTool {
  Q_DECLARE_TR_FUNCTIONS(WhyTool)

 public:
  /// `asked` is called for clicks, and for the key Return at the place of the mouse; `over` is called when another tool
  /// becomes active.
  WhyTool(std::function<void(const QPoint&)> asked, std::function<void()> over)
      : asked_(std::move(asked)), over_(std::move(over)) {}

  void clicked(const ViewMouse& mouse) override { asked_(mouse.place); }
  void mouseMoved(const ViewMouse& mouse) override { mouse_ = mouse.place; }
  bool keyPressed(const QKeyEvent& event) override;
  void ended() override { over_(); }
  [[nodiscard]] QCursor cursor() const override { return Qt::WhatsThisCursor; }
  [[nodiscard]] QString hint() const override;

 private:
  std::function<void(const QPoint&)> asked_;
  std::function<void()> over_;
  QPoint mouse_;
};

/// The corners of a triangle of an environment.
std::array<Vec3, 3> cornersOf(const Environment& environment, std::uint32_t triangle);

/// Triangles that block an agent at the place: the obstacle that the filter found, else the lowest one above, and
/// walls.
std::vector<std::uint32_t> obstaclesOf(const PlaceExplanation& told);

/// The place with its triangle, the blocking triangles, and the free height as a line.
ViewOverlay whyOverlay(const Inspector& inspector, const PlaceExplanation& told, const LevelUnits& units);

}  // namespace footfall::ui
