// Thousands of random events in the real window: no crash, memory that stays within bounds, a camera that shows
// something, rows that show the run that is shown, and the result is still right. The longest stretch in which the
// event loop could not answer is reported, with its cause; only a freeze fails, as drawing in software on a busy
// machine says little about a user's. FOOTFALL_MONKEY_EVENTS, FOOTFALL_MONKEY_SECONDS, FOOTFALL_MONKEY_SEED and
// FOOTFALL_MONKEY_LEVEL choose other amounts, other events and another level. QTEST_FUNCTION_TIMEOUT, in ms, must allow
// for more than five minutes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/resource.h>
#include <unistd.h>

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QElapsedTimer>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QRandomGenerator>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string>

#include "core/io/export.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "footfall/report.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/base/text/localized_numbers.hpp"
#include "ui/base/work/frame_watchdog.hpp"
#include "ui/filters/filter_list.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

int environmentNumber(const char* name, int otherwise) {
  bool ok = false;
  const int number = qEnvironmentVariableIntValue(name, &ok);
  return ok ? number : otherwise;
}

double residentMegabytes() {
  std::ifstream file("/proc/self/statm");
  long pages = 0, resident = 0;
  file >> pages >> resident;
  return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

/// The random actions of a person.
class Monkey {
 public:
  Monkey(EditorWindow& window, quint32 seed) : window_(window), random_(seed) {}

  void step() {
    closeDialogs();
    switch (below(15)) {
      case 12:
        dragValue();
        break;
      case 13:
        listKey();
        break;
      case 14:
        dragRow();
        break;
      case 0:
      case 1:
      case 2:
        drag();
        break;
      case 3:
        wheel(window_.view(), placeIn(window_.view()));
        break;
      case 4:
        last_ = QStringLiteral("double click");
        QTest::mouseDClick(&window_.view(), Qt::LeftButton, {}, placeIn(window_.view()));
        break;
      case 5:
      case 6:
        key(window_.view());
        break;
      case 7:
      case 8:
        command();
        break;
      case 9:
      case 10:
        widget();
        break;
      default:
        last_ = QStringLiteral("undo and redo");
        for (int i = below(4); i >= 0; --i)
          below(3) == 0 ? partOf<Document>(window_).undoStack()->redo() : partOf<Document>(window_).undoStack()->undo();
    }
    QTest::qWait(below(10) == 0 ? below(120) : below(8));
  }

  void closeDialogs() {
    for (int i = 0; i < 5; ++i) {
      QWidget* popup = QApplication::activePopupWidget();
      QWidget* dialog = popup ? popup : QApplication::activeModalWidget();
      if (!dialog) return;
      last_ += QStringLiteral(" [closes ") + QString::fromLatin1(dialog->metaObject()->className()) + QLatin1Char(']');
      dialog->close();
      QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
      QTest::qWait(1);
    }
  }

  [[nodiscard]] const QString& last() const { return last_; }

 private:
  int below(int bound) { return static_cast<int>(random_.bounded(static_cast<quint32>(bound))); }

  QPoint placeIn(const QWidget& widget) {
    return {below(std::max(1, widget.width())), below(std::max(1, widget.height()))};
  }

  Qt::KeyboardModifiers modifiers() {
    static constexpr std::array<Qt::KeyboardModifier, 4> kModifiers = {Qt::NoModifier, Qt::ShiftModifier,
                                                                       Qt::ControlModifier, Qt::AltModifier};
    return below(3) == 0 ? kModifiers.at(static_cast<std::size_t>(below(4))) : Qt::NoModifier;
  }

  void drag() {
    static constexpr std::array<Qt::MouseButton, 3> kButtons = {Qt::LeftButton, Qt::RightButton, Qt::MiddleButton};
    const Qt::MouseButton button = below(3) < 2 ? Qt::LeftButton : kButtons.at(static_cast<std::size_t>(below(3)));
    const Qt::KeyboardModifiers held = modifiers();
    last_ = QStringLiteral("drag with button %1").arg(button);
    QWidget* view = &window_.view();
    QTest::mousePress(view, button, held, placeIn(*view));
    for (int i = below(5); i > 0; --i) QTest::mouseMove(view, placeIn(*view));
    QTest::mouseRelease(view, button, held, placeIn(*view));
  }

  // Sideways, as values are dragged: the list runs again and again meanwhile.
  void dragValue() {
    const int id = anyRow() ? anyRow()->entryId() : -1;
    const auto& rows = partOf<FilterList>(window_).rows();
    auto found = std::ranges::find(rows, id, &FilterRow::entryId);
    if (found == rows.end()) return;
    if (!(*found)->isOpen()) QTest::mouseClick((*found)->nameLabel(), Qt::LeftButton);
    found = std::ranges::find(rows, id, &FilterRow::entryId);
    if (found == rows.end() || (*found)->fieldCount() == 0) return;
    FilterRow* row = *found;
    auto* field = qobject_cast<NumberField*>(row->field(static_cast<std::size_t>(below(int(row->fieldCount())))));
    if (!field || !field->isVisible() || !field->isEnabled()) return;
    last_ = QStringLiteral("drag of %1 in %2").arg(field->objectName(), row->nameLabel()->text());
    QPoint place = field->rect().center();
    QTest::mousePress(field, Qt::LeftButton, {}, place);
    for (int i = below(8) + 1; i > 0; --i) {
      place.rx() += below(41) - 20;
      QTest::mouseMove(field, place);
      QTest::qWait(below(30));
    }
    QTest::mouseRelease(field, Qt::LeftButton, {}, place);
  }

  void dragRow() {
    FilterRow* row = anyRow();
    if (!row) return;
    last_ = QStringLiteral("drag of the row %1").arg(row->nameLabel()->text());
    QWidget* handle = row->handle();
    QPoint place = handle->rect().center();
    QTest::mousePress(handle, Qt::LeftButton, {}, place);
    for (int i = below(4) + 1; i > 0; --i) QTest::mouseMove(handle, place += QPoint(0, below(161) - 80));
    QTest::mouseRelease(handle, Qt::LeftButton, {}, place);
  }

  // Space switches filters off and on, Alt and the arrows move them.
  void listKey() {
    static constexpr std::array<int, 5> kKeys = {Qt::Key_Space, Qt::Key_Space, Qt::Key_Up, Qt::Key_Down,
                                                 Qt::Key_Delete};
    FilterRow* row = anyRow();
    if (!row) return;
    const auto chosen = static_cast<Qt::Key>(kKeys.at(static_cast<std::size_t>(below(below(4) == 0 ? 5 : 4))));
    last_ = QStringLiteral("%1 on the row %2").arg(QKeySequence(chosen).toString(), row->nameLabel()->text());
    QTest::mouseClick(row->nameLabel(), Qt::LeftButton);
    QWidget* focus = window_.focusWidget() ? window_.focusWidget() : row;
    QTest::keyClick(focus, chosen, chosen == Qt::Key_Up || chosen == Qt::Key_Down ? Qt::AltModifier : Qt::NoModifier);
  }

  FilterRow* anyRow() {
    const auto& rows = partOf<FilterList>(window_).rows();
    return rows.empty() ? nullptr : rows[static_cast<std::size_t>(below(static_cast<int>(rows.size())))];
  }

  void wheel(QWidget& widget, const QPoint& place) {
    last_ = QStringLiteral("wheel on ") + widget.objectName();
    const QPoint turn(0, below(2) == 0 ? 120 : -120);
    QWheelEvent event(place, widget.mapToGlobal(QPointF(place)), {}, turn, Qt::NoButton, modifiers(), Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(&widget, &event);
  }

  void key(QWidget& widget) {
    static constexpr std::array<int, 44> kKeys = {
        Qt::Key_A,      Qt::Key_B,      Qt::Key_C,     Qt::Key_D,    Qt::Key_E,     Qt::Key_F,      Qt::Key_G,
        Qt::Key_H,      Qt::Key_I,      Qt::Key_J,     Qt::Key_K,    Qt::Key_L,     Qt::Key_M,      Qt::Key_N,
        Qt::Key_O,      Qt::Key_P,      Qt::Key_R,     Qt::Key_S,    Qt::Key_T,     Qt::Key_U,      Qt::Key_V,
        Qt::Key_W,      Qt::Key_X,      Qt::Key_Y,     Qt::Key_Z,    Qt::Key_0,     Qt::Key_1,      Qt::Key_5,
        Qt::Key_7,      Qt::Key_Left,   Qt::Key_Right, Qt::Key_Up,   Qt::Key_Down,  Qt::Key_PageUp, Qt::Key_PageDown,
        Qt::Key_Home,   Qt::Key_Escape, Qt::Key_Tab,   Qt::Key_Plus, Qt::Key_Minus, Qt::Key_F1,     Qt::Key_F5,
        Qt::Key_Return, Qt::Key_Delete};
    const int chosen = kKeys.at(static_cast<std::size_t>(below(static_cast<int>(kKeys.size()))));
    last_ = QStringLiteral("key %1 on %2").arg(QKeySequence(chosen).toString(), widget.objectName());
    QTest::keyClick(&widget, static_cast<Qt::Key>(chosen), modifiers());
  }

  void command() {
    const auto& entries = partOf<CommandRegistry>(window_).entries();
    const auto& entry = entries.at(static_cast<std::size_t>(below(static_cast<int>(entries.size()))));
    static const QStringList kNot = {QStringLiteral("file.quit"), QStringLiteral("file.recent")};
    if (kNot.contains(entry.command.id) || !entry.action->isEnabled()) return;
    last_ = QStringLiteral("command ") + entry.command.id;
    entry.action->trigger();
  }

  void widget() {
    QWidgetList candidates;
    for (QWidget* child : window_.findChildren<QWidget*>()) {
      if (child->isVisible() && child->isEnabled() && child->focusPolicy() != Qt::NoFocus && child != &window_.view())
        candidates << child;
    }
    if (candidates.isEmpty()) return;
    QWidget* chosen = candidates.at(below(static_cast<int>(candidates.size())));
    last_ = QStringLiteral("%1 '%2'").arg(QString::fromLatin1(chosen->metaObject()->className()), chosen->objectName());
    switch (below(4)) {
      case 0:
        // A menu that opens would wait for a choice.
        if (!qobject_cast<QToolButton*>(chosen) && !qobject_cast<QPushButton*>(chosen))
          QTest::mouseClick(chosen, Qt::LeftButton, {}, placeIn(*chosen));
        break;
      case 1:
        chosen->setFocus();
        for (int i = below(4); i >= 0; --i) QTest::keyClick(chosen, static_cast<char>('0' + below(10)));
        QTest::keyClick(chosen, Qt::Key_Return);
        break;
      case 2:
        wheel(*chosen, placeIn(*chosen));
        break;
      default:
        key(*chosen);
    }
  }

  EditorWindow& window_;
  QRandomGenerator random_;
  QString last_;
};

/// A camera whose place is no number shows nothing, and no command but opening brings it back.
bool isSane(const CameraPose& pose) {
  const auto isFinite = [](double x) { return std::isfinite(x); };
  return isFinite(pose.position.x + pose.position.y + pose.position.z) &&
         isFinite(pose.pivot.x + pose.pivot.y + pose.pivot.z) && std::ranges::all_of(pose.orientation, isFinite);
}

/// The camera's numbers, for the message of a failure.
QString poseText(const CameraPose& pose) {
  return QStringLiteral("eye %1 %2 %3, pivot %4 %5 %6, turn %7 %8 %9 %10%11")
      .arg(pose.position.x)
      .arg(pose.position.y)
      .arg(pose.position.z)
      .arg(pose.pivot.x)
      .arg(pose.pivot.y)
      .arg(pose.pivot.z)
      .arg(pose.orientation[0])
      .arg(pose.orientation[1])
      .arg(pose.orientation[2])
      .arg(pose.orientation[3])
      .arg(pose.orthographic ? QStringLiteral(", parallel") : QString());
}

/// The filters after random edits may take long on a large level. The list is what a failure is repeated with.
bool waitForRuns(EditorWindow& window, int milliseconds) {
  if (QTest::qWaitFor([&] { return window.idle(); }, milliseconds)) return true;
  qWarning("not done: %s", qPrintable(QString::fromStdString(formatPipeline(partOf<Document>(window).pipeline()))
                                          .replace(QLatin1Char('\n'), QLatin1String("; "))));
  return false;
}

/// A row that does not show the run that is shown, in words; empty for none. The window is idle.
QString lyingRow(EditorWindow& window) {
  const auto shown = window.controller().finishedRun();
  if (!shown || !window.controller().upToDate()) return {};
  const auto& rows = partOf<FilterList>(window).rows();
  const auto& filters = partOf<Document>(window).filters();
  if (rows.size() != filters.size()) return QStringLiteral("%1 rows of %2").arg(rows.size()).arg(filters.size());
  std::size_t step = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const QString state = rows[i]->stateText();
    const QString what =
        QStringLiteral("%1 says '%2', '%3'").arg(rows[i]->nameLabel()->text(), state, rows[i]->figuresText());
    if (!filters[i].step.enabled) {
      if (state != QLatin1String("off")) return what + QStringLiteral(", and is off");
      continue;
    }
    if (rows[i]->mendButton()->isVisibleTo(rows[i])) continue;  // skipped
    if (step >= shown->result.steps.size()) return what + QStringLiteral(", and has not run");
    const StepStatistics& ran = shown->result.steps[step++];
    if (ran.name != filters[i].step.filter->name) return what + QStringLiteral(", and is another filter");
    if (state != QLatin1String("done") && state != QLatin1String("cached"))
      return what + QStringLiteral(", and has run");
    const StepStatus status = window.controller().status(filters[i].id);
    if (status.trianglesOut && *status.trianglesOut != ran.out.triangles)
      return what + QStringLiteral(", and left %1").arg(ran.out.triangles);
    if (status.trianglesOut && !rows[i]->figuresText().contains(countText(ran.out.triangles)))
      return what + QStringLiteral(", and its status says %1").arg(*status.trianglesOut);
  }
  return {};
}

}  // namespace

