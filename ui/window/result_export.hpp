// What the editor exports: the walkable area, pictures and reports.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "ui/base/message_bar.hpp"
#include "ui/base/message_log.hpp"
#include "ui/document/document.hpp"
#include "ui/document/export_settings.hpp"
#include "ui/level/view_modes.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/view/legend.hpp"
#include "ui/view/level_view.hpp"
#include "ui/window/file_writer.hpp"

namespace footfall {
struct ExportExtra;
}

namespace footfall::ui {

/// Exports show the last finished result. While there is none of the filters as they are, they wait for the run; what
/// still waits when the run is cancelled, or another level is opened, is not written, and that is reported.
class ResultExport : public QObject {
  Q_OBJECT

 public:
  struct Uses {
    QWidget& window;  ///< parent of the dialog
    const Document& document;
    const LevelFile& level;
    RunController& controller;
    LevelView& view;
    const ViewModes& modes;
    const Legend& legend;
    FileWriter& writer;
    MessageBar& messages;
    MessageLog& log;
  };
  explicit ResultExport(const Uses& uses);

  /// Off: choices of the dialog are not kept in the user's settings.
  void setRemembering(bool on) { remembering_ = on; }
  /// For the target of the last export, or another one.
  void showDialog();
  void showDialog(const ExportTarget& target);
  /// Replaces other files without a question, but not those that FileWriter refuses. The name's ending chooses the
  /// format; all there is, in the file's frame and units.
  void write(const QString& path);
  void write(const QString& path, const ExportSettings& settings);

  /// The last export that was asked for, to the same file; without one the dialog comes.
  void exportAgain();
  [[nodiscard]] bool hasLast() const { return last_.has_value(); }
  /// Where an export was asked for, each result from now on is written to that file, the one that is there among them,
  /// until another environment is opened.
  void setAfterRuns(bool on);
  [[nodiscard]] bool afterRuns() const { return afterRuns_; }

  /// The first file that waits for the run; empty: none.
  [[nodiscard]] QString waiting() const { return pending_.empty() ? QString() : pending_.front().first; }
  /// Gives them up; returns their names, with commas. dropped() follows where there were some.
  QString takeWaiting();

 signals:
  /// Files that waited are not written.
  void dropped();
  /// hasLast() or afterRuns() is another.
  void lastChanged();

 private:
  void writeNow(const QString& path, const ExportSettings& settings);
  void writeFiles(const QString& path, const ExportSettings& settings);
  void writePicture(const QString& path, const ExportSettings& settings);
  void writeReport(const QString& path, bool pictures);
  void writeWaiting();
  void writeAfterRun();
  void forgetLast();
  [[nodiscard]] std::vector<ExportExtra> placedExtras() const;

  Uses uses_;
  bool remembering_ = true;
  bool afterRuns_ = false;
  std::optional<std::pair<QString, ExportSettings>> last_;
  std::weak_ptr<const FinishedRun> written_;  ///< the result that was last written to it
  /// Written when the run under way is finished, and for pictures the view shows what belongs to it.
  std::vector<std::pair<QString, ExportSettings>> pending_;
};

}  // namespace footfall::ui
