// Saves sessions where the user chooses, and autosaves them for recovery after a crash.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <optional>

#include "ui/base/files/recent_files.hpp"
#include "ui/base/files/session_sections.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/cells/cells_feature.hpp"
#include "ui/document/document.hpp"
#include "ui/view/level_view.hpp"
#include "ui/window/file_writer.hpp"
#include "ui/window/session_keeper.hpp"

namespace footfall::ui {

class SessionFiles : public QObject {
  Q_OBJECT

 public:
  struct Uses {
    QWidget& window;  ///< parent of dialogs
    Document& document;
    const LevelFile& level;
    const LevelView& view;
    const CellsFeature& cells;
    SessionSections& sections;
    FileWriter& writer;
    RecentFiles& recent;
    MessageBar& messages;
    BackgroundQueue& writing;  ///< meets the requirements of SessionKeeper
  };
  explicit SessionFiles(const Uses& uses);

  /// Off: nothing of this window is saved in the settings (for screenshots).
  void setRemembering(bool on) { remembering_ = on; }
  [[nodiscard]] bool remembering() const { return remembering_; }

  /// The file that was opened or saved last; empty: none.
  [[nodiscard]] QString path() const { return uses_.writer.openPath(WrittenKind::Session); }
  void setPath(const QString& path);
  /// Replaces an existing file without a question, except files that FileWriter refuses.
  void save(const QString& path);
  /// Saves to the file that was opened or saved last; asks for one where there is none.
  void saveAgain();
  void askForTarget();

  /// Returns whether there are edits that no session file has.
  [[nodiscard]] bool hasUnsavedChanges() const;
  /// Asks whether to save unsaved changes, if there are some; `next` follows unless the user cancels.
  void askUnsaved(std::function<void()> next);

  /// Writes the autosave soon, or at once.
  void keepSoon() { keepTimer_.start(); }
  void keep();
  /// Called when the window closes: the autosave becomes the last session.
  void close();
  /// Offers to restore work after the program, or the machine, ended unexpectedly. `path` is the file that is being
  /// opened; its lost session comes first.
  void offerRestoring(const QString& path = {});
  [[nodiscard]] std::optional<KeptSession> lastSession() const { return keeper_.lastSession(); }
  /// Removes a kept session that is open, or not wanted.
  void forget(const KeptSession& kept) { keeper_.forget(kept); }

 signals:
  void pathChanged();
  void restoreRequested(const footfall::ui::KeptSession& kept);

 private:
  [[nodiscard]] Session current() const;
  void offerSeveral(const std::vector<KeptSession>& found);
  void chooseLost();

  Uses uses_;
  SessionKeeper keeper_;
  QTimer keepTimer_;
  bool remembering_ = true;
  std::function<void()> afterSaving_;  ///< runs after the session has been written
};

}  // namespace footfall::ui
