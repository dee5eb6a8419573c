// The descriptors: complete, consistent, and the same in docs/reference/filters.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QTest>
#include <map>
#include <set>
#include <string>

#include "core/filters/descriptor_text.hpp"
#include "core/filters/filter_traits.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "footfall/pipeline.hpp"

using namespace footfall;
using namespace footfall::detail;

class TestDescriptor : public QObject {
  Q_OBJECT
 private slots:
  void namesAreUniqueAndFound();
  void everythingIsExplained();
  void removalsAreExplained();
  void removalsLookDifferent();
  void sizesDriveOneParameterEach();
  void defaultsAreInRange();
  void optionalParametersAreLast();
  void scopesFollowTheDesign_data();
  void scopesFollowTheDesign();
  void theThesisNamesAreAliases();
  void valuesAtTheLimits_data();
  void valuesAtTheLimits();
  void valuesInWords();
  void usageInWords();
  void nearestName_data();
  void nearestName();
  void documentationIsUpToDate();
};

void TestDescriptor::namesAreUniqueAndFound() {
  std::set<std::string_view> names;
  for (const FilterDescriptor& filter : filterDescriptors()) {
    QVERIFY(names.insert(filter.name).second);
    QCOMPARE(findFilter(filter.name), &filter);
    QCOMPARE(&filterDescriptor(filter.type), &filter);
    for (const std::string_view alias : filter.aliases) {
      QVERIFY(names.insert(alias).second);
      QCOMPARE(findFilter(alias), &filter);
    }
    std::set<std::string_view> parameters;
    for (const ParameterDescriptor& parameter : filter.parameters) QVERIFY(parameters.insert(parameter.name).second);
  }
  QCOMPARE(filterDescriptors().size(), std::size_t{kFilterTypes});
  QVERIFY(findFilter("slopefilter") == nullptr);
  QVERIFY(findFilter("") == nullptr);
}

