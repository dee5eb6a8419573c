// Pipeline files: what is accepted, what is refused and where, and that text and pipeline say the same.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <rapidcheck.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <clocale>
#include <cmath>
#include <string>

#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/report.hpp"
#include "tests/support/message_of.hpp"

using namespace footfall;
using namespace footfall::detail;
using footfall::test::messageOf;

namespace {

// A value that the parameter allows, limits included.
double arbitraryValue(const ParameterDescriptor& parameter) {
  if (parameter.type == ParameterType::Boolean) return *rc::gen::inRange(0, 2);
  if (parameter.type == ParameterType::Integer) {
    return *rc::gen::inRange(static_cast<int>(parameter.minimum),
                             static_cast<int>(std::min(parameter.maximum, 1000000.0)) + 1);
  }
  return *rc::gen::suchThat(rc::gen::map(rc::gen::arbitrary<double>(), [](double x) { return std::abs(x); }),
                            [&](double x) { return checkValue(parameter, x).empty(); });
}

PipelineStep arbitraryStep(const FilterDescriptor& filter) {
  PipelineStep step{&filter, {}, *rc::gen::arbitrary<bool>(), 0};
  const std::size_t more = filter.repeats == 0 ? 0 : filter.repeats * *rc::gen::inRange<std::size_t>(0, 5);
  for (std::size_t i = 0; i < filter.parameters.size() + more; ++i) {
    const ParameterDescriptor& parameter = filter.parameterOf(i);
    const bool isDefault = *rc::gen::arbitrary<bool>();
    step.values.push_back(isDefault ? parameter.defaultValue : arbitraryValue(parameter));
  }
  return step;
}

// Any valid pipeline: filters, and blocks of local filters.
Pipeline arbitraryPipeline() {
  std::vector<const FilterDescriptor*> plain, local, strategies;
  for (const FilterDescriptor& filter : filterDescriptors()) {
    // StepFilter and DropFilter have places where they cannot stand: below, test_step_filter and test_drop_filter
    const bool isPlain = filter.type != FilterType::Step && filter.type != FilterType::Drop;
    if (filter.kind == FilterKind::Filter && isPlain) plain.push_back(&filter);
    if (filter.kind == FilterKind::Filter && isPlain && filter.scope == Scope::Local) local.push_back(&filter);
    if (filter.kind == FilterKind::Strategy) strategies.push_back(&filter);
  }
  Pipeline pipeline;
  const int parts = *rc::gen::inRange(0, 8);
  for (int i = 0; i < parts; ++i) {
    if (*rc::gen::inRange(0, 4) > 0) {
      pipeline.steps.push_back(arbitraryStep(**rc::gen::elementOf(plain)));
      // A distance of their own to ledges needs a clearance before it: test_radius_filter
      if (PipelineStep& step = pipeline.steps.back(); step.filter->type == FilterType::Radius)
        step.values[1] = step.values[0];
      continue;
    }
    pipeline.steps.push_back(arbitraryStep(**rc::gen::elementOf(strategies)));
    const bool enabled = pipeline.steps.back().enabled;
    const int inside = *rc::gen::inRange(0, 3);
    for (int j = 0; j < inside; ++j) pipeline.steps.push_back(arbitraryStep(**rc::gen::elementOf(local)));
    pipeline.steps.push_back({&filterDescriptor(FilterType::Collapse), {}, enabled, 0});
  }
  if (*rc::gen::inRange(0, 3) == 0) {
    for (const FilterType last : {FilterType::VerticalClearance, FilterType::Step, FilterType::Drop, FilterType::Area})
      pipeline.steps.push_back(arbitraryStep(filterDescriptor(last)));
    pipeline.steps[pipeline.steps.size() - 4].enabled = true;
  }
  return pipeline;
}

}  // namespace

class TestPipelineFile : public QObject {
  Q_OBJECT
 private slots:
  void accepted_data();
  void accepted();
  void refused_data();
  void refused();
  void thesisSequentialListing();
  void thesisParallelListing();
  void linesAreRemembered();
  void disabledStepsAreComments();
  void textRoundTrips();
  void anyTextIsReadOrRefused();
  void localeDoesNotMatter();
  void defaultsFollowTheScale_data();
  void defaultsFollowTheScale();
  void defaultPipelineIsTheShippedFile();
  void parallelPipelineIsTheDefaultInABlock();
  void badFiles();
  void agent_data();
  void agent();
};

