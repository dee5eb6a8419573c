// Opening environments, sessions and samples.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "ui/base/message_bar.hpp"
#include "ui/base/recent_files.hpp"
#include "ui/base/session_sections.hpp"
#include "ui/base/status_line.hpp"
#include "ui/cells/cells_feature.hpp"
#include "ui/document/document.hpp"
#include "ui/level/level_composer.hpp"
#include "ui/level/level_file.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/view/level_view.hpp"
#include "ui/view/view_layout.hpp"
#include "ui/window/session_files.hpp"

namespace footfall::ui {

/// Reads what is opened in the background; when it is there, gives it to document, level, runs and view, with what its
/// session says.
class LevelOpening : public QObject {
  Q_OBJECT

 public:
  struct Uses {
    QWidget& window;  ///< parent of dialogs
    Document& document;
    LevelFile& file;
    LevelComposer& composer;
    RunController& controller;
    LevelView& view;
    ViewLayout& layout;
    CellsFeature& cells;
    SessionSections& sections;
    SessionFiles& sessions;
    RecentFiles& recent;
    MessageBar& messages;
    StatusLine& status;
  };
  explicit LevelOpening(const Uses& uses);

  /// An environment or a session, by its content, with a pipeline in place of the default one (or the session's), and
  /// with import options.
  void open(const QString& path, const std::optional<Pipeline>& pipeline = {}, const ImportOptions& import = {});
  /// These ask first what is to become of unsaved changes.
  void openAsking(const QString& path);
  void openKept(const KeptSession& kept);
  /// Opens what was open when a window was closed last.
  void continueLastSession();
  /// Opens a sample with the pipeline in a file; empty: with the default one.
  void openSample(const QString& path, const QString& pipeline);
  void askForFile();
  void useDefaultFilters();

 signals:
  /// What was to be opened is no session that can be read.
  void failed(const QString& message);

 private:
  /// What comes with the file that is being read.
  struct Opening {
    QString path;
    std::optional<Pipeline> pipeline = {};
    ImportOptions import = {};
    std::optional<CameraPose> camera = {};
    bool unsaved = false;  ///< it comes with changes that its session file has not
    QString session = {};  ///< the file that all this comes from, when it is one
    std::optional<CellsShown> cells = {};
    DocumentState rest = {};  ///< of the session: agents, roles, obstacles
    std::optional<std::map<std::string, std::string>> sections = {};
    std::optional<KeptSession> kept = {};  ///< where it comes from, when it was kept and not saved
  };

  void openFile(Opening opening, const std::optional<KeptSession>& kept);
  /// Whether there is a level to be read; else the session was no more than filters, which the list has now.
  bool readSessionInto(Opening& opening, const std::optional<KeptSession>& kept);
  void take(Reading reading, const std::shared_ptr<const Environment>& before);
  void takeDocument(const std::shared_ptr<const Environment>& before, const Environment& level);

  Uses uses_;
  Opening opening_;
};

}  // namespace footfall::ui
