// "Try it" for a body: a radius that is typed and dragged, which way it takes, and the passage that is too narrow.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <cmath>

#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "tests/editor/editor_driver.hpp"
#include "ui/base/commands/translations.hpp"
#include "ui/inspect/corridors/corridor_colours.hpp"
#include "ui/path/path_feature.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

constexpr const char* kPipeline = "SlopeFilter 45\nVerticalClearanceFilter 0.5\n";
constexpr Vec3 kFirst{1, 2, 0}, kSecond{8, 2, 0};

/// Two rooms of 4 x 4 and two passages between them, 1 long: one 0.8 wide in the middle, one 0.9 wide along the side.
QByteArray roomsObj() {
  return "v 0 0 0\nv 4 0 0\nv 4 1.6 0\nv 4 2.4 0\nv 4 3.1 0\nv 4 4 0\nv 0 4 0\nf 1 2 3 4 5 6 7\n"
         "v 5 0 0\nv 9 0 0\nv 9 4 0\nv 5 4 0\nv 5 3.1 0\nv 5 2.4 0\nv 5 1.6 0\nf 8 9 10 11 12 13 14\n"
         "f 3 14 13 4\nf 5 12 11 6\n";
}

}  // namespace

class TestTryRadius : public EditorSuite {
  Q_OBJECT

 private slots:
  void init() {
    QVERIFY(openLevel(roomsObj(), kPipeline));
    show();
  }
  void cleanup() { closeWindow(); }

  void aPointIsAsBefore() {
    QVERIFY(waitForPath());
    QVERIFY(!model().bodyPath());
    QCOMPARE(model().result()->planLength, 7.0);
    QVERIFY(!way()->isEnabled());
    QVERIFY(!button()->isVisible());
    QVERIFY2(text("pathText").startsWith("Length 7 units"), qPrintable(text("pathText")));
    QVERIFY(!text("pathText").contains("Narrowest"));
  }

  void aBodyTakesThePassageThatIsWideEnough() {
    type("0.3");
    QVERIFY(waitForPath());
    QVERIFY(std::fabs(model().result()->planLength - 7) < 1e-9);
    QVERIFY2(text("pathText").contains("Narrowest passage 0.8 units"), qPrintable(text("pathText")));
    type("0.42");  // only the one along the side is left
    QTRY_VERIFY(model().result() && model().result()->planLength > 7.5);
    QVERIFY2(text("pathText").contains("Narrowest passage 0.9 units"), qPrintable(text("pathText")));
    QCOMPARE(walkerRadius(), 0.25);  // no wider than high
    shoot(*window_, "radius-found");
  }

  void whatIsTooNarrowIsShown() {
    type("0.5");
    QTRY_VERIFY(model().bodyPath());
    QCOMPARE(model().bodyPath()->status, BodyPathStatus::TooNarrow);
    QVERIFY(!model().result());
    QCOMPARE(text("rowError"), QString("Every way is too narrow. The widest one has a passage of 0.9 units at x 5, "
                                       "y 3.55, z 0 units; the body is 1 unit wide, which is 0.1 units too much."));
    QTRY_VERIFY(button()->isVisible());
    const Vec3 before = pose().position;
    QTest::mouseClick(button(), Qt::LeftButton);
    QVERIFY(!(pose().position == before));
    window_->view().cameraController().endGlide();
    for (const double y : {3.1, 4.0}) {
      const auto border = window_->view().project({5, y, 0});
      QVERIFY(border && QRectF(window_->view().rect()).contains(*border));
      QTRY_VERIFY(isLike(colourInView(*window_, {5, y, 0}), widthColour(0)));
    }
    shoot(*window_, "radius-too-narrow");
    // A point fits again, and nothing of it is left.
    type("0");
    QVERIFY(waitForPath());
    QVERIFY(!button()->isVisible());
    QVERIFY(text("rowError").isEmpty());
    QTRY_VERIFY(!isLike(colourInView(*window_, {5, 4, 0}), widthColour(0)));
  }

