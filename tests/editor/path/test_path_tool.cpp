// "Try it" in the real window: by mouse, by keyboard, while dragging and while the result changes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <cmath>

#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "tests/editor/editor_driver.hpp"
#include "ui/path/path_feature.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

constexpr const char* kPipeline = "SlopeFilter 45\nVerticalClearanceFilter 2\nLayerSubdivisionFilter\n";

/// The floor with a thin wall across it that leaves a gap of 1, and a piece of floor that nothing leads to.
QByteArray roomObj() {
  return floorObj() +
         "v 0 -4 0\nv 0 3 0\nv 0 3 1\nv 0 -4 1\nf 5 6 7 8\n"
         "v 6 -2 0\nv 8 -2 0\nv 8 2 0\nv 6 2 0\nf 9 10 11 12\n";
}

}  // namespace

class TestPathTool : public EditorSuite {
  Q_OBJECT
 private slots:
  void init() {
    QVERIFY(openLevel(roomObj(), kPipeline));
    feature_ = window_->findChild<PathFeature*>();
    QVERIFY(feature_);
  }
  void cleanup() { closeWindow(); }

  void twoClicksShowThePath() {
    startTool();
    click({-2, -2, 0});
    QVERIFY(model().start() && !model().target());
    click({2, -2, 0});
    QVERIFY(waitForResult(PathStatus::Found));
    // The view picks with the precision of its floats.
    QVERIFY(std::fabs(model().result()->planLength - 2 * std::hypot(2, 5)) < 0.05);
    QCOMPARE(model().result()->bends.size(), 1U);
    QVERIFY(text("pathText").startsWith("Length 10.7"));
    QVERIFY2(text("pathText").contains("7.7 s at 1.4 m/s"), qPrintable(text("pathText")));
    shoot(*window_, "path-found");
    // One more click begins another path.
    click({-3, 3, 0});
    QVERIFY(model().start() && !model().target() && !model().result());
  }

  void whereItFailsIsShown() {
    startTool();
    click({2, 0, 0});
    click({7, 0, 0});
    QVERIFY(waitForResult(PathStatus::NotConnected));
    QVERIFY(std::fabs(model().result()->points.back().x - 4) < 1e-9);
    QVERIFY2(text("rowError", "pathPanel").contains("separate parts"), qPrintable(text("rowError", "pathPanel")));
    // The reason appears beside it, a little later.
    QTRY_VERIFY(model().result()->separation);
    QCOMPARE(model().result()->separation->barrier().gap, 2.0);
    QVERIFY2(text("pathSeparation").contains("nearest at x 4, y 0, z 0 units: a gap of 2 units."),
             qPrintable(text("pathSeparation")));
    shoot(*window_, "path-fails");
    const CameraPose pose = window_->view().cameraController().pose();
    press("pathShowSeparation");
    QTRY_VERIFY(!(window_->view().cameraController().pose().position == pose.position));
    QVERIFY(window_->view().project({5, 0, 0}));
    shoot(*window_, "path-separation");
    // Dragging to another place of the same part needs no new search; a way that leads there has none.
    model().setTarget(Vec3{7.5, 1, 0});
    QTRY_VERIFY(model().result()->to == (Vec3{7.5, 1, 0}));
    QVERIFY(model().result()->separation);
    model().setTarget(Vec3{-2, -2, 0});
    QVERIFY(waitForResult(PathStatus::Found));
    QVERIFY(text("pathSeparation").isEmpty());
  }

