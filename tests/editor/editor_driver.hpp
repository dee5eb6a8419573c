// Small environments, and waiting, for the suites that drive the editor.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>
#include <memory>

#include "tests/editor/window_parts.hpp"
#include "ui/base/work/guarded_application.hpp"
#include "ui/filters/filter_list.hpp"
#include "ui/window/editor_application.hpp"
#include "ui/window/editor_window.hpp"

namespace footfall::test {
using namespace detail;
using namespace ui;

/// A square floor of 8 x 8 at the height 0, counter-clockwise seen from above; Z up.
inline QByteArray floorObj() { return "v -4 -4 0\nv 4 -4 0\nv 4 4 0\nv -4 4 0\nf 1 2 3\nf 1 3 4\n"; }

/// The floor with a table of 2 x 2 at the height 1 over its middle, and a ramp of 60 degrees beside it.
inline QByteArray tableObj() {
  return floorObj() +
         "v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\nf 5 6 7 8\n"
         "v 5 -2 0\nv 6 -2 1.7320508\nv 6 2 1.7320508\nv 5 2 0\nf 9 10 11 12\n";
}

/// `cells` x `cells` squares of two triangles, in waves: work that takes a while to compute and to draw.
inline QByteArray wavesObj(int cells) {
  QByteArray text;
  for (int y = 0; y <= cells; ++y) {
    for (int x = 0; x <= cells; ++x) {
      text += "v " + QByteArray::number(x) + ' ' + QByteArray::number(y) + ' ' +
              QByteArray::number((x * 7 + y * 5) % 4 * 0.25) + '\n';
    }
  }
  for (int y = 0; y < cells; ++y) {
    for (int x = 1; x <= cells; ++x) {
      const int a = y * (cells + 1) + x;
      for (const auto& corners : {std::array{a, a + 1, a + cells + 2}, std::array{a, a + cells + 2, a + cells + 1}}) {
        text += 'f';
        for (const int corner : corners) text += ' ' + QByteArray::number(corner);
        text += '\n';
      }
    }
  }
  return text;
}

inline QString writeFile(const QTemporaryDir& folder, const QString& name, const QByteArray& content) {
  const QString path = folder.filePath(name);
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
    qFatal("cannot write %s", qPrintable(path));
  return path;
}

inline QByteArray readFile(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// The timeout for things that take a moment, on machines that are busy.
constexpr int kWaitMs = 20000;

/// Shown, with the focus: there may be no window manager to give it.
inline bool showWindow(EditorWindow& window) {
  window.show();
  if (!QTest::qWaitForWindowExposed(&window, kWaitMs)) return false;
  window.activateWindow();
  return QTest::qWaitForWindowActive(&window, kWaitMs);
}

inline bool waitUntilIdle(EditorWindow& window) {
  return QTest::qWaitFor([&] { return window.idle(); }, kWaitMs);
}

/// Reads a Z-up OBJ, as the ones above are, and waits for the result.
inline bool openZUp(EditorWindow& window, const QString& path, const char* pipeline) {
  ImportOptions import;
  import.up = UpAxis::Z;
  window.openWith(path, parsePipeline(pipeline, "test"), import);
  return waitUntilIdle(window) && window.controller().finishedRun() != nullptr;
}

/// A suite whose tests have a folder and a window each; the window remembers nothing.
class EditorSuite : public QObject {
 protected:
  bool openWindow(const QSize& size = {1280, 800}) {
    folder_ = std::make_unique<QTemporaryDir>();
    window_ = std::make_unique<EditorWindow>();
    window_->setRemembering(false);
    window_->resize(size);
    return showWindow(*window_);
  }
  /// A window with a Z-up level and its result.
  bool openLevel(const QByteArray& obj, const char* pipeline, const QSize& size = {1280, 800}) {
    return openWindow(size) && openZUp(*window_, writeFile(*folder_, "level.obj", obj), pipeline);
  }
  void closeWindow() {
    window_.reset();
    folder_.reset();
  }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<EditorWindow> window_;
};

/// Opens a row of the filter list and returns the field of one of its values.
inline NumberField* openField(EditorWindow& window, std::size_t row, std::size_t value = 0) {
  FilterRow* found = partOf<FilterList>(window).rows()[row];
  QTest::mouseClick(found->nameLabel(), Qt::LeftButton);
  return qobject_cast<NumberField*>(found->field(value));
}

inline QStringList filterNames(EditorWindow& window) {
  QStringList names;
  for (const FilterEntry& entry : partOf<Document>(window).filters()) {
    names << QString::fromStdString(formatStep(entry.step)).section(QLatin1Char(' '), 0, 0);
  }
  return names;
}

/// Pastes into whatever dialog for files is open and confirms it.
inline void answerFileDialog(const QString& path) {
  QWidget* dialog = nullptr;
  QVERIFY(QTest::qWaitFor([&] { return (dialog = QApplication::activeModalWidget()) != nullptr; }, kWaitMs));
  auto* name = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
  QVERIFY(name);
  // Pasted, as the completion of half a path may turn it into something else.
  QApplication::clipboard()->setText(path);
  QTest::keyClick(name, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClick(name, Qt::Key_V, Qt::ControlModifier);
  if (QWidget* suggestions = QApplication::activePopupWidget()) suggestions->close();
  QTest::keyClick(name, Qt::Key_Return);
}

/// The position of a place of the level in the view; (-1, -1) when it is behind the eye.
inline QPoint placeInView(EditorWindow& window, const Vec3& place) {
  const auto found = window.view().project(place);
  return found ? found->toPoint() : QPoint(-1, -1);
}

inline void clickInView(EditorWindow& window, const Vec3& place, Qt::KeyboardModifiers modifiers = {}) {
  QTest::mouseClick(&window.view(), Qt::LeftButton, modifiers, placeInView(window, place));
}

inline QColor colourInView(EditorWindow& window, const Vec3& place) {
  const QImage picture = window.view().grabFramebuffer();
  const auto at = window.view().project(place);
  return at ? picture.pixelColor((*at * picture.devicePixelRatio()).toPoint()) : QColor();
}

/// Writes a picture for eyes into the folder FOOTFALL_TEST_PICTURES; nothing where that is not set.
inline void shoot(QWidget& widget, const QString& name) {
  const QString folder = qEnvironmentVariable("FOOTFALL_TEST_PICTURES");
  if (folder.isEmpty()) return;
  QTest::qWait(200);
  if (auto* window = qobject_cast<EditorWindow*>(&widget)) window->view().grabFramebuffer();  // all of it drawn
  QVERIFY(widget.grab().save(folder + QLatin1Char('/') + name + QStringLiteral(".png")));
}

/// Fresh settings, OpenGL and the program's looks; then all tests of one suite.
template <typename Suite>
int runSuite(int argc, char** argv) {
  const QTemporaryDir settings;
  qputenv("XDG_CONFIG_HOME", settings.path().toUtf8());
  requestOpenGl();
  GuardedApplication application(argc, argv);
  prepareApplication();
  Suite suite;
  return QTest::qExec(&suite, argc, argv);
}

}  // namespace footfall::test

#define FOOTFALL_EDITOR_SUITE(Suite) \
  int main(int argc, char** argv) { return footfall::test::runSuite<Suite>(argc, argv); }
