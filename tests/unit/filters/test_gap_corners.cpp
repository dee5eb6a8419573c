// StepFilter across gaps at corners and between borders at large angles: from both sides of the definition.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>

#include "core/assembly/mesh_assembly.hpp"
#include "core/assembly/walkable_state.hpp"
#include "core/mesh/gap_bridges.hpp"
#include "core/mesh/surface_topology.hpp"
#include "footfall/inspect.hpp"
#include "footfall/io.hpp"
#include "footfall/path.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run.hpp"
#include "tests/reference/gaps.hpp"
#include "tests/support/exact_borders.hpp"
#include "tests/support/live_runs.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/run_with_threads.hpp"
#include "tests/support/soup.hpp"
#include "tests/support/soup_generators.hpp"
#include "tests/unit/filters/gap_agreement.hpp"

using namespace footfall;
using namespace footfall::test;
using namespace footfall::test::corners;

namespace {

double planLength(const NavigationMesh& mesh, const std::array<std::uint32_t, 2>& edge) {
  const Vec3 &p = mesh.vertices[edge[0]], &q = mesh.vertices[edge[1]];
  return std::hypot(p.x - q.x, p.y - q.y);
}

/// Two floors of 4 by 4 corner to corner, the second one moved by that much.
Soup diagonal(double x, double y, double rise = 0) {
  return Soup().floor(0, 0, 4, 4, 0).floor(4 + x, 4 + y, 8 + x, 8 + y, rise);
}
Soup turned(const Soup& soup, double degrees) {
  const double angle = degrees * std::acos(-1.0) / 180, c = std::cos(angle), s = std::sin(angle);
  return soup.mapped([=](const Vec3& p) { return Vec3{c * p.x - s * p.y, s * p.x + c * p.y, p.z}; });
}
/// A floor between x = 0 and 4 whose lower right corner points down, and a floor below: `degrees` between both borders.
Soup pointed(double degrees, double apart) {
  const double angle = degrees * std::acos(-1.0) / 180;
  const double x = 3 * std::cos(angle), y = 3 * std::sin(angle);
  return Soup().floor(-4, -4, 4, 0, 0).triangle({0, apart, 0}, {x, apart + y, 0}, {-x, apart + y, 0});
}

/// Convex floors at all angles whose corners come near to each other, with walls, steps and ceilings.
Soup randomCorners(std::mt19937& random) {
  const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  const auto pick = [&](int count) { return std::uniform_int_distribution(0, count - 1)(random); };
  const bool isGrid = pick(3) == 0;
  const auto place = [&](double low, double high) {
    return isGrid ? std::round(number(low, high) * 32) / 32 : number(low, high);
  };
  Soup soup;
  for (int i = 0; i < 4; ++i) {
    // Two edges from a corner near the middle, away from it.
    const double angle = i * 1.5707963 + number(-0.7, 0.7), opening = number(0.2, 1.5);
    const double x = place(-0.2, 0.2), y = place(-0.2, 0.2), z = pick(2) == 0 ? 0 : place(-0.3, 0.3);
    const double rise = pick(3) == 0 ? place(-0.2, 0.2) : 0;
    const auto at = [&](double a, double up) {
      return Vec3{x + place(1, 2) * std::cos(a), y + place(1, 2) * std::sin(a), z + up};
    };
    soup.triangle({x, y, z}, at(angle - opening / 2, rise), at(angle + opening / 2, 0));
  }
  for (int i = pick(3); i > 0; --i) {
    const double x = place(-0.4, 0.4), y = place(-0.4, 0.4), base = place(-0.3, 2.2);
    soup.wall(x, y, x + place(-0.3, 0.3), y + place(-0.3, 0.3), base, base + place(0.05, 1.5));
  }
  if (pick(4) == 0) soup.ceiling(-1, -1, place(0, 1), place(0, 1), place(1.8, 2.6));
  return soup;
}

}  // namespace

class TestGapCorners : public QObject {
  Q_OBJECT

