// The coarse surfaces that stand for large ones while the camera moves.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <cmath>
#include <set>

#include "footfall/filter_type.hpp"
#include "ui/view/geometry/coarse_geometry.hpp"

using namespace footfall;
using namespace footfall::ui;

namespace {

using Point = std::array<float, 3>;

double areaOf(const std::vector<SurfaceVertex>& surface) {
  double area = 0;
  for (std::size_t v = 0; v + 2 < surface.size(); v += 3) {
    const Point &a = surface[v].position, &b = surface[v + 1].position, &c = surface[v + 2].position;
    const std::array<double, 3> u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, w{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    area += std::hypot(u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]) / 2;
  }
  return area;
}

// Hills on a square of `cells` x `cells`; every triangle has a colour of its own.
std::vector<SurfaceVertex> hills(int cells, float scale) {
  std::vector<SurfaceVertex> surface;
  const auto point = [&](int x, int y) {
    return Point{static_cast<float>(x) * scale, static_cast<float>(y) * scale,
                 scale * 8 * std::sin(static_cast<float>(x) / 40) * std::sin(static_cast<float>(y) / 40)};
  };
  for (int y = 0; y < cells; ++y) {
    for (int x = 0; x < cells; ++x) {
      for (const auto& corners : {std::array{point(x, y), point(x + 1, y), point(x + 1, y + 1)},
                                  std::array{point(x, y), point(x + 1, y + 1), point(x, y + 1)}}) {
        const std::size_t number = surface.size() / 3;
        for (const Point& corner : corners) {
          SurfaceVertex vertex;
          vertex.position = corner;
          vertex.colour = {static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(number >> 8U),
                           static_cast<std::uint8_t>(number >> 16U), 255};
          surface.push_back(vertex);
        }
      }
    }
  }
  return surface;
}

}  // namespace

class TestCoarseGeometry : public QObject {
  Q_OBJECT

 private slots:
  void smallSurfacesStayAsTheyAre() {
    std::vector<std::uint32_t> kept{7};
    QVERIFY(coarsened({}, kept).empty());
    QVERIFY(kept.empty());
    QVERIFY(coarsened(hills(100, 1), kept).empty());
    QVERIFY(kept.empty());
  }

  void largeSurfacesLookAlike_data() {
    QTest::addColumn<float>("scale");
    QTest::newRow("metres") << 1.0F;
    QTest::newRow("tiny") << 1e-12F;
    QTest::newRow("huge") << 1e12F;
  }
  void largeSurfacesLookAlike() {
    QFETCH(float, scale);
    const std::vector<SurfaceVertex> surface = hills(500, scale);  // 500,000 triangles
    std::vector<std::uint32_t> kept;
    const std::vector<SurfaceVertex> coarse = coarsened(surface, kept);
    QCOMPARE(coarse.size(), 3 * kept.size());
    QVERIFY2(kept.size() > kCoarseAim / 3 && kept.size() < 3 * kCoarseAim, qPrintable(QString::number(kept.size())));
    std::set<Point> corners;
    for (const SurfaceVertex& vertex : surface) corners.insert(vertex.position);
    for (std::size_t i = 0; i < kept.size(); ++i) {
      QVERIFY(kept[i] < surface.size() / 3);
      QVERIFY(i == 0 || kept[i - 1] < kept[i]);
      QVERIFY(coarse[3 * i].colour == surface[3 * kept[i]].colour);
      for (std::size_t k = 0; k < 3; ++k) QVERIFY(corners.contains(coarse[3 * i + k].position));
    }
    const double ratio = areaOf(coarse) / areaOf(surface);
    QVERIFY2(ratio > 0.95 && ratio < 1.05, qPrintable(QString::number(ratio)));
  }

