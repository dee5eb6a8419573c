// The preview of an edit before it runs, compared with the result of the run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <ctime>

#include "core/io/import.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "tests/editor/editor_driver.hpp"
#include "ui/view/previews/edit_preview.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

double areaOf(const NavigationMeshGeometry& geometry) {
  double area = 0;
  for (std::size_t v = 0; v < geometry.surface.size(); v += 3) {
    std::array<double, 3> a{}, b{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double origin = geometry.surface[v].position[k];
      a[k] = geometry.surface[v + 1].position[k] - origin;
      b[k] = geometry.surface[v + 2].position[k] - origin;
    }
    area += std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]) / 2;
  }
  return area;
}

/// True when a place is near the border of the floor of 8 x 8.
bool isNearBorder(const NavigationMeshGeometry& geometry, double distance) {
  return std::all_of(geometry.surface.begin(), geometry.surface.end(), [&](const SurfaceVertex& vertex) {
    return std::max(std::abs(vertex.position[0]), std::abs(vertex.position[1])) > 4 - distance - 1e-4;
  });
}

bool about(double a, double b) { return std::abs(a - b) < 1e-4; }

bool isPainted(const NavigationMeshGeometry& geometry, const Paint& paint) {
  const auto& colour = geometry.surface.front().colour;
  return colour[0] == paint.colour.red() && colour[1] == paint.colour.green() && colour[2] == paint.colour.blue();
}

}  // namespace

class TestEditPreview : public QObject {
  Q_OBJECT

 private slots:
  void facesGoAndComeWithTheirSlope() {
    load(tableObj());  // 68 without the ramp of 60 degrees, whose area is 8
    const auto preview = prepare(FilterType::Slope, 50);
    QVERIFY(preview->changes({50}, {59.9}).empty());
    const auto come = preview->changes({50}, {61});
    QCOMPARE(come.size(), std::size_t{1});
    QVERIFY(isPainted(*come[0], walkablePaint()));
    QVERIFY(about(areaOf(*come[0]), areaAt("SlopeFilter 61\n") - areaAt("SlopeFilter 50\n")));
    const auto gone = preview->changes({61}, {50});
    QCOMPARE(gone.size(), std::size_t{1});
    QVERIFY(isPainted(*gone[0], removalStyle(FilterType::Slope)->paint));
    QVERIFY(about(areaOf(*gone[0]), areaOf(*come[0])));
  }

  void regionsGoWithTheirArea() {
    load(tableObj());
    const auto preview = prepare(FilterType::Area, 0);
    QVERIFY(preview->changes({0}, {3.9}).empty());
    for (const double minimum : {4.0, 7.9, 8.1, 100.0}) {
      const auto gone = preview->changes({0}, {minimum});
      QCOMPARE(gone.size(), std::size_t{1});
      const std::string edited = "AreaFilter " + std::to_string(minimum) + '\n';
      QVERIFY(about(areaOf(*gone[0]), areaAt("AreaFilter 0\n") - areaAt(edited)));
    }
    QVERIFY(preview->changes({5}, {0}).empty());  // Only the run can find what comes back.
  }

  void floorsGoWhereObstaclesAre() {
    // A board that rises from 0.5 to 3 over the floor.
    load(floorObj() + "v -2 -1 0.5\nv 2 -1 3\nv 2 1 3\nv -2 1 0.5\nf 5 6 7 8\n");
    const auto preview = prepare(FilterType::VerticalClearance, 2);
    for (const auto& [low, high] : {std::pair{1.0, 2.0}, std::pair{0.25, 4.0}, std::pair{2.0, 2.25}}) {
      const double lost = areaWithClearance(low) - areaWithClearance(high);
      const auto gone = preview->changes({low}, {high});
      QCOMPARE(gone.size(), std::size_t{1});
      QVERIFY(isPainted(*gone[0], removalStyle(FilterType::VerticalClearance)->paint));
      QVERIFY2(about(areaOf(*gone[0]), lost),
               qPrintable(QString::number(areaOf(*gone[0])) + ' ' + QString::number(lost)));
      const auto back = preview->changes({high}, {low});
      QVERIFY(back.size() >= 1 && isPainted(*back[0], walkablePaint()));
      QVERIFY(about(areaOf(*back[0]), lost));
    }
    QVERIFY(preview->changes({3.5}, {3.9}).empty());
    QVERIFY(preview->changes({2}, {5}).empty());  // The value is beyond the prepared range.
  }

  void whatIsUnderSomethingLowerDoesNotComeBack() {
    load(tableObj() + "v -1 -1 2.5\nv 1 -1 2.5\nv 1 1 2.5\nv -1 1 2.5\nf 13 14 15 16\n");
    // The upper board stands 1.5 above the table and 2.5 above the floor, the table 1 above the floor.
    const auto back = prepare(FilterType::VerticalClearance, 3)->changes({3}, {1.2});
    QCOMPARE(back.size(), std::size_t{2});
    QVERIFY(about(areaOf(*back[0]), 8));  // Places are under the board, on the table and on the floor.
    QVERIFY(isPainted(*back[1], removalStyle(FilterType::VerticalClearance)->paint));
    QVERIFY(about(areaOf(*back[1]), 4));  // but over the latter stands the table
  }

