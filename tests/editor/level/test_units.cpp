// Metres, feet and the file's units in the window, and one frame for places in all panels.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLabel>
#include <QPushButton>
#include <QSettings>

#include "footfall/up_axis.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/base/text/localized_numbers.hpp"
#include "ui/filters/filter_list.hpp"
#include "ui/inspect/inspection_feature.hpp"
#include "ui/inspect/measure_panel.hpp"
#include "ui/level/import_panel.hpp"
#include "ui/level/obstacle_features.hpp"
#include "ui/path/path_feature.hpp"
#include "ui/view/camera/camera_tools.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

constexpr const char* kPipeline = "SlopeFilter 45\nVerticalClearanceFilter 2\nLayerSubdivisionFilter\n";

/// The floor of floorObj() in a file with another axis up.
QByteArray floorObj(UpAxis up) {
  QByteArray text;
  for (const Vec3& corner : {Vec3{-4, -4, 0}, Vec3{4, -4, 0}, Vec3{4, 4, 0}, Vec3{-4, 4, 0}}) {
    const Vec3 p = inFileFrame(corner, up);
    text += "v " + QByteArray::number(p.x) + ' ' + QByteArray::number(p.y) + ' ' + QByteArray::number(p.z) + '\n';
  }
  return text + "f 1 2 3\nf 1 3 4\n";
}

}  // namespace

class TestUnits : public QObject {
  Q_OBJECT
 private slots:
  void init() {
    QSettings().clear();
    folder_ = std::make_unique<QTemporaryDir>();
    window_ = std::make_unique<EditorWindow>();
    window_->setRemembering(false);
    window_->resize(1280, 800);
    QVERIFY(showWindow(*window_));
  }
  void cleanup() {
    window_.reset();
    folder_.reset();
  }

  void onePlaceIsTheSameInAllPanels_data() {
    QTest::addColumn<int>("up");
    QTest::addColumn<double>("scale");
    for (const UpAxis up : kUpAxes) QTest::newRow(shownName(up).c_str()) << static_cast<int>(up) << 0.0;
    QTest::newRow("Y up, inches") << static_cast<int>(UpAxis::Y) << 0.0254;
    QTest::newRow("Z up, metres") << static_cast<int>(UpAxis::Z) << 1.0;
  }
  void onePlaceIsTheSameInAllPanels() {
    QFETCH(int, up);
    QFETCH(double, scale);
    const UpAxis axis = static_cast<UpAxis>(up);
    QVERIFY(open(floorObj(axis), axis, scale));
    window_->view().cameraController().viewFromTop();
    // Their panels share the window with the view: all of them first.
    for (const char* command : {"tools.path", "inspect.why", "tools.measure"})
      window_->findChild<QAction*>(command)->trigger();
    QTest::qWait(100);
    const QPoint at = window_->view().project({2, -1, 0})->toPoint();
    const LevelUnits& units = partOf<UnitChoice>(*window_).units();

    useTool("tools.path", at);
    const Vec3 start = window_->findChild<PathFeature*>()->model().start().value();
    const QString expected = units.place(start);
    QStringList fields;
    for (const char* name : {"pathStartX", "pathStartY", "pathStartZ"})
      fields << window_->findChild<QLineEdit*>(name)->text();
    QCOMPARE(listText(fields), units.placeNumbers(start));
    // The file's coordinates, in the shown unit.
    const Vec3 file = inFileFrame(start, axis);
    QCOMPARE(parseNumber(fields[1]).value(), parseNumber(measureText(file.y * units.factor())).value());

    useTool("inspect.why", at);
    auto* why = window_->findChild<QLabel*>("whyPlace");
    QTRY_COMPARE(why->text(), expected);
    useTool("tools.measure", at);
    QCOMPARE(window_->findChild<QLabel*>("measureSum")->text(), "From " + expected);
    // Each panel shows the unit of its places.
    for (const char* name : {"pathFrame", "whyFrame", "measureFrame", "obstacleFrame", "componentsFrame"}) {
      const QString frame = window_->findChild<QLabel*>(name)->text();
      QCOMPARE(frame, units.frameText());
      QVERIFY2(frame.contains(QString::fromStdString(shownName(axis)) + " up"), qPrintable(frame));
    }

    // An obstacle that stands there has the same numbers in its fields and beside it.
    PlacedObstacle box;
    box.base = start;
    box.size = {1, 1, 1};
    auto& editor = window_->findChild<ObstacleFeatures*>()->editor();
    editor.add(box);
    auto* panel = window_->findChild<ObstaclePanel*>();
    for (std::size_t i = 0; i < 3; ++i)
      QCOMPARE(measureText(parseNumber(panel->field(i)->text()).value()), fields[static_cast<int>(i)]);

    // Typed back, it is the same place.
    PlaceFields other("Other", "other");
    other.setUnits(units);
    std::optional<Vec3> typed;
    connect(&other, &PlaceFields::edited, this, [&](const Vec3& place) { typed = place; });
    for (std::size_t i = 0; i < 3; ++i) QTest::keyClicks(other.field(i), fields[static_cast<int>(i)]);
    QVERIFY(typed.has_value());
    QCOMPARE(units.place(*typed), expected);
    for (std::size_t i = 0; i < 3; ++i) QCOMPARE(other.field(i)->text(), fields[static_cast<int>(i)]);
  }

