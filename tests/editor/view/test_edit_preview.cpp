// The preview of an edit before it runs, compared with the result of the run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <ctime>

#include "core/base/vector.hpp"
#include "core/io/import.hpp"
#include "core/mesh/clearance_field.hpp"
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
    const auto preview = prepareLast("SlopeFilter 45\nVerticalClearanceFilter 2\nRadiusFilter 0.5 0.5 0.05\n");
    const auto gone = preview->changes({0.5, 0.5, 0.05}, {1.5, 1.5, 0.05});
    QCOMPARE(gone.size(), std::size_t{1});
    QVERIFY(isPainted(*gone[0], removalStyle(FilterType::Radius)->paint));
    QVERIFY(isNearBorder(*gone[0], 1.5));
    const auto back = preview->changes({0.5, 0.5, 0.05}, {0.25, 0.25, 0.05});
    QCOMPARE(back.size(), std::size_t{1});  // and nothing that stays removed needs drawing anew
    QVERIFY(isPainted(*back[0], walkablePaint()));
    QVERIFY(isNearBorder(*back[0], 0.5));
    const double area = 7.5 * 7.5 - 7 * 7;
    QVERIFY2(std::abs(areaOf(*back[0]) - area) < 1e-3, qPrintable(QString::number(areaOf(*back[0]))));
    QVERIFY(preview->changes({0.5, 0.5, 0.05}, {0.5, 0.5, 0.05}).empty());
    // Only a run can find which borders are ledges.
    QVERIFY(preview->changes({0.5, 0.5, 0.05}, {0.5, 1.5, 0.05}).empty());
    QVERIFY(preview->changes({0.5, 0.5, 0.05}, {1.6, 1.6, 0.05}).empty());  // The value is beyond the prepared range.
  }

  void marginsAreThoseOfTheClearanceField() {
    // A house of two floors with stairs, doors, walls from both sides and corners of all kinds.
    environment_ = importEnvironment(FOOTFALL_SOURCE_DIR "/samples/house/house.obj");
    checkMargins("SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.4 0.05\n", 0.3);
    // Floors that are joined over a gap and a step: their sides there are no borders.
    load(
        "v -4 -4 0\nv 0 -4 0\nv 0 4 0\nv -4 4 0\nf 1 2 3 4\n"
        "v 0.1 -4 0\nv 4 -4 0\nv 4 4 0\nv 0.1 4 0\nf 5 6 7 8\n"
        "v 4 -3 0.3\nv 8 -3 0.3\nv 8 3 0.3\nv 4 3 0.3\nf 9 10 11 12\n");
    checkMargins("SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.4 0.2\n", 0.4);
  }

  void aRoundHoleNearAWallHasManyBorders() {
    // A square with a hole of 200 sides. Each triangle is divided between one wall and dozens of sides of the hole.
    constexpr int kSides = 200;
    std::string obj = "v 4 4 0\nv -4 4 0\nv -4 -4 0\nv 4 -4 0\n";
    for (int i = 0; i < kSides; ++i) {
      const double angle = 2 * std::acos(-1.0) * i / kSides;
      obj += "v " + std::to_string(3 * std::cos(angle)) + " " + std::to_string(3 * std::sin(angle)) + " 0\n";
    }
    const auto face = [&obj](int a, int b, int c) {
      obj += "f " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
    };
    for (int i = 0; i < kSides; ++i) {
      const int corner = 1 + i * 4 / kSides, next = (i + 1) % kSides;
      face(corner, 5 + next, 5 + i);
      if (next * 4 % kSides == 0) face(corner, 1 + corner % 4, 5 + next);
    }
    load(QByteArray::fromStdString(obj));
    checkMargins("SlopeFilter 45\nVerticalClearanceFilter 2\n", 0.3);
  }

  void aPreviewServesAllRadiiOfItsFloor() {
    load(tableObj());
    const auto preview = prepare(FilterType::Radius, 0.5);
    for (const auto& [radius, suits] : {std::pair{0.1, true}, std::pair{0.9, true}, std::pair{1.2, false}})
      QCOMPARE(preview->suits({FilterType::Radius, {radius, radius, 0.05}, before_, nullptr}), suits);
    const auto other = std::make_shared<NavigationMesh>(*before_);
    QVERIFY(!preview->suits({FilterType::Radius, {0.5, 0.5, 0.05}, other, nullptr}));
  }

  // A sample of 30,000 triangles; processor time, because other programs may run. It takes under 20 ms, and 50 are due;
  // instrumented or cache-sharing programs take several times as long.
  void editsOfALargeLevelAreShownAtOnce() {
    environment_ = importEnvironment(FOOTFALL_SOURCE_DIR "/samples/villa/villa.obj");
    const std::string head = "SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.4 0.05\n";
    const auto links = prepareLast(head);
    const std::string radius = head + "RadiusFilter 0.3 0.3 0.05\n";
    const auto margins = prepareLast(radius, "AreaFilter 2\nSimplificationFilter\n");
    using Values = EditPreview::Values;
    const auto changesWithin = [](const EditPreview& preview, const Values& from, const Values& to) {
      const std::clock_t begun = std::clock();
      const auto changes = preview.changes(from, to);
      const double ms = 1000.0 * static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
      std::size_t triangles = 0;
      for (const auto& surface : changes) triangles += surface->surface.size() / 3;
      qInfo("%g %g to %g %g: %.1f ms, %zu triangles", from[0], from[1], to[0], to[1], ms, triangles);
      return ms < 500 ? changes.size() : 1000;
    };
    for (const Values& to : {Values{0.1, 0.05}, Values{0.7, 0.05}, Values{0.4, 0}, Values{0.4, 0.3}}) {
      const std::size_t changes = changesWithin(*links, {0.4, 0.05}, to);
      QVERIFY(changes > 0 && changes < 1000);
    }
    for (const double to : {0.28, 0.31, 0.32, 0.45}) {
      const std::size_t changes = changesWithin(*margins, {0.3, 0.3, 0.05}, {to, to, 0.05});
      QVERIFY(changes > 0 && changes < 1000);
    }
    environment_ = importEnvironment(FOOTFALL_SOURCE_DIR "/samples/docks/docks.obj");
    const auto docks = prepareLast(radius);
    for (const double to : {0.05, 0.28, 0.32, 0.45, 0.6, 0.9}) {
      const std::size_t changes = changesWithin(*docks, {0.3, 0.3, 0.05}, {to, to, 0.05});
      QVERIFY(changes > 0 && changes < 1000);
    }
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
  /// Compares the margins of two radii, from one to the other, with the distances of the clearance field.
  void checkMargins(const std::string& pipeline, double radius) {
    RunContext context;
    const auto mesh = runPipeline(environment_, parsePipeline(pipeline, "test"), context).mesh;
    const auto preview =
        makeEditPreview({FilterType::Radius, {radius, radius, 0.05}, mesh, mesh}, environment_, {}, [] {});
    const ClearanceField field(*mesh);
    for (const double to : {0.5 * radius, 1.5 * radius, 2.5 * radius}) {
      const auto surfaces = preview->changes({radius, radius, 0.05}, {to, to, 0.05});
      QVERIFY(!surfaces.empty());
      const double low = std::min(radius, to), high = std::max(radius, to), slack = 1e-4;
      int changed = 0, kept = 0, wrong = 0;
      std::uint32_t state = 1;
      const auto next = [&state] { return (state = state * 1664525U + 1013904223U) / 4294967296.0; };
      for (int i = 0; i < 2000; ++i) {
        const auto face = static_cast<std::uint32_t>(next() * static_cast<double>(mesh->triangles.size()));
        const Triangle& t = mesh->triangles[face];
        double u = next(), v = next();
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const Vec3 &a = mesh->vertices[t[0]], &b = mesh->vertices[t[1]], &c = mesh->vertices[t[2]];
        const Vec3 p = a + u * (b - a) + v * (c - a);
        const double distance = field.at(face, p.x, p.y).distance;
        // The last surface that has a place is the one in sight.
        int shown = -1;
        for (std::size_t k = 0; k < surfaces.size(); ++k)
          if (holds(*surfaces[k], p)) shown = static_cast<int>(k);
        const bool isBack = to < radius;
        if (distance > high * 1.01 + slack) {
          wrong += shown >= 0;
          ++kept;
        } else if (distance > low * 1.01 + slack && distance < high - slack) {
          wrong += shown != 0;
          ++changed;
        } else if (distance < low - slack) {
          // A margin that stays is in sight as what it was, or drawn again.
          wrong += isBack && shown == 0;
        }
      }
      qInfo("%g to %g: %d places changed, %d kept, %d wrong", radius, to, changed, kept, wrong);
      QVERIFY(changed > 20 && kept > 20);
      QCOMPARE(wrong, 0);
    }
  }
  static bool holds(const NavigationMeshGeometry& geometry, const Vec3& p) {
    for (std::size_t v = 0; v < geometry.surface.size(); v += 3) {
      const auto at = [&](std::size_t k) {
        const auto& q = geometry.surface[v + k].position;
        return Vec3{q[0], q[1], q[2]};
      };
      const Vec3 a = at(0), b = at(1), c = at(2);
      const auto side = [&p](const Vec3& from, const Vec3& to) {
        return (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
      };
      const auto isBeside = [&side](const Vec3& from, const Vec3& to) {
        return side(from, to) < -1e-6 * std::hypot(to.x - from.x, to.y - from.y);
      };
      const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
      if (isBeside(a, b) || isBeside(b, c) || isBeside(c, a) || area < 1e-9) continue;
      const double z = (a.z * side(b, c) + b.z * side(c, a) + c.z * side(a, b)) / area;
      if (std::abs(z - p.z) < 0.05) return true;
    }
    return false;
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
