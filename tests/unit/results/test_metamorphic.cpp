// The properties that must not change, or only as stated, when the input is moved, scaled, turned or put in another
// order.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <rapidcheck.h>

#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

#include "core/io/export.hpp"
#include "tests/reference/comparison.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;
using namespace footfall::reference;

namespace {

/// The compared measures: exact plan areas (twice) by input triangle, and of all; parts; obstacle edges; layers.
struct Measures {
  std::map<std::uint32_t, Rational> areas;
  Rational area;
  std::size_t parts = 0, partsOfMesh = 0;
  double obstacleLength = 0;
};

Measures measure(const Environment& environment, const std::string& filters) {
  const StatePtr state = runFilters(std::make_shared<Environment>(environment), filters);
  Measures result;
  const auto pieces = toPieces(exactWalkableTriangles(*state));
  for (const Piece& p : pieces) {
    result.areas[p.source] += twiceArea(p.plan);
    result.area += twiceArea(p.plan);
  }
  result.parts = reference::countParts(reference::connectedParts(pieces));
  const NavigationMesh mesh = navigationMesh(state);
  result.partsOfMesh = test::countParts(mesh);
  result.obstacleLength = reference::obstacleLength(pieces);
  return result;
}

/// Triangles that overlap in one plane may hand an area to each other when the map changes which of them comes first;
/// then only the sum is compared.
void expectScaled(const Measures& before, const Measures& after, double scale, bool sameOwners) {
  const Rational factor = Rational(scale) * Rational(scale);
  RC_ASSERT(after.area == before.area * factor);
  RC_ASSERT(after.parts == before.parts);
  RC_ASSERT(after.partsOfMesh == before.partsOfMesh);
  RC_ASSERT(std::fabs(after.obstacleLength - before.obstacleLength * scale) <= 1e-9 * scale);
  if (!sameOwners) return;
  RC_ASSERT(after.areas.size() == before.areas.size());
  for (const auto& [source, area] : before.areas) {
    const auto found = after.areas.find(source);
    RC_ASSERT(found != after.areas.end() && found->second == area * factor);
  }
}

rc::Gen<Soup> anySoup() {
  return rc::gen::oneOf(rc::gen::map(gridTriangles(14, 3, 3), [](const auto& numbers) { return soupOf(numbers); }),
                        rc::gen::map(gridTriangles(14, 5, 2), [](const auto& numbers) { return soupOf(numbers); }),
                        rc::gen::map(buildingParts(8), [](const auto& numbers) { return buildingOf(numbers); }));
}

Soup genSoup(const char* name) {
  const Soup soup = *rc::gen::noShrink(anySoup());
  RC_LOG() << name << "\n" << toText(*soup.environment());
  return soup;
}

std::string objText(const Environment& environment, const std::string& filters) {
  return formatObj(navigationMesh(runFilters(std::make_shared<Environment>(environment), filters)), {});
}

std::vector<std::uint32_t> randomOrder(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[static_cast<std::size_t>(*below(1 << 20)) % i]);
  return order;
}

void checkMap(const std::string& name, int cases, const std::function<Vec3(const Vec3&)>& map, double scale,
              bool sameOwners) {
  QVERIFY(check(name, cases, [&] {
    const Soup soup = genSoup(name.c_str());
    const double clearance = std::array{1.0, 0.5, 1.5, 2.0}[static_cast<std::size_t>(*below(4))];
    expectScaled(measure(*soup.environment(), minimalPipeline(clearance)),
                 measure(*soup.mapped(map).environment(), minimalPipeline(clearance * scale)), scale, sameOwners);
  }));
}

}  // namespace

class TestMetamorphic : public QObject {
  Q_OBJECT
 private slots:
  void shuffledTriangles() {
    // The product is the same to the last byte; input triangles are the same under their new numbers, but for twins.
    QVERIFY(check("shuffled triangles", 960, [] {
      const auto environment = genSoup("shuffled triangles").environment();
      const std::string filters = minimalPipeline(1) + "LayerSubdivisionFilter\n";
      const auto other =
          shuffled(*environment, randomOrder(environment->triangles.size()), static_cast<std::uint32_t>(*below(3)));
      RC_ASSERT(objText(*environment, filters) == objText(*other, filters));
      expectScaled(measure(*environment, filters), measure(*other, filters), 1, false);
    }));
  }

