// The window's widgets, menus, tool bar and dialogs.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>

#include "core/io/import.hpp"
#include "footfall/version.hpp"
#include "ui/base/command_bar.hpp"
#include "ui/base/fitted_labels.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/panel_dock.hpp"
#include "ui/base/shortcut_window.hpp"
#include "ui/window/editor_window.hpp"
#include "ui/window/welcome_page.hpp"

namespace footfall::ui {
namespace {

/// Shows a file dialog without waiting for it; `use` gets the chosen path.
template <typename Use>
QFileDialog* showDialog(QWidget* parent, const QString& title, const QString& nameFilter, const QString& suggested,
                        const QString& suffix, Use use) {
  auto* dialog = new QFileDialog(parent, title, QFileInfo(suggested).path(), nameFilter);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  if (suffix.isEmpty()) {
    dialog->setFileMode(QFileDialog::ExistingFile);
  } else {
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setOption(QFileDialog::DontConfirmOverwrite);  // EditorWindow::writeAsking() asks
    dialog->setDefaultSuffix(suffix);
    dialog->selectFile(QFileInfo(suggested).fileName());
  }
  QObject::connect(dialog, &QFileDialog::fileSelected, parent, use);
  dialog->open();
  return dialog;
}

QDockWidget* addDock(QMainWindow* window, const QString& title, const QString& name, QWidget* widget,
                     Qt::DockWidgetArea area = Qt::LeftDockWidgetArea) {
  auto* dock = new QDockWidget(title, window);
  dock->setObjectName(name);
  dock->setWidget(new PanelArea(widget, dock));
  dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable);
  window->addDockWidget(area, dock);
  return dock;
}

}  // namespace

void EditorWindow::createWidgets() {
  messages_ = new MessageBar(this);
  view_ = new LevelView(this);
  view_->installEventFilter(this);
  legend_ = new Legend(view_);
  legend_->hide();
  heights_ = new HeightSlider(view_);
  connect(heights_, &HeightSlider::rangeChanged, view_, &LevelView::setHeights);
  heights_->hide();
  welcome_ = new WelcomePage(view_);
  auto* central = new QWidget(this);
  auto* layout = new QVBoxLayout(central);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(messages_);
  layout->addWidget(view_, 1);
  setCentralWidget(central);
  central->setFocusProxy(view_);  // who gives the keys back gives them to the view

  import_ = new ImportPanel(this);
  filters_ = new FilterList(document_, controller_, this);
  QDockWidget* environment = addDock(this, tr("Environment"), QStringLiteral("environmentDock"), import_);
  static_cast<PanelArea*>(environment->widget())->setFitsContent();
  addDock(this, tr("Filters"), QStringLiteral("filterDock"), filters_);

  summary_ = new StatusLine(this);
  summary_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  progress_ = new ProgressDisplay(this);
  cancel_ = new QPushButton(tr("Cancel"), this);
  cancel_->setObjectName(QStringLiteral("cancel"));
  cancel_->setShortcut(Qt::Key_Escape);
  cancel_->setToolTip(tr("Stop loading or running; the last result stays (Esc)"));
  statusBar()->addWidget(summary_, 1);
  statusBar()->addPermanentWidget(progress_);
  statusBar()->addPermanentWidget(cancel_);
}

void EditorWindow::createActions() {
  toolBar_ = new CommandBar(tr("Files and view"), QStringLiteral("toolBar"), this);
  toolsBar_ = new CommandBar(tr("Tools"), QStringLiteral("toolsBar"), this);
  toolsBar_->hide();
  for (CommandBar* bar : {toolBar_, toolsBar_}) {
    addToolBar(bar);
    connect(bar->toggleViewAction(), &QAction::toggled, this, [this] { shareBarWidth(); });
  }
  connect(&commands_, &CommandRegistry::added, this, &EditorWindow::fillToolsBar);
  for (const auto& [place, title] :
       {std::pair{CommandMenu::File, tr("&File")}, std::pair{CommandMenu::Edit, tr("&Edit")},
        std::pair{CommandMenu::Pipeline, tr("&Pipeline")}, std::pair{CommandMenu::Tools, tr("&Tools")},
        std::pair{CommandMenu::View, tr("&View")}, std::pair{CommandMenu::Help, tr("&Help")}})
    commands_.setMenu(place, menuBar()->addMenu(title));
  createSubmenus();
  createFileActions();
  createEditActions();
  createPipelineActions();
  createViewActions();
  createDockActions();
  createCellActions();
  createHelpActions();
}

