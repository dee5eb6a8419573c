// Pipelines as files of their own.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

#include "ui/base/messages/message_bar.hpp"
#include "ui/document/document.hpp"
#include "ui/window/file_writer.hpp"

namespace footfall::ui {

class PipelineFiles : public QObject {
  Q_OBJECT

 public:
  PipelineFiles(QWidget& window, Document& document, const LevelFile& level, FileWriter& writer, MessageBar& messages);

  /// Reads a file into the list, as one edit.
  void open(const QString& path);
  /// Replaces an existing file without a question, except files that FileWriter refuses.
  void save(const QString& path);
  void askForFile();
  void askForTarget();

 private:
  QWidget& window_;
  Document& document_;
  const LevelFile& level_;
  FileWriter& writer_;
  MessageBar& messages_;
};

}  // namespace footfall::ui
