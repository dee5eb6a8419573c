// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/result_summary.hpp"

#include <algorithm>

#include "ui/base/text/localized_numbers.hpp"

namespace footfall::ui {
namespace {

QString counted(std::uint64_t count, const QString& one, const QString& many) {
  return countText(count) + QLatin1Char(' ') + (count == 1 ? one : many);
}

}  // namespace

ResultSummary::ResultSummary(RunController& controller, UnitChoice& units, StatusLine& status)
    : QObject(&status), controller_(controller), units_(units), status_(status) {
  connect(&controller_, &RunController::finished, this, &ResultSummary::show);
  connect(&units_, &UnitChoice::changed, this, [this] {
    if (controller_.finishedRun() && status_.state() == text_) show();
  });
}

void ResultSummary::show() {
  const auto run = controller_.finishedRun();
  const StateSummary& summary = run->result.summary;
  const NavigationMesh& mesh = *run->result.mesh;
  QStringList parts{counted(mesh.triangles.size(), tr("walkable triangle"), tr("walkable triangles")),
                    tr("area %1").arg(units_.units().area(summary.area))};
  if (mesh.layerCount > 0) {
    parts << counted(mesh.layerCount, tr("layer"), tr("layers"))
          << counted(mesh.connections.size(), tr("connection"), tr("connections"));
  }
  const auto gaps = static_cast<std::size_t>(std::ranges::count(mesh.links, StepKind::Gap, &StepLink::kind));
  if (gaps < mesh.links.size()) parts << counted(mesh.links.size() - gaps, tr("step"), tr("steps"));
  if (gaps > 0) parts << counted(gaps, tr("gap"), tr("gaps"));
  if (!mesh.drops.empty()) parts << counted(mesh.drops.size(), tr("drop"), tr("drops"));
  parts << counted(mesh.obstacleEdges.size(), tr("obstacle edge"), tr("obstacle edges"))
        << tr("%1 ms").arg(fixedText(run->result.totalMs, 0));
  text_ = parts.join(QStringLiteral("   ·   "));
  status_.setState(text_, parts.join(QLatin1Char('\n')));
}

}  // namespace footfall::ui