// Long menus in parts, by the groups of commands; that of the pipeline has its parts behind its first commands.
void EditorWindow::createSubmenus() {
  const auto in = [](auto... groups) { return QStringList{QString::fromLatin1(groups)...}; };
  commands_.addSubmenu(CommandMenu::Tools, tr("&Agents"), in("agents"));
  commands_.addSubmenu(CommandMenu::View, tr("C&amera"), in("camera", "camera moves", "bookmarks"));
  commands_.addSubmenu(CommandMenu::View, tr("Display &mode"), in("modes"));
  commands_.addSubmenu(CommandMenu::View, tr("&Floors and cuts"), in("floors"));
  commands_.addSubmenu(CommandMenu::View, tr("&Panels"), in("panels", "layout"));
}

QAction* EditorWindow::onBar(QAction* action, const QString& text) {
  action->setIconText(text);
  toolBar_->addAction(action);
  return action;
}

QToolBar* EditorWindow::toolBar() const { return toolBar_; }

// The tools with icons, group by group, in the order in which they come.
void EditorWindow::fillToolsBar(const CommandRegistry::Entry& entry) {
  if (entry.command.menu != CommandMenu::Tools || entry.command.icon.isEmpty()) return;
  QAction* before = nullptr;
  bool grouped = false;
  const QList<QAction*> there = toolsBar_->actions();
  for (const CommandRegistry::Entry& other : commands_.entries()) {
    if (other.command.menu != entry.command.menu || other.command.group != entry.command.group) continue;
    const qsizetype at = there.indexOf(other.action);
    if (at < 0) continue;
    grouped = true;
    before = at + 1 < there.size() ? there[at + 1] : nullptr;
  }
  if (!grouped && !there.isEmpty()) toolsBar_->addSeparator();
  toolsBar_->insertAction(before, entry.action);
  toolsBar_->show();
  shareBarWidth();
}

void EditorWindow::shareBarWidth() { CommandBar::shareWidth({toolBar_, toolsBar_}, width()); }

void EditorWindow::createFileActions() {
  const QString open = QStringLiteral("open");
  onBar(commands_.add({QStringLiteral("file.open"),
                       CommandMenu::File,
                       open,
                       tr("&Open..."),
                       tr("Open an environment or a session"),
                       {QKeySequence::Open},
                       QStringLiteral("open")},
                      [this](bool) { openDialog(); }),
        tr("Open"));
  auto* recent = new QMenu(tr("Open &recent"), this);
  recent_.attachTo(recent);
  commands_.adopt(recent->menuAction(), {QStringLiteral("file.recent"), CommandMenu::File, open, {}, {}});
  const QString save = QStringLiteral("save");
  onBar(commands_.add({QStringLiteral("file.save"),
                       CommandMenu::File,
                       save,
                       tr("&Save session..."),
                       tr("Save environment, filters and view"),
                       {QKeySequence::Save},
                       QStringLiteral("save")},
                      [this](bool) { saveSessionDialog(); }),
        tr("Save session"));
  exportAction_ = commands_.add({QStringLiteral("file.export"),
                                 CommandMenu::File,
                                 save,
                                 tr("&Export..."),
                                 tr("Write the walkable area, a picture or a report"),
                                 {QKeySequence(Qt::CTRL | Qt::Key_E)},
                                 QStringLiteral("export")},
                                [this](bool) { exportDialog(); });
  exportAction_->setEnabled(false);
  onBar(exportAction_, tr("Export"));
  toolBar_->addSeparator();
  commands_.add(
      {QStringLiteral("file.quit"), CommandMenu::File, QStringLiteral("quit"), tr("&Quit"), {}, {QKeySequence::Quit}},
      [this](bool) { close(); });
}

void EditorWindow::createEditActions() {
  QAction* undo = document_.undoStack()->createUndoAction(this, tr("&Undo"));
  QAction* redo = document_.undoStack()->createRedoAction(this, tr("&Redo"));
  commands_.adopt(undo, {QStringLiteral("edit.undo"),
                         CommandMenu::Edit,
                         QStringLiteral("undo"),
                         {},
                         {},
                         {QKeySequence::Undo},
                         QStringLiteral("undo")});
  commands_.adopt(redo, {QStringLiteral("edit.redo"),
                         CommandMenu::Edit,
                         QStringLiteral("undo"),
                         {},
                         {},
                         {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)},
                         QStringLiteral("redo")});
  for (const auto& [action, text] : {std::pair{undo, tr("Undo")}, std::pair{redo, tr("Redo")}}) {
    // The actions rename themselves after the edit; the tool bar's width must not change with them.
    auto* button = new QToolButton(toolBar_);
    button->setDefaultAction(action);
    button->setFocusPolicy(Qt::TabFocus);
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    button->setAccessibleName(text);
    const auto rename = [button, name = text] { button->setText(name); };
    rename();
    connect(action, &QAction::changed, button, rename);
    toolBar_->addWidget(button);
  }
  toolBar_->addSeparator();
}

