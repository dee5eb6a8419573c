// The log: entries and commands; problems are reported and survived; progress.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <new>

#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/base/messages/log_panel.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/base/messages/message_log.hpp"
#include "ui/base/messages/progress_display.hpp"
#include "ui/base/work/frame_watchdog.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

/// Does something when it gets an event.
class Reacting : public QObject {
 public:
  explicit Reacting(std::function<void()> reaction) : reaction_(std::move(reaction)) {}
  bool event(QEvent* event) override {
    if (event->type() == QEvent::User) reaction_();
    return QObject::event(event);
  }

 private:
  std::function<void()> reaction_;
};

}  // namespace

class TestLogPanel : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    table_ = writeFile(*folder_, "table.obj", tableObj());
    window_ = std::make_unique<EditorWindow>();
    window_->resize(1100, 800);
    QVERIFY(showWindow(*window_));
  }
  void cleanup() { window_.reset(); }

  void opensRunsAndErrorsAreKept() {
    window_->open(folder_->filePath("missing.obj"));
    QTRY_VERIFY(partOf<MessageBar>(*window_).isVisible());
    QVERIFY(openZUp(*window_, table_, "SlopeFilter 45\n"));
    const QStringList texts = allTexts();
    QVERIFY(texts[0].contains("missing.obj"));
    QCOMPARE(partOf<MessageLog>(*window_).messages()[0].level, MessageLevel::Error);
    QVERIFY(texts[1].contains("table.obj"));
    QVERIFY(texts.back().contains("Run finished"));
    QVERIFY(texts.back().contains("6 → 4 triangles"));
    QVERIFY(partOf<MessageLog>(*window_).messages()[0].time <= QDateTime::currentDateTime());
  }

  void filtersByLevelAndText() {
    LogPanel& panel = openLog();
    partOf<MessageLog>(*window_).clear();
    partOf<MessageLog>(*window_).add(MessageLevel::Note, "a note about doors");
    partOf<MessageLog>(*window_).add(MessageLevel::Hint, "a hint about doors");
    partOf<MessageLog>(*window_).add(MessageLevel::Error, "an error about walls");
    QCOMPARE(panel.list()->model()->rowCount(), 3);
    panel.levels()->setFocus();
    QTest::keyClick(panel.levels(), Qt::Key_Down);
    QCOMPARE(panel.list()->model()->rowCount(), 2);
    QTest::keyClicks(panel.search(), "DOORS");
    QCOMPARE(panel.list()->model()->rowCount(), 1);
    QVERIFY(panel.text().contains("hint about doors"));
  }

  void copiesWhatIsSelected() {
    LogPanel& panel = openLog();
    partOf<MessageLog>(*window_).clear();
    partOf<MessageLog>(*window_).add(MessageLevel::Note, "first\nwith a second line");
    partOf<MessageLog>(*window_).add(MessageLevel::Error, "second");
    QTest::mouseClick(panel.copyButton(), Qt::LeftButton);
    QVERIFY(QApplication::clipboard()->text().contains("first\n    with a second line\n"));
    QVERIFY(QApplication::clipboard()->text().contains("error  second"));
    panel.list()->setFocus();
    panel.list()->setCurrentIndex(panel.list()->model()->index(1, 0));
    QTest::keyClick(panel.list(), Qt::Key_C, Qt::ControlModifier);
    QCOMPARE(QApplication::clipboard()->text().count('\n'), 1);
    QVERIFY(QApplication::clipboard()->text().endsWith("error  second\n"));
  }

  void savesAndClears() {
    LogPanel& panel = openLog();
    partOf<MessageLog>(*window_).add(MessageLevel::Note, "to be kept");
    const QString target = folder_->filePath("log.txt");
    QSignalSpy written(window_.get(), &EditorWindow::written);
    QTest::mouseClick(panel.saveButton(), Qt::LeftButton);
    answerFileDialog(target);
    QVERIFY(written.count() > 0 || written.wait());
    QVERIFY(readFile(target).contains("note  to be kept\n"));
    QTest::mouseClick(panel.clearButton(), Qt::LeftButton);
    QCOMPARE(partOf<MessageLog>(*window_).messages().size(), std::size_t{0});
  }

  void isBoundedAndDoesNotRepeat() {
    MessageLog log;
    for (std::size_t i = 0; i < MessageLog::kMost + 10; ++i) log.add(MessageLevel::Note, QString::number(i));
    QCOMPARE(log.messages().size(), MessageLog::kMost);
    QCOMPARE(log.messages().front().text, QString("10"));
    log.clear();
    for (int i = 0; i < 5; ++i) log.add(MessageLevel::Error, "the same");
    QCOMPARE(log.messages().size(), std::size_t{1});
  }

  void exceptionsInEventsAreToldAndNotDiedOf() {
    Reacting hungry([] { throw std::bad_alloc(); });
    QCoreApplication::postEvent(&hungry, new QEvent(QEvent::User));
    QTRY_VERIFY(partOf<MessageBar>(*window_).isVisible());
    QVERIFY(partOf<MessageBar>(*window_).text().contains("memory ran out"));
    Reacting wrong([] { throw std::runtime_error("the reason"); });
    QCoreApplication::postEvent(&wrong, new QEvent(QEvent::User));
    QTRY_VERIFY(partOf<MessageBar>(*window_).text().contains("the reason"));
    QCOMPARE(partOf<MessageLog>(*window_).messages().back().level, MessageLevel::Error);
    QVERIFY(openZUp(*window_, table_, "SlopeFilter 45\n"));  // and works on
  }

  void memoryErrorsWhileWritingAreTold() {
    window_->writer().write([] { throw std::bad_alloc(); }, folder_->filePath("x.obj"));
    QTRY_VERIFY(partOf<MessageBar>(*window_).text().contains("memory ran out"));
    QVERIFY(window_->idle());
    BackgroundQueue queue;
    std::atomic<bool> done = false;
    queue.post([] { throw std::runtime_error("a job that tells nobody"); });
    queue.post([&] { done = true; });
    QTRY_VERIFY(done);
  }

  void theWatchdogFindsWhatHeldTheWindow() {
    FrameWatchdog watchdog;
    watchdog.start();
    QTest::qWait(150);
    QVERIFY2(watchdog.longestStallMs() < 100, qPrintable(watchdog.longestStall().during));
    Reacting slow([] { QTest::qSleep(130); });
    slow.setObjectName("slow one");
    QCoreApplication::postEvent(&slow, new QEvent(QEvent::User));
    QTest::qWait(300);  // a loop of its own, whose waiting must not count
    QVERIFY(watchdog.longestStallMs() >= 130);
    QVERIFY(watchdog.longestStallMs() < 280);
    QVERIFY2(watchdog.longestStall().during.contains("User in QObject 'slow one'"),
             qPrintable(watchdog.longestStall().during));
    QCOMPARE(watchdog.stallsOver(130).size(), std::size_t{1});
    // A loop inside an event: only what is done counts.
    Reacting nested([] {
      QTest::qSleep(40);
      QTest::qWait(200);
      QTest::qSleep(60);
    });
    watchdog.start();
    QCoreApplication::postEvent(&nested, new QEvent(QEvent::User));
    QTest::qWait(500);
    QVERIFY2(watchdog.longestStallMs() >= 60 && watchdog.longestStallMs() < 150,
             qPrintable(QString::number(watchdog.longestStallMs())));
    watchdog.stop();
    QVERIFY(!FrameWatchdog::running());
  }

  void timeLeftIsToldOnceItIsKnown() {
    TimeLeft left;
    left.begin();
    QVERIFY(!left.estimate(0.5, 0.2));  // too early
    QVERIFY(!left.estimate(3, 0.001));  // too little
    QCOMPARE(*left.estimate(2, 0.2), 8.0);
    const double smoothed = *left.estimate(4, 0.5);
    QVERIFY(smoothed > 4 && smoothed < 6.01);
    QCOMPARE(timeLeftText(0.2), QString("nearly done"));
    QCOMPARE(timeLeftText(7.2), QString("about 8 s left"));
    QCOMPARE(timeLeftText(31), QString("about 35 s left"));
    QCOMPARE(timeLeftText(240), QString("about 4 min left"));
    ProgressDisplay display;
    display.showProgress(-1);
    QVERIFY(!display.isHidden());
    QCOMPARE(display.bar()->maximum(), 0);
    display.showProgress(0.5, 12.0);
    QCOMPARE(display.bar()->value(), 500);
    QCOMPARE(display.timeText(), QString("about 15 s left"));
    display.finish();
    QVERIFY(display.isHidden());
  }

 private:
  LogPanel& openLog() {
    QTest::keyClick(window_.get(), Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier);
    LogPanel& panel = partOf<LogPanel>(*window_);
    if (!QTest::qWaitFor([&] { return panel.isVisible(); })) qFatal("the log did not open");
    return panel;
  }
  QStringList allTexts() {
    QStringList texts;
    for (const LoggedMessage& message : partOf<MessageLog>(*window_).messages()) texts << message.text;
    return texts;
  }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<EditorWindow> window_;
  QString table_;
};

FOOTFALL_EDITOR_SUITE(TestLogPanel)
#include "test_log_panel.moc"