 private slots:
  void cornerToCorner() {
    // A ruling from either corner is 0.05 long at the most: 0.03 across and 0.04 along, of which 0.03 is there already.
    const NavigationMesh mesh = linked(diagonal(0.03, 0.03, 0.25), 0.25, 0.05);
    QCOMPARE(gapCount(mesh), std::size_t{1});  // The link is on one side of the corner; the other side would lead
                                               // nowhere else.
    QCOMPARE(parts(mesh), std::size_t{1});
    QCOMPARE(pathParts(mesh), 1U);
    QCOMPARE(findMeshError(mesh), std::string());
    for (const StepLink& link : mesh.links) {
      QCOMPARE(bridgeOver(link, mesh.vertices).size(), std::size_t{2});
      QVERIFY(std::fabs(link.width - 0.05) < 1e-10 && link.width <= 0.05);
      QCOMPARE(link.height, 0.25);
      for (const auto& edge : {link.from, link.to}) QVERIFY(std::fabs(planLength(mesh, edge) - 0.01) < 1e-10);
    }
    // Too far, too high, at the corner itself.
    QCOMPARE(gapCount(linked(diagonal(0.03, 0.0401), 0.25, 0.05)), std::size_t{0});
    QCOMPARE(gapCount(linked(diagonal(0.03, 0.03, 0.26), 0.25, 0.05)), std::size_t{0});
    QCOMPARE(gapCount(linked(diagonal(0, 0), 0.25, 0.05)), std::size_t{0});
    QCOMPARE(gapCount(linked(diagonal(0, 0.03), 0.25, 0.05)), std::size_t{1});  // the other way leads along borders
    QCOMPARE(parts(linked(diagonal(0.03, 0.03), 0.25, 0)), std::size_t{2});
  }

  void anyTurn() {
    for (int degrees = 0; degrees < 360; degrees += 7)
      for (const double x : {0.005, 0.02, 0.03}) {
        const NavigationMesh mesh = linked(turned(diagonal(x, 0.03, 0.125), degrees), 0.25, 0.05);
        QVERIFY2(gapCount(mesh) >= 1 && parts(mesh) == 1 && pathParts(mesh) == 1,
                 qPrintable(QString("%1 degrees, %2").arg(degrees).arg(x)));
      }
  }

  void aCornerAtABorder() {
    // The corner is as near as the gap allows, farther than the bisector of both allows.
    for (const double degrees : {10.0, 30.0, 45.0, 60.0, 70.0, 80.0}) {
      const auto text = QString::number(degrees);
      const NavigationMesh mesh = linked(pointed(degrees, 0.0499), 0.25, 0.05);
      QVERIFY2(gapCount(mesh) == 1 && parts(mesh) == 1 && pathParts(mesh) == 1, qPrintable(text));
      for (const StepLink& link : mesh.links) QVERIFY(link.width <= 0.05);
      QCOMPARE(gapCount(linked(pointed(degrees, 0.0501), 0.25, 0.05)), std::size_t{0});
    }
    QCOMPARE(gapCount(linked(pointed(85, 0.03), 0.25, 0.05)), std::size_t{0});  // the angle is less than 7 degrees
  }

  void whatStandsAtACornerBlocksIt() {
    const auto with = [](double x0, double y0, double x1, double y1, double low) {
      return gapCount(linked(diagonal(0.03, 0.03).wall(x0, y0, x1, y1, low, 3), 0.25, 0.05));
    };
    QCOMPARE(with(4, 4.03, 4.03, 4, 0), std::size_t{0});     // across
    QCOMPARE(with(4, 4.03, 4.03, 4, 2), std::size_t{1});     // The gap is above.
    QCOMPARE(with(4.03, 4.03, 5, 4.03, 0), std::size_t{0});  // The gap is at the corner, along the border.
    // An obstacle on one side leaves the other side, the longer one.
    const auto lengthWith = [](const Soup& wall) {
      const NavigationMesh mesh = linked(diagonal(0.03, 0.03).add(wall), 0.25, 0.05);
      return mesh.links.size() == 1 ? planLength(mesh, mesh.links[0].from) : 0;
    };
    const Soup above = Soup().wall(3.994, 4.001, 3.994, 4.07, 0, 3),
               below = Soup().wall(4.001, 3.994, 4.07, 3.994, 0, 3);
    QVERIFY(std::fabs(lengthWith(above) - 0.01) < 1e-10 && std::fabs(lengthWith(below) - 0.01) < 1e-10);
    // Ways are turned as far as what is in the way leaves them.
    const double length = lengthWith(Soup(above).add(below));
    QVERIFY(length > 0.0029 && length < 0.006);
  }

