// The window's widgets, menus, tool bar and dialogs.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QSlider>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>

#include "core/environment/import.hpp"
#include "ui/editor_window.hpp"

namespace footfall {
namespace {

constexpr int kCutSteps = 500;

/// Shows a file dialog without waiting for it; `use` gets the chosen path.
template <typename Use>
void showDialog(QWidget* parent, const QString& title, const QString& nameFilter, const QString& suggested,
                const QString& suffix, Use use) {
  auto* dialog = new QFileDialog(parent, title, QFileInfo(suggested).path(), nameFilter);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  if (suffix.isEmpty()) {
    dialog->setFileMode(QFileDialog::ExistingFile);
  } else {
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(suffix);
    dialog->selectFile(QFileInfo(suggested).fileName());
  }
  QObject::connect(dialog, &QFileDialog::fileSelected, parent, use);
  dialog->open();
}

QDockWidget* addDock(QMainWindow* window, const QString& title, const QString& name, QWidget* widget) {
  auto* dock = new QDockWidget(title, window);
  dock->setObjectName(name);
  dock->setWidget(widget);
  dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable);
  window->addDockWidget(Qt::LeftDockWidgetArea, dock);
  return dock;
}

QString mouseHelp() {
  return EditorWindow::tr(
      "<table cellpadding=3>"
      "<tr><td><b>Left drag</b></td><td>turn about the pivot</td></tr>"
      "<tr><td><b>Right or middle drag, Shift+left drag</b></td><td>move sideways</td></tr>"
      "<tr><td><b>Wheel, Ctrl+left drag, + and -</b></td><td>zoom</td></tr>"
      "<tr><td><b>Double click</b></td><td>turn about this place from now on</td></tr>"
      "<tr><td><b>Arrow keys</b></td><td>move</td></tr>"
      "<tr><td><b>C, L</b></td><td>cells in the view, load of the threads</td></tr>"
      "<tr><td><b>Click on a cell</b></td><td>select it and bring it into sight</td></tr>"
      "<tr><td><b>T, O, F</b></td><td>from the top, from the side, fit into the view</td></tr>"
      "<tr><td><b>Alt+Up, Alt+Down</b></td><td>move a filter in the list</td></tr>"
      "<tr><td><b>F5, Esc</b></td><td>run again, cancel</td></tr></table>");
}

}  // namespace

void EditorWindow::createWidgets() {
  messages_ = new MessageBar(this);
  view_ = new LevelView(this);
  view_->installEventFilter(this);
  legend_ = new Legend(view_);
  legend_->hide();
  cut_ = new QFrame(view_);
  cut_->setObjectName(QStringLiteral("cut"));
  cut_->setToolTip(tr("Leave out what is higher, to look under roofs. The result stays the same."));
  auto* slider = new QSlider(Qt::Vertical, cut_);
  slider->setRange(0, kCutSteps);
  slider->setValue(kCutSteps);
  slider->setFocusPolicy(Qt::NoFocus);  // the keys belong to the view
  auto* cutLayout = new QVBoxLayout(cut_);
  cutLayout->setContentsMargins(4, 6, 4, 6);
  cutLayout->addWidget(new QLabel(tr("Height"), cut_), 0, Qt::AlignHCenter);
  cutLayout->addWidget(slider, 1, Qt::AlignHCenter);
  connect(slider, &QSlider::valueChanged, view_,
          [this](int value) { view_->setCut(static_cast<double>(value) / kCutSteps); });
  cut_->hide();
  welcome_ = new QLabel(tr("Open an environment (Ctrl+O), or drop a file here"), view_);
  welcome_->setObjectName(QStringLiteral("welcome"));
  welcome_->setAlignment(Qt::AlignCenter);
  welcome_->setAttribute(Qt::WA_TransparentForMouseEvents);
  auto* central = new QWidget(this);
  auto* layout = new QVBoxLayout(central);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(messages_);
  layout->addWidget(view_, 1);
  setCentralWidget(central);

  import_ = new ImportPanel(this);
  import_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  filters_ = new FilterList(document_, controller_, this);
  QDockWidget* environment = addDock(this, tr("Environment"), QStringLiteral("environmentDock"), import_);
  QDockWidget* list = addDock(this, tr("Filters"), QStringLiteral("filterDock"), filters_);
  resizeDocks({environment, list}, {120, 600}, Qt::Vertical);
  resizeDocks({environment}, {380}, Qt::Horizontal);
  import_->setMinimumWidth(340);

  summary_ = new QLabel(this);
  summary_->setTextFormat(Qt::PlainText);
  summary_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  progress_ = new QProgressBar(this);
  progress_->setFixedWidth(220);
  progress_->setTextVisible(false);
  cancel_ = new QPushButton(tr("Cancel"), this);
  cancel_->setObjectName(QStringLiteral("cancel"));
  cancel_->setShortcut(Qt::Key_Escape);
  cancel_->setToolTip(tr("Stop loading or running; the last result stays (Esc)"));
  statusBar()->addWidget(summary_, 1);
  statusBar()->addPermanentWidget(progress_);
  statusBar()->addPermanentWidget(cancel_);
}

