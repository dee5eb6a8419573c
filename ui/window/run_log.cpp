// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/run_log.hpp"

#include <QFileInfo>

#include "core/io/export.hpp"
#include "footfall/filter.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/filter_text.hpp"
#include "ui/base/text/localized_numbers.hpp"
#include "ui/window/file_dialogs.hpp"

namespace footfall::ui {

RunLog::RunLog(const FeatureHost& host, MessageLog& log, const Document& document, const LevelFile& file,
               RunController& controller, FileWriter& writer)
    : QObject(&host.window),
      window_(host.window),
      status_(host.status),
      log_(log),
      document_(document),
      file_(file),
      controller_(controller),
      writer_(writer),
      panel_(new LogPanel(log)) {
  connect(&host.messages, &MessageBar::told, &log_, &MessageLog::add);
  connect(&controller_, &RunController::finished, this, &RunLog::addRun);
  connect(&controller_, &RunController::cancelled, this,
          [this] { log_.add(MessageLevel::Note, tr("The run was cancelled")); });
  connect(&file_, &LevelFile::opened, this, [this] {
    log_.add(MessageLevel::Note,
             tr("Opened %1: %n triangle(s)", nullptr, static_cast<int>(file_.environment()->triangles.size()))
                 .arg(QString::fromStdString(file_.environment()->source)));
  });
  host.panels.add({QStringLiteral("view.log"),
                   tr("Log"),
                   tr("What was opened, run and written, and all errors"),
                   {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_L)},
                   QStringLiteral("log"),
                   Qt::BottomDockWidgetArea},
                  panel_);
  connect(panel_, &LogPanel::saveRequested, this, &RunLog::askForTarget);
}

void RunLog::askForTarget() {
  const QString suggested = QFileInfo(suggestedPath(file_)).path() + QStringLiteral("/footfall-log.txt");
  ui::askForTarget(
      &window_, tr("Save the log"), tr("Text files (*.txt);;All files (*)"), suggested, QStringLiteral("txt"),
      [this](const QString& path) {
        writer_.writeAsking(path, WrittenKind::Export, [this, path] {
          writer_.write([text = panel_->text().toStdString(), target = toPath(path)] { writeFileSafely(target, text); },
                        path);
        });
      });
}

// Adds one message for each run: the result, and the times of the computed steps.
void RunLog::addRun() {
  QStringList lines{tr("Run finished: %1").arg(status_.state().simplified())};
  for (const FilterEntry& entry : document_.filters()) {
    const StepStatus status = controller_.status(entry.id);
    if (status.state != StepState::Done || !status.wallMs) continue;
    QString line = tr("%1: %2 ms").arg(filterText(entry.step.filter->label)).arg(fixedText(*status.wallMs, 1));
    if (status.trianglesIn && status.trianglesOut)
      line += *status.trianglesOut == 1
                  ? tr(", %1 → 1 triangle").arg(countText(*status.trianglesIn))
                  : tr(", %1 → %2 triangles").arg(countText(*status.trianglesIn), countText(*status.trianglesOut));
    lines << line;
  }
  log_.add(MessageLevel::Note, lines.join(QLatin1Char('\n')));
}

}  // namespace footfall::ui