  void theSliderDragsIt() {
    QSlider* slider = window_->findChild<QSlider*>("pathRadiusSlider");
    QVERIFY(waitForPath());
    QSignalSpy results(&model(), &PathModel::resultChanged);
    const int y = slider->height() / 2, width = slider->width();
    QTest::mousePress(slider, Qt::LeftButton, {}, {3, y});
    for (int i = 1; i <= 10; ++i) {
      QTest::mouseMove(slider, {3 + i * width / 20, y});
      QTest::qWait(20);
    }
    QTest::mouseRelease(slider, Qt::LeftButton, {}, {3 + width / 2, y});
    QVERIFY(results.count() > 1);  // while it is dragged
    const double radius = model().body().radius;
    QVERIFY2(radius > 0.5 && radius < 1.2, qPrintable(QString::number(radius)));
    QTRY_VERIFY(!model().busy());
    QVERIFY(model().bodyPath() && model().bodyPath()->status != BodyPathStatus::Found);
    QVERIFY(std::fabs(field()->text().toDouble() - radius) < 1e-9);
    // Each key is a step of a hundredth.
    slider->setFocus();
    const double before = model().body().radius;
    QTest::keyClick(slider, Qt::Key_Left);
    QVERIFY(std::fabs(before - model().body().radius - 0.01) < 1e-9);
    // A number beyond its end moves it there, and stays.
    type("2.5");
    QCOMPARE(slider->value(), slider->maximum());
    QCOMPARE(model().body().radius, 2.5);
  }

  void theLastOfManyValuesCounts() {
    QVERIFY(waitForPath());
    for (int i = 1; i <= 300; ++i) model().setBody({0.46 + 0.001 * i});
    QTRY_VERIFY(!model().busy() && model().bodyPath());
    QCOMPARE(model().bodyPath()->status, BodyPathStatus::TooNarrow);
    QVERIFY(std::fabs(model().bodyPath()->lacking - (2 * 0.76 - 0.9)) < 1e-9);
    model().setBody({0.3});
    model().setBody({0});
    QTRY_VERIFY(!model().busy() && model().result());
    QVERIFY(!model().bodyPath());
  }

  void widthMayCountMoreThanLength() {
    type("0.3");
    QVERIFY(waitForPath());
    const double shortest = model().result()->planLength;
    choose("Widest way");
    QTRY_VERIFY(model().result() && model().result()->planLength > shortest + 0.5);
    QVERIFY(text("pathText").contains("Narrowest passage 0.9 units"));
    choose("Shortest way");
    QTRY_VERIFY(model().result() && model().result()->planLength < shortest + 1e-9);
    choose("Prefer wide passages");  // neither is twice as wide, so the wider one
    QTRY_VERIFY(model().result() && model().result()->planLength > shortest + 0.5);
    type("0.2");  // both are
    QTRY_VERIFY(model().result() && model().result()->planLength < shortest + 1e-9);
  }

  void theRoomAtAnEndIsShown() {
    model().setStart(Vec3{0.1, 2, 0});
    type("0.3");
    QTRY_VERIFY(model().bodyPath());
    QCOMPARE(model().bodyPath()->status, BodyPathStatus::StartTooNear);
    QCOMPARE(text("rowError"), QString("The start is 0.1 units from the border, 0.2 units less than the radius. A "
                                       "place with enough room is at x 0.3, y 2, z 0 units."));
    QTRY_VERIFY(button()->isVisible());
    QCOMPARE(button()->text().remove('&'), QString("Show the place"));
  }

