// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/skipped_feature.hpp"

#include <algorithm>

#include "core/environment/skipped_polygons.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/core_text.hpp"
#include "ui/base/widgets/panel_dock.hpp"
#include "ui/view/scene/appearance.hpp"

namespace footfall::ui {
namespace {

const QString kSkippedOverlay = QStringLiteral("skipped");
constexpr double kShownAround = 1;  // metres around the corners

}  // namespace

SkippedFeature::SkippedFeature(const FeatureHost& host, LevelView& view, LevelFile& file, ImportPanel& import)
    : QObject(&host.window),
      view_(view),
      file_(file),
      units_(host.units),
      status_(host.status),
      panel_(new SkippedPanel),
      show_(new QPushButton(&import)) {
  setObjectName(QStringLiteral("skipped"));
  dock_ = host.panels.add({QStringLiteral("panel.skipped"),
                           tr("Left Out"),
                           tr("List the polygons of the file that could not be read as floors or walls, and why"),
                           {},
                           {},
                           Qt::RightDockWidgetArea,
                           false},
                          panel_);
  show_->setObjectName(QStringLiteral("showSkipped"));
  show_->setToolTip(tr("List the polygons of the file that were left out, and why"));
  show_->hide();
  import.addBelowFigures(show_);
  connect(show_, &QPushButton::clicked, this, [this] {
    bringToFront(*dock_);
    dock_->raise();
  });
  connect(dock_->toggleViewAction(), &QAction::toggled, this, [this](bool on) {
    if (!on) view_.removeOverlay(kSkippedOverlay);
  });
  // While the window is destroyed, its docks are hidden when the view no longer exists.
  connect(&host.commands, &QObject::destroyed, this, [this] { dock_->toggleViewAction()->disconnect(this); });
  connect(panel_, &SkippedPanel::frameRequested, this, &SkippedFeature::frame);
  connect(&file_, &LevelFile::opened, this, &SkippedFeature::follow);
  connect(&file_, &LevelFile::rereadDone, this, &SkippedFeature::follow);
  connect(&units_, &UnitChoice::changed, this, &SkippedFeature::follow);
}

void SkippedFeature::follow() {
  view_.removeOverlay(kSkippedOverlay);
  const auto environment = file_.environment();
  const SkippedElements& skipped = environment ? environment->skipped : SkippedElements{};
  panel_->show(skipped, [units = units_.units()](const Vec3& place) { return units.place(place); });
  show_->setVisible(skipped.polygons > 0);
  show_->setText(tr("%n polygons left out: show them", "", static_cast<int>(skipped.polygons)));
}

void SkippedFeature::frame(int row) {
  const auto environment = file_.environment();
  if (!environment || row < 0 || static_cast<std::size_t>(row) >= environment->skipped.listed.size()) return;
  const SkippedPolygon& polygon = environment->skipped.listed[static_cast<std::size_t>(row)];
  if (polygon.corners.empty()) {
    view_.removeOverlay(kSkippedOverlay);
    status_.say(StatusSubject::Note, tr("This polygon has no corners: it is nowhere in the level."));
    return;
  }
  ViewOverlay overlay;
  overlay.throughWalls = true;
  const Vec3 &a = polygon.corners.front(), &b = polygon.corners.back();
  overlay.lines.push_back({{{a, b}}, selectedCellColour(), 3, outlineColour()});
  for (const Vec3& corner : polygon.corners) overlay.marks.push_back({corner, selectedCellColour(), 11});
  overlay.labels.push_back({a, coreText(skippedSource(polygon))});
  view_.setOverlay(kSkippedOverlay, std::move(overlay));
  const double around = kShownAround / environment->metresPerUnit;
  view_.cameraController().frame(
      {std::min(a.x, b.x) - around, std::min(a.y, b.y) - around, std::min(a.z, b.z) - around},
      {std::max(a.x, b.x) + around, std::max(a.y, b.y) + around, std::max(a.z, b.z) + around});
}

}  // namespace footfall::ui
