// Opening environments, sessions and samples.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "ui/base/files/recent_files.hpp"
#include "ui/base/files/session_sections.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/base/messages/status_line.hpp"
#include "ui/cells/cells_feature.hpp"
#include "ui/document/document.hpp"
#include "ui/level/level_composer.hpp"
#include "ui/level/level_file.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/view/level_view.hpp"
#include "ui/view/widgets/view_layout.hpp"
#include "ui/window/session_files.hpp"

namespace footfall::ui {

/// Reads the opened file in the background, and then sets document, level, runs and view, with the content of its
/// session.
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

  /// Opens an environment or a session, by its content, with a pipeline that replaces the default one (or the
  /// session's), and with import options.
  void open(const QString& path, const std::optional<Pipeline>& pipeline = {}, const ImportOptions& import = {});
  /// These functions first ask whether to save unsaved changes.
  void openAsking(const QString& path);
  void openKept(const KeptSession& kept);
  /// Opens the level that was open when a window was closed last.
  void continueLastSession();
  /// Opens a sample with the pipeline in a file; empty: with the default one.
  void openSample(const QString& path, const QString& pipeline);
  void askForFile();
  void useDefaultFilters();

 signals:
  /// Emitted for a session that cannot be read.
  void failed(const QString& message);

 private:
  /// The session data of the file that is being read.
  struct Opening {
    QString path;
    std::optional<Pipeline> pipeline = {};
    ImportOptions import = {};
    std::optional<CameraPose> camera = {};
    bool unsaved = false;  ///< the data has changes that its session file does not have
    QString session = {};  ///< session file that the data was read from, if any
    std::optional<CellsShown> cells = {};
    DocumentState rest = {};  ///< agents, roles and obstacles of the session
    std::optional<std::map<std::string, std::string>> sections = {};
    std::optional<KeptSession> kept = {};  ///< kept session that the data was read from, if it was not saved
  };

  void openFile(Opening opening, const std::optional<KeptSession>& kept);
  /// Returns whether there is a level to read; else the session had filters only, which the list has now.
  bool readSessionInto(Opening& opening, const std::optional<KeptSession>& kept);
  void take(Reading reading, const std::shared_ptr<const Environment>& before);
  void takeDocument(const std::shared_ptr<const Environment>& before, const Environment& level);

  Uses uses_;
  Opening opening_;
};

}  // namespace footfall::ui