  void theGizmoShowsTheFilesAxes() {
    auto* gizmo = window_->findChild<AxisGizmo*>("axisGizmo");
    const auto sideOf = [&](const QString& letter) {
      for (const AxisGizmo::End& end : gizmo->ends())
        if (end.letter == letter) return end.side;
      return ViewSide::Bottom;
    };
    QVERIFY(open(floorObj(UpAxis::Y), UpAxis::Y, 0));
    QCOMPARE(sideOf("Y"), ViewSide::Top);
    QCOMPARE(sideOf("Z"), ViewSide::Front);
    QCOMPARE(sideOf("X"), ViewSide::Right);
    QVERIFY(open(floorObj(UpAxis::Z), UpAxis::Z, 0));
    QCOMPARE(sideOf("Z"), ViewSide::Top);
    QCOMPARE(sideOf("Y"), ViewSide::Back);
  }

  void oneClickConfirmsAGuess() {
    QVERIFY(open(floorObj(UpAxis::Z), UpAxis::Z, 0));
    ImportPanel& panel = partOf<ImportPanel>(*window_);
    QCOMPARE(field()->text(), QString("2"));
    QCOMPARE(rowOfClearance()->unitOf(0), QString("units"));
    QVERIFY(figures().contains("units"));
    QVERIFY(panel.yesButton()->isVisible());
    QCOMPARE(panel.questionText(), QString("1 unit = 1 m?"));
    panel.yesButton()->setFocus();
    QTest::mouseClick(panel.yesButton(), Qt::LeftButton);
    QVERIFY(!panel.yesButton()->isVisible());
    QVERIFY(window_->view().hasFocus());  // and not the next button, which Space would press
    QCOMPARE(rowOfClearance()->unitOf(0), QString("m"));
    QVERIFY2(figures().contains(QString::fromUtf8("8 × 8 × 0 m")), qPrintable(figures()));
    QVERIFY(summary().contains(QString::fromUtf8("area 64.00 m²")));
    QVERIFY(!window_->controller().busy());  // nothing is computed again
    partOf<Document>(*window_).undoStack()->undo();
    QVERIFY(panel.yesButton()->isVisible());
    QVERIFY(summary().contains(QString::fromUtf8("area 64.00 units²")));
  }

