// The difference of two meshes as triangles: against cells that are looked at one by one, and against points.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QElapsedTimer>
#include <QtTest>
#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

#include "core/compare/surface_difference.hpp"
#include "core/exact/source_predicates.hpp"
#include "footfall/errors.hpp"

using namespace footfall;
using namespace footfall::detail;

namespace {

using Random = std::mt19937_64;
using Corners = std::array<Vec3, 3>;

NavigationMesh meshOf(const std::vector<Corners>& triangles) {
  NavigationMesh mesh;
  for (const Corners& t : triangles) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), t.begin(), t.end());
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

double areaOf(const Corners& t) {
  const Vec3 u{t[1].x - t[0].x, t[1].y - t[0].y, t[1].z - t[0].z}, v{t[2].x - t[0].x, t[2].y - t[0].y, t[2].z - t[0].z};
  return std::hypot(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x) / 2;
}

double areaOf(const std::vector<Corners>& triangles) {
  return std::accumulate(triangles.begin(), triangles.end(), 0.0,
                         [](double sum, const Corners& t) { return sum + areaOf(t); });
}

bool isInside(const std::vector<Corners>& triangles, double x, double y) {
  const Vec3 p{x, y, 0};
  return std::ranges::any_of(triangles, [&](const Corners& t) {
    const int turn = facing(t[0], t[1], t[2]);
    return turn * facing(t[0], t[1], p) > 0 && turn * facing(t[1], t[2], p) > 0 && turn * facing(t[2], t[0], p) > 0;
  });
}

QString differenceError(const SurfaceDifference& difference) {
  for (std::uint32_t m = 0; m < 2; ++m) {
    const double area = areaOf(difference.triangles[m]);
    if (std::fabs(area - difference.areas[m].surface) > 1e-9 * (1 + area)) return QString("triangles of %1").arg(m);
    double regions = 0;
    for (const DifferentRegion& region : difference.regions) regions += region.mesh == m ? region.area : 0;
    if (std::fabs(area - regions) > 1e-9 * (1 + area)) return QString("regions of %1").arg(m);
    if (difference.hasArea[m] == difference.triangles[m].empty()) return QString("presence of %1").arg(m);
    if (difference.regionOf[m].size() != difference.triangles[m].size()) return "regions of triangles";
  }
  return {};
}

/// A part of a field of unit cells, each in two triangles along one of its diagonals; some are raised.
struct Field {
  static constexpr int kSize = 6;
  Field(Random& random, const std::array<double, kSize * kSize>& heights) {
    for (int i = 0; i < kSize * kSize; ++i) {
      const double x = i % kSize, y = i / kSize, h = heights[i];
      const std::array<Vec3, 4> c = {Vec3{x, y, h}, {x + 1, y, h}, {x + 1, y + 1, h}, {x, y + 1, h}};
      const std::size_t turn = random() % 2;  // direction of the diagonal
      for (std::size_t k = 0; k < 2; ++k) {
        if (random() % 3 == 0) continue;
        const std::size_t a = turn + 2 * k;
        triangles.push_back({c[a % 4], c[(a + 1) % 4], c[(a + 2) % 4]});
        // Quarter q lies between corners q and q + 1.
        quarters[{i, h}] |= 1U << (a % 4) | 1U << ((a + 1) % 4);
      }
    }
  }
  std::vector<Corners> triangles;
  std::map<std::pair<int, double>, unsigned> quarters;
};

double missingFrom(const Field& all, const Field& other) {
  double area = 0;
  for (const auto& [cell, quarters] : all.quarters) {
    const auto found = other.quarters.find(cell);
    area += 0.25 * std::popcount(quarters & ~(found == other.quarters.end() ? 0U : found->second));
  }
  return area;
}

}  // namespace

