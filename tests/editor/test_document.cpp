// What is edited, without a window: undo, sessions, numbers, the background queue.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>

#include "tests/editor/editor_driver.hpp"
#include "ui/background_queue.hpp"

using namespace footfall;
using namespace footfall::test;

class TestDocument : public QObject {
  Q_OBJECT

 private slots:
  void everyEditCanBeUndone() {
    Document document;
    const Pipeline start = parsePipeline("SlopeFilter 45\nVerticalClearanceFilter 2\nAreaFilter 1\n", "test");
    document.reset(start, {});
    const auto id = [&](std::size_t row) { return document.filters()[row].id; };
    document.addFilter(*findFilter("LayerSubdivisionFilter"), 1);
    document.moveFilter(id(0), 2);
    document.setEnabled(id(1), false);
    document.setValue(id(2), 0, 30, 1);
    document.removeFilter(id(0));
    ImportOptions options;
    options.up = UpAxis::Z;
    document.setImportAndPipeline(options, document.pipeline(), "import");
    const Pipeline end = document.pipeline();
    QCOMPARE(document.undoStack()->count(), 6);
    while (document.undoStack()->canUndo()) document.undoStack()->undo();
    QCOMPARE(document.pipeline(), start);
    QVERIFY(!document.state().import.up.has_value());
    while (document.undoStack()->canRedo()) document.undoStack()->redo();
    QCOMPARE(document.pipeline(), end);
    QVERIFY(document.state().import.up == UpAxis::Z);
  }

  void typingIsOneEditAndTypingBackIsNone() {
    Document document;
    document.reset(parsePipeline("SlopeFilter 45\n", "test"), {});
    const int id = document.filters()[0].id;
    for (const double value : {4.0, 40.0, 40.5}) document.setValue(id, 0, value, 7);
    QCOMPARE(document.undoStack()->count(), 1);
    document.setValue(id, 0, 45, 7);
    QCOMPARE(document.undoStack()->count(), 0);
    document.setValue(id, 0, 45, 8);  // the value that it has
    QCOMPARE(document.undoStack()->count(), 0);
    document.setValue(id, 0, 30, 8);
    document.setValue(id, 0, 20, 9);  // left and entered again
    QCOMPARE(document.undoStack()->count(), 2);
  }

  void onlyDefaultsFollowTheScale() {
    const Pipeline pipeline =
        parsePipeline("VerticalClearanceFilter 2\nVerticalClearanceFilter 1.8\nAreaFilter 1\n", "test");
    const Pipeline rescaled = rescaleDefaults(pipeline, 1, 0.05);
    QCOMPARE(rescaled.steps[0].values[0], 40.0);
    QCOMPARE(rescaled.steps[1].values[0], 1.8);
    QCOMPARE(rescaled.steps[2].values[0], 400.0);
    QCOMPARE(rescaleDefaults(rescaled, 0.05, 1), pipeline);
  }

  void numbersAreTakenAsTyped() {
    QCOMPARE(parseNumber("0.1").value(), 0.1);
    QCOMPARE(parseNumber(" 1e-3 ").value(), 1e-3);
    QCOMPARE(parseNumber("+5").value(), 5.0);
    QCOMPARE(parseNumber("122000.123456789").value(), 122000.123456789);
    for (const char* text : {"", "abc", "1,5", "1.5m", "0x10", "--1", "+-1"}) QVERIFY2(!parseNumber(text), text);
  }

  void sessionsKeepEveryNumber() {
    const QTemporaryDir folder;
    Session session;
    session.environment = folder.filePath("level.obj").toStdString();
    session.import.up = UpAxis::Y;
    session.import.metresPerUnit = 0.1;
    session.import.bothSides = true;
    session.pipeline = parsePipeline("#off SlopeFilter 44.99999999999999\nSimplificationFilter true 1e-7\n", "test");
    session.camera = CameraPose{{122000.123, 487000.456, 7}, {1.0 / 3, 2, 3}, {0, 0.6, 0, 0.8}, true};
    const std::string path = folder.filePath("a.footfall").toStdString();
    const std::string text = formatSession(session, path);
    writeFile(folder, "a.footfall", QByteArray::fromStdString(text));
    QVERIFY(isSessionFile(path));
    const Session back = readSession(path);
    QCOMPARE(back.environment, session.environment);
    QVERIFY(sameImport(back.import, session.import));
    QCOMPARE(back.pipeline, session.pipeline);
    QVERIFY(back.camera->position == session.camera->position && back.camera->pivot == session.camera->pivot);
    QCOMPARE(back.camera->orientation, session.camera->orientation);
    QCOMPARE(formatSession(back, path), text);
  }

  void badSessionsAreOneLineWithTheFile_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("broken") << QByteArray("{\"footfall_session\": 1,");
    QTest::newRow("no session") << QByteArray("{}");
    QTest::newRow("newer") << QByteArray("{\"footfall_session\": 2, \"pipeline\": []}");
    QTest::newRow("no pipeline") << QByteArray("{\"footfall_session\": 1}");
    QTest::newRow("unknown filter") << QByteArray(
        "{\"footfall_session\": 1, \"pipeline\": [{\"filter\": \"NoFilter\"}]}");
    QTest::newRow("out of range") << QByteArray(
        "{\"footfall_session\": 1, \"pipeline\": [{\"filter\": \"SlopeFilter\", \"parameters\": {\"max_slope\": "
        "90}}]}");
    QTest::newRow("wrong type") << QByteArray("{\"footfall_session\": 1, \"pipeline\": 3}");
    QTest::newRow("bad scale") << QByteArray(
        "{\"footfall_session\": 1, \"import\": {\"metres_per_unit\": 0}, \"pipeline\": []}");
  }
  void badSessionsAreOneLineWithTheFile() {
    QFETCH(QByteArray, content);
    const QTemporaryDir folder;
    const std::string path = writeFile(folder, "bad.footfall", content).toStdString();
    try {
      readSession(path);
      QFAIL("a bad session was read");
    } catch (const InputError& error) {
      const QString message = error.what();
      QVERIFY2(message.startsWith(QString::fromStdString(path)), error.what());
      QVERIFY(!message.contains('\n'));
      QVERIFY2(message.contains("; "), error.what());
    }
  }

  void queuesDropOrFinishWhatIsLeft() {
    for (const auto atEnd : {BackgroundQueue::AtEnd::DropJobs, BackgroundQueue::AtEnd::FinishJobs}) {
      std::atomic<bool> go{false};
      std::atomic<int> done{0};
      std::thread opener;
      {
        BackgroundQueue queue(atEnd);
        std::atomic<bool> begun{false};
        queue.post([&] {
          begun = true;
          while (!go) std::this_thread::yield();
          ++done;
        });
        for (int i = 0; i < 5; ++i) queue.post([&] { ++done; });
        while (!begun) std::this_thread::yield();
        opener = std::thread([&] {
          std::this_thread::sleep_for(std::chrono::milliseconds(50));
          go = true;
        });
      }
      opener.join();
      QCOMPARE(done.load(), atEnd == BackgroundQueue::AtEnd::FinishJobs ? 6 : 1);
    }
  }
};

QTEST_GUILESS_MAIN(TestDocument)
#include "test_document.moc"