  void lengthsAreShownAndTypedInMetres() {
    QVERIFY(open(floorObj(UpAxis::Z), UpAxis::Z, 0.0254));
    QCOMPARE(rowOfClearance()->unitOf(0), QString("m"));
    QCOMPARE(field()->text(), QString("0.0508"));  // the pipeline's own 2 units
    field()->setFocus();
    field()->selectAll();
    QTest::keyClicks(field(), "2.5");
    QCOMPARE(partOf<Document>(*window_).filters()[1].step.values[0], 98.4251968504);
    QVERIFY2(field()->help().contains("98.4251968504"), qPrintable(field()->help()));
    QVERIFY(partOf<Document>(*window_).undoStack()->undoText().contains("2.5"));
    // The value in feet is the same.
    partOf<UnitChoice>(*window_).choose(LengthUnit::Feet);
    QCOMPARE(rowOfClearance()->unitOf(0), QString("ft"));
    QVERIFY(field()->text().startsWith("8.2020997"));
    QCOMPARE(partOf<Document>(*window_).filters()[1].step.values[0], 98.4251968504);
    window_->findChild<QAction*>("view.lengths.millimetres")->trigger();
    QCOMPARE(rowOfClearance()->unitOf(0), QString("mm"));
    QCOMPARE(field()->text(), QString("2500"));
    field()->setFocus();
    field()->selectAll();
    QTest::keyClicks(field(), "2540");
    QCOMPARE(partOf<Document>(*window_).filters()[1].step.values[0], 100.0);
    field()->selectAll();
    QTest::keyClicks(field(), "2500");
    partOf<UnitChoice>(*window_).choose(LengthUnit::FileUnits);
    QCOMPARE(field()->text(), QString("98.4251968504"));
    // The choice is kept for the next window.
    EditorWindow other;
    QCOMPARE(partOf<UnitChoice>(other).units().wanted, LengthUnit::FileUnits);
  }

