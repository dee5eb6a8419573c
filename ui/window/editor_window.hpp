// The editor's window: puts document, loader, runs and view together.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <QMainWindow>
#include <QPushButton>
#include <QToolBar>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ui/base/command_bar.hpp"
#include "ui/base/commands.hpp"
#include "ui/base/message_bar.hpp"
#include "ui/base/message_log.hpp"
#include "ui/base/progress_display.hpp"
#include "ui/base/recent_files.hpp"
#include "ui/base/status_line.hpp"
#include "ui/cells/cell_watch.hpp"
#include "ui/document/document.hpp"
#include "ui/document/export_settings.hpp"
#include "ui/filters/filter_list.hpp"
#include "ui/level/environment_loader.hpp"
#include "ui/level/import_panel.hpp"
#include "ui/level/level_composer.hpp"
#include "ui/level/unit_choice.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/run/run_threads.hpp"
#include "ui/view/height_slider.hpp"
#include "ui/view/legend.hpp"
#include "ui/view/level_view.hpp"
#include "ui/view/view_layout.hpp"
#include "ui/window/session.hpp"
#include "ui/window/session_keeper.hpp"

namespace footfall::ui {

class CommandPalette;
class HelpPanel;
class LogPanel;
class WelcomePage;

/// A dock with one widget, and the command that shows and hides it (in the menu View, group "panels").
struct Panel {
  QString id;     ///< of the command; the dock's object name
  QString title;  ///< of the dock and the command
  QString help;
  QList<QKeySequence> keys = {};
  QString icon = {};
  Qt::DockWidgetArea area = Qt::RightDockWidgetArea;
  bool shown = false;  ///< at the first start
};

/// What a file that is written is for. Of the files that the window works with, only those of the same kind may be
/// replaced: a session by a session.
enum class WrittenKind { Export, Session, Pipeline };

/// What a tool keeps in sessions, as a JSON text.
struct SessionSection {
  QString name;
  std::function<std::string()> save;
  /// Gets an empty text where the session has none of it. Throws std::exception with what is wrong; the message is
  /// shown and the rest of the session counts.
  std::function<void(const std::string&)> load;
};

/// Errors appear in the message bar, in the words of the exception, and leave everything as it was. Nothing here waits
/// for a computation.
class EditorWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit EditorWindow(QWidget* parent = nullptr);
  ~EditorWindow() override;

  /// Opens an environment or a session, by its content; in the background.
  void open(const QString& path);
  /// The same, with a pipeline in place of the default one (or the session's), and with import options.
  void openWith(const QString& path, const std::optional<Pipeline>& pipeline, const ImportOptions& import);
  /// Reads the file again, which another program has saved. All else stays, and runs compute what differs. Errors are
  /// told by rereadFailed() alone.
  void reread();
  /// Reads a pipeline file into the list, one edit.
  void openPipeline(const QString& path);
  /// These, and exportResult(), refuse what refusal() tells, and replace other files without a question: see
  /// writeAsking().
  void savePipeline(const QString& path);
  void saveSession(const QString& path);
  /// Writes the last finished result, in the background; when the filters have changed since, after the next run. The
  /// name's ending chooses the format. Without settings: all there is, in the file's frame and units.
  void exportResult(const QString& path);
  void exportResult(const QString& path, const ExportSettings& settings);
  /// The same for what somebody chose: asks first what is to become of unsaved changes.
  void openAsking(const QString& path);
  /// Offers what was worked on when the program, or the machine, ended unexpectedly.
  void offerRestoring();
  /// Opens what was open when a window was closed last.
  void continueLastSession();
  /// The page with samples and recent files, over the view.
  void showWelcome(bool on);
  /// Docks, tool bars and size as they were, for the program; tests have windows as they are made.
  void restoreLayout(bool withSize);
  void resetLayout();
  /// Off: nothing of this window is remembered (for screenshots).
  void setRemembering(bool on) { remembering_ = on; }
  /// Whether what is shown was opened as a session.
  [[nodiscard]] bool openedSession() const { return !sessionPath_.isEmpty(); }