class TestMonkey : public QObject {
  Q_OBJECT

 private slots:
  void randomEventsBreakNothing();

 private:
  QTemporaryDir folder_;
};

void TestMonkey::randomEventsBreakNothing() {
  const int events = environmentNumber("FOOTFALL_MONKEY_EVENTS", 3000);
  const auto seed = static_cast<quint32>(environmentNumber("FOOTFALL_MONKEY_SEED", 1));
  const int seconds = environmentNumber("FOOTFALL_MONKEY_SECONDS", 0);
  const int longest = seconds > 0 ? 300'000 : kWaitMs;
  qInfo("%d events, seed %u", events, seed);
  EditorWindow window;
  window.setRemembering(false);
  window.resize(960, 640);  // Software drawing takes most of the time.
  QVERIFY(showWindow(window));
  window.open(
      qEnvironmentVariable("FOOTFALL_MONKEY_LEVEL", QStringLiteral(FOOTFALL_SOURCE_DIR "/samples/house/house.obj")));
  QVERIFY(waitForRuns(window, longest));
  partOf<Document>(window).addFilter(filterDescriptor(FilterType::Radius),
                                     partOf<LevelComposer>(window).level()->metresPerUnit);
  QVERIFY(waitForRuns(window, longest));

  Monkey monkey(window, seed);
  FrameWatchdog watchdog;
  double megabytesEarly = 0;
  watchdog.start();
  QElapsedTimer clock;
  clock.start();
  constexpr int kCheckedEvery = 100;
  int done = 0, checks = 0;
  const CameraController& camera = window.view().cameraController();
  for (int i = 0; seconds > 0 ? clock.elapsed() < 1000LL * seconds : i < events; ++i) {
    const QString before = poseText(camera.pose());
    monkey.step();
    done = i + 1;
    QVERIFY2(isSane(camera.pose()), qPrintable(QStringLiteral("event %1, the camera after %2: %3; before: %4")
                                                   .arg(i)
                                                   .arg(monkey.last(), poseText(camera.pose()), before)));
    // Caches fill in the first part.
    const bool isEarly = seconds > 0 ? clock.elapsed() < 250LL * seconds : i <= events / 4;
    if (isEarly) megabytesEarly = residentMegabytes();
    if (i % kCheckedEvery != 0) continue;
    monkey.closeDialogs();
    const QString last = monkey.last();
    if (!waitUntilIdle(window)) continue;  // a large level
    ++checks;
    const QString row = lyingRow(window);
    QVERIFY2(row.isEmpty(), qPrintable(QStringLiteral("event %1, after %2: %3").arg(i).arg(last, row)));
  }
  watchdog.stop();
  monkey.closeDialogs();
  QVERIFY2(waitForRuns(window, longest), qPrintable(monkey.last()));

  qInfo("%d events, rows checked %d times; longest stall %.0f ms (%s); %.0f MB after a quarter, %.0f MB at the end",
        done, checks, watchdog.longestStallMs(), qPrintable(watchdog.longestStall().during), megabytesEarly,
        residentMegabytes());

  QVERIFY2(watchdog.longestStallMs() < 5000, "the window froze");
  QVERIFY2(residentMegabytes() < megabytesEarly + 400, "memory grows");

  // The shown result is that of a run from nothing.
  window.controller().runNow();
  QVERIFY(waitForRuns(window, longest));
  if (!partOf<LevelComposer>(window).level()) return;
  const auto shown = window.controller().finishedRun();
  QVERIFY(shown);
  RunContext context;
  const RunResult fresh = runPipeline(partOf<LevelComposer>(window).level(), shown->pipeline, context);
  const ExportHeader header = makeExportHeader(shown->pipeline);
  QVERIFY(formatObj(*fresh.mesh, header) == formatObj(*shown->result.mesh, header));
}

FOOTFALL_EDITOR_SUITE(TestMonkey)
#include "test_monkey.moc"
