// The area that a RadiusFilter removes is shown by the kind of border: a wall, a ledge, or, if that is unknown, a
// border.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCheckBox>

#include "footfall/filter_type.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/view/scene/appearance.hpp"
#include "ui/view/widgets/legend.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

/// A floor of 8 x 8 with a wall on its border at x = -4; all other borders are ledges.
QByteArray walledFloor() { return floorObj() + "v -4 -4 3\nv -4 4 3\nf 1 4 6 5\n"; }

constexpr const char* kSlope = "SlopeFilter 45\n";
constexpr const char* kClearance = "SlopeFilter 45\nVerticalClearanceFilter 2\n";

}  // namespace

class TestMargins : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    window_ = std::make_unique<EditorWindow>();
    window_->setRemembering(false);
    window_->resize(1100, 760);
    QVERIFY(showWindow(*window_));
  }
  void cleanup() { window_.reset(); }

  void wallsAndLedgesHavePaintsOfTheirOwn() {
    open(QByteArray(kClearance) + "RadiusFilter 1\n");
    QCOMPARE(reasons(), (QStringList{"Too near a wall", "Too near a ledge"}));
    QVERIFY(hasPaint({-3.5, 0, 0}, PlaceVerdict::TooNearWall));
    QVERIFY(hasPaint({3.5, 0, 0}, PlaceVerdict::TooNearLedge));
    QVERIFY(hasPaint({0, 3.5, 0}, PlaceVerdict::TooNearLedge));
    QVERIFY(hasPaint({-3.5, 3.5, 0}, PlaceVerdict::TooNearWall));  // near both
    QVERIFY(hasPaint({0, 0, 0}, walkablePaint().colour));
    // Each is drawn in stripes of another direction.
    QVERIFY(removalStyle(PlaceVerdict::TooNearWall).paint.pattern !=
            removalStyle(PlaceVerdict::TooNearLedge).paint.pattern);
  }

  void theResultIsThereBeforeItsKinds() {
    QStringList seen;
    connect(&window_->controller(), &RunController::contentReady, this, [&](const ViewContent& content) {
      QStringList reasons{content.firstRemoval ? content.firstRemoval->reason : QString()};
      for (const ViewContent::Removed& removed : content.removed) reasons << removed.style->reason;
      seen << reasons.join('+') + (content.hasMixedMargins ? "?" : "");
    });
    open(QByteArray(kClearance) + "RadiusFilter 1\n");
    seen.removeAll("");
    QCOMPARE(seen, (QStringList{"Too near a border?", "Too near a wall+Too near a ledge"}));
    // A cached result has them at once. A result that was left before they were computed gets them when it is shown
    // again.
    QUndoStack* const edits = partOf<Document>(*window_).undoStack();
    bool left = false;
    connect(&window_->controller(), &RunController::finished, this, [&] {
      if (std::exchange(left, true)) return;
      QVERIFY(window_->controller().seeksMarginKinds());
      edits->undo();
    });
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[2].id, 0, 1.5, 1);
    QTRY_VERIFY_WITH_TIMEOUT(left, 20000);
    QVERIFY(window_->controller().upToDate() && !window_->controller().seeksMarginKinds());
    QCOMPARE(seen.last(), QString("Too near a wall+Too near a ledge"));
    QCOMPARE(window_->controller().finishedRun()->pipeline.steps[2].values[0], 1.0);
    edits->redo();
    QVERIFY(window_->controller().upToDate());
    QCOMPARE(seen.last(), QString("Too near a border?"));
    QTRY_COMPARE_WITH_TIMEOUT(seen.last(), QString("Too near a wall+Too near a ledge"), 20000);
  }

  void cancellingLeavesThemAsTheyAre() {
    open(QByteArray(kClearance) + "RadiusFilter 1\n");
    connect(&window_->controller(), &RunController::finished, this, [&] { window_->controller().cancel(); });
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[2].id, 0, 1.5, 1);
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(!window_->controller().seeksMarginKinds() && window_->controller().upToDate());
    QTest::qWait(200);
    QCOMPARE(reasons(), (QStringList{"Too near a border"}));
  }

  void afterAFailedRunTheyAreThoseOfTheLastResult() {
    open(QByteArray(kClearance) + "RadiusFilter 1\n");
    const int radius = partOf<Document>(*window_).filters()[2].id;
    // A result whose kinds have not been found yet, and a run that fails: a radius far below what doubles distinguish.
    bool left = false;
    connect(&window_->controller(), &RunController::finished, this, [&] {
      if (std::exchange(left, true)) return;
      QVERIFY(window_->controller().seeksMarginKinds());
      partOf<Document>(*window_).setValue(radius, 0, 1e-30, 2);
    });
    const QSignalSpy failed(&window_->controller(), &RunController::failed);
    partOf<Document>(*window_).setValue(radius, 0, 1.5, 1);
    QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, 20000);
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(!window_->controller().upToDate());
    QTRY_VERIFY_WITH_TIMEOUT(!window_->controller().seeksMarginKinds(), 20000);
    QCOMPARE(window_->controller().finishedRun()->pipeline.steps[2].values[0], 1.5);
    const QStringList both{"Too near a wall", "Too near a ledge"};
    QCOMPARE(reasons(), both);
    QVERIFY(hasPaint({-2.7, 0, 0}, PlaceVerdict::TooNearWall));
    QVERIFY(hasPaint({2.7, 0, 0}, PlaceVerdict::TooNearLedge));
    QVERIFY(hasPaint({0, 0, 0}, walkablePaint().colour));
    // Another run fails after they are known.
    partOf<Document>(*window_).setValue(radius, 0, 1e-31, 3);
    QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 2, 20000);
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(reasons(), both);
    QVERIFY(hasPaint({-2.7, 0, 0}, PlaceVerdict::TooNearWall));
    // The first result's are not taken for those of a later one.
    partOf<Document>(*window_).setValue(radius, 0, 0.5, 4);
    QVERIFY(waitUntilIdle(*window_));
    QTRY_VERIFY_WITH_TIMEOUT(!window_->controller().seeksMarginKinds(), 20000);
    QCOMPARE(reasons(), both);
    QVERIFY(hasPaint({-3.7, 0, 0}, PlaceVerdict::TooNearWall));
    QVERIFY(hasPaint({-2.7, 0, 0}, walkablePaint().colour));
  }

  void aDragHasTheKindsAtItsEnd() {
    open(QByteArray(kClearance) + "RadiusFilter 1\n");
    window_->controller().setDragging(true);
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[2].id, 0, 1.5, 1);
    QVERIFY(waitUntilIdle(*window_));
    QTest::qWait(300);
    QVERIFY(window_->controller().seeksMarginKinds());
    window_->controller().setDragging(false);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->controller().seeksMarginKinds(), 20000);
    QCOMPARE(reasons(), (QStringList{"Too near a wall", "Too near a ledge"}));
  }

  void switchesOfTheLegend() {
    open(QByteArray(kClearance) + "RadiusFilter 1\n");
    click("Too near a ledge");
    QVERIFY(hasPaint({-3.5, 0, 0}, PlaceVerdict::TooNearWall));
    QVERIFY(hasPaint({3.5, 0, 0}, undecidedPaint().colour));
    click("Too near a wall");
    QVERIFY(hasPaint({-3.5, 0, 0}, undecidedPaint().colour));
    click("Too near a ledge");
    QVERIFY(hasPaint({3.5, 0, 0}, PlaceVerdict::TooNearLedge));
    QVERIFY(hasPaint({-3.5, 0, 0}, undecidedPaint().colour));
    // Other content keeps them.
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[2].id, 0, 1.25, 0);
    QVERIFY(waitUntilIdle(*window_));
    QTRY_VERIFY_WITH_TIMEOUT(!window_->controller().seeksMarginKinds(), 20000);
    QVERIFY(hasPaint({-2.9, 0, 0}, undecidedPaint().colour));
  }

  void distancesOfTheirOwn() {
    open(QByteArray(kClearance) + "RadiusFilter 1 2\n");
    QVERIFY(hasPaint({-3.5, 0, 0}, PlaceVerdict::TooNearWall));
    QVERIFY(hasPaint({2.5, 0, 0}, PlaceVerdict::TooNearLedge));
    open(QByteArray(kClearance) + "RadiusFilter 1 0\n");
    QCOMPARE(reasons(), (QStringList{"Too near a wall"}));
    open(QByteArray(kClearance) + "RadiusFilter 0 1\n");
    QCOMPARE(reasons(), (QStringList{"Too near a ledge"}));
    QVERIFY(hasPaint({3.5, 0, 0}, PlaceVerdict::TooNearLedge));
  }

  void oneKindAlone() {
    openText(floorObj(), QByteArray(kClearance) + "RadiusFilter 1\n");
    QCOMPARE(reasons(), (QStringList{"Too near a ledge"}));
    // Walls are undefined without a clearance.
    open(QByteArray(kSlope) + "RadiusFilter 1\n");
    QCOMPARE(reasons(), (QStringList{"Too near a border"}));
    QVERIFY(hasPaint({3.5, 0, 0}, removalStyle(FilterType::Radius)->paint.colour));
  }

  void behindOtherRemovals() {
    openText(walledFloor() +
                 "v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\nf 7 8 9 10\n"
                 "v 5 -2 0\nv 6 -2 1.7320508\nv 6 2 1.7320508\nv 5 2 0\nf 11 12 13 14\n",
             QByteArray(kClearance) + "RadiusFilter 0.5\n");
    QVERIFY(reasons().contains("Too steep") && reasons().contains("Too near a wall"));
    QVERIFY(hasPaint({5.5, 0, 0.87}, PlaceVerdict::TooSteep));
    QVERIFY(hasPaint({-3.75, 0, 0}, PlaceVerdict::TooNearWall));
    QVERIFY(hasPaint({3.75, 0, 0}, PlaceVerdict::TooNearLedge));
    click("Too steep");
    QVERIFY(hasPaint({5.5, 0, 0.87}, undecidedPaint().colour));
    QVERIFY(hasPaint({3.75, 0, 0}, PlaceVerdict::TooNearLedge));
  }

  void statusesAndStatisticsAreOfTheList() {
    open(QByteArray(kClearance) + "RadiusFilter 1\nAreaFilter 1\n");
    const auto run = window_->controller().finishedRun();
    QCOMPARE(run->result.steps.size(), std::size_t{4});
    for (const FilterEntry& entry : partOf<Document>(*window_).filters())
      QVERIFY(window_->controller().status(entry.id).state == StepState::Done);
    QVERIFY(run->result.summary.area < 36.001);
  }

 private:
  void open(const QByteArray& pipeline) { openText(walledFloor(), pipeline); }
  void openText(const QByteArray& text, const QByteArray& pipeline) {
    QVERIFY(openZUp(*window_, writeFile(folder_, "level.obj", text), pipeline));
    QTRY_VERIFY_WITH_TIMEOUT(!window_->controller().seeksMarginKinds(), 20000);
    window_->view().cameraController().viewFromTop();
  }
  QStringList reasons() {
    QStringList texts;
    for (const QCheckBox* box : boxes()) texts << box->text();
    return texts;
  }
  QList<QCheckBox*> boxes() {
    return partOf<Legend>(*window_).findChild<QWidget*>("reasons")->findChildren<QCheckBox*>();
  }
  void click(const QString& reason) {
    for (QCheckBox* box : boxes())
      if (box->text() == reason) return box->click();
    QFAIL(qPrintable("no switch for " + reason));
  }
  bool hasPaint(const Vec3& place, PlaceVerdict verdict) { return hasPaint(place, removalStyle(verdict).paint.colour); }
  /// The brightest pixel around is between the stripes; light keeps hue and saturation.
  bool hasPaint(const Vec3& place, const QColor& colour) {
    const QImage picture = window_->view().grabFramebuffer();
    const auto at = window_->view().project(place);
    if (!at) return false;
    const QPoint middle = (*at * picture.devicePixelRatio()).toPoint();
    QColor brightest(Qt::black);
    for (int y = -5; y <= 5; ++y)
      for (int x = -5; x <= 5; ++x) {
        const QColor pixel = picture.pixelColor(middle + QPoint(x, y));
        if (pixel.value() > brightest.value()) brightest = pixel;
      }
    const int hue = std::abs(brightest.hsvHue() - colour.hsvHue());
    const bool grey = colour.hsvSaturationF() < 0.05F;
    const bool same = std::abs(brightest.hsvSaturationF() - colour.hsvSaturationF()) < 0.06F &&
                      (grey || std::min(hue, 360 - hue) < 10);
    if (!same) qWarning() << place.x << place.y << "has" << brightest << "for" << colour;
    return same;
  }

  const QTemporaryDir folder_;
  std::unique_ptr<EditorWindow> window_;
};

FOOTFALL_EDITOR_SUITE(TestMargins)
#include "test_margins.moc"