  void slitsGetNoLinksAcrossTheirVertices() {
    // Chains of edges on both sides, straight and round.
    Soup straight, round;
    for (int i = 0; i < 8; ++i) {
      straight.floor(0, i, 4, i + 1, 0).floor(4.03, i + 0.5, 8, i + 1.5, 0);
      const auto at = [](double radius, double k) {
        return Vec3{radius * std::cos(k * 0.1), radius * std::sin(k * 0.1), 0};
      };
      round.quad(at(1, i), at(4, i), at(4, i + 1), at(1, i + 1));
      round.quad(at(4.03, i), at(8, i), at(8, i + 1), at(4.03, i + 1));
    }
    QCOMPARE(gapCount(linked(straight, 0.25, 0.05)), std::size_t{15});
    const NavigationMesh mesh = linked(round, 0.25, 0.05);
    QCOMPARE(gapCount(mesh), std::size_t{8});
    QCOMPARE(parts(mesh), std::size_t{1});
  }

  void pathsAndLaterFilters() {
    const std::string more = "AreaFilter 17\nSimplificationFilter\nLayerSubdivisionFilter\n";
    for (const std::string& text : {std::string(), more, std::string("VerticalClearanceFilter 2.5\n"),
                                    std::string("RoundingFilter\n"), "DuplicationFilter 1e-6\n" + more}) {
      const auto mesh = std::make_shared<const NavigationMesh>(linked(diagonal(0.03, 0.03, 0.125), 0.25, 0.05, text));
      QCOMPARE(gapCount(*mesh), std::size_t{1});
      const PathFinder finder(mesh);
      const PathResult path = finder.find({1, 1, 0}, {7, 7, 0.125});
      QVERIFY2(path.reached() && path.gaps.size() == 1, text.c_str());
      QVERIFY(std::fabs(path.planLength - 6 * std::sqrt(2.0)) < 1e-9);
    }
    QCOMPARE(gapCount(linked(diagonal(0.03, 0.03), 0.25, 0.05, "RadiusFilter 0.2\n")), std::size_t{0});
  }

  void exportsAndWhy() {
    const QTemporaryDir folder;
    const Soup soup = diagonal(0.03, 0.03, 0.125);
    const NavigationMesh mesh = linked(soup, 0.25, 0.05);
    const std::string path = folder.filePath("a.obj").toStdString();
    save(mesh, path);
    const NavigationMesh read = readNavigationMesh(path).mesh;
    QCOMPARE(read.links.size(), mesh.links.size());
    for (std::size_t i = 0; i < mesh.links.size(); ++i) {
      QCOMPARE(read.links[i].width, mesh.links[i].width);
      QVERIFY(read.links[i].kind == StepKind::Gap);
    }
    // The excess of a smaller gap is stated as it is: from corner to corner.
    const auto apart = std::make_shared<const NavigationMesh>(linked(soup, 0.25, 0.04));
    const PathFinder finder(apart);
    const PathResult none = finder.find({1, 1, 0}, {7, 7, 0.125});
    QVERIFY(none.status == PathStatus::NotConnected);
    const SeparationFinder separations(finder, soup.environment(), kHeight, 0.25, nullptr, 0.04);
    const auto separation = separations.find(none.start->triangle, none.target->triangle);
    QVERIFY(separation.has_value());
    QVERIFY(std::fabs(separation->barrier().gap - std::hypot(0.03, 0.03)) < 1e-9);
    QVERIFY(std::fabs(separation->barrier().excess - (std::hypot(0.03, 0.03) - 0.04)) < 1e-9);
  }

  void structuredSoupsAgree() {
    Counts counts;
    std::vector<Soup> soups;
    for (const double degrees : {0.0, 5.0, 30.0, 45.0, 60.0, 75.0, 84.0, 89.0, 90.0})
      for (const double apart : {0.02, 0.0499, 0x1p-30}) {
        soups.push_back(pointed(degrees == 0 ? 1 : degrees, apart));
        soups.push_back(turned(diagonal(apart, 0.02), degrees));
        soups.push_back(turned(diagonal(apart, std::nextafter(apart, 1), 0.2), degrees));
      }
    soups.push_back(diagonal(0x1p-50, 0x1p-50));
    soups.push_back(diagonal(0.03, 0.04));  // exactly the gap
    soups.push_back(diagonal(0.03, 0.03).wall(4.03, 4.03, 4.03, 5, 0, 3));
    soups.push_back(diagonal(0.03, 0.03).box({4.01, 4.01, 0}, {4.02, 4.02, 0.25}));
    soups.push_back(diagonal(0.03, 0.03).ramp(3.9, 4, 4.1, 4.1, 0, 0.6));
    for (std::size_t i = 0; i < soups.size(); ++i)
      for (const double step : {0.125, 0.25})
        QVERIFY2(agrees(soups[i].environment(), step, 0.05, 1e-6, counts), qPrintable(QString::number(i)));
    qInfo("%zu links, %zu borders", counts.linked, counts.expected);
    QVERIFY(counts.linked > 60);
  }