void TestPipelineFile::accepted_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QByteArray>("formatted");
  const auto row = [](const char* name, const char* text, const char* formatted) {
    QTest::newRow(name) << QByteArray(text) << QByteArray(formatted);
  };
  row("empty", "", "");
  row("blank lines", "\n \n\t\n", "");
  row("comments only", "# one\n  # two", "");
  row("no final line break", "SlopeFilter 45", "SlopeFilter 45\n");
  row("comment behind a step", "SlopeFilter 45 # steep\n", "SlopeFilter 45\n");
  row("comment right behind", "SlopeFilter 45#steep\n", "SlopeFilter 45\n");
  row("comment right behind a name", "DegeneracyFilter#x", "DegeneracyFilter\n");
  row("DOS line ends", "SlopeFilter 45\r\nDegeneracyFilter\r\n", "SlopeFilter 45\nDegeneracyFilter\n");
  row("old Macintosh line ends", "SlopeFilter 45\rDegeneracyFilter\r", "SlopeFilter 45\nDegeneracyFilter\n");
  row("tabs and indentation", "\t SlopeFilter\t 45\t \n", "SlopeFilter 45\n");
  row("byte order mark", "\xEF\xBB\xBFSlopeFilter 45\n", "SlopeFilter 45\n");
  row("alias", "PEELFilter\n", "LayerSubdivisionFilter\n");
  row("exponent", "VerticalClearanceFilter 2.5e+1\n", "VerticalClearanceFilter 25\n");
  row("negative zero", "AreaFilter -0\n", "AreaFilter 0\n");
  row("17 digits", "AreaFilter 0.10000000000000001\n", "AreaFilter 0.1\n");
  row("optional left out", "SimplificationFilter\n", "SimplificationFilter\n");
  row("one optional", "SimplificationFilter true\n", "SimplificationFilter true\n");
  row("both optional", "SimplificationFilter true 0.000001\n", "SimplificationFilter true\n");
  row("other tolerance", "SimplificationFilter false 0.5\n", "SimplificationFilter false 0.5\n");
  row("rounding", "RoundingFilter true\nRoundingFilter\nRoundingFilter false",
      "RoundingFilter\nRoundingFilter\nRoundingFilter false\n");
  row("block", "GridStrategy 3 2\nSlopeFilter 45\nCollapse\n", "GridStrategy 3 2\nSlopeFilter 45\nCollapse\n");
  row("two blocks", "GridStrategy 3 2\nCollapse\nRecursiveStrategy 50 3\nCollapse\n",
      "GridStrategy 3 2\nCollapse\nRecursiveStrategy 50 3\nCollapse\n");
  row("switched off", "#off SlopeFilter 45 # why\n", "#off SlopeFilter 45\n");
  row("no filter behind #off", "#off by one\n#off\n#offSlopeFilter\n# off SlopeFilter 45\n", "");
  row("global filter in a block, switched off", "GridStrategy 1 1\n#off AreaFilter 1\nCollapse\n",
      "GridStrategy 1 1\n#off AreaFilter 1\nCollapse\n");
}

void TestPipelineFile::accepted() {
  QFETCH(QByteArray, text);
  QFETCH(QByteArray, formatted);
  QCOMPARE(QByteArray::fromStdString(formatPipeline(parsePipeline(text.toStdString(), "p"))), formatted);
}