void EditorWindow::createPipelineActions() {
  const QString files = QStringLiteral("files");
  commands_.add({QStringLiteral("pipeline.open"),
                 CommandMenu::Pipeline,
                 files,
                 tr("&Open pipeline..."),
                 {},
                 {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O)}},
                [this](bool) { openPipelineDialog(); });
  commands_.add({QStringLiteral("pipeline.save"),
                 CommandMenu::Pipeline,
                 files,
                 tr("&Save pipeline..."),
                 {},
                 {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S)}},
                [this](bool) { savePipelineDialog(); });
  commands_.add({QStringLiteral("pipeline.default"), CommandMenu::Pipeline, files, tr("Use &default filters"), {}},
                [this](bool) { useDefaultFilters(); });
  const QString runs = QStringLiteral("runs");
  commands_.add({QStringLiteral("pipeline.run"),
                 CommandMenu::Pipeline,
                 runs,
                 tr("&Run again"),
                 {},
                 {Qt::Key_F5},
                 QStringLiteral("run")},
                [this](bool) { controller_.runNow(); });
  commands_.add(
      {QStringLiteral("pipeline.cancel"), CommandMenu::Pipeline, runs, tr("&Cancel"), {}, {}, QStringLiteral("cancel")},
      [this](bool) { cancelWork(); });
  commands_.addSubmenu(CommandMenu::Pipeline, tr("Selected &filters"), {QStringLiteral("steps")});
  commands_.addSubmenu(CommandMenu::Pipeline, tr("T&hreads"), {QStringLiteral("threads")});
}

void EditorWindow::createViewActions() {
  const QString camera = QStringLiteral("camera");
  onBar(commands_.add({QStringLiteral("view.top"),
                       CommandMenu::View,
                       camera,
                       tr("From the &top"),
                       tr("Look straight down, as on a plan"),
                       {Qt::Key_T},
                       QStringLiteral("camera-top")},
                      [this](bool) { view_->viewFromTop(); }),
        tr("Top"));
  onBar(commands_.add({QStringLiteral("view.oblique"),
                       CommandMenu::View,
                       camera,
                       tr("&Oblique"),
                       tr("Look from above at an angle"),
                       {Qt::Key_O},
                       QStringLiteral("camera-oblique")},
                      [this](bool) { view_->viewOblique(); }),
        tr("Oblique"));
  onBar(commands_.add({QStringLiteral("view.fit"),
                       CommandMenu::View,
                       camera,
                       tr("&Fit"),
                       tr("Bring everything into sight"),
                       {Qt::Key_F},
                       QStringLiteral("fit")},
                      [this](bool) { view_->fit(); }),
        tr("Fit"));
  commands_.add({QStringLiteral("view.zoomIn"), CommandMenu::View, camera, tr("Zoom &in"), {}, {Qt::Key_Plus}},
                [this](bool) { view_->zoomBy(1.25); });
  commands_.add({QStringLiteral("view.zoomOut"), CommandMenu::View, camera, tr("Zoom o&ut"), {}, {Qt::Key_Minus}},
                [this](bool) { view_->zoomBy(0.8); });
}

void EditorWindow::createDockActions() {
  const auto add = [this](const char* dockName, const char* id, const QString& text, const QString& help) {
    auto* dock = findChild<QDockWidget*>(QLatin1String(dockName));
    dock->setFeatures(dock->features() | QDockWidget::DockWidgetClosable);
    commands_.adopt(makePanelAction(*dock, *view_, this),
                    {QLatin1String(id), CommandMenu::View, QStringLiteral("panels"), text, help, {}, {}, true});
  };
  add("environmentDock", "panel.environment", tr("&Environment"), tr("What was opened: its extent, axes and scale"));
  add("filterDock", "panel.filters", tr("&Filters"), tr("The steps that make the walkable area"));
}

