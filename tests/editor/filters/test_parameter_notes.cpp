// Hints about filters that do not suit the level.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/base/messages/message_bar.hpp"

using namespace footfall;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

/// Nine treads, each 0.25 above the one before, with risers between them.
QByteArray stairsObj() {
  QByteArray text;
  int vertices = 0;
  const auto face = [&](double x0, double z0, double x1, double z1) {
    for (const auto& [x, y, z] : {std::array{x0, 0.0, z0},
                                  {x1, x0 == x1 ? 2.0 : 0.0, x0 == x1 ? z0 : z1},
                                  {x1, 2.0, z1},
                                  {x0, x0 == x1 ? 0.0 : 2.0, x0 == x1 ? z1 : z0}})
      text += "v " + QByteArray::number(x) + ' ' + QByteArray::number(y) + ' ' + QByteArray::number(z) + '\n';
    text += "f";
    for (int i = 1; i <= 4; ++i) text += ' ' + QByteArray::number(vertices + i);
    text += '\n';
    vertices += 4;
  };
  for (int i = 0; i < 9; ++i) {
    face(i, 0.25 * i, i + 1, 0.25 * i);
    if (i > 0) face(i, 0.25 * (i - 1), i, 0.25 * i);
  }
  return text;
}

}  // namespace

class TestParameterNotes : public QObject {
  Q_OBJECT

 private slots:
  void stepsThatMissTheRisersAreTold() {
    const QTemporaryDir folder;
    EditorWindow window;
    QVERIFY(showWindow(window));
    QVERIFY(openZUp(window, writeFile(folder, "stairs.obj", stairsObj()),
                    "SlopeFilter 45\nVerticalClearanceFilter 0.85\nStepFilter 0.245\n"));
    const QString expected =
        "Steps: most risers here are 0.25 high, a little more than the step, and are not climbed; give 0.26";
    QTRY_COMPARE(partOf<MessageBar>(window).text(), expected);
    const int id = partOf<Document>(window).filters()[2].id;
    partOf<Document>(window).setValue(id, 0, 0.26, 1);
    QVERIFY(waitUntilIdle(window));
    QTRY_COMPARE(partOf<MessageBar>(window).text(), QString());
    partOf<Document>(window).undoStack()->undo();
    QTRY_COMPARE(partOf<MessageBar>(window).text(), expected);
    partOf<Document>(window).setValue(partOf<Document>(window).filters()[0].id, 0, 40, 2);  // reported once
    QVERIFY(waitUntilIdle(window));
    QTest::qWait(100);
    QCOMPARE(partOf<MessageBar>(window).text(), QString());
  }

  // Ramps of 45 degrees, steeper by a rounding: one click on the hint, one step of undo.
  void oneClickTakesRampsJustBeyondTheSlope() {
    const QTemporaryDir folder;
    EditorWindow window;
    QVERIFY(showWindow(window));
    const QByteArray ramp =
        "v 0 0 0\nv 100 0 100.001\nv 100 20 100.001\nv 0 20 0\nf 1 2 3\nf 1 3 4\n"
        "v 0 20 0\nv 100 20 0\nv 100 40 0\nv 0 40 0\nf 5 6 7\nf 5 7 8\n";
    QVERIFY(openZUp(window, writeFile(folder, "ramp.obj", ramp), "SlopeFilter 45 0\nVerticalClearanceFilter 2\n"));
    QTRY_VERIFY(partOf<MessageBar>(window).text().contains("steeper than 45 degrees by less than 0.0003 degrees"));
    const auto area = [&window] { return window.controller().finishedRun()->result.summary.area; };
    const double before = area();
    QPushButton* set = nullptr;
    for (auto* button : partOf<MessageBar>(window).findChildren<QPushButton*>())
      if (button->isVisible()) set = button;
    QVERIFY(set);
    QVERIFY2(set->text().endsWith("to 0.0003"), qPrintable(set->text()));
    set->click();
    QCOMPARE(partOf<Document>(window).filters()[0].step.values[1], 0.0003);
    QVERIFY(waitUntilIdle(window));
    QVERIFY(area() > before + 2800);
    QVERIFY(partOf<MessageBar>(window).text().isEmpty());
    partOf<Document>(window).undoStack()->undo();
    QCOMPARE(partOf<Document>(window).filters()[0].step.values[1], 0.0);
    QVERIFY(waitUntilIdle(window));
  }

  // A run of such a level may take long, so the hint does not wait for it, nor for the measures.
  void aLevelSmallerThanItsAgentsIsToldWhenItIsOpened() {
    const QTemporaryDir folder;
    EditorWindow window;
    QVERIFY(showWindow(window));
    QString atOnce;
    connect(&window.file(), &LevelFile::opened, this, [&] { atOnce = partOf<MessageBar>(window).text(); });
    ImportOptions import;
    import.up = UpAxis::Z;
    import.metresPerUnit = 0.01;
    window.openWith(writeFile(folder, "floor.obj", floorObj()),
                    parsePipeline("SlopeFilter 45\nVerticalClearanceFilter 200\n", "test"), import);
    QVERIFY(waitUntilIdle(window));
    QVERIFY2(atOnce.contains("the whole level is no larger than 0.08 m"), qPrintable(atOnce));
    QTest::qWait(200);
    QCOMPARE(partOf<MessageBar>(window).text(), atOnce);
  }

  void oneClickSetsTheScale() {
    const QTemporaryDir folder;
    EditorWindow window;
    QVERIFY(showWindow(window));
    ImportOptions import;
    import.up = UpAxis::Z;
    import.metresPerUnit = 1;
    window.openWith(writeFile(folder, "floor.obj", floorObj()),
                    parsePipeline("SlopeFilter 45\nVerticalClearanceFilter 2\n", "test"), import);
    QVERIFY(waitUntilIdle(window));
    QTRY_VERIFY(partOf<MessageBar>(window).text().contains("less than ten times an agent's height"));
    for (auto* button : partOf<MessageBar>(window).findChildren<QPushButton*>())
      if (button->isVisible()) button->click();
    QVERIFY(waitUntilIdle(window));
    QCOMPARE(partOf<Document>(window).state().import.metresPerUnit, std::optional(10.0));
  }
};

FOOTFALL_EDITOR_SUITE(TestParameterNotes)
#include "test_parameter_notes.moc"