void TestPipelineFile::refused_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QByteArray>("place");
  QTest::addColumn<QByteArray>("says");
  const auto row = [](const char* name, const char* text, const char* place, const char* says) {
    QTest::newRow(name) << QByteArray(text) << QByteArray(place) << QByteArray(says);
  };
  row("unknown name", "SlpeFilter 45", "1:1", "did you mean SlopeFilter?");
  row("wrong case", "\n\n  slopeFilter 45", "3:3", "did you mean SlopeFilter?");
  row("comma", "SlopeFilter, 45", "1:1", "did you mean SlopeFilter?");
  row("too few", "SlopeFilter", "1:12", "needs a value for max_slope; write for example \"SlopeFilter 45\"");
  row("too few, with a comment", "SlopeFilter # 45", "1:17", "needs a value for max_slope");
  row("too few of three", "SortedRecursiveStrategy 50 3\nCollapse", "1:29", "needs a value for round");
  row("too many", "SlopeFilter 45 0 3", "1:18", "remove \"3\"");
  row("too many for none", "DegeneracyFilter 0", "1:18", "takes no parameters; remove \"0\"");
  row("too many optional", "SimplificationFilter true 0.1 2", "1:31", "remove \"2\"");
  row("no number", "SlopeFilter steep", "1:13", "\"steep\" is no value for max_slope");
  row("trailing letters", "SlopeFilter 45deg", "1:13", "\"45deg\" is no value");
  row("decimal comma", "SlopeFilter 45,5", "1:13", "\"45,5\" is no value");
  row("hexadecimal", "SlopeFilter 0x10", "1:13", "is no value");
  row("not a number", "SlopeFilter nan", "1:13", "is not a finite number");
  row("infinite", "AreaFilter inf", "1:12", "is not a finite number");
  row("too large to hold", "AreaFilter 1e999", "1:12", "is no value");
  row("slope 0", "SlopeFilter 0", "1:13", "0 is out of range; give a number above 0 and below 90 (degrees)");
  row("slope 90", "SlopeFilter 90", "1:13", "90 is out of range");
  row("clearance 0", "VerticalClearanceFilter 0", "1:25", "0 is out of range");
  row("negative area", "AreaFilter -1", "1:12", "-1 is out of range");
  row("boolean as number", "SimplificationFilter 1", "1:22", "give true or false");
  row("boolean in capitals", "RoundingFilter TRUE", "1:16", "give true or false");
  row("broken integer", "GridStrategy 2.5 1\nCollapse", "1:14", "is not a whole number");
  row("huge integer", "GridStrategy 1e300 1\nCollapse", "1:14", "1e+300 is out of range");
  row("collapse alone", "SlopeFilter 45\n Collapse", "2:2", "ends no parallel block");
  row("collapse twice", "GridStrategy 1 1\nCollapse\nCollapse", "3:1", "ends no parallel block");
  row("no collapse", "SlopeFilter 45\n  GridStrategy 1 1\nSlopeFilter 45", "2:3", "add a Collapse");
  row("strategy in a block", "GridStrategy 1 1\nGridStrategy 1 1\nCollapse", "2:1", "GridStrategy begins in line 1");
  row("global in a block", "GridStrategy 1 1\n\tAreaFilter 1\nCollapse", "2:2", "move it behind Collapse");
  row("collapse switched off", "GridStrategy 1 1\n#off Collapse", "1:1", "add a Collapse");
  row("switched off but wrong", " #off SlopeFilter 95", "1:19", "95 is out of range");
  row("columns are characters", "SlopeFilter \xC3\xA4\xC3\xB6", "1:13", "is no value");
  row("columns behind characters", "SlopeFilter 45 0 \xC3\xA4 3", "1:18", "remove");
  row("after a byte order mark", "\xEF\xBB\xBFSlope 45", "1:1", "did you mean SlopeFilter?");
  row("DOS line ends", "DegeneracyFilter\r\nSlope 45\r\n", "2:1", "unknown filter \"Slope\"");
}

void TestPipelineFile::refused() {
  QFETCH(QByteArray, text);
  QFETCH(QByteArray, place);
  QFETCH(QByteArray, says);
  const QByteArray message =
      QByteArray::fromStdString(messageOf([&] { parsePipeline(text.toStdString(), "my.pipeline"); }));
  QVERIFY2(message.startsWith("my.pipeline:" + place + ": "), message.constData());
  QVERIFY2(message.contains(says), message.constData());
  QVERIFY2(message.contains(';') && !message.contains('\n'), message.constData());
}

void TestPipelineFile::thesisSequentialListing() {
  const char* listing =
      "DegeneracyFilter\nSlopeFilter 60\nDuplicationFilter 0.005\nVerticalClearanceFilter 3\nDegeneracyFilter\n"
      "DuplicationFilter 0.005\nAreaFilter 500\nSimplificationFilter\nPEELFilter\n";
  Pipeline pipeline = parsePipeline(listing, "5.4");
  QCOMPARE(pipeline.steps.size(), std::size_t{9});
  QCOMPARE(pipeline.steps[2].values, std::vector<double>{0.005});
  pipeline.steps[1].values[1] = 0;  // the thesis has no tolerance
  QVERIFY(pipeline == readPipelineFile(FOOTFALL_SOURCE_DIR "/resources/pipelines/thesis_sequential.pipeline"));
}

