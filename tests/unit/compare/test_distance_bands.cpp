// The heat map of distances: its values, its bands, its bound, and the picture with the legend.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <cmath>

#include "core/base/vector.hpp"
#include "core/report/distance_picture.hpp"
#include "footfall/errors.hpp"

using namespace footfall;
using namespace footfall::detail;

namespace {

/// A square of 8 by 8 whose height rises along x from 0 to `rise`.
NavigationMesh square(double rise) {
  NavigationMesh mesh;
  mesh.vertices = {{0, 0, 0}, {8, 0, rise}, {8, 8, rise}, {0, 8, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

DistanceBands bandsOf(const NavigationMesh& a, const NavigationMesh& b, std::size_t most = 100'000) {
  RunContext context;
  return findDistanceBands(a, b, most, context);
}

double planArea(const std::vector<DistanceBands::Corners>& triangles) {
  double area = 0;
  for (const auto& [a, b, c] : triangles) {
    const double twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (twice < 0) return std::nan("");
    area += twice / 2;
  }
  return area;
}

}  // namespace

class TestDistanceBands : public QObject {
  Q_OBJECT

 private slots:
  void equalMeshesAreAllZero() {
    const DistanceBands bands = bandsOf(square(0), square(0));
    QCOMPARE(bands.largest, 0.0);
    QCOMPARE(bands.mean, 0.0);
    QCOMPARE(bands.samples, std::size_t{4});
    QCOMPARE(planArea(bands.triangles[0]), 64.0);
    for (std::size_t band = 1; band < DistanceBands::kCount; ++band) QVERIFY(bands.triangles[band].empty());
  }

  // Above the flat square every vertex is as far from it as it is high.
  void bandsAreStripesOfARamp() {
    const DistanceBands bands = bandsOf(square(2), square(0));
    QCOMPARE(bands.largest, 2.0);
    QCOMPARE(bands.mean, 1.0);
    QCOMPARE(bands.rms, std::sqrt(2.0));
    QCOMPARE(bands.farthest.x, 8.0);
    for (std::size_t band = 0; band < DistanceBands::kCount; ++band) {
      const double from = 8.0 * static_cast<double>(band) / DistanceBands::kCount, width = 8.0 / DistanceBands::kCount;
      QVERIFY(std::fabs(planArea(bands.triangles[band]) - 8 * width) < 1e-9);
      for (const auto& corners : bands.triangles[band])
        for (const Vec3& p : corners) QVERIFY(p.x > from - 1e-9 && p.x < from + width + 1e-9);
    }
  }

  // The other side does not count: A is a part of B.
  void distancesAreOneSided() {
    NavigationMesh half = square(0);
    half.vertices[1].x = half.vertices[2].x = 4;
    QCOMPARE(bandsOf(half, square(0)).largest, 0.0);
    QCOMPARE(bandsOf(square(0), half).largest, 4.0);
  }

  void theSmallestDistancesAreLeftOut() {
    NavigationMesh mesh;
    for (std::uint32_t i = 0; i < 100; ++i) {
      const double x = 10.0 * i, z = 0.01 * i;
      mesh.vertices.insert(mesh.vertices.end(), {{x, 0, z}, {x + 1, 0, z}, {x, 1, z}});
      mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    NavigationMesh ground;
    ground.vertices = {{-10, -10, 0}, {2000, -10, 0}, {-10, 2000, 0}};
    ground.triangles = {{0, 1, 2}};
    const DistanceBands bands = bandsOf(mesh, ground, 10);
    QCOMPARE(bands.leftOut, std::size_t{90});
    QCOMPARE(bands.samples, std::size_t{300});
    for (const auto& band : bands.triangles)
      for (const auto& corners : band) QVERIFY(corners[0].x >= 900);
  }

  void nothingToCompare() {
    QVERIFY(bandsOf(square(0), NavigationMesh()).isEmpty());
    QVERIFY(bandsOf(NavigationMesh(), square(0)).isEmpty());
    RunContext context;
    context.cancel();
    QVERIFY_THROWS_EXCEPTION(Cancelled, findDistanceBands(square(1), square(0), 100, context));
  }

  void coloursGoFromRedOverGreenToBlue() {
    QCOMPARE(colourOfBand(0), (Rgb{255, 0, 0}));
    QCOMPARE(colourOfBand(DistanceBands::kCount - 1), (Rgb{0, 0, 255}));
    const Rgb middle = colourOfBand(DistanceBands::kCount / 2);
    QVERIFY(middle[1] > 200 && middle[1] > middle[0] && middle[1] > middle[2]);
  }

  void thePictureHasALegend() {
    const DistanceBands bands = bandsOf(square(2), square(0));
    const std::string svg = formatDistancePicture("a.SVG", bands, {"folder/one<1>.obj", "two.obj"});
    for (const char* part : {"one&lt;1&gt;.obj", "two.obj", "d_max 2,", "d_mean 1,", ">0.5<", ">1.5<", "#ff0000",
                             "#0000ff", "4 vertices of A"})
      QVERIFY2(svg.find(part) != std::string::npos, part);
    QVERIFY(svg.find("folder") == std::string::npos);
    QCOMPARE(formatDistancePicture("a.svg", bands, {"a", "b"}), formatDistancePicture("b.svg", bands, {"a", "b"}));
    try {
      checkPictureName("map.png");
      QFAIL("a PNG is refused");
    } catch (const InputError& error) {
      QVERIFY(std::string(error.what()).find("give one that ends in .svg or .pdf") != std::string::npos);
    }
  }
};

QTEST_APPLESS_MAIN(TestDistanceBands)
#include "test_distance_bands.moc"
