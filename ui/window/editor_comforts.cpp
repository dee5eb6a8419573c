// What makes the window comfortable: log, help, command palette, welcome page, theme, and where the panels are.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>

#include "core/io/export.hpp"
#include "ui/base/command_bar.hpp"
#include "ui/base/command_palette.hpp"
#include "ui/base/filter_text.hpp"
#include "ui/base/focus_ring.hpp"
#include "ui/base/guarded_application.hpp"
#include "ui/base/hover_reset.hpp"
#include "ui/base/icon.hpp"
#include "ui/base/installed_files.hpp"
#include "ui/base/log_panel.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/number_text.hpp"
#include "ui/base/theme_commands.hpp"
#include "ui/base/translations.hpp"
#include "ui/window/editor_window.hpp"
#include "ui/window/help_panel.hpp"
#include "ui/window/welcome_page.hpp"

namespace footfall::ui {
namespace {

constexpr int kLayoutVersion = 2;  // another one forgets what was remembered of docks and tool bars
// Of docks at first, in heights of a line.
constexpr int kLeftWidth = 26;
constexpr int kRightWidth = 21;
const auto kGeometryKey = QStringLiteral("windowGeometry");
const auto kStateKey = QStringLiteral("windowState");

}  // namespace

void EditorWindow::createComforts() {
  addThemeCommands(commands_);
  addLanguageCommands(commands_);
  new FocusRing(this);
  new HoverReset(this);
  createLog();
  createPalette();
  createWelcome();
  help_ = new HelpPanel(document_, *filters_);
  addPanel({QStringLiteral("view.help"),
            tr("Help"),
            tr("Tells about the filter that has the focus"),
            {QKeySequence(Qt::SHIFT | Qt::Key_F1)},
            QStringLiteral("help")},
           help_);
  commands_.add({QStringLiteral("view.resetLayout"), CommandMenu::View, QStringLiteral("layout"),
                 tr("&Reset window layout"), tr("Put all panels and tool bars back to where they were at first")},
                [this](bool) { resetLayout(); });
}

// --- Log

void EditorWindow::createLog() {
  connect(messages_, &MessageBar::told, &log_, &MessageLog::add);
  connect(&controller_, &RunController::finished, this, &EditorWindow::logRun);
  connect(this, &EditorWindow::environmentLoaded, this, [this] {
    log_.add(MessageLevel::Note,
             tr("Opened %1: %n triangle(s)", nullptr, static_cast<int>(loaded_.environment->triangles.size()))
                 .arg(QString::fromStdString(loaded_.environment->source)));
  });
  connect(&controller_, &RunController::cancelled, this,
          [this] { log_.add(MessageLevel::Note, tr("The run was cancelled")); });
  connect(&keeper_, &SessionKeeper::failed, this,
          [this](const QString& message) { messages_->showErrorOf(MessageSubject::Keeping, message); });
  connect(&keeper_, &SessionKeeper::recovered, this, [this] { messages_->finish(MessageSubject::Keeping); });
  if (auto* application = qobject_cast<GuardedApplication*>(qApp))
    connect(application, &GuardedApplication::problemTold, messages_, &MessageBar::showError);
  logPanel_ = new LogPanel(log_);
  addPanel({QStringLiteral("view.log"),
            tr("Log"),
            tr("What was opened, run and written, and all errors"),
            {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_L)},
            QStringLiteral("log"),
            Qt::BottomDockWidgetArea},
           logPanel_);
  connect(logPanel_, &LogPanel::saveRequested, this, [this] {
    auto* dialog = new QFileDialog(this, tr("Save the log"), QFileInfo(suggestedPath({})).path(),
                                   tr("Text files (*.txt);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setOption(QFileDialog::DontConfirmOverwrite);  // writeAsking() asks
    dialog->setDefaultSuffix(QStringLiteral("txt"));
    dialog->selectFile(QStringLiteral("footfall-log.txt"));
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
      writeAsking(path, WrittenKind::Export, [this, path] {
        writeInBackground([text = logPanel_->text().toStdString(),
                           target = QFile::encodeName(path).toStdString()] { writeFileSafely(target, text); },
                          path);
      });
    });
    dialog->open();
  });
}