  void randomCornersAgree() {
    Counts counts;
    std::mt19937 random(static_cast<std::uint32_t>(seed()));
    for (int i = 0; i < rounds(60); ++i) {
      const double step = std::array{0.2, 0.4}[i % 2], gap = std::array{0.05, 0.2, 0.4}[i % 3];
      QVERIFY2(agrees(randomCorners(random).environment(), step, gap, 1e-6, counts), qPrintable(QString::number(i)));
    }
    qInfo("%zu links, %zu borders", counts.linked, counts.expected);
    QVERIFY(counts.linked > 60);
  }

  void farFromTheOrigin() {
    // Links that hold with 2^-40 of the largest coordinate to spare are listed there, too.
    Counts counts;
    std::mt19937 random(static_cast<std::uint32_t>(seed() + 1));
    for (int i = 0; i < rounds(30); ++i) {
      const Soup soup = randomCorners(random).mapped([](const Vec3& v) {
        return Vec3{122000.123 + v.x, 487000.456 + v.y, v.z};
      });
      QVERIFY2(agrees(soup.environment(), 0.3, 0.2, 487000 * 0x1p-40, counts), qPrintable(QString::number(i)));
    }
    QVERIFY(counts.linked > 20);
  }

  void moreNeverPartsAndOrderChangesNothing() {
    std::mt19937 random(7);
    for (int i = 0; i < rounds(60); ++i) {
      const auto environment = randomCorners(random).environment();
      for (const double step : {0.1, 0.3}) {
        std::size_t before = SIZE_MAX;
        for (const double gap : {0.0, 0.05, 0.1, 0.2, 0.3}) {
          const std::string text = gaps(step, gap);
          const NavigationMesh mesh = navigationMesh(runFilters(environment, text));
          QCOMPARE(findMeshError(mesh), std::string());
          QVERIFY2(parts(mesh) <= before, qPrintable(QString("%1, gap %2").arg(i).arg(gap)));
          before = parts(mesh);
          QVERIFY(parts(navigationMesh(runFilters(environment, gaps(step + 0.2, gap)))) <= before);
          std::vector<std::uint32_t> order(environment->triangles.size());
          for (std::uint32_t t = 0; t < order.size(); ++t) order[t] = t;
          std::shuffle(order.begin(), order.end(), random);
          NavigationMesh other;
          runWithThreads(1 + i % 3,
                         [&] { other = navigationMesh(runFilters(shuffled(*environment, order, 1), text)); });
          QVERIFY(other.triangles == mesh.triangles && other.vertices == mesh.vertices);
          QVERIFY(std::ranges::equal(other.links, mesh.links, [](const StepLink& a, const StepLink& b) {
            return a.from == b.from && a.to == b.to && a.kind == b.kind && a.width == b.width && a.height == b.height;
          }));
        }
      }
    }
  }

  void liveEditsGiveTheSame() {
    Soup level = diagonal(0.03, 0.03).floor(-4.02, -4.03, -0.02, -0.03, 0.1).floor(-4.02, 4.01, -0.04, 8, 0.2);
    const std::string pipeline = gaps(0.3, 0.05, "SimplificationFilter\nLayerSubdivisionFilter\n");
    ResultCache cache;
    EditableEnvironment edited(level.environment());
    QVERIFY(agrees(edited.environment(), pipeline, cache));
    const auto crate = [](double x, double y) { return soupFor(Soup().box({x, y, 0}, {x + 0.75, y + 0.75, 0.5})); };
    const ObstacleId id = edited.add(crate(3.5, 1));
    for (const auto& [x, y] : {std::pair(3.5, 3.5), {3.2, 3.2}, {4.0, 4.0}, {-0.5, -0.5}, {4.01, 4.2}, {1.0, 1.0}}) {
      edited.replace(id, crate(x, y));
      QVERIFY2(agrees(edited.environment(), pipeline, cache), qPrintable(QString::number(x)));
    }
    edited.remove(id);
    QVERIFY(agrees(edited.environment(), pipeline, cache));
  }
};

QTEST_GUILESS_MAIN(TestGapCorners)
#include "test_gap_corners.moc"