void EditorWindow::createActions() {
  QToolBar* bar = addToolBar(tr("Tools"));
  bar->setObjectName(QStringLiteral("toolBar"));
  bar->setMovable(false);
  bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
  const auto add = [this](QMenu* menu, const QString& text, const QKeySequence& keys, auto run) {
    QAction* action = menu->addAction(text);
    action->setShortcut(keys);
    connect(action, &QAction::triggered, this, run);
    return action;
  };
  const auto onBar = [bar](QAction* action, const QString& text, const QString& help) {
    action->setIconText(text);
    action->setToolTip(action->shortcut().isEmpty()
                           ? help
                           : help + QStringLiteral(" (%1)").arg(action->shortcut().toString(QKeySequence::NativeText)));
    bar->addAction(action);
  };

  QMenu* file = menuBar()->addMenu(tr("&File"));
  onBar(add(file, tr("&Open..."), QKeySequence::Open, [this] { openDialog(); }), tr("Open"),
        tr("Open an environment or a session"));
  recent_.attachTo(file->addMenu(tr("Open &recent")));
  file->addSeparator();
  onBar(add(file, tr("&Save session..."), QKeySequence::Save, [this] { saveSessionDialog(); }), tr("Save session"),
        tr("Save environment, filters and view"));
  exportAction_ = add(file, tr("&Export OBJ..."), QKeySequence(Qt::CTRL | Qt::Key_E), [this] { exportDialog(); });
  exportAction_->setEnabled(false);
  onBar(exportAction_, tr("Export OBJ"), tr("Write the walkable area"));
  bar->addSeparator();
  file->addSeparator();
  add(file, tr("&Quit"), QKeySequence::Quit, [this] { close(); });

  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  QAction* undo = document_.undoStack()->createUndoAction(this, tr("&Undo"));
  undo->setShortcut(QKeySequence::Undo);
  QAction* redo = document_.undoStack()->createRedoAction(this, tr("&Redo"));
  redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
  edit->addActions({undo, redo});
  for (const auto& [action, text] : {std::pair{undo, tr("Undo")}, std::pair{redo, tr("Redo")}}) {
    // The actions rename themselves after the edit; the tool bar's width must not change with them.
    auto* button = new QToolButton(bar);
    button->setDefaultAction(action);
    const auto rename = [button, name = text] { button->setText(name); };
    rename();
    connect(action, &QAction::changed, button, rename);
    bar->addWidget(button);
  }
  bar->addSeparator();

  QMenu* pipeline = menuBar()->addMenu(tr("&Pipeline"));
  add(pipeline, tr("&Open pipeline..."), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O),
      [this] { openPipelineDialog(); });
  add(pipeline, tr("&Save pipeline..."), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S),
      [this] { savePipelineDialog(); });
  add(pipeline, tr("Use &default filters"), {}, [this] { useDefaultFilters(); });
  pipeline->addSeparator();
  add(pipeline, tr("&Run again"), Qt::Key_F5, [this] { controller_.runNow(); });
  add(pipeline, tr("&Cancel"), {}, [this] { cancelWork(); });
  pipeline->addSeparator();

  QMenu* look = menuBar()->addMenu(tr("&View"));
  onBar(add(look, tr("From the &top"), Qt::Key_T, [this] { view_->viewFromTop(); }), tr("Top"),
        tr("Look straight down, as on a plan"));
  onBar(add(look, tr("&Oblique"), Qt::Key_O, [this] { view_->viewOblique(); }), tr("Oblique"),
        tr("Look from above at an angle"));
  onBar(add(look, tr("&Fit"), Qt::Key_F, [this] { view_->fit(); }), tr("Fit"), tr("Bring everything into sight"));
  add(look, tr("Zoom &in"), Qt::Key_Plus, [this] { view_->zoomBy(1.25); });
  add(look, tr("Zoom o&ut"), Qt::Key_Minus, [this] { view_->zoomBy(0.8); });
  createCellActions(pipeline, look, bar);

  QMenu* help = menuBar()->addMenu(tr("&Help"));
  add(help, tr("&Mouse and keys"), Qt::Key_F1, [this] {
    auto* box = new QMessageBox(QMessageBox::NoIcon, tr("Mouse and keys"), mouseHelp(), QMessageBox::Ok, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
  });
  add(help, tr("&About Footfall"), {}, [this] {
    auto* box = new QMessageBox(QMessageBox::NoIcon, tr("About Footfall"),
                                tr("<b>Footfall %1</b><p>The exact walkable area of 3D environments.</p>"
                                   "<p>Free software under the GNU GPL, version 3 or later.</p>")
                                    .arg(QStringLiteral(FOOTFALL_VERSION)),
                                QMessageBox::Ok, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
  });
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
             [this](const QString& path) { open(path); });
}

void EditorWindow::openPipelineDialog() {
  showDialog(this, tr("Open a pipeline"), tr("Pipelines (*.pipeline *.txt);;All files (*)"), suggestedPath({}), {},
             [this](const QString& path) { openPipeline(path); });
}

void EditorWindow::savePipelineDialog() {
  showDialog(this, tr("Save the pipeline"), tr("Pipelines (*.pipeline)"), suggestedPath(QStringLiteral(".pipeline")),
             QStringLiteral("pipeline"), [this](const QString& path) { savePipeline(path); });
}

void EditorWindow::saveSessionDialog() {
  const QString extension = QLatin1String(kSessionExtension);
  const QString suggested = sessionPath_.isEmpty() ? suggestedPath(QLatin1Char('.') + extension) : sessionPath_;
  showDialog(this, tr("Save the session"), tr("Sessions (*.%1)").arg(extension), suggested, extension,
             [this](const QString& path) { saveSession(path); });
}

void EditorWindow::exportDialog() {
  showDialog(this, tr("Export the walkable area"), tr("Wavefront OBJ (*.obj)"),
             suggestedPath(QStringLiteral("-walkable.obj")), QStringLiteral("obj"),
             [this](const QString& path) { exportResult(path); });
}

}  // namespace footfall
