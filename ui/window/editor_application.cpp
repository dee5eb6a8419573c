// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/editor_application.hpp"

#include <QApplication>
#include <QFile>
#include <QLibrary>
#include <QOpenGLContext>
#include <QSaveFile>
#include <QSettings>
#include <QSurfaceFormat>
#include <QTimer>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "footfall/version.hpp"
#include "ui/base/guarded_application.hpp"
#include "ui/base/icon.hpp"
#include "ui/base/outline_style.hpp"
#include "ui/base/theme.hpp"
#include "ui/base/translations.hpp"
#include "ui/level/level_look.hpp"
#include "ui/level/packed_feature.hpp"
#include "ui/view/view_hint.hpp"
#include "ui/window/editor_window.hpp"
#include "ui/window/preferences.hpp"
#include "ui/window/window_placement.hpp"

namespace footfall::ui {
namespace {

constexpr int kSettleMs = 100;  // time for the layout, before the picture is taken

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

// A connection to the X server, which tests whether a server responds. libxcb is loaded because Qt's plug-in needs it
// as well; without it Qt decides. The connection is kept until Qt has its own, because a server without clients
// restarts and may refuse the next client meanwhile.
class DisplayProbe {
 public:
  DisplayProbe() {
    QLibrary xcb(QStringLiteral("xcb"), 1);
    using Connect = void* (*)(const char*, int*);
    using HasError = int (*)(void*);
    const auto connect = reinterpret_cast<Connect>(xcb.resolve("xcb_connect"));
    const auto hasError = reinterpret_cast<HasError>(xcb.resolve("xcb_connection_has_error"));
    m_disconnect = reinterpret_cast<Disconnect>(xcb.resolve("xcb_disconnect"));
    if (!connect || !hasError || !m_disconnect) return;
    m_connection = connect(nullptr, nullptr);
    m_answers = hasError(m_connection) == 0;
  }
  ~DisplayProbe() {
    if (m_connection) m_disconnect(m_connection);
  }
  DisplayProbe(const DisplayProbe&) = delete;
  DisplayProbe& operator=(const DisplayProbe&) = delete;

  bool answers() const { return m_answers; }

 private:
  using Disconnect = void (*)(void*);
  Disconnect m_disconnect = nullptr;
  void* m_connection = nullptr;
  bool m_answers = true;
};

// See findDisplayProblem(); `probe` is set where a server had to be tested.
std::string displayProblem(std::unique_ptr<DisplayProbe>& probe) {
  if (!variable("QT_QPA_PLATFORM").empty() && variable("QT_QPA_PLATFORM").rfind("xcb", 0) != 0) return {};
  if (!variable("WAYLAND_DISPLAY").empty() && variable("QT_QPA_PLATFORM").empty()) return {};
  if (variable("DISPLAY").empty()) {
    return "no display: DISPLAY is not set; start it from a desktop, under xvfb-run, or use the command line footfall";
  }
  probe = std::make_unique<DisplayProbe>();
  if (!probe->answers()) {
    return "no display: nothing answers at DISPLAY=" + variable("DISPLAY") +
           "; start it from a desktop, under xvfb-run, or use the command line footfall";
  }
  return {};
}

int fail(int code, const QString& message) {
  std::fprintf(stderr, "footfall-editor: %s\n", qPrintable(message));
  return code;
}

int takeScreenshot(EditorWindow& window, const EditorOptions& options) {
  // Only picture files are accepted, so that a typing error cannot replace a level.
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
    if (!window.cellWatch().upToDate() || !look->modes().upToDate() || window.controller().seeksMarginKinds()) return;
    // A session's part of a large environment is loaded after the first one, and blocks after either.
    if (window.file().busy() || window.controller().busy() || window.packed().busy()) return;
    settle.stop();
    // A session has a camera position of its own.
    if (options.top) window.view().cameraController().viewFromTop();
    if (!options.top && !window.openedSession()) window.view().cameraController().viewOblique();
    const QString why = window.writer().refusal(target, WrittenKind::Export);
    if (!why.isEmpty()) {
      finish(fail(2, why));
      return;
    }
    // Hints cannot be closed in a picture.
    for (ViewHint* hint : window.findChildren<ViewHint*>()) hint->hide();
    window.view().grabFramebuffer();  // the next frames find all of it drawn
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
  std::unique_ptr<DisplayProbe> probe;
  return displayProblem(probe);
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
  QApplication::setWindowIcon(applicationIcon());
  QGuiApplication::setDesktopFileName(QStringLiteral("org.footfall.Editor"));
  QApplication::setStyle(new OutlineStyle);  // the application owns it
  if (!Theme::instance()) new Theme(qApp);
}

int runEditor(int& argc, char** argv, const EditorOptions& options) {
  std::unique_ptr<DisplayProbe> probe;
  const std::string problem = displayProblem(probe);
  if (!problem.empty()) return fail(2, QString::fromStdString(problem));
  requestOpenGl();
  // Pictures do not depend on the user's settings.
  if (options.screenshot.empty()) applyInterfaceScale();
  GuardedApplication application(argc, argv);
  probe.reset();
  prepareApplication();
  loadTranslations(QString::fromStdString(options.language));
  if (options.theme) Theme::instance()->show(*options.theme);
  if (QOpenGLContext context; !context.create()) {
    return fail(2,
                QStringLiteral("no OpenGL on this display (%1); install a graphics driver or Mesa's software OpenGL, "
                               "or use the command line footfall")
                    .arg(QGuiApplication::platformName()));
  }
  EditorWindow window;
  const bool shooting = !options.screenshot.empty();
  window.setRemembering(!shooting);
  const QSize size = options.size.isEmpty() ? QSize(1440, 900) : options.size;
  if (shooting || !options.size.isEmpty()) {
    window.resize(size);
  } else {
    placeAtFirst(window, size);
  }
  if (!shooting) window.restoreLayout(options.size.isEmpty());
  if (options.cells) window.setCellsShown(*options.cells);
  window.setInteractive(!shooting);
  window.show();
  if (!shooting && options.environment.empty()) window.offerRestoring();
  if (!options.environment.empty()) {
    const QString path = QFile::decodeName(options.environment.c_str());
    // Opening removes messages.
    if (!shooting) {
      const auto offer = [&window, path] { window.offerRestoring(path); };
      QObject::connect(&window.file(), &LevelFile::opened, &window, offer, Qt::SingleShotConnection);
      QObject::connect(&window, &EditorWindow::loadFailed, &window, offer, Qt::SingleShotConnection);
    }
    // The call runs inside the event loop, so that a problem can end it.
    QMetaObject::invokeMethod(
        &window,
        [&window, &options, path, shooting] {
          window.openWith(path, options.pipeline, options.import);
          if (options.top && !shooting) window.view().cameraController().viewFromTop();
          if (options.mode && !shooting) window.findChild<LevelLook*>()->modes().setMode(*options.mode);
        },
        Qt::QueuedConnection);
  }
  return shooting ? takeScreenshot(window, options) : QApplication::exec();
}

}  // namespace footfall::ui
