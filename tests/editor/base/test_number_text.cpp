// Numbers as people read them, in every language and at every size.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <limits>

#include "ui/base/text/localized_numbers.hpp"

using namespace footfall;
using namespace footfall::ui;

class TestNumberText : public QObject {
  Q_OBJECT

 private slots:
  void init() { QLocale::setDefault(QLocale(QLocale::English)); }
  void cleanup() { QLocale::setDefault(QLocale::c()); }

  void numbersAreShort() {
    QCOMPARE(shortText(78.74015748031496), QString("78.7402"));
    QCOMPARE(shortText(2.5), QString("2.5"));
    QCOMPARE(shortText(1234.5), QString("1,234.5"));
    QCOMPARE(shortText(1234567.25), QString("1,234,567"));
    QCOMPARE(shortText(0.05, 3), QString("0.05"));
    QCOMPARE(fixedText(2.5, 2), QString("2.50"));
    QCOMPARE(measureText(1234.56), QString("1234.6"));
    QCOMPARE(measureText(0.012345), QString("0.01235"));
    QCOMPARE(countText(1234567), QString("1,234,567"));
  }

  void noNumberIsLong() {
    for (const double value : {1e300, -1e300, 1e-300, -1e-300, 1e15, 123456789012345.0, 1e9}) {
      for (const QString& text : {shortText(value), fixedText(value, 2), measureText(value)})
        QVERIFY2(text.size() <= 23, qPrintable(text));
    }
    QCOMPARE(shortText(1e300), QString("1e+300"));
    QCOMPARE(measureText(-1e300), QString("-1e+300"));
    QCOMPARE(fixedText(1e300, 2), QString("1e+300"));
    QCOMPARE(shortText(std::numeric_limits<double>::infinity()), QString::fromUtf8("∞"));
  }

  void zeroHasNoSign() {
    for (const double value : {-0.0, -1e-9, -0.001}) QCOMPARE(fixedText(value, 2), QString("0.00"));
    QCOMPARE(shortText(-0.0), QString("0"));
    QCOMPARE(measureText(-0.0), QString("0"));
    QCOMPARE(numberText(-0.0), QString("0"));
    QCOMPARE(fixedText(-0.01, 2), QString("-0.01"));
  }

  void germanHasItsOwnNotation() {
    QLocale::setDefault(QLocale(QLocale::German));
    QCOMPARE(countText(1234567), QString("1.234.567"));
    QCOMPARE(shortText(1234.5), QString("1.234,5"));
    QCOMPARE(fixedText(2.5, 2), QString("2,50"));
    QCOMPARE(measureText(1234.56), QString("1234,6"));
    QCOMPARE(numberText(0.1), QString("0,1"));
    QCOMPARE(listText({measureText(1.5), measureText(-2.5)}), QString("1,5; -2,5"));
  }

  void bothDecimalMarksAreRead() {
    QCOMPARE(parseNumber("1.5").value(), 1.5);
    QVERIFY(!parseNumber("1,5"));
    QLocale::setDefault(QLocale(QLocale::German));
    QCOMPARE(parseNumber("1,5").value(), 1.5);
    QCOMPARE(parseNumber("1.5").value(), 1.5);
    QVERIFY(!parseNumber("1.234,5"));
    QCOMPARE(parseNumber(" +2e-3 ").value(), 2e-3);
  }

  void whatIsWrittenIsReadBack() {
    for (const auto language : {QLocale::English, QLocale::German, QLocale::Swedish}) {
      QLocale::setDefault(QLocale(language));
      for (const double value : {0.1, -1.0 / 3, 1e300, -1e-300, 123456.789, 2.5e9}) {
        QCOMPARE(parseNumber(numberText(value)).value(), value);
        QVERIFY(parseNumber(measureText(value)));
      }
    }
  }

  void withoutALanguageItIsEnglish() {
    QLocale::setDefault(QLocale::c());
    QCOMPARE(countText(1234567), QString("1,234,567"));
  }
};

QTEST_GUILESS_MAIN(TestNumberText)
#include "test_number_text.moc"
