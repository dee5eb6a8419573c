// The meaning of a filter's values, drawn in the view, and handles that change them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QEnterEvent>
#include <cmath>

#include "core/base/vector.hpp"
#include "core/mesh/clearance_field.hpp"
#include "core/pipeline/runner.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/filters/filter_list.hpp"
#include "ui/filters/parameter_handles.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

/// A floor of 8 x 8 at 0, a second one behind a riser of 0.3 at x = 4, and a third one over a gap of 0.1 at x = -4.
QByteArray stairObj() {
  return floorObj() +
         "v 4 -4 0.3\nv 8 -4 0.3\nv 8 4 0.3\nv 4 4 0.3\nf 5 6 7 8\nf 2 3 8 5\n"
         "v -8 -4 0\nv -4.1 -4 0\nv -4.1 4 0\nv -8 4 0\nf 9 10 11 12\n";
}

constexpr const char* kPipeline =
    "SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.4 0.2\nRadiusFilter 0.5\nAreaFilter 0\n";
enum Row : std::size_t { Slope, Clearance, Step, Radius, Area };

}  // namespace

class TestParameterHandles : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    window_ = std::make_unique<EditorWindow>();
    window_->setRemembering(false);
    window_->resize(1280, 800);
    QVERIFY(showWindow(*window_));
    QVERIFY(openZUp(*window_, writeFile(folder_, "stair.obj", stairObj()), kPipeline));
    handles_ = window_->findChild<ParameterHandles*>();
    QVERIFY(handles_);
    // Upright handles can be taken, and all floors are in sight.
    window_->view().cameraController().viewOblique();
    QTest::qWait(250);
  }
  void cleanup() { window_.reset(); }

  void theCurrentRowShowsItsMeasures() {
    QVERIFY(handles_->measures().empty());
    choose(Slope);
    QCOMPARE(handles_->measures().size(), std::size_t{1});
    QVERIFY(handles_->measures()[0].kind == MeasureKind::Angle);
    choose(Clearance);
    QCOMPARE(handles_->measures().size(), std::size_t{1});
    QVERIFY(handles_->measures()[0].kind == MeasureKind::Height);
    choose(Area);
    QVERIFY(handles_->measures().empty());
    choose(Radius);
    QCOMPARE(handles_->measures().size(), std::size_t{1});  // ledges keep the same distance
    partOf<Document>(*window_).setValue(id(Radius), 1, 0.25, 1);
    QCOMPARE(handles_->measures().size(), std::size_t{2});
    partOf<Document>(*window_).setEnabled(id(Radius), false);
    QVERIFY(handles_->measures().empty());
  }

  void stepsAndGapsAreShownAtLinks() {
    choose(Step);
    QCOMPARE(handles_->measures().size(), std::size_t{2});
    const ParameterMeasure step = handles_->measures()[0], gap = handles_->measures()[1];
    QCOMPARE(step.at.x, 4.0);
    QCOMPARE(step.at.z, 0.0);  // starts at the lower floor
    QVERIFY2(step.text.contains("0.4") && step.text.contains("here 0.3"), qPrintable(step.text));
    QVERIFY(std::abs(std::abs(gap.at.x + 4.05) - 0.05) < 1e-9 && std::abs(std::abs(gap.along.x) - 1) < 1e-9);
    QVERIFY2(gap.text.contains("0.2") && gap.text.contains("here 0.1"), qPrintable(gap.text));
    shoot(*window_, "step-measures");
  }

  void aHandleChangesItsValue() {
    choose(Clearance);
    const ParameterMeasure measure = handles_->measures()[0];
    const int edits = partOf<Document>(*window_).undoStack()->count();
    dragHandle(0, measure.at + Vec3{0, 0, 1.5});
    // A pixel of this view is two centimetres, and values are rounded to one.
    QVERIFY2(std::abs(value(Clearance) - 1.5) < 0.025, qPrintable(QString::number(value(Clearance))));
    QCOMPARE(value(Clearance), std::round(value(Clearance) * 100) / 100);
    QCOMPARE(partOf<Document>(*window_).undoStack()->count(), edits + 1);  // one edit
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(window_->controller().finishedRun()->pipeline.steps[Clearance].values[0], value(Clearance));
    partOf<Document>(*window_).undoStack()->undo();
    QCOMPARE(value(Clearance), 2.0);
  }

  void aClickOnAHandleEditsNothing() {
    partOf<Document>(*window_).setValue(id(Clearance), 0, 1.987654321, 1);
    QVERIFY(waitUntilIdle(*window_));
    choose(Clearance);
    const int edits = partOf<Document>(*window_).undoStack()->count();
    const Vec3 handle = handles_->measures()[0].handle();
    press(handle);
    release(handle);
    QCOMPARE(value(Clearance), 1.987654321);
    QCOMPARE(partOf<Document>(*window_).undoStack()->count(), edits);
  }

  void anAngleIsTurned() {
    choose(Slope);
    const ParameterMeasure measure = handles_->measures()[0];
    ParameterMeasure wanted = measure;
    wanted.value = 20;
    dragHandle(0, wanted.handle());
    QVERIFY2(std::abs(value(Slope) - 20) <= 1, qPrintable(QString::number(value(Slope))));
    shoot(*window_, "slope-measure");
  }

  void aRadiusTakesLedgesAlongAndStopsAtItsRange() {
    choose(Radius);
    const ParameterMeasure measure = handles_->measures()[0];
    dragHandle(0, measure.at + 0.9 * measure.along);
    QVERIFY2(std::abs(value(Radius) - 0.9) <= 0.03, qPrintable(QString::number(value(Radius))));
    QCOMPARE(value(Radius, 1), value(Radius));
    shoot(*window_, "radius-measure");
    const ParameterMeasure now = handles_->measures()[0];
    dragHandle(0, now.at - 2.0 * now.along);
    QCOMPARE(value(Radius), 0.0);
  }

  void aDraggedRadiusIsShownBeforeItsRun() {
    choose(Radius);
    QTRY_VERIFY_WITH_TIMEOUT(window_->controller().previews(id(Radius)), 20000);
    const std::string head = "SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.4 0.2\n";
    RunContext context;
    const auto before =
        runPipeline(window_->controller().finishedRun()->environment, parsePipeline(head, "test"), context).mesh;
    const ClearanceField field(*before);
    const Vec3 centre{0, 0, 0.15};  // of the level
    EditPreview::Surfaces shown;
    connect(&window_->controller(), &RunController::contentReady, this, [&](const ViewContent& content) {
      if (!content.changes.empty()) shown = content.changes;
    });
    const ParameterMeasure measure = handles_->measures()[0];
    press(measure.handle());
    for (const double radius : {0.7, 0.9, 0.3}) {
      shown.clear();
      move(measure.at + radius * measure.along);
      // It is shown within the event of the mouse, before any run.
      QVERIFY(!shown.empty());
      const double now = value(Radius);
      QVERIFY2(std::abs(now - radius) <= 0.03, qPrintable(QString::number(now)));
      // Middles of the removed triangles are nearer than the radius to a border of their face.
      std::size_t found = 0;
      const auto& surface = shown.back()->surface;
      for (std::size_t v = 0; v < surface.size(); v += 3) {
        Vec3 middle = centre;
        for (std::size_t k = 0; k < 3; ++k) {
          const auto& p = surface[v + k].position;
          middle = middle + (1.0 / 3) * Vec3{p[0], p[1], p[2]};
        }
        double least = 1e9;
        for (std::uint32_t face = 0; face < before->triangles.size(); ++face)
          if (holds(*before, face, middle)) least = std::min(least, field.at(face, middle.x, middle.y).distance);
        QVERIFY2(least < now + 1e-4, qPrintable(QString::number(least)));
        ++found;
      }
      QVERIFY(found > 10);
      // shoot() would wait for the run.
      const QString pictures = qEnvironmentVariable("FOOTFALL_TEST_PICTURES");
      if (!pictures.isEmpty())
        window_->view().grabFramebuffer().save(QString("%1/radius-dragged-%2.png").arg(pictures).arg(qRound(now * 10)));
    }
    release(measure.at + 0.3 * measure.along);
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(window_->controller().finishedRun()->pipeline.steps[Radius].values[0], value(Radius));
  }

  void escTakesADragBack() {
    choose(Clearance);
    const Vec3 handle = handles_->measures()[0].handle();
    const CameraPose pose = window_->view().cameraController().pose();
    press(handle);
    move(handle + Vec3{0, 0, -1});
    QVERIFY(value(Clearance) < 1.2);
    QTest::keyClick(&window_->view(), Qt::Key_Escape);
    QCOMPARE(value(Clearance), 2.0);
    move(handle + Vec3{0, 0, 1});
    QCOMPARE(value(Clearance), 2.0);
    release(handle);
    QVERIFY(pose == window_->view().cameraController().pose());  // no drag of the camera
  }

  void besideTheHandleTheCameraTurns() {
    choose(Clearance);
    const CameraPose pose = window_->view().cameraController().pose();
    const QPoint from = window_->view().rect().center() + QPoint(150, 90);
    QTest::mousePress(&window_->view(), Qt::LeftButton, {}, from);
    QTest::mouseMove(&window_->view(), from + QPoint(60, 0));
    QTest::mouseMove(&window_->view(), from + QPoint(80, 0));
    QTest::mouseRelease(&window_->view(), Qt::LeftButton, {}, from + QPoint(80, 0));
    QVERIFY(!(pose == window_->view().cameraController().pose()));
    QCOMPARE(value(Clearance), 2.0);
  }

  void aClickPutsTheMeasureThere() {
    choose(Clearance);
    clickInView(*window_, {2, -2, 0});
    const Vec3 at = handles_->measures()[0].at;
    QVERIFY2(std::hypot(at.x - 2, at.y + 2) < 0.1, qPrintable(QString("%1 %2").arg(at.x).arg(at.y)));
    // The handle returns to the middle when its place is no longer in view.
    window_->view().cameraController().lookAt({-7, 3, 0});
    window_->view().cameraController().zoomBy(6);
    QTRY_VERIFY(window_->view().rect().contains(placeInView(*window_, handles_->measures()[0].at)));
  }

  void theMouseOnAValueShowsIt() {
    FilterRow* row = partOf<FilterList>(*window_).rows()[Radius];
    QEnterEvent enter({5, 5}, {5, 5}, {5, 5});
    QApplication::sendEvent(row->field(0), &enter);
    QCOMPARE(handles_->measures().size(), std::size_t{1});
    QCOMPARE(handles_->measures()[0].filter, id(Radius));
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(row->field(0), &leave);
    QVERIFY(handles_->measures().empty());
  }

  void aToolHasTheMouseAlone() {
    choose(Clearance);
    const Vec3 handle = handles_->measures()[0].handle();
    window_->findChild<QAction*>(QStringLiteral("tools.measure"))->trigger();
    QVERIFY(window_->view().tool() != nullptr);
    QVERIFY(handles_->measures().empty());
    press(handle);
    move(handle + Vec3{0, 0, -1});
    release(handle);
    QCOMPARE(value(Clearance), 2.0);
    window_->view().setTool(nullptr);
    QCOMPARE(handles_->measures().size(), std::size_t{1});
  }

  void aDragShowsWhatItChangesAtOnce() {
    choose(Radius);
    QTRY_VERIFY_WITH_TIMEOUT(window_->controller().previews(id(Radius)), 20000);
    std::size_t changes = 0;
    connect(&window_->controller(), &RunController::contentReady, this,
            [&](const ViewContent& content) { changes = std::max(changes, content.changes.size()); });
    const ParameterMeasure measure = handles_->measures()[0];
    press(measure.handle());
    move(measure.at + 0.7 * measure.along);
    QCOMPARE(changes, std::size_t{1});  // changes during the movement
    release(measure.at + 0.7 * measure.along);
  }

 private:
  int id(Row row) { return partOf<Document>(*window_).filters()[row].id; }
  double value(Row row, std::size_t parameter = 0) {
    return partOf<Document>(*window_).filters()[row].step.values[parameter];
  }
  void choose(Row row) {
    partOf<FilterList>(*window_).choose({id(row)});
    if (row != Area) QTRY_VERIFY(!handles_->measures().empty());  // the camera may have moved just before
  }
  void press(const Vec3& place) {
    QTest::mousePress(&window_->view(), Qt::LeftButton, {}, placeInView(*window_, place));
  }
  void move(const Vec3& place) { QTest::mouseMove(&window_->view(), placeInView(*window_, place)); }
  void release(const Vec3& place) {
    QTest::mouseRelease(&window_->view(), Qt::LeftButton, {}, placeInView(*window_, place));
  }
  void dragHandle(std::size_t measure, const Vec3& to) {
    const Vec3 from = handles_->measures()[measure].handle();
    press(from);
    move(0.5 * (from + to));
    move(to);
    release(to);
  }
  static bool holds(const NavigationMesh& mesh, std::uint32_t face, const Vec3& p) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &a = mesh.vertices[mesh.triangles[face][k]], &b = mesh.vertices[mesh.triangles[face][(k + 1) % 3]];
      if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) < 0) return false;
    }
    return true;
  }

  const QTemporaryDir folder_;
  std::unique_ptr<EditorWindow> window_;
  ParameterHandles* handles_ = nullptr;
};

FOOTFALL_EDITOR_SUITE(TestParameterHandles)
#include "test_parameter_handles.moc"
