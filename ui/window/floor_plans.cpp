// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/floor_plans.hpp"

#include "core/io/export.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/window/file_dialogs.hpp"
#include "ui/window/floor_plan_dialog.hpp"

namespace footfall::ui {

FloorPlans::FloorPlans(const FeatureHost& host, const LevelFile& level, const RunController& controller,
                       FileWriter& writer)
    : QObject(&host.window),
      window_(host.window),
      messages_(host.messages),
      level_(level),
      controller_(controller),
      writer_(writer) {
  QAction* action =
      host.commands.add({QStringLiteral("file.plan"), CommandMenu::File, QStringLiteral("save"), tr("&Floor plan..."),
                         tr("Draw plans of the storeys or layers to scale, as PDF or SVG")},
                        [this](bool) { showDialog(); });
  action->setEnabled(false);
  connect(&controller_, &RunController::finished, action, [action] { action->setEnabled(true); });
}

void FloorPlans::showDialog() {
  auto* dialog = new FloorPlanDialog(&window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] { askForTarget(dialog->options()); });
  dialog->open();
}

void FloorPlans::askForTarget(const PlanOptions& options) {
  ui::askForTarget(&window_, tr("Save the floor plan"), tr("PDF (*.pdf);;SVG, a file for each page (*.svg)"),
                   suggestedPath(level_, QStringLiteral("-plan.pdf")), QStringLiteral("pdf"),
                   [this, options](const QString& path) {
                     writer_.writeAsking(path, WrittenKind::Export, [this, path, options] { write(path, options); });
                   });
}

void FloorPlans::write(const QString& path, const PlanOptions& options) {
  if (!controller_.upToDate()) {
    messages_.showErrorOf(
        MessageSubject::Writing,
        tr("%1: not drawn, as the filters have changed since the last run; run them first").arg(path));
    return;
  }
  if (writer_.refuses(path, WrittenKind::Export)) return;
  writer_.write(
      [run = controller_.finishedRun(), target = toPath(path), options] {
        const std::vector<PlanFile> files =
            makePlanFiles(*run->environment, run->pipeline, *run->result.mesh, target, options);
        for (const PlanFile& file : files) checkWritable(file.path);
        for (const PlanFile& file : files) writeFileSafely(file.path, file.bytes);
      },
      path);
}

}  // namespace footfall::ui