  void oneClickRaisesTheStep() {
    const QByteArray step =
        "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 4 0 0.5\nv 8 0 0.5\nv 8 4 0.5\nv 4 4 0.5\nf 1 2 3 4\nf 5 6 7 8\n"
        "f 2 5 8 3\n";
    QVERIFY(openZUp(*window_, writeFile(*folder_, "step.obj", step),
                    "SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.4\n"));
    startTool();
    model().setPlaces(Vec3{1, 2, 0}, Vec3{7, 2, 0.5});
    QVERIFY(waitForResult(PathStatus::NotConnected));
    QTRY_VERIFY(model().result()->separation);
    auto* mend = window_->findChild<QPushButton*>("pathMend");
    QTRY_VERIFY(mend->isVisible());
    QCOMPARE(mend->text(), QString("Raise Step to 0.51 units"));
    shoot(*window_, "path-mend");
    QTest::mouseClick(mend, Qt::LeftButton);
    QVERIFY(waitForResult(PathStatus::Found));
    QVERIFY(!mend->isVisible());
    QCOMPARE(partOf<Document>(*window_).filters()[2].step.values[0], 0.51);
    partOf<Document>(*window_).undoStack()->undo();
    QVERIFY(waitForResult(PathStatus::NotConnected));
  }

  void whatIsMendedIsTheBarrier() {
    LevelUnits units;
    units.metresPerUnit = 0.01;
    units.scaleKnown = true;
    Separation separation;
    BorderLink link;
    link.rise = -43.2;  // file units: centimetres
    link.excess = 3.2;
    const auto mend = [&](const std::string& pipeline, const BorderLink& barrier) {
      separation.links = {barrier};
      std::vector<FilterEntry> entries;
      for (const PipelineStep& one : parsePipeline(pipeline, "test").steps)
        entries.push_back({static_cast<int>(entries.size()) + 1, one});
      separation.step = 40;
      separation.height = 200;
      return mendOf(separation, entries, units);
    };
    const std::string pipeline = "VerticalClearanceFilter 200\nStepFilter 40\n";
    const auto raised = mend(pipeline, link);
    QVERIFY(raised);
    QCOMPARE(raised->filter, 2);
    QCOMPARE(raised->value, 44.0);
    QCOMPARE(raised->text, QString("Raise Step to 0.44 m"));
    QVERIFY(!mend("VerticalClearanceFilter 200\nStepFilter 44\n", link));  // allowed already
    QVERIFY(!mend("VerticalClearanceFilter 200\n#off StepFilter 40\n", link));
    // Something to be stepped over, higher than the step from floor to floor.
    link.kind = LinkKind::Obstacle;
    link.obstacle = 57;
    link.excess = 17;
    QCOMPARE(mend(pipeline, link)->value, 58.0);
    // Too low a ceiling.
    link.kind = LinkKind::LowCeiling;
    link.headroom = 181.5;
    QVERIFY(!mend(pipeline, link));  // and too high
    link.rise = 30;
    link.excess = 18.5;
    QCOMPARE(mend(pipeline, link)->filter, 1);
    QCOMPARE(mend(pipeline, link)->value, 181.0);
    QCOMPARE(mend(pipeline, link)->text, QString("Lower Clearance to 1.81 m"));
    QVERIFY(!mend("VerticalClearanceFilter 200\nVerticalClearanceFilter 190\nStepFilter 40\n", link));
    QVERIFY(!mend(pipeline + "RadiusFilter 30\n", link));  // the border is the radius's
    // A gap.
    link.kind = LinkKind::Open;
    link.gap = 12.3;
    link.excess = 12.3;
    QCOMPARE(mend(pipeline, link)->parameter, std::size_t{1});
    QCOMPARE(mend(pipeline, link)->value, 13.0);
    QCOMPARE(mend(pipeline, link)->text, QString("Raise Gap to 0.13 m"));
    for (const LinkKind kind : {LinkKind::Wall, LinkKind::Touch}) {
      link.kind = kind;
      QVERIFY(!mend(pipeline, link));
    }
  }