  // A third walkable in two layers, a third removed by a filter, a third by the first; triangles that are cut count as
  // what most of them is.
  void floorsHaveThePaintsOfTheResult() {
    constexpr std::uint32_t kTriangles = kCoarseAbove + 9;
    constexpr std::uint32_t kThird = kTriangles / 3;
    Environment environment;
    for (std::uint32_t t = 0; t < kTriangles; ++t) {
      const double x = t;
      for (const Vec3& p : {Vec3{x, 0, 0}, Vec3{x + 1, 0, 0}, Vec3{x, 1, 0}}) environment.vertices.push_back(p);
      environment.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    // The part of each triangle below `height`: 1 - (1 - height)^2 of it.
    const auto part = [](std::uint32_t from, std::uint32_t to, double height) {
      NavigationMesh mesh;
      for (std::uint32_t t = from; t < to; ++t) {
        const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
        const double x = t;
        for (const Vec3& p : {Vec3{x, 0, 0}, Vec3{x + 1, 0, 0}, Vec3{x + 1 - height, height, 0}, Vec3{x, height, 0}})
          mesh.vertices.push_back(p);
        mesh.triangles.push_back({base, base + 1, base + 2});
        mesh.triangles.push_back({base, base + 2, base + 3});
        mesh.sourceTriangles.insert(mesh.sourceTriangles.end(), 2, t);
        mesh.layers.insert(mesh.layers.end(), 2, t % 2);
      }
      return mesh;
    };
    const NavigationMesh before = part(0, 2 * kThird, 0.9);
    for (const double height : {0.4, 0.2}) {  // 64 % and 36 %
      const NavigationMesh result = part(0, kThird, height);
      const auto states = makeFloorStates(environment, result, floorsUnder(result, environment), {&before});
      QVERIFY(states);
      QCOMPARE(states->size(), environment.triangles.size());
      for (std::uint32_t t = 0; t < kTriangles; ++t) {
        std::int32_t due = kFloorAsItIs;
        if (t < 2 * kThird) due = kFirstRemoval;
        if (t < kThird && height > 0.3) due = static_cast<std::int32_t>(t % 2);
        QCOMPARE((*states)[t], due);
      }
      ViewContent content;
      content.floorStates = states;
      content.environmentLayers = std::make_shared<const EnvironmentLayers>();
      const RemovalStyle* const style = removalStyle(FilterType::VerticalClearance);
      QVERIFY(style);
      content.removed.push_back({style, nullptr});
      CoarseSurface coarse;
      coarse.triangles = {0, 1, kThird, kTriangles - 1, 0};
      coarse.surface.resize(3 * coarse.triangles.size());
      coarse.surface[12].colour = {1, 2, 3, 255};  // a wall
      const std::vector<SurfaceVertex> painted = paintedCoarse(coarse, content, CoarsePaints::Result);
      const auto colourOf = [&](std::size_t triangle) {
        const auto& colour = painted[3 * triangle].colour;
        return QColor(colour[0], colour[1], colour[2], colour[3]);
      };
      if (height > 0.3) {
        QCOMPARE(colourOf(0), layerPaint(0).colour);
        QCOMPARE(colourOf(1), layerPaint(1).colour);
        QCOMPARE(QColor(paintedCoarse(coarse, content, CoarsePaints::Vivid)[0].colour[0], 0, 0).red(),
                 paleWalkablePaint().colour.red());
      }
      QCOMPARE(colourOf(2), style->paint.colour);
      QCOMPARE(colourOf(3).alpha(), 0);  // takes the view's floor paint
      QCOMPARE(colourOf(4), QColor(1, 2, 3));
    }
    environment.triangles.resize(kCoarseAbove);
    QVERIFY(!makeFloorStates(environment, before, {}, {}));
  }

  // All in one place, or on one line: there is nothing to divide.
  void surfacesWithoutAreaHaveNone() {
    std::vector<std::uint32_t> kept;
    std::vector<SurfaceVertex> point(3 * (kCoarseAbove + 10));
    QVERIFY(coarsened(point, kept).empty());
    for (std::size_t i = 0; i < point.size(); ++i) point[i].position = {static_cast<float>(i), 0, 0};
    QVERIFY(coarsened(point, kept).empty());
    QVERIFY(kept.empty());
  }
};

QTEST_APPLESS_MAIN(TestCoarseGeometry)
#include "test_coarse_geometry.moc"