class TestSurfaceDifference : public QObject {
  Q_OBJECT
 private slots:
  void sameSetsGiveNothing() {
    RunContext context;
    const NavigationMesh one = meshOf({{Vec3{0, 0, 1}, {2, 0, 1}, {2, 2, 1}}, {Vec3{0, 0, 1}, {2, 2, 1}, {0, 2, 1}}});
    const NavigationMesh other = meshOf({{Vec3{0, 0, 1}, {2, 0, 1}, {0, 2, 1}}, {Vec3{2, 0, 1}, {2, 2, 1}, {0, 2, 1}}});
    for (const NavigationMesh* second : {&one, &other}) {
      const SurfaceDifference difference = subtractSurfaces(one, *second, context);
      QVERIFY(difference.empty() && difference.regions.empty());
      QVERIFY(difference.triangles[0].empty() && difference.triangles[1].empty());
    }
    QVERIFY(subtractSurfaces({}, {}, context).empty());
    // The difference to an empty mesh is everything.
    const SurfaceDifference all = subtractSurfaces({}, one, context);
    QVERIFY(!all.hasArea[0] && all.hasArea[1]);
    QCOMPARE(all.areas[1].surface, 4.0);
    QCOMPARE(all.regions.size(), std::size_t{1});
    QCOMPARE(differenceError(all), QString());
  }

  void aHoleAndAnIsland() {
    RunContext context;
    const auto square = [](double x0, double y0, double x1, double y1, double z) {
      return std::vector<Corners>{{Vec3{x0, y0, z}, {x1, y0, z}, {x1, y1, z}},
                                  {Vec3{x0, y0, z}, {x1, y1, z}, {x0, y1, z}}};
    };
    std::vector<Corners> before = square(0, 0, 9, 9, 0), after;
    for (const auto& [x0, y0, x1, y1] :
         {std::array{0., 0., 9., 3.}, {0., 6., 9., 9.}, {0., 3., 3., 6.}, {6., 3., 9., 6.}})
      for (const Corners& t : square(x0, y0, x1, y1, 0)) after.push_back(t);
    for (const Corners& t : square(3, 3, 6, 6, 1)) after.push_back(t);
    const SurfaceDifference difference = subtractSurfaces(meshOf(before), meshOf(after), context);
    QCOMPARE(differenceError(difference), QString());
    QCOMPARE(difference.areas[0].surface, 9.0);
    QCOMPARE(difference.areas[1].surface, 9.0);
    QCOMPARE(difference.regions.size(), std::size_t{2});
    QCOMPARE(difference.regions[0].lower, (Vec3{3, 3, difference.regions[0].mesh == 0 ? 0. : 1.}));
    QCOMPARE(difference.regions[0].upper, (Vec3{6, 6, difference.regions[0].mesh == 0 ? 0. : 1.}));
  }

  void fieldsOfCells() {
    RunContext context;
    Random random(2718);
    for (int round = 0; round < 300; ++round) {
      std::array<double, Field::kSize * Field::kSize> heights{}, others{};
      for (std::size_t i = 0; i < heights.size(); ++i) {
        heights[i] = static_cast<double>(random() % 2);
        others[i] = random() % 8 == 0 ? 1 - heights[i] : heights[i];
      }
      const Field a(random, heights), b(random, others);
      const SurfaceDifference difference = subtractSurfaces(meshOf(a.triangles), meshOf(b.triangles), context);
      QCOMPARE(differenceError(difference), QString());
      QCOMPARE(difference.areas[0].surface, missingFrom(a, b));
      QCOMPARE(difference.areas[1].surface, missingFrom(b, a));
      // |A| + |B - A| = |B| + |A - B|
      QCOMPARE(areaOf(a.triangles) + difference.areas[1].surface, areaOf(b.triangles) + difference.areas[0].surface);
    }
  }

