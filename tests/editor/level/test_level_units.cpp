// Lengths and places in metres, millimetres, feet and the file's units, along the axes of files with any axis up.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "ui/base/text/level_units.hpp"
#include "ui/base/text/localized_numbers.hpp"
#include "ui/document/document.hpp"
#include "ui/level/scale_question.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;

namespace {

LevelUnits units(UpAxis up, double metresPerUnit, bool known = true, LengthUnit wanted = LengthUnit::Metres) {
  LevelUnits made;
  made.up = up;
  made.metresPerUnit = metresPerUnit;
  made.scaleKnown = known;
  made.wanted = wanted;
  return made;
}

}  // namespace

class TestLevelUnits : public QObject {
  Q_OBJECT
 private slots:
  void init() { QLocale::setDefault(QLocale(QLocale::English)); }

  void aGuessIsShownInTheFilesUnits() {
    const LevelUnits guess = units(UpAxis::Z, 0.0254, false);
    QCOMPARE(guess.length(100), QString("100 units"));
    QCOMPARE(guess.area(100), QString::fromUtf8("100.00 units²"));
    const LevelUnits known = units(UpAxis::Z, 0.0254);
    QCOMPARE(known.length(100), QString("2.54 m"));
    QCOMPARE(known.area(10000), QString::fromUtf8("6.45 m²"));
    QCOMPARE(units(UpAxis::Z, 0.0254, true, LengthUnit::Feet).length(12), QString("1 ft"));
    QCOMPARE(units(UpAxis::Z, 0.0254, true, LengthUnit::FileUnits).length(12), QString("12 units"));
    QCOMPARE(units(UpAxis::Z, 0.0254, true, LengthUnit::FileUnits).length(1), QString("1 unit"));
    const LevelUnits millimetres = units(UpAxis::Z, 0.0254, true, LengthUnit::Millimetres);
    QCOMPARE(millimetres.length(100), QString("2540 mm"));
    QCOMPARE(millimetres.area(10000), QString::fromUtf8("6.45 m²"));
  }

  void placesAreTheFiles() {
    // the place (1, 2, 3) in the file
    const Vec3 inYUp{1, -3, 2};
    QCOMPARE(units(UpAxis::Y, 1).place(inYUp), QString("x 1, y 2, z 3 m"));
    QCOMPARE(units(UpAxis::Z, 1).place({1, 2, 3}), QString("x 1, y 2, z 3 m"));
    QCOMPARE(units(UpAxis::Y, 0.5).placeNumbers(inYUp), QString("0.5, 1, 1.5"));
    QCOMPARE(units(UpAxis::Y, 0.5).storedPlace({0.5, 1, 1.5}), inYUp);
    QCOMPARE(units(UpAxis::Y, 1).shownHeight(2), 2.0);
    QCOMPARE(units(UpAxis::Y, 1).frameText(), QString("Places are in the file's frame (Y up), in m"));
  }

  void axesAreTheFiles() {
    const LevelUnits y = units(UpAxis::Y, 1);
    QCOMPARE(y.fileAxis(2).axis, 1);  // Y is up
    QVERIFY(y.fileAxis(2).same);
    QCOMPARE(y.fileAxis(1).axis, 2);  // and Z points to the viewer
    QVERIFY(!y.fileAxis(1).same);
    for (int axis = 0; axis < 3; ++axis) {
      QCOMPARE(units(UpAxis::Z, 1).fileAxis(axis).axis, axis);
      QVERIFY(units(UpAxis::Z, 1).fileAxis(axis).same);
    }
  }

  void whatIsTypedComesBack() {
    for (const double scale : {1.0, 0.0254, 0.01, 0.3048, 12.3}) {
      for (const LengthUnit wanted :
           {LengthUnit::Metres, LengthUnit::Millimetres, LengthUnit::Feet, LengthUnit::FileUnits}) {
        const LevelUnits level = units(UpAxis::Z, scale, true, wanted);
        for (const double typed : {2.0, 2.5, 0.1, 99.9, 1e-3, 1.23456789}) {
          QCOMPARE(level.shown(level.stored(typed)), typed);
          QCOMPARE(level.shown(level.stored(typed, Unit::Area), Unit::Area), typed);
        }
        QCOMPARE(level.stored(45, Unit::Degrees), 45.0);
      }
    }
    // The conversion is that of defaults.
    const PipelineStep clearance = defaultStep(filterDescriptor(FilterType::VerticalClearance), 0.0254);
    QCOMPARE(units(UpAxis::Z, 0.0254).stored(2), clearance.values[0]);
  }

  void lengthsStayTheSameInMetres() {
    Pipeline pipeline;
    pipeline.steps.push_back(defaultStep(filterDescriptor(FilterType::VerticalClearance), 1));
    pipeline.steps.push_back(defaultStep(filterDescriptor(FilterType::Area), 1));
    pipeline.steps.push_back(defaultStep(filterDescriptor(FilterType::Slope), 1));
    pipeline.steps[0].values[0] = 2.54;
    pipeline.steps[1].values[0] = 4;
    const Pipeline inches = rescaleLengths(pipeline, 1, 0.0254);
    QCOMPARE(inches.steps[0].values[0], 100.0);
    QCOMPARE(inches.steps[1].values[0] * 0.0254 * 0.0254, 4.0);
    QCOMPARE(inches.steps[2].values[0], pipeline.steps[2].values[0]);
    QVERIFY(rescaleLengths(inches, 0.0254, 1) == pipeline);
    // Defaults become defaults, digit for digit.
    pipeline.steps[0] = defaultStep(filterDescriptor(FilterType::VerticalClearance), 1);
    QVERIFY(rescaleLengths(pipeline, 1, 0.0254).steps[0] ==
            defaultStep(filterDescriptor(FilterType::VerticalClearance), 0.0254));
  }

  void theScaleIsAskedFor() {
    const ScaleQuestion room = askAboutScale({8, 6, 3}, 1);
    QCOMPARE(room.text, QString("1 unit = 1 m?"));
    QCOMPARE(room.scale, 1.0);
    QVERIFY(!room.guess);
    const ScaleQuestion centimetres = askAboutScale({640, 480, 300}, 1);
    QCOMPARE(centimetres.text, QString("640 m long: is 1 unit = 1 cm?"));
    QCOMPARE(centimetres.scale, 0.01);
    QCOMPARE(centimetres.guess.value(), 1.0);
    QCOMPARE(askAboutScale({300, 300, 250}, 1).text, QString("250 m high: is 1 unit = 1 cm?"));
    QCOMPARE(askAboutScale({8, 6, 3}, 0.001).text, QString("0.008 m long: is 1 unit = 1 m?"));
    QCOMPARE(askAboutScale({12000, 9000, 2500}, 0.001).text, QString("1 unit = 1 mm?"));
    QCOMPARE(unitLengthText(0.0254), QString("1 inch"));
    QCOMPARE(unitLengthText(0.05), QString("0.05 m"));
  }
};

QTEST_GUILESS_MAIN(TestLevelUnits)
#include "test_level_units.moc"
