// Why a filter removed a place, by its descriptor: a filter with words of its own, and one that has none.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include "core/filters/filter_traits.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "footfall/report.hpp"
#include "tests/support/soup_generators.hpp"
#include "tests/unit/inspect/explained_places.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

/// SlopeFilter as a filter that has other removals.
class OtherFilter {
 public:
  explicit OtherFilter(std::vector<Removal> removals) : traits_(*descriptor_.traits) {
    traits_.removals = std::move(removals);
    descriptor_.traits = &traits_;
  }
  [[nodiscard]] Pipeline pipeline() const { return {{{&descriptor_, {45, 0}}}}; }

 private:
  FilterDescriptor descriptor_ = filterDescriptor(FilterType::Slope);
  FilterTraits traits_;
};

std::string explained(const Pipeline& pipeline) {
  const auto ramp = Soup().ramp(0, 0, 2, 2, 0, 3).environment();
  RunContext context;
  const RunResult result = runPipeline(ramp, pipeline, context);
  const Inspector inspector(ramp, pipeline, result.mesh);
  const PlaceExplanation told = inspector.explain({0, {1.5, 0.5, 2.25}});
  return std::string(verdictWord(pipeline, told)) + '\n' + formatExplanation(inspector, told);
}

}  // namespace

class TestRemovals : public QObject {
  Q_OBJECT

 private slots:
  void aFilterThatDescribesNothing() {
    const std::string text = explained(OtherFilter({}).pipeline());
    QVERIFY2(text.starts_with("removed\n"), text.c_str());
    QVERIFY2(text.find("not walkable: the filter of this step removed it\n") != text.npos, text.c_str());
    QVERIFY2(text.find("rejected by step 1: ") != text.npos, text.c_str());
  }

  void aFilterWithItsOwnWords() {
    const Removal removal{.verdict = PlaceVerdict::Removed,
                          .word = "too_odd",
                          .headline = Pattern{"Not walkable: too odd"},
                          .reason = Pattern{"It has %1, and %2 are odd."},
                          .reasonWithoutMeasure = kNoText,
                          .measure = PlaceMeasure::Slope,
                          .limit = 0,
                          .legend = kNoText,
                          .paint = {}};
    const std::string text = explained(OtherFilter({removal}).pipeline());
    QVERIFY2(text.starts_with("too_odd\n"), text.c_str());
    QVERIFY2(text.find("not walkable: too odd. It has 56.3099 degrees, and 45 degrees are odd.\n") != text.npos,
             text.c_str());
  }

  void theSlopeFilter() {
    const std::string text = explained({{{&filterDescriptor(FilterType::Slope), {45, 0}}}});
    QVERIFY2(text.starts_with("too_steep\n"), text.c_str());
    QVERIFY2(text.find("not walkable: too steep. It rises by 56.3099 degrees; at most 45 degrees are allowed.\n") !=
                 text.npos,
             text.c_str());
  }

  // A triangle without area needs no filter for its verdict.
  void aVerdictWithoutAStep() {
    const auto line = Soup().floor(0, 0, 1, 1, 0).triangle({5, 0, 0}, {6, 0, 0}, {7, 0, 0}).environment();
    const Inspected run = inspect(line, "SlopeFilter 45\n");
    const PlaceExplanation told = explain(run, 2, {5.5, 0, 0});
    QVERIFY(told.verdict == PlaceVerdict::NoArea && !told.step);
    QCOMPARE(std::string(verdictWord(run.inspector->pipeline(), told)), std::string("no_area"));
    QVERIFY(formatExplanation(*run.inspector, told)
                .find("not walkable: without area. The corners of this triangle lie "
                      "on one line.\n") != std::string::npos);
  }
};

QTEST_APPLESS_MAIN(TestRemovals)
#include "test_removals.moc"
