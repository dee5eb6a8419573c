// Texts: places and what stands in them; the messages of errors are what they say in English.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <limits>
#include <string>

#include "core/base/counted_text.hpp"
#include "core/io/input_file.hpp"
#include "footfall/errors.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/text.hpp"

using namespace footfall;
using namespace footfall::detail;

namespace {

template <class Work>
std::string messageOf(Work&& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.text().str() == error.what() ? error.what() : "what() is not the text";
  }
  return "nothing was thrown";
}

}  // namespace

class TestText : public QObject {
  Q_OBJECT

 private slots:
  void oneIsNotMany() {
    const auto layers = [](std::uint64_t n) {
      return countedText(n, FOOTFALL_TEXT("1 layer"), FOOTFALL_TEXT("%1 layers")).str();
    };
    QCOMPARE(layers(0), std::string("0 layers"));
    QCOMPARE(layers(1), std::string("1 layer"));
    QCOMPARE(layers(21), std::string("21 layers"));
    QCOMPARE(counted(1, "vertex", "vertices"), std::string("1 vertex"));
    QCOMPARE(counted(0, "vertex", "vertices"), std::string("0 vertices"));
  }

  void zeroHasNoSign() {
    QCOMPARE(formatted(-0.001, "%.2f ms"), std::string("0.00 ms"));
    QCOMPARE(formatted(-0.0, "%g"), std::string("0"));
    QCOMPARE(formatted(-0.0, "%.3e"), std::string("0.000e+00"));
    QCOMPARE(formatted(-0.006, "%.2f"), std::string("-0.01"));
    QCOMPARE(formatted(-1e-20, "%.6g"), std::string("-1e-20"));
    QCOMPARE(formatted(-0.05, "%.6g"), std::string("-0.05"));
    QCOMPARE(formatted(-10, "%.0f"), std::string("-10"));
    QCOMPARE(formatted(-std::numeric_limits<double>::infinity(), "%g"), std::string("-inf"));
  }

  void placesAreFilled() {
    QCOMPARE(Text(FOOTFALL_TEXT("%1 of %2"), 3, std::size_t{40}).str(), std::string("3 of 40"));
    QCOMPARE(Text(FOOTFALL_TEXT("%2 %1 %2"), "a", std::string("b")).str(), std::string("b a b"));
    QCOMPARE(Text(FOOTFALL_TEXT("%1"), std::numeric_limits<std::uint64_t>::max()).str(),
             std::string("18446744073709551615"));
    QCOMPARE(Text(FOOTFALL_TEXT("no place")).str(), std::string("no place"));
    QCOMPARE(Text().str(), std::string());
    QVERIFY(Text().empty() && !Text(FOOTFALL_TEXT("x")).empty());
  }

  void textsStandInTexts() {
    const Text inner(FOOTFALL_TEXT("line %1"), 7);
    const Text outer(FOOTFALL_TEXT("%1: %2"), inner, "what");
    QCOMPARE(outer.str(), std::string("line 7: what"));
    QCOMPARE(outer.arguments().size(), std::size_t{2});
    QVERIFY(outer.arguments()[0].isPattern() && !outer.arguments()[1].isPattern());
    QCOMPARE(outer.arguments()[0].pattern(), std::string("line %1"));
  }

  void whatIsNoPlaceStays() {
    QCOMPARE(Text(FOOTFALL_TEXT("%2 %0 %% 100% %"), "a").str(), std::string("%2 %0 %% 100% %"));
    QCOMPARE(Text(FOOTFALL_TEXT("%1 %12"), "a").str(), std::string("a a2"));
  }

  void argumentsHaveNoPlaces() {
    QCOMPARE(Text(FOOTFALL_TEXT("%1 and %2"), "%2", "100%1").str(), std::string("%2 and 100%1"));
    QCOMPARE(Text("%1").str(), std::string("%1"));
    QCOMPARE(Text(FOOTFALL_TEXT("%1: %2"), Text(FOOTFALL_TEXT("%1"), "%2"), "b").str(), std::string("%2: b"));
  }

  void equalOnesAreEqual() {
    const Text text(FOOTFALL_TEXT("%1 cells"), 4);
    QVERIFY(text == Text(FOOTFALL_TEXT("%1 cells"), "4"));
    QVERIFY(!(text == Text(FOOTFALL_TEXT("%1 cells"), 5)));
    QVERIFY(!(text == Text("4 cells")));
    QVERIFY(!(Text("plain") == Text(FOOTFALL_TEXT("plain"))));
  }

  void oneLineHasNoControlCharacters() {
    const Text text = Text(FOOTFALL_TEXT("%1: %2"), "a\nb\x7f", Text(FOOTFALL_TEXT("in %1"), "\tc")).inOneLine();
    QCOMPARE(text.str(), std::string("a b : in  c"));
    QVERIFY(text.isPattern());
  }

  void errorsSayTheirTextInEnglish() {
    QCOMPARE(messageOf([] { throw InputError("as it is, with %1"); }), std::string("as it is, with %1"));
    QCOMPARE(messageOf([] { throw InputError(FOOTFALL_TEXT("%1 is not a number"), "'x%1'"); }),
             std::string("'x%1' is not a number"));
    QCOMPARE(
        messageOf([] { failInput("a\nb%2.obj", 4, FOOTFALL_TEXT("no such file"), FOOTFALL_TEXT("check the name")); }),
        std::string("a b%2.obj:4: no such file; check the name"));
    QCOMPARE(messageOf([] { checkInputFile("/no/such%1"); }), std::string("/no/such%1: no such file; check the name"));
    QCOMPARE(messageOf([] { parsePipeline("SlopeFilter 95\n", "100%2"); }),
             std::string("100%2:1:13: max_slope 95 is out of range; give a number above 0 and below 90 (degrees)"));
    QCOMPARE(messageOf([] { parsePipeline("GridStrategy 1 1\nLayerSubdivisionFilter\nCollapse\n", "p"); }),
             std::string("p:2:1: LayerSubdivisionFilter needs all cells and cannot run inside the parallel block "
                         "that GridStrategy begins in line 1; move it behind Collapse or before the block"));
  }
};

QTEST_APPLESS_MAIN(TestText)
#include "test_text.moc"