  // --- For tools (ui/window/editor_features.cpp)
  [[nodiscard]] CommandRegistry& commands() { return commands_; }
  [[nodiscard]] QToolBar* toolBar() const;
  QDockWidget* addPanel(const Panel& panel, QWidget* widget);
  void addSessionSection(SessionSection section);
  /// A command that switches the mouse to `tool`, and back, checked while it has it. The tool must outlive the view.
  /// With a panel: the command shows it; while it is hidden or behind another tab, it does nothing but that.
  QAction* addTool(Command command, ViewTool* tool, QDockWidget* panel = nullptr);
  /// In the status bar: what a tool says until it ends, notes for a while.
  void say(const QString& text, StatusSubject subject = StatusSubject::Note);
  /// Writes in the background and tells errors; written() follows. `then` gets whether it was written, before.
  void writeInBackground(std::function<void()> write, const QString& path, std::function<void(bool)> then = {});
  /// Why a file must not be written to, in one line; empty where it may be. The rule is WriteTargets'.
  [[nodiscard]] QString refusal(const QString& path, WrittenKind kind) const;
  /// Writes to a name that somebody chose: not where refusal() says so, and asks before another file is replaced. Else
  /// `keep` follows.
  void writeAsking(const QString& path, WrittenKind kind, std::function<void()> write, std::function<void()> keep = {});
  /// The level that runs compute on: with roles of parts and obstacles. Null when nothing is loaded.
  [[nodiscard]] std::shared_ptr<const Environment> level() const { return composer_.level(); }
  [[nodiscard]] LevelComposer& composer() { return composer_; }
  /// Keeps the session soon (it survives a crash).
  void keepSoon() { keepTimer_.start(); }

  [[nodiscard]] Document& document() { return document_; }
  [[nodiscard]] RunController& controller() { return controller_; }
  [[nodiscard]] const EnvironmentLoader& loader() const { return loader_; }
  [[nodiscard]] LevelView& view() { return *view_; }
  [[nodiscard]] FilterList& filterList() { return *filters_; }
  [[nodiscard]] ImportPanel& importPanel() { return *import_; }
  /// How lengths and places are shown and typed.
  [[nodiscard]] UnitChoice& units() { return units_; }
  [[nodiscard]] CellModel& cells() { return cells_; }
  [[nodiscard]] CellWatch& cellWatch() { return *cellWatch_; }
  [[nodiscard]] CellLegend& cellLegend() { return *cellLegend_; }
  [[nodiscard]] LoadPanel& loadPanel() { return *load_; }
  [[nodiscard]] RunThreads& runThreads() { return runThreads_; }
  /// Cells in the view, and the dock with the timeline.
  void setCellsShown(const CellsShown& shown);
  [[nodiscard]] CellsShown cellsShown() const;
  [[nodiscard]] MessageBar& messageBar() { return *messages_; }
  [[nodiscard]] HeightSlider& heightSlider() { return *heights_; }
  [[nodiscard]] StatusLine& statusLine() { return *summary_; }
  [[nodiscard]] MessageLog& log() { return log_; }
  [[nodiscard]] WelcomePage& welcomePage() { return *welcome_; }
  [[nodiscard]] CommandPalette& commandPalette() { return *palette_; }
  [[nodiscard]] HelpPanel& helpPanel() { return *help_; }
  [[nodiscard]] LogPanel& logPanel() { return *logPanel_; }
  [[nodiscard]] ProgressDisplay& progressDisplay() { return *progress_; }
  /// Edits that no session file has.
  [[nodiscard]] bool hasUnsavedChanges();
  [[nodiscard]] Legend& legend() { return *legend_; }
  /// What lies over the view; call placeOverlays() after something of it has changed.
  [[nodiscard]] ViewLayout& overlays() { return overlays_; }
  void placeOverlays();
  /// Somebody sits in front of it: the camera may take its time. At first nobody does.
  void setInteractive(bool on);
  [[nodiscard]] bool interactive() const { return interactive_; }
  [[nodiscard]] QPushButton* cancelButton() const { return cancel_; }
  /// As its file gave it.
  [[nodiscard]] std::shared_ptr<const Environment> environment() const { return loaded_.environment; }
  /// Neither loading, running nor exporting, nor about to.
  [[nodiscard]] bool idle() const {
    return !loader_.busy() && !controller_.busy() && !composer_.busy() && exports_ == 0 && pendingExports_.empty();
  }

 signals:
  void environmentLoaded();
  void loadFailed(const QString& message);
  void rereadDone();
  void rereadFailed(const QString& message);
  /// A file has been saved or exported.
  void written(const QString& path);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// What is to happen once the file under way is loaded.
  struct Opening {
    QString path;
    std::optional<Pipeline> pipeline;
    ImportOptions import;
    std::optional<CameraPose> camera;
    bool reload = false;   ///< the same file with other options
    bool reread = false;   ///< the same file with the same options
    bool unsaved = false;  ///< it comes with changes that its session file has not
    QString session;       ///< the file that all this comes from, when it is one
    std::optional<CellsShown> cells;
    DocumentState rest;  ///< of the session: agents, roles, obstacles
    std::optional<std::map<std::string, std::string>> sections;
    std::optional<KeptSession> kept;  ///< where it comes from, when it was kept and not saved
  };

  /// What a scale that is being typed converts from.
  struct ScaleEdit {
    QString key;  ///< of the edits that are one
    Pipeline pipeline;
    std::vector<NamedAgent> agents;
    double scale = 1;
    bool guessed = true;
  };