void TestPipelineFile::thesisParallelListing() {
  const char* listing =
      "DegeneracyFilter\nSlopeFilter 60\nDuplicationFilter 0.005\nSmartRecursiveStrategy 50 3 true\nDegeneracyFilter\n"
      "VerticalClearanceFilter 3\nRoundingFilter true\nCollapse\nDegeneracyFilter\nDuplicationFilter 0.005\n"
      "AreaFilter 500\nSimplificationFilter true 0.000001\nPEELFilter\n";
  Pipeline pipeline = parsePipeline(listing, "5.4");
  QCOMPARE(pipeline.steps.size(), std::size_t{13});
  QCOMPARE(pipeline.steps[3].values, (std::vector<double>{50, 3, 1}));
  QCOMPARE(pipeline.steps[11].values, (std::vector<double>{1, 0.000001}));
  pipeline.steps[1].values[1] = 0;  // the thesis has no tolerance
  QVERIFY(pipeline == readPipelineFile(FOOTFALL_SOURCE_DIR "/resources/pipelines/thesis_parallel.pipeline"));
}

void TestPipelineFile::linesAreRemembered() {
  const Pipeline pipeline = parsePipeline("# title\n\nSlopeFilter 45\r\n#off AreaFilter 1\nDegeneracyFilter", "p");
  QCOMPARE(pipeline.steps.size(), std::size_t{3});
  QCOMPARE(pipeline.steps[0].line, 3);
  QCOMPARE(pipeline.steps[1].line, 4);
  QCOMPARE(pipeline.steps[2].line, 5);
}

void TestPipelineFile::disabledStepsAreComments() {
  Pipeline pipeline = parsePipeline("SlopeFilter 45\nAreaFilter 1\n", "p");
  pipeline.steps[0].enabled = false;
  QCOMPARE(formatPipeline(pipeline), std::string("#off SlopeFilter 45\nAreaFilter 1\n"));
  QVERIFY(parsePipeline(formatPipeline(pipeline), "p") == pipeline);
}

void TestPipelineFile::textRoundTrips() {
  QVERIFY(rc::check("what is written reads back equal", [] {
    const Pipeline pipeline = arbitraryPipeline();
    const std::string text = formatPipeline(pipeline);
    const Pipeline again = parsePipeline(text, "p");
    RC_ASSERT(again == pipeline);
    RC_ASSERT(formatPipeline(again) == text);
  }));
}

void TestPipelineFile::anyTextIsReadOrRefused() {
  QVERIFY(rc::check("any text gives a pipeline or one line with a place", [] {
    const auto words = *rc::gen::container<std::vector<std::string>>(
        rc::gen::oneOf(rc::gen::element<std::string>("SlopeFilter", "Collapse", "GridStrategy", "1", "true", "#off",
                                                     "#", "\n", "\r", "\t", "-", "1e", "nan"),
                       rc::gen::arbitrary<std::string>()));
    std::string text;
    for (const std::string& word : words) text += word + ' ';
    const std::string message = messageOf([&] { parsePipeline(text, "p"); });
    RC_ASSERT(message == "no error" || message.starts_with("p:"));
    RC_ASSERT(message.find('\n') == message.npos);
  }));
}

void TestPipelineFile::localeDoesNotMatter() {
  // Locales whose decimal mark is a comma; "C" stays if the system has no such locale.
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "nl_NL.UTF-8"}) {
    if (std::setlocale(LC_ALL, name) != nullptr) break;
  }
  const std::string text = formatPipeline(parsePipeline("SlopeFilter 44.5\n", "p"));
  std::setlocale(LC_ALL, "C");
  QCOMPARE(text, std::string("SlopeFilter 44.5\n"));
}

