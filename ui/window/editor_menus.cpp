// The window's menus, and their commands in the tool bar.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QClipboard>
#include <QDockWidget>
#include <QGuiApplication>
#include <QMenuBar>
#include <QMessageBox>
#include <QToolButton>

#include "footfall/version.hpp"
#include "ui/base/commands/shortcut_window.hpp"
#include "ui/window/editor_window.hpp"

namespace footfall::ui {
namespace {

// Divides long menus into submenus, by the groups of commands; the menu of the pipeline has its submenus after its
// first commands.
void addSubmenus(CommandRegistry& commands) {
  const auto in = [](auto... groups) { return QStringList{QString::fromLatin1(groups)...}; };
  commands.addSubmenu(CommandMenu::Tools, EditorWindow::tr("&Agents"), in("agents"));
  commands.addSubmenu(CommandMenu::View, EditorWindow::tr("C&amera"), in("camera", "camera moves", "bookmarks"));
  commands.addSubmenu(CommandMenu::View, EditorWindow::tr("Display &mode"), in("modes"));
  commands.addSubmenu(CommandMenu::View, EditorWindow::tr("&Floors and cuts"), in("floors"));
  commands.addSubmenu(CommandMenu::View, EditorWindow::tr("&Panels"), in("panels", "layout"));
}

}  // namespace

void EditorWindow::createMenus() {
  bars_ = new ToolBars(*this, commands_);
  for (const auto& [place, title] :
       {std::pair{CommandMenu::File, tr("&File")}, std::pair{CommandMenu::Edit, tr("&Edit")},
        std::pair{CommandMenu::Pipeline, tr("&Pipeline")}, std::pair{CommandMenu::Tools, tr("&Tools")},
        std::pair{CommandMenu::View, tr("&View")}, std::pair{CommandMenu::Help, tr("&Help")}})
    commands_.setMenu(place, menuBar()->addMenu(title));
  addSubmenus(commands_);
  createFileActions();
  createEditActions();
  createPipelineActions();
  createViewActions();
  createDockActions();
  createCells();
  createHelpActions();
}

void EditorWindow::createFileActions() {
  const QString open = QStringLiteral("open");
  bars_->add(commands_.add({QStringLiteral("file.open"),
                            CommandMenu::File,
                            open,
                            tr("&Open..."),
                            tr("Open an environment or a session"),
                            {QKeySequence::Open},
                            QStringLiteral("open")},
                           [this](bool) { opening_->askForFile(); }),
             tr("Open"));
  auto* recent = new QMenu(tr("Open &recent"), this);
  recent_.attachTo(recent);
  commands_.registerAction(recent->menuAction(), {QStringLiteral("file.recent"), CommandMenu::File, open, {}, {}});
  const QString save = QStringLiteral("save");
  bars_->add(commands_.add({QStringLiteral("file.save"),
                            CommandMenu::File,
                            save,
                            tr("&Save session"),
                            tr("Save environment, filters and view to the session's file"),
                            {QKeySequence::Save},
                            QStringLiteral("save")},
                           [this](bool) { sessions_->saveAgain(); }),
             tr("Save session"));
  commands_.add({QStringLiteral("file.saveAs"),
                 CommandMenu::File,
                 save,
                 tr("Save session &as..."),
                 tr("Save environment, filters and view to another file"),
                 {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S)}},
                [this](bool) { sessions_->askForTarget(); });
  commands_.add({QStringLiteral("file.screenshot"), CommandMenu::File, save, tr("Copy s&creenshot"),
                 tr("Copy what the view shows as a picture, without panels")},
                [this](bool) {
                  QGuiApplication::clipboard()->setImage(view_->grabFramebuffer());
                  status_->say(StatusSubject::Note, tr("Copied a picture of the view"));
                });
  exportAction_ = commands_.add({QStringLiteral("file.export"),
                                 CommandMenu::File,
                                 save,
                                 tr("&Export..."),
                                 tr("Write the walkable area, a picture or a report"),
                                 {QKeySequence(Qt::CTRL | Qt::Key_E)},
                                 QStringLiteral("export")},
                                [this](bool) { exports_->showDialog(); });
  exportAction_->setEnabled(false);
  bars_->add(exportAction_, tr("Export"));
  bars_->main().addSeparator();
  commands_.add(
      {QStringLiteral("file.quit"), CommandMenu::File, QStringLiteral("quit"), tr("&Quit"), {}, {QKeySequence::Quit}},
      [this](bool) { close(); });
}

