// What an edit shows before it runs, against what the run gives.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "core/io/import.hpp"
#include "core/pipeline/runner.hpp"
#include "tests/editor/editor_driver.hpp"
#include "ui/view/edit_preview.hpp"

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
    QVERIFY(preview->changes(50, 59.9).empty());
    const auto come = preview->changes(50, 61);
    QCOMPARE(come.size(), std::size_t{1});
    QVERIFY(isPainted(*come[0], walkablePaint()));
    QVERIFY(about(areaOf(*come[0]), areaAt("SlopeFilter 61\n") - areaAt("SlopeFilter 50\n")));
    const auto gone = preview->changes(61, 50);
    QCOMPARE(gone.size(), std::size_t{1});
    QVERIFY(isPainted(*gone[0], removalStyle(FilterType::Slope)->paint));
    QVERIFY(about(areaOf(*gone[0]), areaOf(*come[0])));
  }

  void regionsGoWithTheirArea() {
    load(tableObj());
    const auto preview = prepare(FilterType::Area, 0);
    QVERIFY(preview->changes(0, 3.9).empty());
    for (const double minimum : {4.0, 7.9, 8.1, 100.0}) {
      const auto gone = preview->changes(0, minimum);
      QCOMPARE(gone.size(), std::size_t{1});
      const std::string edited = "AreaFilter " + std::to_string(minimum) + '\n';
      QVERIFY(about(areaOf(*gone[0]), areaAt("AreaFilter 0\n") - areaAt(edited)));
    }
    QVERIFY(preview->changes(5, 0).empty());  // what comes back only the run knows
  }

  void floorsGoWhereObstaclesAre() {
    // A board that rises from 0.5 to 3 over the floor.
    load(floorObj() + "v -2 -1 0.5\nv 2 -1 3\nv 2 1 3\nv -2 1 0.5\nf 5 6 7 8\n");
    const auto preview = prepare(FilterType::VerticalClearance, 2);
    for (const auto& [low, high] : {std::pair{1.0, 2.0}, std::pair{0.25, 4.0}, std::pair{2.0, 2.25}}) {
      const double lost = areaWithClearance(low) - areaWithClearance(high);
      const auto gone = preview->changes(low, high);
      QCOMPARE(gone.size(), std::size_t{1});
      QVERIFY(isPainted(*gone[0], removalStyle(FilterType::VerticalClearance)->paint));
      QVERIFY2(about(areaOf(*gone[0]), lost),
               qPrintable(QString::number(areaOf(*gone[0])) + ' ' + QString::number(lost)));
      const auto back = preview->changes(high, low);
      QVERIFY(back.size() >= 1 && isPainted(*back[0], walkablePaint()));
      QVERIFY(about(areaOf(*back[0]), lost));
    }
    QVERIFY(preview->changes(3.5, 3.9).empty());
    QVERIFY(preview->changes(2, 5).empty());  // farther than it knows
  }

  void whatIsUnderSomethingLowerDoesNotComeBack() {
    load(tableObj() + "v -1 -1 2.5\nv 1 -1 2.5\nv 1 1 2.5\nv -1 1 2.5\nf 13 14 15 16\n");
    // The upper board stands 1.5 above the table and 2.5 above the floor, the table 1 above the floor.
    const auto back = prepare(FilterType::VerticalClearance, 3)->changes(3, 1.2);
    QCOMPARE(back.size(), std::size_t{2});
    QVERIFY(about(areaOf(*back[0]), 8));  // under the board, on the table and on the floor
    QVERIFY(isPainted(*back[1], removalStyle(FilterType::VerticalClearance)->paint));
    QVERIFY(about(areaOf(*back[1]), 4));  // but over the latter stands the table
  }

  void whatDependsOnNothingNewServesAgain() {
    load(tableObj());
    const auto preview = prepare(FilterType::VerticalClearance, 2);
    const EditedStep same{FilterType::VerticalClearance, 2.5, before_, nullptr};
    QVERIFY(preview->suits(same));
    EditedStep other = same;
    other.threshold = 4;  // it knows no more than twice the clearance that it was made for
    QVERIFY(!preview->suits(other));
    other = same;
    other.before = std::make_shared<NavigationMesh>(*before_);
    QVERIFY(!preview->suits(other));
  }

  void preparingCanBeCancelled() {
    load(tableObj());
    for (const FilterType filter : {FilterType::Slope, FilterType::Area, FilterType::VerticalClearance}) {
      const EditedStep step{filter, 2, before_, before_};
      QVERIFY_THROWS_EXCEPTION(Cancelled, makeEditPreview(step, environment_, {}, [] { throw Cancelled(); }));
    }
    QVERIFY(!makeEditPreview({FilterType::LayerSubdivision, 0, before_, before_}, environment_, {}, [] {}));
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
    return makeEditPreview({filter, threshold, before_, before_}, environment_, {}, [] {});
  }

  QTemporaryDir folder_;
  std::shared_ptr<const Environment> environment_;
  std::shared_ptr<const NavigationMesh> before_;
};

QTEST_MAIN(TestEditPreview)
#include "test_edit_preview.moc"