  void shuffledVertices() {
    QVERIFY(check("shuffled vertices", 960, [] {
      const auto environment = genSoup("shuffled vertices").environment();
      auto other = *environment;
      const auto order = randomOrder(environment->vertices.size());
      for (std::size_t i = 0; i < order.size(); ++i) other.vertices[order[i]] = environment->vertices[i];
      for (Triangle& t : other.triangles)
        for (std::uint32_t& v : t) v = order[v];
      const std::string filters = "DuplicationFilter 0\nDegeneracyFilter\n" + minimalPipeline(1) +
                                  "AreaFilter 1\nSimplificationFilter\n"
                                  "LayerSubdivisionFilter\n";
      RC_ASSERT(objText(*environment, filters) == objText(other, filters));
      expectScaled(measure(*environment, filters), measure(other, filters), 1, true);
    }));
  }

  void sharedVerticesOrNot() {
    QVERIFY(check("shared vertices", 640, [] {
      const auto environment = genSoup("shared vertices").environment();
      auto other = *environment;
      std::map<std::array<double, 3>, std::uint32_t> numbers;
      other.vertices.clear();
      for (Triangle& t : other.triangles) {
        for (std::uint32_t& v : t) {
          const Vec3 p = environment->vertices[v];
          const auto [it, isNew] =
              numbers.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(other.vertices.size()));
          if (isNew) other.vertices.push_back(p);
          v = it->second;
        }
      }
      RC_ASSERT(objText(*environment, minimalPipeline(1)) == objText(other, minimalPipeline(1)));
    }));
  }

  void translated() {
    checkMap(
        "translated", 80,
        [](const Vec3& v) {
          return Vec3{v.x + 1024, v.y - 77.5, v.z + 3.25};
        },
        1, true);
    checkMap(
        "far away", 80,
        [](const Vec3& v) {
          return Vec3{v.x - 0x1p40, v.y + 0x1p45, v.z - 0x1p30};
        },
        1, true);
  }

  void scaled() {
    for (const int exponent : {-60, -3, 7, 90}) {
      const double s = std::ldexp(1, exponent);
      checkMap(
          "scaled by 2^" + std::to_string(exponent), 40,
          [s](const Vec3& v) {
            return Vec3{v.x * s, v.y * s, v.z * s};
          },
          s, true);
    }
  }

  void turned() {
    checkMap(
        "turned by 90 degrees", 60,
        [](const Vec3& v) {
          return Vec3{-v.y, v.x, v.z};
        },
        1, false);
    checkMap(
        "turned by 180 degrees", 60,
        [](const Vec3& v) {
          return Vec3{-v.x, -v.y, v.z};
        },
        1, false);
  }

  void aRepeatedTriangleChangesNothing() {
    QVERIFY(check("repeated triangle", 640, [] {
      const Soup soup = genSoup("repeated triangle");
      if (soup.size() == 0) return;
      const auto index = static_cast<std::uint32_t>(static_cast<std::size_t>(*below(1 << 20)) % soup.size());
      const auto& t = soup.triangles()[index];
      const auto environment = soup.environment();
      const auto before = measure(*environment, minimalPipeline(1));
      expectScaled(before, measure(*Soup(soup).triangle(t[1], t[2], t[0]).environment(), minimalPipeline(1)), 1, false);
      // Turned over, a ceiling would become a floor; a floor only gets a coplanar rejected twin.
      if (!upwardCorners(*environment, index)) return;
      expectScaled(before, measure(*Soup(soup).triangle(t[2], t[1], t[0]).environment(), minimalPipeline(1)), 1, false);
    }));
  }

  void cuttingATriangleChangesNothing() {
    QVERIFY(check("cut triangle", 640, [] {
      const Soup soup = genSoup("cut triangle");
      Soup cut;
      for (const auto& t : soup.triangles()) {
        const Vec3 middle{(t[0].x + t[1].x) / 2, (t[0].y + t[1].y) / 2, (t[0].z + t[1].z) / 2};
        cut.triangle(t[0], middle, t[2]).triangle(middle, t[1], t[2]);
      }
      expectScaled(measure(*soup.environment(), minimalPipeline(1)), measure(*cut.environment(), minimalPipeline(1)), 1,
                   false);
    }));
  }

  void aStricterAgentNeverGetsMore() {
    QVERIFY(check("stricter agent", 640, [] {
      const auto environment = genSoup("stricter agent").environment();
      const auto low = measure(*environment, minimalPipeline(1)), high = measure(*environment, minimalPipeline(2));
      RC_ASSERT(high.area <= low.area);
      RC_ASSERT(measure(*environment, minimalPipeline(1, 30)).area <= low.area);
    }));
  }
};

QTEST_APPLESS_MAIN(TestMetamorphic)
#include "test_metamorphic.moc"
