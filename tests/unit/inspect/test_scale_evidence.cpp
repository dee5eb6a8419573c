// The unit that the shapes of a level suggest.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>

#include "core/environment/scale_guess.hpp"
#include "core/inspect/scale_evidence.hpp"

using namespace footfall;
using namespace footfall::detail;

namespace {

// A building of so many metres with risers of 17 cm, storeys of 3 m and doors of 2.05 m, in units of so many metres.
LevelMeasures building(double length, double metresPerUnit, double guess = 1) {
  LevelMeasures level;
  level.metresPerUnit = guess;
  level.scaleGuessed = true;
  level.size = {length / metresPerUnit, length / metresPerUnit, 12 / metresPerUnit};
  for (int i = 0; i < 60; ++i) level.wallHeights.push_back(0.17 / metresPerUnit);
  for (int i = 0; i < 40; ++i) level.wallHeights.push_back(3 / metresPerUnit);
  for (int i = 0; i < 10; ++i) level.wallHeights.push_back((12 + i) / metresPerUnit);
  level.doorways = {{0.9 / metresPerUnit, 2.05 / metresPerUnit}};
  std::ranges::sort(level.wallHeights);
  return level;
}

}  // namespace

class TestScaleEvidence : public QObject {
  Q_OBJECT

 private slots:
  void usualUnits_data() {
    QTest::addColumn<double>("unit");
    for (const double unit : {1.0, 0.01, 0.001, 0.3048, 1.0 / 20, 1.0 / 10}) QTest::addRow("%g", unit) << unit;
  }
  void usualUnits() {
    QFETCH(double, unit);
    for (const double length : {20.0, 274.0, 500.0}) {
      const auto found = findScale(building(length, unit));
      QVERIFY(found.has_value());
      QVERIFY2(std::abs(found->metresPerUnit / unit - 1) < 0.25, qPrintable(QString::number(found->metresPerUnit)));
      QVERIFY(found->of == ScaleEvidence::Of::Risers);
    }
  }

  void theLevelsOwnScaleIsKeptWhereItExplainsAsMuch() {
    const auto found = findScale(building(500, 1.0 / 39.37, 1.0 / 39.37));
    QVERIFY(found.has_value());
    QCOMPARE(found->metresPerUnit, 1.0 / 39.37);
  }

  // A plain, a rig of long beams: nothing is proposed rather than something wrong.
  void withoutPeoplesSizesThereIsNone() {
    LevelMeasures level;
    level.size = {274, 90, 60};
    for (int i = 1; i < 100; ++i) level.wallHeights.push_back(10 + 0.37 * i);
    QVERIFY(!findScale(level));
    QVERIFY(!findScale(LevelMeasures{}));
  }

  void noLevelIsLowerThanAPerson() {
    LevelMeasures level = building(500, 1);
    const auto found = findScale(level);
    QVERIFY(found && found->metresPerUnit * level.size.z >= 1.8);
    // 500 m long and 39 m high, without walls: centimetres would make it 39 cm high.
    QVERIFY(!betterScale({500, 500, 39}, 1));
    QCOMPARE(betterScale({30000, 20000, 300}, 1).value_or(0), 0.01);
  }
};

QTEST_APPLESS_MAIN(TestScaleEvidence)
#include "test_scale_evidence.moc"