void EditorWindow::createEditActions() {
  QAction* undo = document_.undoStack()->createUndoAction(this, tr("&Undo"));
  QAction* redo = document_.undoStack()->createRedoAction(this, tr("&Redo"));
  commands_.registerAction(undo, {QStringLiteral("edit.undo"),
                                  CommandMenu::Edit,
                                  QStringLiteral("undo"),
                                  {},
                                  {},
                                  {QKeySequence::Undo},
                                  QStringLiteral("undo")});
  commands_.registerAction(redo, {QStringLiteral("edit.redo"),
                                  CommandMenu::Edit,
                                  QStringLiteral("undo"),
                                  {},
                                  {},
                                  {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)},
                                  QStringLiteral("redo")});
  for (const auto& [action, text] : {std::pair{undo, tr("Undo")}, std::pair{redo, tr("Redo")}}) {
    // The actions change their texts after each edit; the tool bar's width must not change with them.
    auto* button = new QToolButton(&bars_->main());
    button->setDefaultAction(action);
    button->setFocusPolicy(Qt::TabFocus);
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    button->setAccessibleName(text);
    const auto rename = [button, name = text] { button->setText(name); };
    rename();
    connect(action, &QAction::changed, button, rename);
    bars_->main().addWidget(button);
  }
  bars_->main().addSeparator();
}

void EditorWindow::createPipelineActions() {
  const QString files = QStringLiteral("files");
  commands_.add({QStringLiteral("pipeline.open"),
                 CommandMenu::Pipeline,
                 files,
                 tr("&Open pipeline..."),
                 {},
                 {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O)}},
                [this](bool) { pipelines_->askForFile(); });
  commands_.add({QStringLiteral("pipeline.save"),
                 CommandMenu::Pipeline,
                 files,
                 tr("&Save pipeline..."),
                 {},
                 {QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_S)}},
                [this](bool) { pipelines_->askForTarget(); });
  commands_.add({QStringLiteral("pipeline.default"), CommandMenu::Pipeline, files, tr("Use &default filters"), {}},
                [this](bool) { opening_->useDefaultFilters(); });
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
  commands_.addSubmenu(CommandMenu::Pipeline, tr("Run o&n"), {QStringLiteral("run on")});
}

void EditorWindow::createViewActions() {
  const QString camera = QStringLiteral("camera");
  bars_->add(commands_.add({QStringLiteral("view.top"),
                            CommandMenu::View,
                            camera,
                            tr("From the &top"),
                            tr("Look straight down, as on a plan"),
                            {Qt::Key_T},
                            QStringLiteral("camera-top")},
                           [this](bool) { view_->cameraController().viewFromTop(); }),
             tr("Top"));
  bars_->add(commands_.add({QStringLiteral("view.oblique"),
                            CommandMenu::View,
                            camera,
                            tr("&Oblique"),
                            tr("Look from above at an angle"),
                            {Qt::Key_O},
                            QStringLiteral("camera-oblique")},
                           [this](bool) { view_->cameraController().viewOblique(); }),
             tr("Oblique"));
  bars_->add(commands_.add({QStringLiteral("view.fit"),
                            CommandMenu::View,
                            camera,
                            tr("&Fit"),
                            tr("Bring everything into sight"),
                            {Qt::Key_F},
                            QStringLiteral("fit")},
                           [this](bool) { view_->cameraController().fit(); }),
             tr("Fit"));
  commands_.add({QStringLiteral("view.zoomIn"), CommandMenu::View, camera, tr("Zoom &in"), {}, {Qt::Key_Plus}},
                [this](bool) { view_->cameraController().zoomBy(1.25); });
  commands_.add({QStringLiteral("view.zoomOut"), CommandMenu::View, camera, tr("Zoom o&ut"), {}, {Qt::Key_Minus}},
                [this](bool) { view_->cameraController().zoomBy(0.8); });
  commands_.add({QStringLiteral("view.fullScreen"),
                 CommandMenu::View,
                 QStringLiteral("window"),
                 tr("F&ull screen"),
                 tr("Show the window on the whole screen, or leave full screen"),
                 {Qt::Key_F11}},
                [this](bool) { setWindowState(windowState() ^ Qt::WindowFullScreen); });
}

void EditorWindow::createDockActions() {
  const auto add = [this](const char* dockName, const char* id, const QString& text, const QString& help) {
    auto* dock = findChild<QDockWidget*>(QLatin1String(dockName));
    host_->panels.addCommand(
        *dock, {QLatin1String(id), CommandMenu::View, QStringLiteral("panels"), text, help, {}, {}, true});
  };
  add("environmentDock", "panel.environment", tr("&Environment"), tr("What was opened: its extent, axes and scale"));
  add("filterDock", "panel.filters", tr("&Filters"), tr("The steps that make the walkable area"));
}

void EditorWindow::createCells() {
  cells_ = new CellsFeature(*host_, *view_, *overlays_, document_, file_, controller_, *filters_);
  bars_->main().addSeparator();
  for (QAction* action : cells_->actions()) bars_->main().addAction(action);
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

}  // namespace footfall::ui
