// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor_application.hpp"

#include <QApplication>
#include <QFile>
#include <QLibrary>
#include <QOpenGLContext>
#include <QSaveFile>
#include <QSettings>
#include <QStyleFactory>
#include <QSurfaceFormat>
#include <cstdio>
#include <cstdlib>

#include "ui/editor_window.hpp"
#include "ui/level_look.hpp"

namespace footfall {
namespace {

constexpr int kSettleMs = 100;  // for the layout, before the picture is taken

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

// Whether an X server answers. libxcb is loaded because Qt's plug-in needs it as well; without it Qt decides.
bool serverAnswers() {
  QLibrary xcb(QStringLiteral("xcb"), 1);
  using Connect = void* (*)(const char*, int*);
  using HasError = int (*)(void*);
  using Disconnect = void (*)(void*);
  const auto connect = reinterpret_cast<Connect>(xcb.resolve("xcb_connect"));
  const auto hasError = reinterpret_cast<HasError>(xcb.resolve("xcb_connection_has_error"));
  const auto disconnect = reinterpret_cast<Disconnect>(xcb.resolve("xcb_disconnect"));
  if (!connect || !hasError || !disconnect) return true;
  void* connection = connect(nullptr, nullptr);
  const bool answers = hasError(connection) == 0;
  disconnect(connection);
  return answers;
}

int fail(int code, const QString& message) {
  std::fprintf(stderr, "footfall-editor: %s\n", qPrintable(message));
  return code;
}

int takeScreenshot(EditorWindow& window, const EditorOptions& options) {
  // Only pictures: a slip of the hand must not replace a level.
  const QString target = QFile::decodeName(options.screenshot.c_str());
  if (!target.endsWith(QLatin1String(".png"), Qt::CaseInsensitive))
    return fail(2, QStringLiteral("%1: --screenshot writes .png files; give a name that ends so").arg(target));
  int code = 0;
  const auto finish = [&](int result) {
    code = result;
    QCoreApplication::exit(result);
  };
  QObject::connect(&window, &EditorWindow::loadFailed, &window,
                   [&](const QString& message) { finish(fail(2, message)); });
  QObject::connect(&window.controller(), &RunController::failed, &window,
                   [&](const QString& message) { finish(fail(1, message)); });
  QObject::connect(&window.view(), &LevelView::failed, &window,
                   [&](const QString& message) { finish(fail(1, message)); });
  auto* look = window.findChild<LevelLook*>();
  QTimer settle;
  settle.setInterval(kSettleMs);
  QObject::connect(&window.controller(), &RunController::finished, &window, [&] {
    if (options.cells) window.setCellsShown(*options.cells);
    if (options.mode) look->modes().setMode(*options.mode);
    settle.start();
  });
  QObject::connect(&settle, &QTimer::timeout, &window, [&] {
    if (!window.cellWatch().upToDate() || !look->modes().upToDate()) return;
    settle.stop();
    // A session has a view of its own.
    if (options.top) window.view().viewFromTop();
    if (!options.top && !window.openedSession()) window.view().viewOblique();
    QSaveFile file(target);
    const bool written = file.open(QIODevice::WriteOnly) && window.grab().save(&file, "PNG") && file.commit();
    finish(written ? 0
                   : fail(1, QStringLiteral("%1: cannot be written (%2); choose another folder or name")
                                 .arg(target, file.errorString())));
  });
  QApplication::exec();
  return code;
}

}  // namespace

std::string findDisplayProblem() {
  if (!variable("QT_QPA_PLATFORM").empty() && variable("QT_QPA_PLATFORM").rfind("xcb", 0) != 0) return {};
  if (!variable("WAYLAND_DISPLAY").empty() && variable("QT_QPA_PLATFORM").empty()) return {};
  if (variable("DISPLAY").empty()) {
    return "no display: DISPLAY is not set; start it from a desktop, under xvfb-run, or use the command line footfall";
  }
  if (!serverAnswers()) {
    return "no display: nothing answers at DISPLAY=" + variable("DISPLAY") +
           "; start it from a desktop, under xvfb-run, or use the command line footfall";
  }
  return {};
}

void requestOpenGl() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CompatibilityProfile);  // libQGLViewer needs it
  format.setDepthBufferSize(24);
  QSurfaceFormat::setDefaultFormat(format);
}

void prepareApplication() {
  QApplication::setApplicationName(QStringLiteral("footfall"));
  QApplication::setOrganizationName(QStringLiteral("footfall"));
  QApplication::setApplicationVersion(QStringLiteral(FOOTFALL_VERSION));
  QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  QPalette palette;
  palette.setColor(QPalette::Window, QColor(240, 242, 245));
  palette.setColor(QPalette::WindowText, QColor(28, 36, 44));
  palette.setColor(QPalette::Base, Qt::white);
  palette.setColor(QPalette::AlternateBase, QColor(246, 247, 249));
  palette.setColor(QPalette::Text, QColor(28, 36, 44));
  palette.setColor(QPalette::Button, QColor(236, 239, 242));
  palette.setColor(QPalette::ButtonText, QColor(28, 36, 44));
  palette.setColor(QPalette::Highlight, QColor(0, 114, 178));
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::ToolTipBase, QColor(255, 255, 250));
  palette.setColor(QPalette::ToolTipText, QColor(28, 36, 44));
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, QColor(140, 146, 153));
  }
  QApplication::setPalette(palette);
  QFile theme(QStringLiteral(":/resources/theme.qss"));
  if (theme.open(QIODevice::ReadOnly)) qApp->setStyleSheet(QString::fromUtf8(theme.readAll()));
}

int runEditor(int& argc, char** argv, const EditorOptions& options) {
  const std::string problem = findDisplayProblem();
  if (!problem.empty()) return fail(2, QString::fromStdString(problem));
  requestOpenGl();
  QApplication application(argc, argv);
  prepareApplication();
  if (QOpenGLContext context; !context.create()) {
    return fail(2,
                QStringLiteral("no OpenGL on this display (%1); install a graphics driver or Mesa's software OpenGL, "
                               "or use the command line footfall")
                    .arg(QGuiApplication::platformName()));
  }
  EditorWindow window;
  const bool shooting = !options.screenshot.empty();
  window.setRemembering(!shooting);
  window.resize(options.size.isEmpty() ? QSize(1440, 900) : options.size);
  if (!shooting && options.size.isEmpty()) {
    window.restoreGeometry(QSettings().value(QStringLiteral("windowGeometry")).toByteArray());
  }
  if (options.cells) window.setCellsShown(*options.cells);
  window.setInteractive(!shooting);
  window.show();
  if (options.environment.empty()) {
    window.offerLastSession();
  } else {
    const QString path = QFile::decodeName(options.environment.c_str());
    // After the loop has begun, so that a problem can end it.
    QMetaObject::invokeMethod(
        &window,
        [&window, &options, path, shooting] {
          window.openWith(path, options.pipeline, options.import);
          if (options.top && !shooting) window.view().viewFromTop();
          if (options.mode && !shooting) window.findChild<LevelLook*>()->modes().setMode(*options.mode);
        },
        Qt::QueuedConnection);
  }
  return shooting ? takeScreenshot(window, options) : QApplication::exec();
}

}  // namespace footfall
