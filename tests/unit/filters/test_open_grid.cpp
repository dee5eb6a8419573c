// The grid of open space above a face: squares that it reports as closed or out of reach must be so, and it must report
// nearly all that are.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <random>

#include "core/assembly/walkable_state.hpp"
#include "core/filters/open_grid.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

using Corners = std::array<Vec3, 3>;

/// +1 inside, -1 beside; of places that are far enough from the border.
int sideOf(const Corners& t, double x, double y) {
  int inside = 0;
  for (int k = 0; k < 3; ++k) {
    const Vec3 &a = t[k], &b = t[(k + 1) % 3];
    inside += (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x) > 0 ? 1 : 0;
  }
  return inside == 3 ? 1 : -1;
}

double areaOf(const Corners& t) {
  return ((t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[1].y - t[0].y) * (t[2].x - t[0].x)) / 2;
}

}  // namespace

class TestOpenGrid : public QObject {
  Q_OBJECT
 private slots:
  void closesWhatLiesInside_data() {
    QTest::addColumn<double>("unit");
    QTest::addColumn<double>("place");
    QTest::newRow("whole numbers") << 1.0 << 0.0;
    QTest::newRow("tenths") << 0.1 << 0.0;
    QTest::newRow("far away") << 0.1 << 1e9;
    QTest::newRow("tiny") << 1e-9 << 0.3;
  }
  void closesWhatLiesInside() {
    QFETCH(double, unit);
    QFETCH(double, place);
    std::mt19937 random(1);
    const auto number = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
    int covering = 0, apart = 0;
    for (int round = 0; round < 300; ++round) {
      const auto corner = [&](double z) {
        const double x = std::round(number(-8, 72)), y = std::round(number(-8, 72));
        return Vec3{place + unit * x, place - unit * y, z};
      };
      const Corners face{Vec3{place, place, 0}, Vec3{place + 64 * unit, place, 0},
                         Vec3{place + 64 * unit, place + 64 * unit, 0}};
      Corners above{corner(1), corner(1), corner(1)};
      for (Vec3& p : above) p.y = 2 * place - p.y;
      if (areaOf(above) < 0) std::swap(above[1], above[2]);
      if (areaOf(above) < 4 * unit * unit) continue;
      Soup soup;
      soup.triangle(face[0], face[1], face[2]).triangle(above[0], above[1], above[2]);
      const StatePtr state = runFilters(soup.environment(), "SlopeFilter 45");
      const SourceMesh& mesh = state->kernel->mesh();
      const Index lower = mesh.vertices[mesh.triangles[0][0]].z == 0 ? 0 : 1;
      const Vec3 origin = mesh.vertices[mesh.triangles[lower][0]];
      const auto outline = outlineInPlan(*state->kernel, 1 - lower, mesh.triangles[lower][0]);
      const double scale = std::ldexp(1.0, -mesh.grid.scaleExponent());

      OpenGrid grid(*state->kernel, lower);
      const OpenGrid before = grid;
      grid.cover(outline);
      int closed = 0, inside = 0;
      bool meets = false;
      for (std::size_t row = 0; row < OpenGrid::kSquares; ++row)
        for (std::size_t column = 0; column < OpenGrid::kSquares; ++column) {
          const auto [dx, dy] = grid.middle(column, row);
          const double x = origin.x + scale * dx, y = origin.y + scale * dy;
          // The face is the half of its box under the diagonal.
          QCOMPARE(before.isOpen(column, row), row <= column + 1);
          if (!before.isOpen(column, row)) continue;
          const bool isIn = sideOf(above, x, y) > 0;
          inside += isIn ? 1 : 0;
          meets = meets || (isIn && row < column);
          if (grid.isOpen(column, row)) continue;
          ++closed;
          for (const double u : {-0.45, 0.45})
            for (const double v : {-0.45, 0.45}) QVERIFY(sideOf(above, x + u * unit, y + v * unit) > 0);
        }
      // All inner squares are closed beside squares on the outline.
      double around = 0;
      for (int k = 0; k < 3; ++k)
        around += std::fabs(above[k].x - above[(k + 1) % 3].x) + std::fabs(above[k].y - above[(k + 1) % 3].y);
      QVERIFY(inside - closed <= around / unit + 6);
      covering += closed > 0 ? 1 : 0;

      OpenGrid open = before;
      if (meets) QVERIFY(open.mayReach(outline));
      if (!open.mayReach(outline)) ++apart;
      open.close();
      QVERIFY(open.isClosed() && !open.mayReach(outline));
      open.open(outline);
      if (meets) QVERIFY(!open.isClosed() && open.mayReach(outline));
    }
    QVERIFY2(covering > 100 && apart > 10, qPrintable(QString("%1, %2").arg(covering).arg(apart)));
  }

  // Cells are coarse beside thin triangles: the triangles themselves are tested while few are open.
  void tellsThinTrianglesApart() {
    Soup soup;
    soup.floor(0, 0, 64, 64, 0);
    const StatePtr state = runFilters(soup.environment(), "SlopeFilter 45");
    OpenGrid grid(*state->kernel, 0);
    const auto strip = [](double x) {
      return OpenGrid::Outline{ApproximatePoint{x, 0, 0}, {x + 0x1p-20, 0, 0}, {x, 0.5, 0}};
    };
    grid.close();
    grid.open(strip(0.25));
    QVERIFY(grid.mayReach(strip(0.25)));
    QVERIFY(!grid.mayReach(strip(0.25 + 0x1p-10)));
    for (int i = 0; i < 100; ++i) grid.open(strip(0.125));
    QVERIFY(grid.mayReach(strip(0.25)));
    QVERIFY(grid.mayReach(strip(0.25 + 0x1p-10)));  // too many to check each
  }
};

QTEST_GUILESS_MAIN(TestOpenGrid)
#include "test_open_grid.moc"