void EditorWindow::createHelpActions() {
  const QString help = QStringLiteral("help");
  commands_.add({QStringLiteral("help.keys"),
                 CommandMenu::Help,
                 help,
                 tr("&Keys and mouse"),
                 tr("All keys, and what the mouse does in the view"),
                 {Qt::Key_F1},
                 QStringLiteral("help")},
                [this](bool) {
                  auto* window = new ShortcutWindow(commands_, this);
                  window->setAttribute(Qt::WA_DeleteOnClose);
                  window->open();
                });
  commands_.add({QStringLiteral("help.about"), CommandMenu::Help, help, tr("&About Footfall"), {}}, [this](bool) {
    auto* box = new QMessageBox(QMessageBox::NoIcon, tr("About Footfall"),
                                tr("<b>Footfall %1</b><p>The exact walkable area of 3D environments.</p>"
                                   "<p>Free software under the GNU GPL, version 3 or later.</p>")
                                    .arg(QStringLiteral(FOOTFALL_VERSION)),
                                QMessageBox::Ok, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
  });
}

QDockWidget* EditorWindow::addPanel(const Panel& panel, QWidget* widget) {
  QDockWidget* dock = addDock(this, panel.title, panel.id, widget, panel.area);
  dock->setFeatures(dock->features() | QDockWidget::DockWidgetClosable);
  dock->setVisible(panel.shown);
  placePanel(dock, panel.area);
  commands_.adopt(makePanelAction(*dock, *view_, this), {panel.id, CommandMenu::View, QStringLiteral("panels"),
                                                         panel.title, panel.help, panel.keys, panel.icon, true});
  return dock;
}

QAction* EditorWindow::addTool(Command command, ViewTool* tool, QDockWidget* panel) {
  command.menu = CommandMenu::Tools;
  command.checkable = true;
  auto* action = new QAction(command.text, this);
  action->setCheckable(true);
  connect(action, &QAction::triggered, this, [this, action, tool, panel](bool on) {
    // What cannot be seen is asked for, not sent away.
    const bool raises = !on && panel && !isInFront(*panel);
    if (on || raises) {
      view_->setTool(tool);
      if (panel) bringToFront(*panel);
      view_->setFocus();
      action->setChecked(true);
    } else {
      view_->setTool(nullptr);
    }
  });
  commands_.adopt(action, command);
  connect(view_, &LevelView::toolChanged, action, [this, action, tool] { action->setChecked(view_->tool() == tool); });
  return action;
}

QString EditorWindow::suggestedPath(const QString& ending) const {
  if (!loaded_.environment) return QStringLiteral("./footfall") + ending;
  const QFileInfo file(QString::fromStdString(loaded_.environment->source));
  return file.path() + QLatin1Char('/') + file.completeBaseName() + ending;
}

void EditorWindow::openDialog() {
  QStringList patterns;
  for (const std::string& extension : importableExtensions())
    patterns << QStringLiteral("*.") + QString::fromStdString(extension);
  patterns << QStringLiteral("*.") + QLatin1String(kSessionExtension);
  const QString filter = tr("Environments and sessions (%1)").arg(patterns.join(QLatin1Char(' '))) +
                         QStringLiteral(";;") + tr("All files (*)");
  showDialog(this, tr("Open an environment or a session"), filter, suggestedPath({}), {},
             [this](const QString& path) { openAsking(path); });
}

void EditorWindow::openPipelineDialog() {
  showDialog(this, tr("Open a pipeline"), tr("Pipelines (*.pipeline *.txt);;All files (*)"), suggestedPath({}), {},
             [this](const QString& path) { openPipeline(path); });
}

void EditorWindow::savePipelineDialog() {
  showDialog(this, tr("Save the pipeline"), tr("Pipelines (*.pipeline)"), suggestedPath(QStringLiteral(".pipeline")),
             QStringLiteral("pipeline"), [this](const QString& path) {
               writeAsking(path, WrittenKind::Pipeline, [this, path] { savePipeline(path); });
             });
}

void EditorWindow::saveSessionDialog() {
  const QString extension = QLatin1String(kSessionExtension);
  const QString suggested = sessionPath_.isEmpty() ? suggestedPath(QLatin1Char('.') + extension) : sessionPath_;
  QFileDialog* dialog = showDialog(this, tr("Save the session"), tr("Sessions (*.%1)").arg(extension), suggested,
                                   extension, [this](const QString& path) {
                                     writeAsking(
                                         path, WrittenKind::Session, [this, path] { saveSession(path); },
                                         [this] { afterSaving_ = nullptr; });
                                   });
  connect(dialog, &QFileDialog::rejected, this, [this] { afterSaving_ = nullptr; });
}

}  // namespace footfall::ui