void TestPipelineFile::defaultsFollowTheScale_data() {
  QTest::addColumn<double>("metresPerUnit");
  QTest::addColumn<QByteArray>("clearance");
  QTest::addColumn<QByteArray>("step");
  QTest::addColumn<QByteArray>("area");
  QTest::newRow("metres") << 1.0 << QByteArray("2") << QByteArray("0.4") << QByteArray("1");
  QTest::newRow("centimetres") << 0.01 << QByteArray("200") << QByteArray("40 5") << QByteArray("10000");
  QTest::newRow("20 a metre") << 0.05 << QByteArray("40") << QByteArray("8 1") << QByteArray("400");
  QTest::newRow("feet") << 0.3048 << QByteArray("6.56167979003") << QByteArray("1.31233595801 0.164041994751")
                        << QByteArray("10.7639104167");
  QTest::newRow("no scale") << 0.0 << QByteArray("2") << QByteArray("0.4") << QByteArray("1");
}

void TestPipelineFile::defaultsFollowTheScale() {
  QFETCH(double, metresPerUnit);
  QFETCH(QByteArray, clearance);
  QFETCH(QByteArray, step);
  QFETCH(QByteArray, area);
  Environment environment;
  environment.metresPerUnit = metresPerUnit;
  QCOMPARE(QByteArray::fromStdString(formatPipeline(defaultPipeline(environment))),
           "DuplicationFilter 0\nDegeneracyFilter\nSlopeFilter 45\nVerticalClearanceFilter " + clearance +
               "\nStepFilter " + step + "\nAreaFilter " + area + "\nSimplificationFilter\nLayerSubdivisionFilter\n");
}

void TestPipelineFile::defaultPipelineIsTheShippedFile() {
  QVERIFY(readPipelineFile(FOOTFALL_SOURCE_DIR "/resources/pipelines/default.pipeline") ==
          defaultPipeline(Environment{}));
}

void TestPipelineFile::parallelPipelineIsTheDefaultInABlock() {
  Pipeline pipeline = readPipelineFile(FOOTFALL_SOURCE_DIR "/resources/pipelines/parallel.pipeline");
  QCOMPARE(
      std::erase_if(pipeline.steps, [](const PipelineStep& step) { return step.filter->kind != FilterKind::Filter; }),
      std::size_t{2});
  QVERIFY(pipeline == defaultPipeline(Environment{}));
}

void TestPipelineFile::badFiles() {
  QTemporaryDir folder;
  const std::string missing = folder.filePath("missing.pipeline").toStdString();
  QVERIFY(messageOf([&] { readPipelineFile(missing); }).starts_with(missing + ": cannot be opened (No such file"));
  const std::string directory = folder.path().toStdString();
  QCOMPARE(messageOf([&] { readPipelineFile(directory); }), directory + ": is a folder; give a pipeline file");
  QFile binary(folder.filePath("binary.pipeline"));
  QVERIFY(binary.open(QIODevice::WriteOnly));
  binary.write(
      QByteArray("\0\1\2\x7f"
                 "ELF\xff\xfe",
                 9));
  binary.close();
  const std::string message = messageOf([&] { readPipelineFile(binary.fileName().toStdString()); });
  QVERIFY(message.find("binary.pipeline:1:1: unknown filter \"???") != message.npos);
}

void TestPipelineFile::agent_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QByteArray>("agent");
  QTest::newRow("both") << QByteArray("SlopeFilter 45\nVerticalClearanceFilter 2")
                        << QByteArray("slope 45 degrees, height 2");
  QTest::newRow("with steps") << QByteArray("SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.25")
                              << QByteArray("slope 45 degrees, height 2, step 0.25, gap 0.05");
  QTest::newRow("steps off") << QByteArray("SlopeFilter 45\nVerticalClearanceFilter 2\n#off StepFilter 0.25")
                             << QByteArray("slope 45 degrees, height 2");
  QTest::newRow("strictest") << QByteArray(
                                    "SlopeFilter 60\nVerticalClearanceFilter 3\nSlopeFilter 30.5\n"
                                    "VerticalClearanceFilter 1\n#off SlopeFilter 5")
                             << QByteArray("slope 30.5 degrees, height 3");
  QTest::newRow("none") << QByteArray("DegeneracyFilter") << QByteArray("slope any, height any");
}

void TestPipelineFile::agent() {
  QFETCH(QByteArray, text);
  QFETCH(QByteArray, agent);
  const ExportHeader header = makeExportHeader(parsePipeline(text.toStdString(), "p"));
  QCOMPARE(QByteArray::fromStdString(header.agent), agent);
  QVERIFY(header.pipeline.find("#off") == header.pipeline.npos);
}

QTEST_APPLESS_MAIN(TestPipelineFile)
#include "test_pipeline_file.moc"
