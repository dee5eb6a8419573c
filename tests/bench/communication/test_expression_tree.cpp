// The tree format of the communication benchmark: the thesis's own example (figure 24), sizes, and damaged bytes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include "tests/bench/communication/exchange_formats.hpp"
#include "tests/bench/communication/expression_tree.hpp"

using namespace footfall;
using namespace footfall::bench;

class TestExpressionTree : public QObject {
  Q_OBJECT

 private slots:
  // Figures 1 and 24: (35.9922 - (-84.9573)) / 2 + negate(2.642) * 25 has five operations and five constants.
  void theExampleOfTheThesisReturns() {
    const Expression example =
        (Expression(35.9922) - Expression(-84.9573)) / Expression(2.0) + (-Expression(2.642)) * Expression(25.0);
    std::string bytes;
    writeTree(bytes, example);
    QCOMPARE(bytes.size(), std::size_t{5 * 1 + 5 * 9});
    const char* at = bytes.data();
    const Expression again = readTree(at, bytes.data() + bytes.size());
    QCOMPARE(at, bytes.data() + bytes.size());
    QVERIFY(again == example);  // exactly, as CORE decides it
    std::string same;
    writeTree(same, again);
    QVERIFY(same == bytes);
  }

  // The best case of 5.3.1 is nine bytes; each operation adds itself and a constant.
  void sizesAreThoseOfTheThesis() {
    std::mt19937_64 random(3);
    for (const int operations : {0, 3, 12}) {
      std::string bytes;
      writeTree(bytes, growExpression(random, operations));
      QCOMPARE(bytes.size(), static_cast<std::size_t>(9 + 10 * operations));
    }
  }

  void damagedBytesAreRefused() {
    std::mt19937_64 random(5);
    std::string bytes;
    writeTree(bytes, growExpression(random, 12));
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      const char* at = bytes.data();
      QVERIFY_THROWS_EXCEPTION(detail::BadBytes, readTree(at, bytes.data() + length));
    }
    bytes[0] = 99;
    const char* at = bytes.data();
    QVERIFY_THROWS_EXCEPTION(detail::BadBytes, readTree(at, bytes.data() + bytes.size()));
    const std::string deep(100'000, 1);  // negations without an end
    at = deep.data();
    QVERIFY_THROWS_EXCEPTION(detail::BadBytes, readTree(at, deep.data() + deep.size()));
  }

  void everyFormatGivesBackWhatItTook() {
    for (const auto& format : {makeAsciiFormat(12), makeBinaryFormat(3), makeTreeFormat(12), makeProvenanceFormat()}) {
      std::string bytes;
      format->prepare(1, 500);
      format->write(bytes);
      format->read(bytes, 500);
      QVERIFY(format->isSame());
      format->prepare(2, 500);
      QVERIFY(!format->isSame());
      QVERIFY_THROWS_EXCEPTION(detail::BadBytes, format->read(bytes.substr(0, bytes.size() / 2), 500));
    }
  }
};

QTEST_APPLESS_MAIN(TestExpressionTree)
#include "test_expression_tree.moc"
