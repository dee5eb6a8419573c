// The coarse surfaces that stand for large ones while the camera moves.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <cmath>
#include <set>

#include "ui/coarse_geometry.hpp"

using namespace footfall;

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
