// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/pipeline_files.hpp"

#include <QFileInfo>

#include "core/io/export.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/core_text.hpp"
#include "ui/window/file_dialogs.hpp"

namespace footfall::ui {

PipelineFiles::PipelineFiles(QWidget& window, Document& document, const LevelFile& level, FileWriter& writer,
                             MessageBar& messages)
    : QObject(&window), window_(window), document_(document), level_(level), writer_(writer), messages_(messages) {}

void PipelineFiles::open(const QString& path) {
  try {
    document_.replacePipeline(readPipelineFile(toPath(path)), tr("Open %1").arg(QFileInfo(path).fileName()));
    writer_.setOpenPath(WrittenKind::Pipeline, path);
    messages_.finish(MessageSubject::Opening);
  } catch (const std::exception& error) {
    messages_.showErrorOf(MessageSubject::Opening, coreText(error));
  }
}

void PipelineFiles::save(const QString& path) {
  if (writer_.refuses(path, WrittenKind::Pipeline)) return;
  writer_.write([text = formatPipeline(document_.pipeline()), target = toPath(path)] { writeFileSafely(target, text); },
                path,
                [this, path](bool done) {
                  if (done) writer_.setOpenPath(WrittenKind::Pipeline, path);
                });
}

void PipelineFiles::askForFile() {
  ui::askForFile(&window_, tr("Open a pipeline"), tr("Pipelines (*.pipeline *.txt);;All files (*)"),
                 suggestedPath(level_), [this](const QString& path) { open(path); });
}

void PipelineFiles::askForTarget() {
  ui::askForTarget(
      &window_, tr("Save the pipeline"), tr("Pipelines (*.pipeline)"),
      suggestedPath(level_, QStringLiteral(".pipeline")), QStringLiteral("pipeline"),
      [this](const QString& path) { writer_.writeAsking(path, WrittenKind::Pipeline, [this, path] { save(path); }); });
}

}  // namespace footfall::ui
