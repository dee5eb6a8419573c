// The editor's window.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <QPushButton>
#include <QSplitter>
#include <memory>
#include <optional>

#include "ui/base/commands/command_palette.hpp"
#include "ui/base/commands/commands.hpp"
#include "ui/base/files/recent_files.hpp"
#include "ui/base/files/session_sections.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/base/messages/message_log.hpp"
#include "ui/base/messages/progress_display.hpp"
#include "ui/base/messages/status_line.hpp"
#include "ui/base/text/unit_choice.hpp"
#include "ui/cells/cells_feature.hpp"
#include "ui/document/document.hpp"
#include "ui/filters/filter_list.hpp"
#include "ui/level/import_panel.hpp"
#include "ui/level/level_composer.hpp"
#include "ui/level/level_file.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/view/feature_host.hpp"
#include "ui/view/level_view.hpp"
#include "ui/view/widgets/view_layout.hpp"
#include "ui/window/drawing_note.hpp"
#include "ui/window/file_writer.hpp"
#include "ui/window/help_panel.hpp"
#include "ui/window/level_opening.hpp"
#include "ui/window/pipeline_files.hpp"
#include "ui/window/recent/recent_photographer.hpp"
#include "ui/window/result_export.hpp"
#include "ui/window/run_log.hpp"
#include "ui/window/session_files.hpp"
#include "ui/window/tool_bars.hpp"
#include "ui/window/welcome.hpp"
#include "ui/window/window_closing.hpp"
#include "ui/window/window_layout.hpp"

namespace footfall::ui {

class CameraTools;
class EnvironmentTools;
class LevelLook;
class PackedFeature;
class TurntableFeature;

/// Makes the parts of the editor, connects them, and arranges them in menus, bars and docks. Errors appear in the
/// message bar with the message of the exception, and change nothing. Nothing here waits for a computation.
class EditorWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit EditorWindow(QWidget* parent = nullptr);
  ~EditorWindow() override;

  /// Opens an environment or a session, by its content, in the background.
  void open(const QString& path) { opening_->open(path); }
  /// Opens a file with a pipeline that replaces the default one (or the session's), and with import options.
  void openWith(const QString& path, const std::optional<Pipeline>& pipeline, const ImportOptions& import) {
    opening_->open(path, pipeline, import);
  }
  void openAsking(const QString& path) { opening_->openAsking(path); }
  void openPipeline(const QString& path) { pipelines_->open(path); }
  void savePipeline(const QString& path) { pipelines_->save(path); }
  void saveSession(const QString& path) { sessions_->save(path); }
  void exportResult(const QString& path) { exports_->write(path); }
  void exportResult(const QString& path, const ExportSettings& settings) { exports_->write(path, settings); }
  /// Offers to restore work after the program, or the machine, ended unexpectedly. `path` is the file that was opened;
  /// its lost session comes first.
  void offerRestoring(const QString& path = {}) { sessions_->offerRestoring(path); }
  void continueLastSession() { opening_->continueLastSession(); }
  /// Shows the page with samples and recent files over the view.
  void showWelcome(bool on) { welcome_->show(on); }
  /// Restores docks, tool bars and size, for the program; windows of tests keep their defaults.
  void restoreLayout(bool withSize) { layout_->restore(withSize); }
  /// Off: nothing of this window is saved in the settings (for screenshots).
  void setRemembering(bool on);
  /// Returns whether the view does not show all of the last result yet.
  [[nodiscard]] bool drawing() const { return drawingNote_->pending(); }
  /// Sets whether a person uses the window, so that the camera may glide; off at first.
  void setInteractive(bool on);
  /// Sets whether cells are shown in the view, and the dock with the timeline.
  void setCellsShown(const CellsShown& shown) { cells_->setShown(shown); }
  /// Returns whether no load, run or export is under way or about to begin, and an opened level has its final camera.
  [[nodiscard]] bool idle() const;

  // The parts that the program uses without a user (ui/window/unattended.hpp). All parts are the window's children.
  [[nodiscard]] LevelFile& file() { return file_; }
  [[nodiscard]] RunController& controller() { return controller_; }
  [[nodiscard]] LevelView& view() { return *view_; }
  [[nodiscard]] CellWatch& cellWatch() { return cells_->watch(); }
  [[nodiscard]] PackedFeature& packed() { return *packed_; }
  [[nodiscard]] FileWriter& writer() { return *writer_; }
  /// Returns whether the level was opened as a session.
  [[nodiscard]] bool openedSession() const { return !sessions_->path().isEmpty(); }

 signals:
  void loadFailed(const QString& message);
  /// Emitted when a file has been saved or exported.
  void written(const QString& path);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void createWidgets();
  void createStatusBar();
  void createMenus();
  void createFileActions();
  void createEditActions();
  void createPipelineActions();
  void createViewActions();
  void createDockActions();
  void createCells();
  void createHelpActions();
  void createFiles();
  void createComforts();
  void createFeatures();
  void connectLevel();
  void connectRuns();
  void connectProgress();
  void takeUnits();
  void showProgress(const QString& text, double fraction, std::optional<double> secondsLeft = {});
  void hideProgress();
  void showWriting();
  void cancelWork();
  void updateTitle();

  Document document_{this};
  LevelComposer composer_{document_, this};
  CommandRegistry commands_{this};
  UnitChoice units_{this};
  SessionSections sections_;
  RecentFiles recent_;
  MessageLog log_{this};
  bool levelFailed_ = false;  ///< the error of a level that cannot be composed is shown

  LevelView* view_ = nullptr;
  QSplitter* views_ = nullptr;  ///< the view, and another one beside it
  ViewLayout* overlays_ = nullptr;
  WelcomePage* welcomePage_ = nullptr;
  MessageBar* messages_ = nullptr;
  FilterList* filters_ = nullptr;
  ImportPanel* import_ = nullptr;
  StatusLine* status_ = nullptr;
  ProgressDisplay* progress_ = nullptr;
  QPushButton* cancel_ = nullptr;
  HelpPanel* help_ = nullptr;
  CommandPalette* palette_ = nullptr;
  QAction* exportAction_ = nullptr;

  std::unique_ptr<const FeatureHost> host_;
  ToolBars* bars_ = nullptr;
  std::unique_ptr<WindowLayout> layout_;
  CellsFeature* cells_ = nullptr;
  LevelLook* look_ = nullptr;
  CameraTools* camera_ = nullptr;
  DrawingNote* drawingNote_ = nullptr;
  FileWriter* writer_ = nullptr;
  QString writtenName_;  ///< name of the file whose writing began last
  SessionFiles* sessions_ = nullptr;
  PipelineFiles* pipelines_ = nullptr;
  LevelOpening* opening_ = nullptr;
  PackedFeature* packed_ = nullptr;
  ResultExport* exports_ = nullptr;
  TurntableFeature* turntable_ = nullptr;
  WindowClosing* closing_ = nullptr;
  Welcome* welcome_ = nullptr;
  RecentPhotographer* pictures_ = nullptr;
  RunLog* runLog_ = nullptr;

  // Declared last: their threads end before the other members are destroyed.
  RunController controller_;
  LevelFile file_;
  BackgroundQueue writing_{BackgroundQueue::AtEnd::FinishJobs};
};

}  // namespace footfall::ui