  void anEndIsDragged() {
    startTool();
    click({-2, -2, 0});
    click({-2, 2, 0});
    QVERIFY(waitForResult(PathStatus::Found));
    const double before = model().result()->planLength;
    const CameraPose pose = window_->view().cameraController().pose();
    QSignalSpy results(&model(), &PathModel::resultChanged);
    QTest::mousePress(&window_->view(), Qt::LeftButton, {}, at({-2, 2, 0}));
    for (int i = 0; i <= 8; ++i) {
      QTest::mouseMove(&window_->view(), at({-2 + 0.5 * i, 2, 0}));
      QTest::qWait(20);
    }
    QVERIFY(results.count() > 1);  // while it is dragged
    QTest::mouseRelease(&window_->view(), Qt::LeftButton, {}, at({2, 2, 0}));
    QVERIFY(waitForResult(PathStatus::Found));
    QVERIFY(std::fabs(model().target()->x - 2) < 0.05);
    QVERIFY(model().result()->planLength > before + 1);
    // The camera stayed where it was.
    QVERIFY(window_->view().cameraController().pose().position == pose.position);
  }

  void bothPlacesCanBeTyped() {
    window_->findChild<QAction*>("panel.path")->trigger();
    type("pathStart", {"-2", "-2", "0"});
    QVERIFY(model().start());
    type("pathTarget", {"2", "-2", "0"});
    QVERIFY(waitForResult(PathStatus::Found));
    QCOMPARE(model().result()->planLength, 2 * std::hypot(2, 5));
    // Text that is no number is marked, and the last place stays.
    QLineEdit* x = field("pathStartX");
    x->setFocus();
    QTest::keyClick(x, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(x, "1e");
    QVERIFY(x->property("invalid").toBool());
    QCOMPARE(model().start()->x, 1.0);  // the value of "1"
    QTest::keyClicks(x, "0");
    QVERIFY(!x->property("invalid").toBool());

    auto* speed = field("pathSpeed");
    speed->setFocus();
    QTest::keyClick(speed, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(speed, "0.5");
    QTRY_VERIFY(text("pathText").contains("at 0.5 m/s"));
    press("pathSwap");
    QCOMPARE(model().start()->x, 2.0);
    press("pathCopy");
    const QString copied = QApplication::clipboard()->text();
    QVERIFY2(copied.startsWith("Start x 2, y -2, z 0 units\nTarget x 1, y -2, z 0 units\nPlaces are"),
             qPrintable(copied));
    press("pathClear");
    QVERIFY(!model().start() && !model().target() && !model().result());
    QVERIFY(field("pathTargetZ")->text().isEmpty());
    QVERIFY(!button("pathSwap")->isEnabled());
  }

  void fieldsAreReachedByTab() {
    window_->findChild<QAction*>("panel.path")->trigger();
    field("pathStartX")->setFocus();
    QStringList order;
    for (int i = 0; i < 9; ++i) {
      order << QApplication::focusWidget()->objectName();
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    }
    QCOMPARE(order, (QStringList{"pathStartX", "pathStartY", "pathStartZ", "pathTargetX", "pathTargetY", "pathTargetZ",
                                 "pathRadius", "pathRadiusSlider", "pathSpeed"}));
    for (const char* name : {"pathStartX", "pathTargetZ", "pathSpeed"})
      QVERIFY(!field(name)->accessibleName().isEmpty() && !field(name)->toolTip().isEmpty());
  }

  void followsTheResult() {
    startTool();
    click({-2, -2, 0});
    click({2, -2, 0});
    QVERIFY(waitForResult(PathStatus::Found));
    DocumentState next = partOf<Document>(*window_).state();
    std::erase_if(next.filters,
                  [](const FilterEntry& e) { return e.step.filter->type == FilterType::VerticalClearance; });
    partOf<Document>(*window_).edit(next, "remove the clearance");
    QVERIFY(waitUntilIdle(*window_));
    QTRY_VERIFY(model().result() && model().result()->bends.empty());  // nothing stands in the way
    partOf<Document>(*window_).undoStack()->undo();
    QVERIFY(waitUntilIdle(*window_));
    QTRY_VERIFY(model().result() && model().result()->bends.size() == 1);
  }

  void escapeEndsAndKeysTakeBack() {
    startTool();
    click({-2, -2, 0});
    click({2, -2, 0});
    QTest::keyClick(&window_->view(), Qt::Key_Backspace);
    QVERIFY(model().start() && !model().target());
    QTest::keyClick(&window_->view(), Qt::Key_Backspace);
    QVERIFY(!model().start());
    QTest::keyClick(&window_->view(), Qt::Key_Escape);
    QCOMPARE(window_->view().tool(), nullptr);
    QVERIFY(!window_->findChild<QAction*>("tools.path")->isChecked());
    click({-2, -2, 0});
    QVERIFY(!model().start());
  }

  void sessionsKeepIt() {
    startTool();
    click({-2, -2, 0});
    click({2, -2, 0});
    const auto start = model().start(), target = model().target();
    const QString path = folder_->filePath("room.footfall");
    window_->saveSession(path);
    QVERIFY(waitUntilIdle(*window_));
    press("pathClear");
    window_->open(path);
    QVERIFY(QTest::qWaitFor([&] { return model().target().has_value(); }));
    QVERIFY(model().start() == start && model().target() == target);
    // Another environment has other places.
    QVERIFY(openZUp(*window_, writeFile(*folder_, "floor.obj", floorObj()), kPipeline));
    QVERIFY(!model().start() && !model().target());
  }

  void nothingIsWalkable() {
    QVERIFY(openZUp(*window_, writeFile(*folder_, "floor.obj", floorObj()), "SlopeFilter 45\nAreaFilter 1000\n"));
    startTool();
    click({-2, -2, 0});
    click({2, -2, 0});
    QVERIFY(waitForResult(PathStatus::NothingWalkable));
    QCOMPARE(text("rowError", "pathPanel"), QString("Nothing is walkable here."));
  }

  void emptyWindow() {
    EditorWindow empty;
    empty.setRemembering(false);
    empty.findChild<QAction*>("tools.path")->trigger();
    QVERIFY(empty.findChild<QLabel*>("pathText")->text().contains("Open an environment"));
  }

 private:
  PathModel& model() { return feature_->model(); }
  void startTool() {
    window_->view().cameraController().viewFromTop();
    QTest::keyClick(window_.get(), Qt::Key_P);
    QVERIFY(window_->findChild<QAction*>("tools.path")->isChecked());
    QVERIFY(window_->findChild<QDockWidget*>("panel.path")->isVisible());
    QTest::qWait(50);  // the panel takes its place from the view
  }
  QPoint at(const Vec3& place) { return placeInView(*window_, place); }
  void click(const Vec3& place) { clickInView(*window_, place); }
  bool waitForResult(PathStatus status) {
    return QTest::qWaitFor([&] { return !model().busy() && model().result() && model().result()->status == status; });
  }
  QString text(const char* name, const char* parent = "pathPanel") {
    return window_->findChild<QWidget*>(parent)->findChild<QLabel*>(name)->text();
  }
  QLineEdit* field(const char* name) { return window_->findChild<QLineEdit*>(name); }
  QPushButton* button(const char* name) { return window_->findChild<QPushButton*>(name); }
  void press(const char* name) {
    button(name)->setFocus();
    QTest::keyClick(button(name), Qt::Key_Space);
  }
  void type(const QString& id, const QStringList& values) {
    for (int i = 0; i < 3; ++i) {
      auto* edit = window_->findChild<QLineEdit*>(id + QStringList{"X", "Y", "Z"}[i]);
      edit->setFocus();
      QTest::keyClick(edit, Qt::Key_A, Qt::ControlModifier);
      QTest::keyClicks(edit, values[i]);
    }
  }
  /// Pictures are saved where a folder for them is given.

  PathFeature* feature_ = nullptr;
};

FOOTFALL_EDITOR_SUITE(TestPathTool)
#include "test_path_tool.moc"