  // A body has its own radius: that of the filter does not count for it.
  void theFilterRadiusIsLeftOut() {
    partOf<Document>(*window_).addFilter(filterDescriptor(FilterType::Radius), 2);
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters().back().id, 0, 0.6, 1);
    QVERIFY(waitUntilIdle(*window_));
    QTRY_VERIFY(model().result() && !model().result()->reached());
    type("0.3");
    QVERIFY(waitForPath());
    QVERIFY2(text("pathText").contains("The filter Radius is left out"), qPrintable(text("pathText")));
    type("0");
    QTRY_VERIFY(model().result() && !model().result()->reached());
  }

  void theWalkerIsAsWide() {
    type("0.2");
    QVERIFY(waitForPath());
    QCOMPARE(walkerRadius(), 0.2);
    type("0");
    QVERIFY(walkerRadius() < 0.2);
  }

  void wrongNumbersAreRefused() {
    type("0.3");
    type("-1");
    QVERIFY(field()->property("invalid").toBool());
    QVERIFY2(text("rowError").contains("-1"), qPrintable(text("rowError")));
    QVERIFY(model().body().radius >= 0);
  }

  void sessionsKeepIt() {
    type("0.3");
    choose("Widest way");
    const QString path = folder_->filePath("rooms.footfall");
    window_->saveSession(path);
    QVERIFY(waitUntilIdle(*window_));
    type("0.1");
    window_->open(path);
    QTRY_VERIFY(model().body() == (WalkingBody{0.3, BodyWay::Widest}));
    QCOMPARE(way()->currentText(), QString("Widest way"));
    QVERIFY(QTest::qWaitFor([&] { return window_->idle() && model().bodyPath().has_value(); }, kWaitMs));
    // Another environment begins with a point.
    QVERIFY(openZUp(*window_, writeFile(*folder_, "floor.obj", floorObj()), kPipeline));
    QVERIFY(model().body() == WalkingBody{});
  }

  void inGerman() {
    loadTranslations("de");
    closeWindow();
    QVERIFY(openLevel(roomsObj(), kPipeline));
    show();
    model().setBody({0.5});
    QTRY_VERIFY(model().bodyPath());
    QVERIFY2(text("rowError").startsWith("Jeder Weg ist zu schmal."), qPrintable(text("rowError")));
    QVERIFY2(text("rowError").contains("1 Einheit breit"), qPrintable(text("rowError")));
    shoot(*window_, "radius-german");
    loadTranslations("en");
  }

 private:
  PathModel& model() { return window_->findChild<PathFeature*>()->model(); }
  double walkerRadius() { return window_->findChild<PathFeature*>()->walk().walkerView().body().radius; }
  CameraPose pose() { return window_->view().cameraController().pose(); }
  void show() {
    window_->view().cameraController().viewFromTop();
    window_->findChild<QAction*>("panel.path")->trigger();
    QTest::qWait(50);
    model().setPlaces(kFirst, kSecond);
  }
  NumberField* field() { return window_->findChild<NumberField*>("pathRadius"); }
  QComboBox* way() { return window_->findChild<QComboBox*>("pathWay"); }
  QPushButton* button() { return window_->findChild<QPushButton*>("pathShowPassage"); }
  QString text(const char* name) {
    QString found;
    for (const QLabel* label : window_->findChild<QWidget*>("pathPanel")->findChildren<QLabel*>(name))
      if (label->isVisible()) found += label->text();
    return found;
  }
  void type(const char* number) {
    field()->setFocus();
    QTest::keyClick(field(), Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field(), number);
  }
  void choose(const char* name) {
    QVERIFY(way()->findText(name) >= 0);
    way()->setCurrentIndex(way()->findText(name));
  }
  bool waitForPath() {
    return QTest::qWaitFor(
        [&] {
          return !model().busy() && model().result() && model().result()->reached() &&
                 model().bodyPath().has_value() == !model().body().isPoint();
        },
        kWaitMs);
  }
  static bool isLike(const QColor& a, const QColor& b) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()) < 60;
  }
};

FOOTFALL_EDITOR_SUITE(TestTryRadius)
#include "test_try_radius.moc"