  void whatDependsOnNothingNewServesAgain() {
    load(tableObj());
    const auto preview = prepare(FilterType::VerticalClearance, 2);
    const EditedStep same{FilterType::VerticalClearance, {2.5}, before_, nullptr};
    QVERIFY(preview->suits(same));
    EditedStep other = same;
    other.values = {4};  // The range ends at twice the clearance that it was made for.
    QVERIFY(!preview->suits(other));
    other = same;
    other.before = std::make_shared<NavigationMesh>(*before_);
    QVERIFY(!preview->suits(other));
  }

  void stepsComeAndGo() {
    // Two floors with a riser of 0.3 between them, and beyond 0.6 a third one behind a wall.
    load(
        "v -4 -4 0\nv 0 -4 0\nv 0 4 0\nv -4 4 0\nf 1 2 3 4\n"
        "v 0 -4 0.3\nv 4 -4 0.3\nv 4 4 0.3\nv 0 4 0.3\nf 5 6 7 8\nf 2 3 8 5\n"
        "v 4 -4 0.6\nv 8 -4 0.6\nv 8 4 0.6\nv 4 4 0.6\nf 9 10 11 12\n"
        "v 4 -4 3\nv 4 4 3\nf 6 7 14 13\n");
    const std::string head = "SlopeFilter 45\nVerticalClearanceFilter 2\n";
    QCOMPARE(linksOf(head + "StepFilter 0.2 0\n"), std::size_t{0});
    QCOMPARE(linksOf(head + "StepFilter 0.35 0\n"), std::size_t{1});
    const auto low = prepareLast(head + "StepFilter 0.2 0\n");
    QVERIFY(low->changes({0.2, 0}, {0.29, 0}).empty());
    const auto come = low->changes({0.2, 0}, {0.35, 0});
    QCOMPARE(come.size(), std::size_t{1});
    QVERIFY(isPainted(*come[0], Paint{stepColour()}));
    // The riser and strips of 0.03 on both floors, from both sides; nothing at the wall.
    QVERIFY(about(areaOf(*come[0]), 2 * 8 * (0.3 + 2 * 0.03)));
    QVERIFY(low->changes({0.2, 0}, {0.5, 0}).empty());  // The value is beyond the prepared range.
    const auto high = prepareLast(head + "StepFilter 0.35 0\n");
    QVERIFY(high->changes({0.35, 0}, {0.31, 0}).empty());
    const auto gone = high->changes({0.35, 0}, {0.29, 0});
    QCOMPARE(gone.size(), std::size_t{1});
    QVERIFY(isPainted(*gone[0], Paint{obstacleEdgeColour()}));
    QVERIFY(high->changes({0.35, 0}, {0.7, 0}).empty());  // the wall stands there
  }

  void gapsComeAndGo() {
    load(
        "v -4 -4 0\nv 0 -4 0\nv 0 4 0\nv -4 4 0\nf 1 2 3 4\n"
        "v 0.1 -4 0\nv 4 -4 0\nv 4 4 0\nv 0.1 4 0\nf 5 6 7 8\n");
    const std::string head = "SlopeFilter 45\nVerticalClearanceFilter 2\n";
    QCOMPARE(linksOf(head + "StepFilter 0.4 0.05\n"), std::size_t{0});
    QCOMPARE(linksOf(head + "StepFilter 0.4 0.11\n"), std::size_t{1});
    const auto narrow = prepareLast(head + "StepFilter 0.4 0.05\n");
    QVERIFY(narrow->changes({0.4, 0.05}, {0.4, 0.09}).empty());
    const auto come = narrow->changes({0.4, 0.05}, {0.4, 0.11});
    QCOMPARE(come.size(), std::size_t{1});
    QVERIFY(isPainted(*come[0], Paint{gapColour()}));
    QVERIFY(about(areaOf(*come[0]), 2 * 8 * (0.1 + 2 * 0.06)));
    const auto gone = prepareLast(head + "StepFilter 0.4 0.11\n")->changes({0.4, 0.11}, {0.4, 0.09});
    QCOMPARE(gone.size(), std::size_t{1});
    QVERIFY(isPainted(*gone[0], Paint{obstacleEdgeColour()}));
  }

