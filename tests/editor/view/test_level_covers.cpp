// "Look inside" hides roofs and outer walls, and no floor that has a storey above it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include "ui/view/geometry/level_covers.hpp"

using namespace footfall::ui;

namespace {

struct Scene {
  std::vector<SurfaceVertex> surface;
  std::vector<std::uint32_t> regions;
  std::uint32_t next = 0;

  // A quad of two triangles, counter-clockwise seen from where it faces.
  std::uint32_t add(std::array<std::array<float, 3>, 4> p) {
    for (const int k : {0, 1, 2, 0, 2, 3}) {
      SurfaceVertex vertex{};
      vertex.position = p[static_cast<std::size_t>(k)];
      surface.push_back(vertex);
    }
    regions.insert(regions.end(), 2, next);
    return next++;
  }
  // Returns the region of its upper side.
  std::uint32_t addSlab(float half, float z, float thickness) {
    const float low = z - thickness;
    const std::uint32_t top = add({{{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}}});
    add({{{-half, half, low}, {half, half, low}, {half, -half, low}, {-half, -half, low}}});
    return top;
  }
};

// A tower without outer walls: a slab over each storey, each a little smaller than the one below.
Scene tower(int storeys, std::vector<std::uint32_t>& floors) {
  Scene scene;
  for (int i = 0; i <= storeys; ++i)
    floors.push_back(scene.addSlab(10 - 0.3F * static_cast<float>(i), 3.5F * static_cast<float>(i), 0.4F));
  return scene;
}

}  // namespace

class TestLevelCovers : public QObject {
  Q_OBJECT

 private slots:
  void noStoreyOfATowerIsARoof() {
    std::vector<std::uint32_t> floors;
    const Scene scene = tower(16, floors);
    const std::vector<bool> covers = findCovers(scene.surface, scene.regions);
    // All but the last have a storey above.
    for (std::size_t i = 0; i + 1 < floors.size(); ++i)
      QVERIFY2(!covers[2 * floors[i]], qPrintable(QStringLiteral("storey %1").arg(i)));
  }

  void aRoofOverOneFloorStillIs() {
    Scene scene;
    scene.addSlab(10, 0, 0.4F);
    const std::uint32_t roof = scene.addSlab(10, 3.5F, 0.3F);
    for (const float side : {-1.0F, 1.0F}) {
      // Walls, seen from outside.
      const float at = 10 * side;
      if (side < 0) {
        scene.add({{{-10, 10, 0}, {-10, -10, 0}, {-10, -10, 3.5F}, {-10, 10, 3.5F}}});
        scene.add({{{-10, at, 0}, {10, at, 0}, {10, at, 3.5F}, {-10, at, 3.5F}}});
      } else {
        scene.add({{{10, -10, 0}, {10, 10, 0}, {10, 10, 3.5F}, {10, -10, 3.5F}}});
        scene.add({{{10, at, 0}, {-10, at, 0}, {-10, at, 3.5F}, {10, at, 3.5F}}});
      }
    }
    const std::vector<bool> covers = findCovers(scene.surface, scene.regions);
    QVERIFY(covers[2 * roof]);
    QVERIFY(!covers[0]);
  }
};

QTEST_APPLESS_MAIN(TestLevelCovers)
#include "test_level_covers.moc"