void TestDescriptor::everythingIsExplained() {
  for (const FilterDescriptor& filter : filterDescriptors()) {
    QVERIFY(!filter.label.empty() && !filter.effect.empty() && !filter.source.empty());
    QVERIFY(filter.help.ends_with('.') && filter.effect.ends_with('.'));
    for (const ParameterDescriptor& parameter : filter.parameters) {
      QVERIFY(!parameter.label.empty());
      QVERIFY(parameter.help.ends_with('.'));
      QVERIFY(parameter.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") == parameter.name.npos);
    }
  }
}

void TestDescriptor::removalsAreExplained() {
  std::set<std::string_view> words;
  std::set<PlaceVerdict> verdicts;
  for (const FilterDescriptor& filter : filterDescriptors()) {
    QVERIFY(filter.traits != nullptr && filter.traits->parameters.size() <= filter.parameters.size());
    for (const Removal& removal : filter.traits->removals) {
      const std::string_view reason = removal.reason.english, without = removal.reasonWithoutMeasure.english;
      QVERIFY(std::string_view(removal.headline.english).starts_with("Not walkable: ") && reason.ends_with('.'));
      // Moved belongs to all filters that move vertices.
      QVERIFY(words.insert(removal.word).second || removal.verdict == PlaceVerdict::Moved);
      QVERIFY(removal.verdict == PlaceVerdict::Removed || removal.verdict == PlaceVerdict::Moved ||
              verdicts.insert(removal.verdict).second);
      QCOMPARE(reason.find("%1") != reason.npos, removal.measure != PlaceMeasure::None);
      QVERIFY(reason.find("%2") == reason.npos || removal.limit);
      QVERIFY(without.find("%1") == without.npos && without.find("%3") == without.npos);
      QVERIFY(!removal.limit || *removal.limit < filter.parameters.size());
      QCOMPARE(*removal.legend.english != '\0', removal.paint.has_value());
    }
    for (std::size_t i = 1; i < filter.traits->removals.size(); ++i)
      QVERIFY(findRemoval(*filter.traits, filter.traits->removals[i].verdict) == &filter.traits->removals[i]);
  }
}

void TestDescriptor::removalsLookDifferent() {
  std::set<std::pair<FillPattern, Rgb>> paints;
  for (const FilterDescriptor& filter : filterDescriptors()) {
    std::set<std::pair<FillPattern, Rgb>> own;  // a filter may draw two of its reasons alike
    for (const Removal& removal : filter.traits->removals)
      if (removal.paint) own.insert({removal.paint->pattern, removal.paint->pale});
    for (const auto& paint : own) {
      QVERIFY(paint.first != FillPattern::Plain);
      QVERIFY(paints.insert(paint).second);
    }
  }
}

void TestDescriptor::sizesDriveOneParameterEach() {
  std::map<AgentSize, int> found;
  for (const FilterDescriptor& filter : filterDescriptors())
    for (std::size_t i = 0; i < filter.parameters.size(); ++i)
      if (const auto size = parameterUse(filter, i).agentSize) ++found[*size];
  QCOMPARE(found.size(), std::size_t{6});
  for (const auto& [size, count] : found) {
    QCOMPARE(count, 1);
    const DrivenParameter driven = drivenBy(size);
    QVERIFY(parameterUse(*driven.filter, driven.parameter).agentSize == size);
  }
}

void TestDescriptor::defaultsAreInRange() {
  for (const FilterDescriptor& filter : filterDescriptors()) {
    for (const ParameterDescriptor& parameter : filter.parameters) {
      QVERIFY(parameter.minimum < parameter.maximum);
      QVERIFY(checkValue(parameter, parameter.defaultValue).empty());
    }
  }
}

void TestDescriptor::optionalParametersAreLast() {
  for (const FilterDescriptor& filter : filterDescriptors()) {
    bool optional = false;
    for (const ParameterDescriptor& parameter : filter.parameters) {
      QVERIFY(parameter.optional || !optional);
      optional = parameter.optional;
    }
  }
}

void TestDescriptor::scopesFollowTheDesign_data() {
  QTest::addColumn<bool>("local");
  QTest::addColumn<bool>("isFilter");
  QTest::newRow("DegeneracyFilter") << true << true;
  QTest::newRow("SlopeFilter") << true << true;
  QTest::newRow("VerticalClearanceFilter") << true << true;
  QTest::newRow("RoundingFilter") << true << true;
  QTest::newRow("DuplicationFilter") << false << true;
  QTest::newRow("StepFilter") << true << true;
  QTest::newRow("RadiusFilter") << false << true;
  QTest::newRow("ReachableFilter") << false << true;
  QTest::newRow("AreaFilter") << false << true;
  QTest::newRow("SimplificationFilter") << false << true;
  QTest::newRow("LayerSubdivisionFilter") << false << true;
  QTest::newRow("GridStrategy") << false << false;
  QTest::newRow("RecursiveStrategy") << false << false;
  QTest::newRow("SortedRecursiveStrategy") << false << false;
  QTest::newRow("HeightAwareStrategy") << false << false;
  QTest::newRow("AutoStrategy") << false << false;
  QTest::newRow("Collapse") << false << false;
}

void TestDescriptor::scopesFollowTheDesign() {
  QFETCH(bool, local);
  QFETCH(bool, isFilter);
  const FilterDescriptor* filter = findFilter(QTest::currentDataTag());
  QVERIFY(filter != nullptr);
  QCOMPARE(filter->scope == Scope::Local, local);
  QCOMPARE(filter->kind == FilterKind::Filter, isFilter);
}

void TestDescriptor::theThesisNamesAreAliases() {
  QCOMPARE(findFilter("PEELFilter"), findFilter("LayerSubdivisionFilter"));
  QCOMPARE(findFilter("SmartRecursiveStrategy"), findFilter("SortedRecursiveStrategy"));
}

void TestDescriptor::valuesAtTheLimits_data() {
  QTest::addColumn<QString>("filter");
  QTest::addColumn<int>("parameter");
  QTest::addColumn<double>("value");
  QTest::addColumn<bool>("valid");
  const double tiny = std::numeric_limits<double>::denorm_min();
  QTest::newRow("slope 0") << "SlopeFilter" << 0 << 0.0 << false;
  QTest::newRow("slope tiny") << "SlopeFilter" << 0 << tiny << true;
  QTest::newRow("slope below 90") << "SlopeFilter" << 0 << std::nextafter(90.0, 0.0) << true;
  QTest::newRow("slope 90") << "SlopeFilter" << 0 << 90.0 << false;
  QTest::newRow("clearance 0") << "VerticalClearanceFilter" << 0 << 0.0 << false;
  QTest::newRow("clearance tiny") << "VerticalClearanceFilter" << 0 << tiny << true;
  QTest::newRow("clearance largest") << "VerticalClearanceFilter" << 0 << std::numeric_limits<double>::max() << true;
  QTest::newRow("clearance infinite") << "VerticalClearanceFilter" << 0 << HUGE_VAL << false;
  QTest::newRow("clearance NaN") << "VerticalClearanceFilter" << 0 << std::nan("") << false;
  QTest::newRow("distance 0") << "DuplicationFilter" << 0 << 0.0 << true;
  QTest::newRow("distance negative") << "DuplicationFilter" << 0 << -tiny << false;
  QTest::newRow("area 0") << "AreaFilter" << 0 << 0.0 << true;
  QTest::newRow("tolerance 0") << "SimplificationFilter" << 1 << 0.0 << true;
  QTest::newRow("tolerance 1") << "SimplificationFilter" << 1 << 1.0 << false;
  QTest::newRow("boolean 1") << "SimplificationFilter" << 0 << 1.0 << true;
  QTest::newRow("boolean half") << "SimplificationFilter" << 0 << 0.5 << false;
  QTest::newRow("boolean 2") << "SimplificationFilter" << 0 << 2.0 << false;
  QTest::newRow("grid 0") << "GridStrategy" << 0 << 0.0 << false;
  QTest::newRow("grid 1") << "GridStrategy" << 0 << 1.0 << true;
  QTest::newRow("grid 1.5") << "GridStrategy" << 1 << 1.5 << false;
}

void TestDescriptor::valuesAtTheLimits() {
  QFETCH(QString, filter);
  QFETCH(int, parameter);
  QFETCH(double, value);
  QFETCH(bool, valid);
  const std::string message = checkValue(findFilter(filter.toStdString())->parameters.at(parameter), value).str();
  QCOMPARE(message.empty(), valid);
  if (!valid) QVERIFY2(message.find("; give ") != message.npos, message.c_str());
}

void TestDescriptor::valuesInWords() {
  const ParameterDescriptor& slope = filterDescriptor(FilterType::Slope).parameters[0];
  QCOMPARE(describeRange(slope).str(), std::string("a number above 0 and below 90 (degrees)"));
  QCOMPARE(formatValue(slope, 45), std::string("45"));
  QCOMPARE(formatValue(slope, 0.1), std::string("0.1"));
  QCOMPARE(describeRange(filterDescriptor(FilterType::GridStrategy).parameters[0]).str(),
           std::string("a whole number of at least 1"));
  QCOMPARE(formatValue(filterDescriptor(FilterType::GridStrategy).parameters[0], 2147483647),
           std::string("2147483647"));
  QCOMPARE(formatValue(filterDescriptor(FilterType::Rounding).parameters[0], 1), std::string("true"));
}

void TestDescriptor::usageInWords() {
  QCOMPARE(describeUsage(filterDescriptor(FilterType::Simplification)),
           std::string("SimplificationFilter [approximate [tolerance]]"));
  QCOMPARE(describeUsage(filterDescriptor(FilterType::Collapse)), std::string("Collapse"));
}

void TestDescriptor::nearestName_data() {
  QTest::addColumn<QString>("nearest");
  QTest::newRow("SlpeFilter") << "SlopeFilter";
  QTest::newRow("slopefilter") << "SlopeFilter";
  QTest::newRow("Slope") << "SlopeFilter";
  QTest::newRow("peel") << "PEELFilter";
  QTest::newRow("Colapse") << "Collapse";
  QTest::newRow("SmartRecursive") << "SmartRecursiveStrategy";
}

void TestDescriptor::nearestName() {
  QFETCH(QString, nearest);
  QCOMPARE(std::string(nearestFilterName(QTest::currentDataTag())), nearest.toStdString());
}

void TestDescriptor::documentationIsUpToDate() {
  QFile file(FOOTFALL_SOURCE_DIR "/docs/reference/filters.md");
  QVERIFY(file.open(QIODevice::ReadOnly));
  QVERIFY2(file.readAll().toStdString() == filtersMarkdown(),
           "docs/reference/filters.md is out of date; run `footfall filters --markdown > docs/reference/filters.md`");
}

QTEST_APPLESS_MAIN(TestDescriptor)
#include "test_descriptor.moc"