  void anotherScaleKeepsTheMetres() {
    QVERIFY(open(floorObj(UpAxis::Z), UpAxis::Z, 1));
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[1].id, 0, 2.54, -1);
    ImportOptions import;
    import.up = UpAxis::Z;
    import.metresPerUnit = 0.0254;
    window_->openWith(writeFile(*folder_, "inches.obj", floorObj(UpAxis::Z)), std::nullopt, import);
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(partOf<Document>(*window_).filters()[1].step.values[0], 100.0);
    QCOMPARE(field()->text(), QString("2.54"));
    // A change of a known scale converts lengths as well; after a change of a guess, only defaults follow.
    ImportOptions centimetres = partOf<Document>(*window_).state().import;
    centimetres.metresPerUnit = 0.01;
    emit partOf<ImportPanel>(*window_).optionsEdited(centimetres);
    QCOMPARE(partOf<Document>(*window_).filters()[1].step.values[0], 254.0);
  }

  void glTFIsInMetres() {
    ImportOptions import;
    window_->openWith(QStringLiteral(FOOTFALL_SOURCE_DIR "/tests/data/transforms.gltf"), parsePipeline(kPipeline, "t"),
                      import);
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(window_->file().environment() && !window_->file().environment()->scaleGuessed);
    QCOMPARE(rowOfClearance()->unitOf(0), QString("m"));
    QVERIFY(!partOf<ImportPanel>(*window_).yesButton()->isVisible());
  }

  void sessionsKeepUnitAndScale() {
    QVERIFY(open(floorObj(UpAxis::Z), UpAxis::Z, 0));
    QTest::mouseClick(partOf<ImportPanel>(*window_).yesButton(), Qt::LeftButton);
    partOf<UnitChoice>(*window_).useForSession(LengthUnit::Feet);
    const QString path = folder_->filePath("level.footfall");
    window_->saveSession(path);
    QVERIFY(waitUntilIdle(*window_));
    EditorWindow other;
    other.setRemembering(false);
    other.open(path);
    QVERIFY(waitUntilIdle(other));
    QCOMPARE(partOf<UnitChoice>(other).units().unit(), LengthUnit::Feet);
    QVERIFY(QSettings().value("lengthUnit").isNull());
    // Sessions of older versions have none of it.
    QByteArray old = readFile(path);
    const auto from = old.indexOf("\"units\"");
    QVERIFY(from > 0);
    old.replace("\"units\"", "\"other\"").replace("\"metres_per_unit\"", "\"elsewhere\"");
    const QString oldPath = writeFile(*folder_, "old.footfall", old);
    other.open(oldPath);
    QVERIFY(waitUntilIdle(other));
    QCOMPARE(partOf<UnitChoice>(other).units().unit(), LengthUnit::FileUnits);
    QCOMPARE(partOf<UnitChoice>(other).units().wanted, LengthUnit::Metres);
  }

  void enterAndEscapeGiveTheKeysBack() {
    QVERIFY(open(floorObj(UpAxis::Z), UpAxis::Z, 0));
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Escape}) {
      field()->setFocus();
      field()->selectAll();
      QTest::keyClicks(field(), "1.5");
      QVERIFY(waitUntilIdle(*window_));  // else Escape cancels the run
      QTest::keyClick(field(), key);
      QVERIFY(window_->view().hasFocus());
      QCOMPARE(partOf<Document>(*window_).filters()[1].step.values[0], 1.5);
    }
    window_->findChild<QAction*>("tools.path")->trigger();
    auto* place = window_->findChild<QLineEdit*>("pathStartX");
    place->setFocus();
    QTest::keyClick(place, Qt::Key_Return);
    QVERIFY(window_->view().hasFocus());
    // A wrong value stays where it can be corrected.
    field()->setFocus();
    field()->selectAll();
    QTest::keyClicks(field(), "x");
    QTest::keyClick(field(), Qt::Key_Return);
    QVERIFY(field()->hasFocus());
  }

  void aDragOnTheNameChangesTheValue() {
    QVERIFY(open(floorObj(UpAxis::Z), UpAxis::Z, 0));
    QLabel* name = nullptr;
    for (QLabel* label : rowOfClearance()->findChildren<QLabel*>())
      if (label->buddy() == field()) name = label;
    QVERIFY(name);
    const QPoint at = name->rect().center();
    QTest::mousePress(name, Qt::LeftButton, {}, at);
    QVERIFY(field()->hasFocus());
    for (int x = 4; x <= 40; x += 4) QTest::mouseMove(name, at + QPoint(x, 0));
    QTest::mouseRelease(name, Qt::LeftButton, {}, at + QPoint(40, 0));
    QCOMPARE(partOf<Document>(*window_).filters()[1].step.values[0], 3.0);
    QVERIFY(partOf<FilterList>(*window_).selection().contains(rowOfClearance()->entryId()));
  }

  void longNumbersShowTheirBeginning() {
    QVERIFY(open(floorObj(UpAxis::Z), UpAxis::Z, 0));
    field()->setFocus();
    field()->selectAll();
    QTest::keyClicks(field(), "2.12345678901234");
    QTest::keyClick(field(), Qt::Key_Return);
    QCOMPARE(field()->cursorPosition(), 0);
    QVERIFY(field()->help().contains("2.12345678901234"));
    partOf<Document>(*window_).undoStack()->undo();
    partOf<Document>(*window_).undoStack()->redo();
    QCOMPARE(field()->text(), QString("2.12345678901234"));
    QCOMPARE(field()->cursorPosition(), 0);
  }

 private:
  bool open(const QByteArray& obj, UpAxis up, double metresPerUnit) {
    ImportOptions import;
    import.up = up;
    if (metresPerUnit > 0) import.metresPerUnit = metresPerUnit;
    const QString name = QStringLiteral("level%1.obj").arg(++files_);
    window_->openWith(writeFile(*folder_, name, obj), parsePipeline(kPipeline, "test"), import);
    return waitUntilIdle(*window_) && window_->controller().finishedRun() != nullptr;
  }
  void useTool(const char* command, const QPoint& at) {
    window_->findChild<QAction*>(command)->trigger();
    QTest::qWait(50);
    QTest::mouseMove(&window_->view(), at);
    QTest::mouseClick(&window_->view(), Qt::LeftButton, {}, at);
  }
  FilterRow* rowOfClearance() { return partOf<FilterList>(*window_).rows()[1]; }
  NumberField* field() {
    if (!rowOfClearance()->isOpen()) partOf<FilterList>(*window_).choose({rowOfClearance()->entryId()});
    return qobject_cast<NumberField*>(rowOfClearance()->field(0));
  }
  QString figures() { return window_->findChild<QLabel*>("environmentFigures")->text(); }
  QString summary() { return window_->findChild<StatusLine*>()->state(); }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<EditorWindow> window_;
  int files_ = 0;
};

FOOTFALL_EDITOR_SUITE(TestUnits)
#include "test_units.moc"