// One message a run: the result, and the steps that were computed with their times.
void EditorWindow::logRun() {
  QStringList lines{tr("Run finished: %1").arg(summary_->state().simplified())};
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

// --- Command palette

void EditorWindow::createPalette() {
  palette_ = new CommandPalette(this);
  palette_->addSource([this] { return commandEntries(commands_); });
  palette_->addSource([this] {
    std::vector<PaletteEntry> entries;
    for (const FilterDescriptor& filter : filterDescriptors()) {
      PaletteEntry entry;
      entry.title = tr("Add %1").arg(filterText(filter.label));
      entry.detail = tr("Filter");
      entry.icon = icon(QStringLiteral("add"));
      entry.help = filterText(filter.help);
      entry.run = [this, &filter] {
        document_.addFilter(filter, loaded_.environment ? loaded_.environment->metresPerUnit : 1);
      };
      entries.push_back(std::move(entry));
    }
    return entries;
  });
  palette_->addSource([this] {
    std::vector<PaletteEntry> entries;
    for (const QString& path : recent_.paths()) {
      const QFileInfo file(path);
      PaletteEntry entry;
      entry.title = tr("Open %1").arg(file.fileName());
      entry.detail = file.path();
      entry.icon = icon(QStringLiteral("environment"));
      entry.enabled = file.exists();
      entry.help = path;
      entry.run = [this, path] { openAsking(path); };
      entries.push_back(std::move(entry));
    }
    return entries;
  });
  palette_->addSource([this] {
    std::vector<PaletteEntry> entries;
    for (const Sample& sample : findSamples(samplesFolder())) {
      PaletteEntry entry;
      entry.title = tr("Open sample %1").arg(sample.title);
      entry.detail = sample.description;
      entry.icon = icon(QStringLiteral("environment"));
      entry.run = [this, sample] { openSample(sample.path, sample.pipeline); };
      entries.push_back(std::move(entry));
    }
    return entries;
  });
  commands_.add({QStringLiteral("help.palette"),
                 CommandMenu::Help,
                 QStringLiteral("help"),
                 tr("&Find a command..."),
                 tr("Everything that can be done, by a few letters"),
                 {QKeySequence(Qt::CTRL | Qt::Key_K)},
                 QStringLiteral("search")},
                [this](bool) { palette_->openUp(); });
}

// --- Welcome page

void EditorWindow::createWelcome() {
  commands_.add({QStringLiteral("file.welcome"),
                 CommandMenu::File,
                 QStringLiteral("open"),
                 tr("&Welcome"),
                 tr("Samples, recent files and the last session"),
                 {},
                 QStringLiteral("environment")},
                [this](bool) { showWelcome(true); });
  connect(welcome_, &WelcomePage::openRequested, this, &EditorWindow::openDialog);
  connect(welcome_, &WelcomePage::fileChosen, this, &EditorWindow::openAsking);
  connect(welcome_, &WelcomePage::sampleChosen, this, &EditorWindow::openSample);
  connect(welcome_, &WelcomePage::continueRequested, this, &EditorWindow::continueLastSession);
  connect(welcome_, &WelcomePage::removeRequested, &recent_, &RecentFiles::remove);
  connect(welcome_, &WelcomePage::closeRequested, this, [this] { showWelcome(false); });
  connect(&recent_, &RecentFiles::changed, this, [this] {
    if (!welcome_->isHidden()) updateWelcome();
  });
  showWelcome(true);
}

void EditorWindow::updateWelcome() {
  welcome_->setRecentFiles(recent_.paths());
  const std::optional<KeptSession> last = keeper_.lastSession();
  welcome_->setLastSession(
      last ? std::optional(WelcomePage::LastSession{QFileInfo(last->environment).fileName(), last->time})
           : std::nullopt);
  welcome_->setClosable(loaded_.environment != nullptr);
}

void EditorWindow::showWelcome(bool on) {
  if (!on && !loaded_.environment) return;  // there is nothing behind it
  if (on) {
    welcome_->setSamples(findSamples(samplesFolder()));
    updateWelcome();
    welcome_->setGeometry(view_->rect());
    welcome_->raise();
  }
  const bool hadFocus = welcome_->isAncestorOf(QApplication::focusWidget());
  welcome_->setVisible(on);
  if (on) {
    welcome_->openButton()->setFocus();
  } else if (hadFocus) {
    view_->setFocus();
  }
}

void EditorWindow::openSample(const QString& path, const QString& pipeline) {
  askUnsaved([this, path, pipeline] {
    try {
      std::optional<Pipeline> filters;
      if (!pipeline.isEmpty()) filters = readPipelineFile(QFile::encodeName(pipeline).toStdString());
      openWith(path, filters, {});
    } catch (const std::exception& error) {
      messages_->showErrorOf(MessageSubject::Opening, errorText(error));
    }
  });
}

// --- Where things are

void EditorWindow::placePanel(QDockWidget* dock, Qt::DockWidgetArea area) {
  // One behind the other: each has the whole height, and the tabs tell what there is.
  for (QDockWidget* other : findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
    const bool list = other->objectName() == QStringLiteral("filterDock");
    if (other == dock || list || other->isFloating() || dockWidgetArea(other) != area) continue;
    tabifyDockWidget(other, dock);
    break;
  }
}

void EditorWindow::finishLayout() {
  setDockOptions(dockOptions() | QMainWindow::AllowTabbedDocks);
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  giveDocksTheirWidth();
  defaultState_ = saveState(kLayoutVersion);
}

void EditorWindow::giveDocksTheirWidth() {
  const int line = fontMetrics().height();
  for (QDockWidget* dock : findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
    const Qt::DockWidgetArea area = dockWidgetArea(dock);
    if (area == Qt::LeftDockWidgetArea) resizeDocks({dock}, {kLeftWidth * line}, Qt::Horizontal);
    if (area == Qt::RightDockWidgetArea) resizeDocks({dock}, {kRightWidth * line}, Qt::Horizontal);
  }
}

void EditorWindow::saveLayout() {
  QSettings settings;
  settings.setValue(kGeometryKey, saveGeometry());
  settings.setValue(kStateKey, saveState(kLayoutVersion));
}

void EditorWindow::restoreLayout(bool withSize) {
  const QSettings settings;
  if (withSize) restoreGeometry(settings.value(kGeometryKey).toByteArray());
  restoreState(settings.value(kStateKey).toByteArray(), kLayoutVersion);
  shareBarWidth();
}

void EditorWindow::resetLayout() {
  restoreState(defaultState_, kLayoutVersion);
  giveDocksTheirWidth();
  shareBarWidth();
}

void EditorWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  shareBarWidth();
}

void EditorWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && view_) view_->update();  // it draws in colours of its own
}

}  // namespace footfall::ui
