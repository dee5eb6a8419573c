// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/editor_application.hpp"

#include <QApplication>
#include <QFile>
#include <QLibrary>
#include <QOpenGLContext>
#include <QSettings>
#include <QSurfaceFormat>
#include <cstdlib>
#include <memory>

#include "footfall/version.hpp"
#include "ui/base/commands/translations.hpp"
#include "ui/base/look/icon.hpp"
#include "ui/base/look/outline_style.hpp"
#include "ui/base/look/theme.hpp"
#include "ui/base/work/guarded_application.hpp"
#include "ui/level/level_look.hpp"
#include "ui/window/editor_window.hpp"
#include "ui/window/preferences.hpp"
#include "ui/window/unattended.hpp"
#include "ui/window/window_placement.hpp"

namespace footfall::ui {
namespace {

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
  if (!problem.empty()) return failWith(2, QString::fromStdString(problem));
  requestOpenGl();
  // Pictures are the same for everybody.
  const bool shooting = !options.screenshot.empty() || !options.turntable.empty();
  if (!shooting) applyInterfaceScale();
  GuardedApplication application(argc, argv);
  probe.reset();
  prepareApplication();
  loadTranslations(QString::fromStdString(options.language));
  if (options.theme) Theme::instance()->show(*options.theme);
  if (QOpenGLContext context; !context.create()) {
    return failWith(
        2, QStringLiteral("no OpenGL on this display (%1); install a graphics driver or Mesa's software OpenGL, "
                          "or use the command line footfall")
               .arg(QGuiApplication::platformName()));
  }
  EditorWindow window;
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
  if (!options.turntable.empty()) return writeTurntable(window, options);
  return shooting ? takeScreenshot(window, options) : QApplication::exec();
}

}  // namespace footfall::ui