  void marginsGrowAndShrink() {
    load(floorObj());  // 8 x 8
    const auto preview = prepareLast("SlopeFilter 45\nVerticalClearanceFilter 2\nRadiusFilter 1 1 0.05\n");
    // Strips along four sides of 6, of which those at corners overlap.
    const auto gone = preview->changes({1, 1, 0.05}, {1.5, 1.5, 0.05});
    QCOMPARE(gone.size(), std::size_t{1});
    QVERIFY(isPainted(*gone[0], removalStyle(FilterType::Radius)->paint));
    QVERIFY2(about(areaOf(*gone[0]), 4 * 6 * 0.5), qPrintable(QString::number(areaOf(*gone[0]))));
    QVERIFY(isNearBorder(*gone[0], 1.5));
    const auto back = preview->changes({1, 1, 0.05}, {0.25, 0.25, 0.05});
    QCOMPARE(back.size(), std::size_t{2});
    QVERIFY(isPainted(*back[0], walkablePaint()));
    QVERIFY(about(areaOf(*back[0]), 4 * 8 * 1));
    QVERIFY(isPainted(*back[1], removalStyle(FilterType::Radius)->paint));
    QVERIFY(about(areaOf(*back[1]), 4 * 8 * 0.25));
    QVERIFY(isNearBorder(*back[1], 0.25));
    // Only a run can find which borders are ledges.
    QVERIFY(preview->changes({1, 1, 0.05}, {1, 1.5, 0.05}).empty());
    QVERIFY(preview->changes({1, 1, 0.05}, {2.5, 2.5, 0.05}).empty());  // The value is beyond the prepared range.
  }

  // A sample of 30,000 triangles; processor time, because other programs may run. It takes under 20 ms, and 50 are due;
  // instrumented or cache-sharing programs take several times as long.
  void editsOfALargeLevelAreShownAtOnce() {
    environment_ = importEnvironment(std::string(FOOTFALL_SOURCE_DIR) + "/samples/villa/villa.obj");
    const std::string head = "SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.4 0.05\n";
    const auto links = prepareLast(head);
    const auto margins = prepareLast(head + "RadiusFilter 0.3 0.3 0.05\n", "AreaFilter 2\nSimplificationFilter\n");
    using Values = EditPreview::Values;
    const auto changesWithin = [](const EditPreview& preview, const Values& from, const Values& to) {
      const std::clock_t begun = std::clock();
      const auto changes = preview.changes(from, to);
      const double ms = 1000.0 * static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
      qInfo("%g %g to %g %g: %.1f ms, %zu surfaces", from[0], from[1], to[0], to[1], ms, changes.size());
      return ms < 500 ? changes.size() : 1000;
    };
    for (const Values& to : {Values{0.1, 0.05}, Values{0.7, 0.05}, Values{0.4, 0}, Values{0.4, 0.3}}) {
      const std::size_t changes = changesWithin(*links, {0.4, 0.05}, to);
      QVERIFY(changes > 0 && changes < 1000);
    }
    // Margins of a level of many borders may be too much to be shown without a run; that is found in time, too.
    for (const double to : {0.28, 0.31, 0.32, 0.45})
      QVERIFY(changesWithin(*margins, {0.3, 0.3, 0.05}, {to, to, 0.05}) < 1000);
  }

  void preparingCanBeCancelled() {
    load(tableObj());
    for (const FilterType filter :
         {FilterType::Slope, FilterType::Area, FilterType::VerticalClearance, FilterType::Step, FilterType::Radius}) {
      const EditedStep step{filter, {2, 2, 0.05}, before_, before_};
      QVERIFY_THROWS_EXCEPTION(Cancelled, makeEditPreview(step, environment_, {}, [] { throw Cancelled(); }));
    }
    QVERIFY(!makeEditPreview({FilterType::LayerSubdivision, {}, before_, before_}, environment_, {}, [] {}));
  }

 private:
  void load(const QByteArray& text) {
    ImportOptions options;
    options.up = UpAxis::Z;
    environment_ = importEnvironment(writeFile(folder_, "level.obj", text).toStdString(), options);
    RunContext context;
    before_ = runPipeline(environment_, parsePipeline("DegeneracyFilter\n", "test"), context).mesh;
  }
  double areaAt(const std::string& pipeline) {
    RunContext context;
    return runPipeline(environment_, parsePipeline(pipeline, "test"), context).summary.area;
  }
  double areaWithClearance(double height) { return areaAt("VerticalClearanceFilter " + std::to_string(height) + '\n'); }
  std::shared_ptr<const EditPreview> prepare(FilterType filter, double threshold) {
    return makeEditPreview({filter, {threshold}, before_, before_}, environment_, {}, [] {});
  }
  /// A preview of the last step of a pipeline, after a run of it and of the steps behind it.
  std::shared_ptr<const EditPreview> prepareLast(const std::string& pipeline, const std::string& behind = {}) {
    Pipeline all = parsePipeline(pipeline, "test"), before = all;
    before.steps.pop_back();
    RunContext context;
    const auto result = runPipeline(environment_, parsePipeline(pipeline + behind, "test"), context).mesh;
    const auto mesh = runPipeline(environment_, before, context).mesh;
    return makeEditPreview({all.steps.back().filter->type, all.steps.back().values, mesh, result}, environment_, {},
                           [] {});
  }
  std::size_t linksOf(const std::string& pipeline) {
    RunContext context;
    return runPipeline(environment_, parsePipeline(pipeline, "test"), context).mesh->links.size();
  }

  QTemporaryDir folder_;
  std::shared_ptr<const Environment> environment_;
  std::shared_ptr<const NavigationMesh> before_;
};

QTEST_MAIN(TestEditPreview)
#include "test_edit_preview.moc"