  void createWidgets();
  void createActions();
  void createSubmenus();
  void createFileActions();
  void createEditActions();
  void createPipelineActions();
  void createViewActions();
  void createDockActions();
  void createHelpActions();
  QAction* onBar(QAction* action, const QString& text);
  void fillToolsBar(const CommandRegistry::Entry& entry);
  void shareBarWidth();
  void placePanel(QDockWidget* dock, Qt::DockWidgetArea area);
  void createCellWidgets();
  void createCellActions();
  void createFeatures();
  void createComforts();
  void createLog();
  void createPalette();
  void createWelcome();
  void updateWelcome();
  void finishLayout();
  void giveDocksTheirWidth();
  void saveLayout();
  void logRun();
  void openFile(const QString& path, const std::optional<Pipeline>& pipeline, const ImportOptions& import,
                const std::optional<KeptSession>& kept);
  void openKept(const KeptSession& kept);
  void openSample(const QString& path, const QString& pipeline);
  void askUnsaved(std::function<void()> next);
  void loadSections(const std::map<std::string, std::string>& sections);
  void connectParts();
  void connectCells();
  void chooseLegend();
  void previewCells(int strategy);
  void openDialog();
  void openPipelineDialog();
  void savePipelineDialog();
  void saveSessionDialog();
  void exportDialog();
  void writeResult(const QString& path, const ExportSettings& settings);
  void writePicture(const QString& path, const ExportSettings& settings);
  void writeReport(const QString& path, bool pictures);
  [[nodiscard]] std::vector<ExportExtra> placedExtras() const;
  void writePendingExports();
  /// Returns the files that are not written now; empty when there were none.
  QString dropPendingExports();
  [[nodiscard]] bool closesLater();
  void closeIfWritten(bool written);
  void startLoading(Opening opening);
  void takeLoaded(const LoadedEnvironment& loaded);
  void takeReread(const LoadedEnvironment& loaded);
  void editImport(const ImportOptions& options);
  void applyImport();
  void keepFileScale(const LoadedEnvironment& loaded);
  void useDefaultFilters();
  void showResult();
  void showSummary();
  void takeUnits();
  void showProgress(const QString& text, double fraction, std::optional<double> secondsLeft = {});
  void hideProgress();
  void cancelWork();
  void updateTitle();
  [[nodiscard]] Session currentSession() const;
  void keepSession();
  [[nodiscard]] QString suggestedPath(const QString& ending) const;

  Document document_;
  LevelComposer composer_{document_};
  CommandRegistry commands_{this};
  UnitChoice units_;
  std::vector<SessionSection> sections_;
  CellModel cells_;
  RunThreads runThreads_;
  LoadedEnvironment loaded_;
  std::optional<Opening> opening_;
  bool remembering_ = true;
  int exports_ = 0;  ///< being written
  /// To be written when the run under way is finished, and for pictures what the view shows of it.
  std::vector<std::pair<QString, ExportSettings>> pendingExports_;
  bool closeWhenWritten_ = false;
  bool levelFailed_ = false;         ///< told of the level that is being composed
  std::optional<double> fileScale_;  ///< the loaded file's own, or the guess; what holds while the user gives none
  bool fileScaleGuessed_ = true;
  std::optional<ScaleEdit> scaleEdit_;
  QString sessionPath_;
  QString pipelinePath_;  ///< opened or saved last; empty: none
  RecentFiles recent_;
  MessageLog log_;
  SessionKeeper keeper_{writing_, nullptr};
  bool closing_ = false;               ///< what was not saved has been asked for
  std::function<void()> afterSaving_;  ///< once the session is written
  QByteArray defaultState_;            ///< of docks and tool bars

  LevelView* view_ = nullptr;
  ViewLayout overlays_;
  bool interactive_ = false;
  Legend* legend_ = nullptr;
  HeightSlider* heights_ = nullptr;
  CellLegend* cellLegend_ = nullptr;
  LoadPanel* load_ = nullptr;
  QDockWidget* loadDock_ = nullptr;
  QAction* cellsAction_ = nullptr;
  CellWatch* cellWatch_ = nullptr;
  FilterList* filters_ = nullptr;
  ImportPanel* import_ = nullptr;
  MessageBar* messages_ = nullptr;
  StatusLine* summary_ = nullptr;
  QString resultText_;  ///< its state, while that is the last result
  WelcomePage* welcome_ = nullptr;
  LogPanel* logPanel_ = nullptr;
  HelpPanel* help_ = nullptr;
  CommandPalette* palette_ = nullptr;
  ProgressDisplay* progress_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QAction* exportAction_ = nullptr;
  CommandBar* toolBar_ = nullptr;
  CommandBar* toolsBar_ = nullptr;  ///< of the menu Tools
  QTimer keepTimer_;

  // Last: their threads end before the rest goes.
  RunController controller_;
  EnvironmentLoader loader_;
  BackgroundQueue writing_{BackgroundQueue::AtEnd::FinishJobs};
};

}  // namespace footfall::ui