  void crossingTriangles() {
    RunContext context;
    Random random(31415);
    std::uniform_real_distribution<double> place(-3, 3);
    for (int round = 0; round < 300; ++round) {
      const double u = round % 3 == 0 ? 0 : 0.5, v = round % 3 == 2 ? -0.25 : 0;  // coordinates in the common plane
      const auto any = [&] {
        Corners t;
        for (Vec3& p : t) {
          // Coordinates lie on a grid, so that heights are exact.
          p.x = std::round(place(random) * 1024) / 1024;
          p.y = std::round(place(random) * 1024) / 1024;
          p.z = u * p.x + v * p.y;
        }
        return t;
      };
      const std::vector<Corners> a{any()}, b{any()};
      const SurfaceDifference difference = subtractSurfaces(meshOf(a), meshOf(b), context);
      QVERIFY2(differenceError(difference).isEmpty(), qPrintable(differenceError(difference)));
      const double left = areaOf(a) + difference.areas[1].surface, right = areaOf(b) + difference.areas[0].surface;
      QVERIFY2(std::fabs(left - right) < 1e-12 * (1 + left), qPrintable(QString::number(left - right)));
      for (int i = 0; i < 200; ++i) {
        const double x = place(random), y = place(random);
        const bool inA = isInside(a, x, y), inB = isInside(b, x, y);
        QCOMPARE(isInside(difference.triangles[0], x, y), inA && !inB);
        QCOMPARE(isInside(difference.triangles[1], x, y), inB && !inA);
      }
    }
  }

  // A slope that is triangulated anew, with a corner that was rounded: exactly another plane, and nothing to be shown.
  void roundingIsNoDifference() {
    RunContext context;
    const Vec3 a{0, 0, 0}, b{3, 0, 0.1}, c{3, 3, 0.7}, d{0, 3, 0.6}, m{1, 1, 0.1 / 3 + 0.2 + 1e-16};
    const std::vector<Corners> before{{a, b, c}, {a, c, d}}, after{{a, b, m}, {b, c, m}, {c, d, m}};
    const NavigationMesh first = meshOf(before), second = meshOf(after);
    const SurfaceDifference exact = subtractSurfaces(first, second, context);
    QVERIFY(exact.areas[0].surface > 1 && exact.areas[1].surface > 1);
    const SurfaceDifference shown = subtractSurfaces(first, second, context, roundingHeight(first, second));
    QCOMPARE(differenceError(shown), QString());
    QVERIFY(!shown.hasArea[1]);
    // The triangle a, d, m is missing: 1.5 in the plan.
    QVERIFY2(std::fabs(shown.areas[0].plan - 1.5) < 1e-6, qPrintable(QString::number(shown.areas[0].plan, 'g', 17)));
    QCOMPARE(shown.regions.size(), std::size_t{1});
  }

  void aSmallEditOfALargeLevelIsFast() {
    RunContext context;
    std::vector<Corners> ground;
    for (int x = 0; x < 180; ++x)
      for (int y = 0; y < 180; ++y) {
        const double h = (x * 7 + y * 5) % 4 * 0.25, z = (x * 3 + y) % 5 * 0.125;
        ground.push_back({Vec3{x + 0., y + 0., h}, {x + 1., y + 0., z}, {x + 1., y + 1., h}});
        ground.push_back({Vec3{x + 0., y + 0., h}, {x + 1., y + 1., h}, {x + 0., y + 1., z}});
      }
    std::vector<Corners> edited = ground;
    const double gone = areaOf({edited[31000], edited[31001]});
    edited.erase(edited.begin() + 31000, edited.begin() + 31002);
    const NavigationMesh a = meshOf(ground), b = meshOf(edited);
    QElapsedTimer timer;
    timer.start();
    const SurfaceDifference difference = subtractSurfaces(a, b, context);
    qInfo("%zu triangles, %lld ms", ground.size(), static_cast<long long>(timer.elapsed()));
    QVERIFY(std::fabs(difference.areas[0].surface - gone) < 1e-12 && !difference.hasArea[1]);
    QCOMPARE(difference.regions.size(), std::size_t{1});
    context.cancel();
    QVERIFY_EXCEPTION_THROWN(subtractSurfaces(a, b, context), Cancelled);
  }
};

QTEST_GUILESS_MAIN(TestSurfaceDifference)
#include "test_surface_difference.moc"
