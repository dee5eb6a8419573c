// Numbers by typing, dragging, wheel and keys.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QVBoxLayout>
#include <QWheelEvent>

#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "tests/editor/editor_driver.hpp"

using namespace footfall;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

const ParameterDescriptor& slope() { return filterDescriptor(FilterType::Slope).parameters[0]; }
const ParameterDescriptor& clearance() { return filterDescriptor(FilterType::VerticalClearance).parameters[0]; }
const ParameterDescriptor& fewest() { return filterDescriptor(FilterType::RecursiveStrategy).parameters[0]; }

void turnWheel(QWidget* widget, int notches, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  const QPointF at(widget->rect().center());
  QWheelEvent event(at, widget->mapToGlobal(at), QPoint(), QPoint(0, 120 * notches), Qt::NoButton, modifiers,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(widget, &event);
}

}  // namespace

class TestNumberField : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    window_ = std::make_unique<QWidget>();
    auto* layout = new QVBoxLayout(window_.get());
    other_ = new QLineEdit(window_.get());
    label_ = new QLabel("Maximum slope", window_.get());
    field_ = new NumberField(slope(), window_.get());
    field_->takeDragsOf(label_);
    field_->setValue(45);
    for (QWidget* each : std::initializer_list<QWidget*>{other_, label_, field_}) layout->addWidget(each);
    window_->resize(300, 120);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    other_->setFocus();
    at_ = 0;
  }
  void cleanup() { window_.reset(); }

  void aDoubleClickSelectsAllOfTheNumber() {
    field_->setValue(0.25);
    QTest::mouseClick(field_, Qt::LeftButton);
    QTest::mouseDClick(field_, Qt::LeftButton, Qt::NoModifier, QPoint(field_->width() - 12, field_->height() / 2));
    QCOMPARE(field_->selectedText(), QString("0.25"));
    QTest::keyClicks(field_, "1.5");
    QCOMPARE(field_->value(), 1.5);
  }

  void draggingTheLabelChangesTheValueAsOneEdit() {
    QList<int> sessions;
    connect(field_, &NumberField::valueEdited, this, [&] { sessions << field_->editSession(); });
    drag(label_, 40);
    QCOMPARE(field_->value(), 55.0);
    QCOMPARE(field_->text(), QString("55"));
    QVERIFY(sessions.size() > 1);
    for (const int session : sessions) QCOMPARE(session, sessions[0]);
    sessions.clear();
    drag(label_, -20);
    QCOMPARE(field_->value(), 50.0);
    const int second = sessions[0];
    drag(label_, 20);
    QVERIFY(sessions.back() != second);  // another drag, another edit
  }

  void aFieldThatHasNoFocusIsDraggedAndOneThatHasItIsNot() {
    drag(field_, 40);
    QCOMPARE(field_->value(), 55.0);
    QVERIFY(field_->hasFocus());
    drag(field_, 40);  // selects text now
    QCOMPARE(field_->value(), 55.0);
  }

  void aClickIsTheBeginningOfTyping() {
    QTest::mouseClick(field_, Qt::LeftButton);
    QVERIFY(field_->hasFocus());
    QCOMPARE(field_->selectedText(), QString("45"));
    QTest::keyClicks(field_, "30");
    QCOMPARE(field_->value(), 30.0);
  }

  void shiftIsFinerAndCtrlCoarser() {
    drag(label_, 40, Qt::ShiftModifier);
    QCOMPARE(field_->value(), 46.0);
    drag(label_, 12, Qt::ControlModifier);
    QCOMPARE(field_->value(), 80.0);  // 46 and three tens, in tens
  }

  void escapeTakesADragBack() {
    QTest::mousePress(label_, Qt::LeftButton, Qt::NoModifier, QPoint(5, 5));
    move(label_, 60);
    QVERIFY(field_->dragging());
    QCOMPARE(field_->value(), 60.0);
    QTest::keyClick(field_, Qt::Key_Escape);
    QCOMPARE(field_->value(), 45.0);
    QVERIFY(!field_->dragging());
    move(label_, 100);
    QTest::mouseRelease(label_, Qt::LeftButton, Qt::NoModifier, QPoint(105, 5));
    QCOMPARE(field_->value(), 45.0);
  }

  void aDragStopsAtTheRangeAndSaysSo() {
    QTest::mousePress(label_, Qt::LeftButton, Qt::NoModifier, QPoint(5, 5));
    move(label_, 400);
    QCOMPARE(field_->value(), 89.0);  // 90 itself is out of range
    QVERIFY2(field_->problem().contains("145 is out of range"), qPrintable(field_->problem()));
    QVERIFY(field_->problem().contains("stays 89"));
    move(label_, 40);
    QCOMPARE(field_->value(), 55.0);
    QVERIFY(field_->problem().isEmpty());
    move(label_, -400);
    QCOMPARE(field_->value(), 1.0);
    QTest::mouseRelease(label_, Qt::LeftButton);
    QVERIFY(field_->problem().isEmpty());
    QCOMPARE(field_->value(), 1.0);
  }

  void theWheelIsOnlyForTheFocus() {
    turnWheel(field_, 3);
    QCOMPARE(field_->value(), 45.0);
    field_->setFocus();
    turnWheel(field_, 3);
    QCOMPARE(field_->value(), 48.0);
    turnWheel(field_, -1, Qt::ControlModifier);
    QCOMPARE(field_->value(), 38.0);
    turnWheel(field_, 1, Qt::ShiftModifier);
    QCOMPARE(field_->value(), 38.1);
  }

  void keysStepAsTheWheelDoes() {
    field_->setFocus();
    QTest::keyClick(field_, Qt::Key_Up);
    QTest::keyClick(field_, Qt::Key_Up, Qt::ShiftModifier);
    QCOMPARE(field_->value(), 46.1);
    QTest::keyClick(field_, Qt::Key_PageDown);
    QCOMPARE(field_->value(), 36.0);
  }

  void whatIsTypedIsNotClamped() {
    field_->setFocus();
    field_->selectAll();
    QTest::keyClicks(field_, "95");
    QCOMPARE(field_->text(), QString("95"));
    QCOMPARE(field_->value(), 9.0);
    QVERIFY(field_->problem().startsWith("Maximum slope 95 is out of range; give a number above 0 and below 90"));
    field_->selectAll();
    QTest::keyClicks(field_, "4,5");
    QVERIFY(field_->problem().contains("point"));
    QTest::keyClick(field_, Qt::Key_Escape);
    QVERIFY(field_->problem().isEmpty());
    QCOMPARE(field_->text(), QString("4"));
  }

  void wholeNumbersStayWhole() {
    NumberField field(fewest(), window_.get());
    field.setValue(50);
    field.show();
    field.setFocus();
    QTest::keyClick(&field, Qt::Key_Up, Qt::ShiftModifier);
    QCOMPARE(field.value(), 51.0);
    QTest::keyClick(&field, Qt::Key_Up, Qt::ControlModifier);
    QCOMPARE(field.value(), 61.0);
  }

  void stepsSuitTheValue() {
    NumberField field(clearance(), window_.get());
    field.show();
    field.setFocus();
    field.setValue(2);
    QTest::keyClick(&field, Qt::Key_Up);
    QCOMPARE(field.text(), QString("2.1"));
    field.setValue(40);
    QTest::keyClick(&field, Qt::Key_Down);
    QCOMPARE(field.text(), QString("39"));
  }

  void unitsAreNamed() {
    LevelUnits units;
    QCOMPARE(unitText(Unit::Degrees, units), QString("degrees"));
    QCOMPARE(unitText(Unit::Length, units), QString("units"));
    QCOMPARE(unitText(Unit::Area, units), QString::fromUtf8("units²"));
    units.scaleKnown = true;
    QCOMPARE(unitText(Unit::Length, units), QString("m"));
    QCOMPARE(unitText(Unit::Area, units), QString::fromUtf8("m²"));
    QVERIFY(unitText(Unit::Count, units).isEmpty());
    QVERIFY(unitText(Unit::None, units).isEmpty());
  }

  void metresAreTypedAndUnitsKept() {
    NumberField field(clearance(), window_.get());
    LevelUnits inches;
    inches.metresPerUnit = 0.0254;
    inches.scaleKnown = true;
    field.setValue(78.7401574803);
    field.setUnits(inches);
    QCOMPARE(field.text(), QString("2"));
    field.show();
    field.setFocus();
    QTest::keyClick(&field, Qt::Key_Up);
    QCOMPARE(field.text(), QString("2.1"));
    QCOMPARE(field.value(), 82.6771653543);
    field.selectAll();
    QTest::keyClicks(&field, "-1");
    QVERIFY2(field.problem().contains("-1") && !field.problem().contains("units"), qPrintable(field.problem()));
    QCOMPARE(field.value(), 82.6771653543);
    inches.wanted = LengthUnit::FileUnits;
    field.setUnits(inches);
    QCOMPARE(field.text(), QString("82.6771653543"));
    QVERIFY(field.problem().isEmpty());
  }

  void germansTypeACommaOrAPoint() {
    QLocale::setDefault(QLocale(QLocale::German));
    NumberField field(clearance(), window_.get());
    field.setValue(2.5);
    QCOMPARE(field.text(), QString("2,5"));
    for (const char* typed : {"1,75", "1.75"}) {
      field.selectAll();
      QTest::keyClicks(&field, typed);
      QCOMPARE(field.value(), 1.75);
      QVERIFY(field.problem().isEmpty());
    }
    QLocale::setDefault(QLocale::c());
  }

 private:
  // Moves from the point (5, 5), in small steps as a hand does.
  void move(QWidget* widget, int to, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    const int steps = std::max(1, std::abs(to - at_) / 10);
    for (int i = 1; i <= steps; ++i) {
      const QPoint at(5 + at_ + (to - at_) * i / steps, 5);
      QMouseEvent event(QEvent::MouseMove, at, widget->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, modifiers);
      QApplication::sendEvent(widget, &event);
    }
    at_ = to;
  }
  void drag(QWidget* widget, int to, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    at_ = 0;
    QTest::mousePress(widget, Qt::LeftButton, Qt::NoModifier, QPoint(5, 5));
    move(widget, to, modifiers);
    QTest::mouseRelease(widget, Qt::LeftButton, Qt::NoModifier, QPoint(5 + to, 5));
    at_ = 0;
  }

  std::unique_ptr<QWidget> window_;
  QLineEdit* other_ = nullptr;
  QLabel* label_ = nullptr;
  NumberField* field_ = nullptr;
  int at_ = 0;
};

FOOTFALL_EDITOR_SUITE(TestNumberField)
#include "test_number_field.moc"
