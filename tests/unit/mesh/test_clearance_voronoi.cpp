// The clearance field against CGAL's exact Voronoi diagrams of segments, on single layers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <cmath>
#include <random>

#include "core/mesh/clearance_field.hpp"
#include "tests/reference/voronoi/segment_voronoi.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// A prism over a convex polygon: what it stands on is a hole.
void addPillar(Soup& soup, const std::vector<std::array<double, 2>>& outline, double height) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto &p = outline[i], &q = outline[(i + 1) % outline.size()];
    soup.quad({p[0], p[1], -0.5}, {q[0], q[1], -0.5}, {q[0], q[1], height}, {p[0], p[1], height});
    if (i >= 2)
      soup.triangle({outline[0][0], outline[0][1], height}, {outline[i - 1][0], outline[i - 1][1], height},
                    {p[0], p[1], height});
  }
}

/// A regular polygon.
void addColumn(Soup& soup, double x, double y, double radius, int corners, double turn) {
  std::vector<std::array<double, 2>> outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = turn + i * 2 * M_PI / corners;
    outline.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle)});
  }
  addPillar(soup, outline, 1);
}

/// Pillars of all shapes and sizes at random places, which may overlap.
Soup pillars(Random& random, int count, bool isOnGrid) {
  Soup soup = Soup().floor(0, 0, 16, 16, 0);
  for (int i = 0; i < count; ++i) {
    double x = uniform(random, 1, 15), y = uniform(random, 1, 15), size = uniform(random, 0.1, 2);
    if (isOnGrid) {
      x = std::round(x), y = std::round(y), size = std::ceil(size);
      soup.box({x, y, -0.5}, {x + size, y + size, 1});
    } else {
      addColumn(soup, x, y, size, 3 + static_cast<int>(random() % 6), uniform(random, 0, 6));
    }
  }
  return soup;
}

/// Pillars hardly wider than a line, in all directions.
Soup needles(Random& random, int count) {
  Soup soup = Soup().floor(0, 0, 16, 16, 0);
  for (int i = 0; i < count; ++i) {
    const double x = uniform(random, 2, 14), y = uniform(random, 2, 14), angle = uniform(random, 0, 6);
    const double c = std::cos(angle), s = std::sin(angle), width = std::pow(10, uniform(random, -6, -1));
    addPillar(soup, {{x, y}, {x + 2 * c, y + 2 * s}, {x + c - width * s, y + s + width * c}}, 1);
  }
  return soup;
}

/// Columns whose corners lie on one circle, about a centre that is as far from all of them.
Soup circle(int count) {
  Soup soup = Soup().floor(0, 0, 16, 16, 0);
  for (int i = 0; i < count; ++i) {
    const double angle = i * 2 * M_PI / count;
    addColumn(soup, 8 + 5 * std::cos(angle), 8 + 5 * std::sin(angle), 0.5, 4, angle);
  }
  return soup;
}

/// The tops of pillars are walkable as well, and lie over the ground in the plan.
bool isGround(const NavigationMesh& mesh, std::uint32_t triangle) {
  for (const std::uint32_t v : mesh.triangles[triangle])
    if (mesh.vertices[v].z != 0) return false;
  return true;
}

void compare(const Soup& soup, Random& random, int places) {
  const NavigationMesh mesh = navigationMesh(runFilters(soup.environment(), minimalPipeline(2)));
  const ClearanceField field(mesh);
  const FieldSurface& surface = field.surface();
  std::vector<reference::PlanSegment> borders;
  for (const FieldEdge& edge : surface.edges) {
    if (!edge.isBorder()) continue;
    if (!isGround(mesh, edge.faces[0])) continue;
    const auto& face = mesh.triangles[edge.faces[0]];
    const Vec3 &a = mesh.vertices[face[edge.sides[0]]], &b = mesh.vertices[face[(edge.sides[0] + 1) % 3]];
    borders.push_back({{{a.x, a.y}, {b.x, b.y}}});
  }
  const reference::SegmentVoronoi voronoi(borders);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < places && isGround(mesh, t); ++i) {
      double u = uniform(random, 0, 1), v = uniform(random, 0, 1);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const Vec3 &a = mesh.vertices[mesh.triangles[t][0]], &b = mesh.vertices[mesh.triangles[t][1]],
                 &c = mesh.vertices[mesh.triangles[t][2]];
      const double x = c.x + u * (a.x - c.x) + v * (b.x - c.x), y = c.y + u * (a.y - c.y) + v * (b.y - c.y);
      const double expected = voronoi.distance(x, y), found = field.at(t, x, y).distance;
      QVERIFY2(std::fabs(found - expected) <= 0x1p-36 * surface.scale,
               qPrintable(QStringLiteral("%1 %2: %3, must be %4").arg(x).arg(y).arg(found).arg(expected)));
    }
}

}  // namespace

class TestClearanceVoronoi : public QObject {
  Q_OBJECT

 private slots:
  void polygonsWithHoles() {
    Random random(seed());
    for (int i = 0; i < rounds(4); ++i) compare(pillars(random, 3 + i, false), random, 1);
  }
  void floorPlans() {
    Random random(seed());
    for (int i = 0; i < rounds(5); ++i) compare(pillars(random, 3 + i, true), random, 2);
  }
  void needlesInAllDirections() {
    Random random(seed());
    for (int i = 0; i < rounds(3); ++i) compare(needles(random, 4 + i), random, 1);
  }
  void cornersOnOneCircle() {
    Random random(seed());
    for (const int count : {4, 8}) compare(circle(count), random, 1);
  }
  void parallelWalls() {
    Random random(seed());
    Soup soup = Soup().floor(0, 0, 16, 16, 0);
    for (int i = 0; i < 7; ++i) soup.box({2.0 * i + 1, 1, -0.5}, {2.0 * i + 2, 15.0 - i % 2, 1});
    compare(soup, random, 4);
  }
};

QTEST_GUILESS_MAIN(TestClearanceVoronoi)
#include "test_clearance_voronoi.moc"
