// Layers where floors lie above each other in thousands: the same answer without a list of all overlapping pairs.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <random>

#include "core/pipeline/runner.hpp"
#include "footfall/pipeline.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

struct Slab {
  double x = 0, y = 0, width = 0, depth = 0, z = 0;
};

NavigationMesh layersOf(const Soup& soup) {
  return navigationMesh(runFilters(soup.environment(), "SlopeFilter 45\nLayerSubdivisionFilter\n"));
}

/// Slabs at random places, one above the other, each at a height of its own.
std::vector<Slab> randomSlabs(std::size_t count, double extent) {
  std::mt19937 random(1);
  std::vector<Slab> slabs;
  for (std::size_t i = 0; i < count; ++i) {
    const auto place = [&] { return static_cast<double>(random() % 1000) / 1000 * extent; };
    slabs.push_back({place(), place(), 10.0 + static_cast<double>(random() % 20),
                     10.0 + static_cast<double>(random() % 20), 3.0 * static_cast<double>(i)});
  }
  return slabs;
}

/// Each slab, lowest first, goes to the first layer where it overlaps nothing.
std::vector<std::uint32_t> firstFit(const std::vector<Slab>& slabs) {
  std::vector<std::uint32_t> layers;
  for (std::size_t i = 0; i < slabs.size(); ++i) {
    const Slab& a = slabs[i];
    std::vector<char> blocked(i + 1, 0);
    for (std::size_t j = 0; j < i; ++j) {
      const Slab& b = slabs[j];
      const bool overlap = a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.depth && b.y < a.y + a.depth;
      if (overlap) blocked[layers[j]] = 1;
    }
    layers.push_back(static_cast<std::uint32_t>(std::find(blocked.begin(), blocked.end(), 0) - blocked.begin()));
  }
  return layers;
}

/// A ramp that winds around the origin, four sides a turn.
Soup helix(int turns) {
  Soup soup;
  double z = 0;
  for (int i = 0; i < 4 * turns; ++i) {
    const double angle = 1.5707963267948966 * i;
    const auto at = [&](double x, double y, double height) {
      const double c = std::round(std::cos(angle)), s = std::round(std::sin(angle));
      return Vec3{c * x - s * y, s * x + c * y, height};
    };
    soup.quad(at(10, -10, z), at(20, -20, z), at(20, 20, z + 1), at(10, 10, z + 1));
    z += 1;
  }
  return soup;
}

}  // namespace

class TestTowers : public QObject {
  Q_OBJECT
 private slots:
  void floorsAboveEachOther() {
    constexpr int kFloors = 4000;  // sixteen million pairs of triangles
    Soup soup;
    for (int i = 0; i < kFloors; ++i) soup.floor(0, 0, 10, 10, 3.0 * i);
    const NavigationMesh mesh = layersOf(soup);
    QCOMPARE(mesh.layerCount, static_cast<std::uint32_t>(kFloors));
    QCOMPARE(mesh.triangles.size(), std::size_t{2 * kFloors});
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      QCOMPARE(mesh.layers[t], static_cast<std::uint32_t>(mesh.vertices[mesh.triangles[t][0]].z / 3));
  }

  void slabsGoToTheFirstLayerWithRoom_data() {
    QTest::addColumn<int>("count");
    QTest::addColumn<double>("extent");
    QTest::newRow("few: from a list of pairs") << 200 << 100.0;
    QTest::newRow("many") << 3000 << 40.0;
    QTest::newRow("many, in one place") << 2500 << 5.0;
  }
  void slabsGoToTheFirstLayerWithRoom() {
    QFETCH(int, count);
    QFETCH(double, extent);
    const std::vector<Slab> slabs = randomSlabs(static_cast<std::size_t>(count), extent);
    Soup soup;
    for (const Slab& s : slabs) soup.floor(s.x, s.y, s.x + s.width, s.y + s.depth, s.z);
    const NavigationMesh mesh = layersOf(soup);
    const std::vector<std::uint32_t> expected = firstFit(slabs);
    QCOMPARE(mesh.triangles.size(), 2 * slabs.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto slab = static_cast<std::size_t>(mesh.vertices[mesh.triangles[t][0]].z / 3);
      QCOMPARE(mesh.layers[t], expected[slab]);
    }
    QCOMPARE(mesh.layerCount, *std::max_element(expected.begin(), expected.end()) + 1);
  }

  // A region that lies above itself is divided the same way, whether or not a tower stands beside it.
  void rampsBesideATower() {
    const Soup ramp = helix(30);
    Soup both = ramp;
    for (int i = 0; i < 3000; ++i) both.floor(100, 100, 110, 110, 3.0 * i);
    const NavigationMesh alone = layersOf(ramp), beside = layersOf(both);
    QVERIFY(alone.layerCount > 1 && alone.layerCount <= 30);
    QCOMPARE(beside.layerCount, 3000U);
    QCOMPARE(beside.connections.size(), alone.connections.size());
    using Key = std::array<double, 9>;
    const auto byPlace = [](const NavigationMesh& mesh) {
      std::map<Key, std::uint32_t> layers;
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        Key key{};
        for (std::size_t k = 0; k < 3; ++k) {
          const Vec3& p = mesh.vertices[mesh.triangles[t][k]];
          key[3 * k] = p.x, key[3 * k + 1] = p.y, key[3 * k + 2] = p.z;
        }
        layers[key] = mesh.layers[t];
      }
      return layers;
    };
    const auto expected = byPlace(alone), found = byPlace(beside);
    for (const auto& [place, layer] : expected) {
      QVERIFY(found.contains(place));
      QCOMPARE(found.at(place), layer);
    }
  }

  void progressIsToldToTheEnd() {
    Soup soup;
    for (int i = 0; i < 3000; ++i) soup.floor(0, 0, 10, 10, 3.0 * i);
    std::atomic<int> late{0};
    RunContext context([&](const RunEvent& event) {
      if (event.kind == RunEvent::Kind::Progress && event.step == 1 && event.fraction > 0.6) ++late;
    });
    runPipeline(soup.environment(), parsePipeline("SlopeFilter 45\nLayerSubdivisionFilter\n", "test"), context);
    QVERIFY(late > 10);
  }
};

QTEST_GUILESS_MAIN(TestTowers)
#include "test_towers.moc"
