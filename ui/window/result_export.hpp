// Exports the walkable area, pictures and reports.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "ui/base/messages/message_bar.hpp"
#include "ui/base/messages/message_log.hpp"
#include "ui/base/text/unit_choice.hpp"
#include "ui/document/document.hpp"
#include "ui/document/export_settings.hpp"
#include "ui/level/view_modes.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/view/level_view.hpp"
#include "ui/view/widgets/legend.hpp"
#include "ui/window/file_writer.hpp"

namespace footfall {
struct ExportExtra;
}

namespace footfall::ui {

/// Exports contain the last finished result. While the present filters have none, exports wait for the run. When the
/// run is cancelled, or another level is opened, waiting exports are dropped, and a message says so.
class ResultExport : public QObject {
  Q_OBJECT

 public:
  struct Uses {
    QWidget& window;  ///< parent of the dialog
    const Document& document;
    const LevelFile& level;
    const UnitChoice& units;
    RunController& controller;
    LevelView& view;
    const ViewModes& modes;
    const Legend& legend;
    FileWriter& writer;
    MessageBar& messages;
    MessageLog& log;
  };
  explicit ResultExport(const Uses& uses);

  /// Off: choices of the dialog are not saved in the user's settings.
  void setRemembering(bool on) { remembering_ = on; }
  /// Opens the dialog for the target of the last export, or another one.
  void showDialog();
  void showDialog(const ExportTarget& target);
  /// Writes everything in the file's frame and units; the name's ending chooses the format. Replaces an existing file
  /// without a question, except files that FileWriter refuses.
  void write(const QString& path);
  void write(const QString& path, const ExportSettings& settings);

  /// Repeats the last export to the same file; opens the dialog where there was none.
  void exportAgain();
  [[nodiscard]] bool hasLast() const { return last_.has_value(); }
  /// Writes each result from now on, and the present one, to the file of the last export, until another environment is
  /// opened.
  void setAfterRuns(bool on);
  [[nodiscard]] bool afterRuns() const { return afterRuns_; }

  /// The first file that waits for the run; empty: none.
  [[nodiscard]] QString waiting() const { return pending_.empty() ? QString() : pending_.front().first; }
  /// Drops the waiting exports and returns their names, separated by commas. dropped() follows where there were some.
  QString takeWaiting();

 signals:
  /// Emitted when waiting files are not written.
  void dropped();
  /// Emitted when hasLast() or afterRuns() changed.
  void lastChanged();

 private:
  void writeNow(const QString& path, const ExportSettings& settings);
  void writeFiles(const QString& path, const ExportSettings& settings);
  void writePicture(const QString& path, const ExportSettings& settings);
  void writeReport(const QString& path, const ExportSettings& settings);
  void writeWaiting();
  void writeAfterRun();
  void forgetLast();
  [[nodiscard]] std::vector<ExportExtra> placedExtras() const;

  Uses uses_;
  bool remembering_ = true;
  bool afterRuns_ = false;
  std::optional<std::pair<QString, ExportSettings>> last_;
  std::weak_ptr<const FinishedRun> written_;  ///< the result that was last written to it
  /// Exports that are written when the present run is finished; pictures also wait until the view shows the result.
  std::vector<std::pair<QString, ExportSettings>> pending_;
};

}  // namespace footfall::ui
