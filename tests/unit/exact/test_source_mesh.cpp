// Source meshes against plain sorting and exact predicates, and the radix sort against std::sort.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <random>
#include <stdexcept>

#include "core/base/lexicographic_order.hpp"
#include "core/exact/mesh_match.hpp"
#include "core/exact/plan_places.hpp"
#include "core/exact/source_mesh.hpp"
#include "core/exact/source_predicates.hpp"
#include "tests/support/run_with_threads.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

using Random = std::mt19937_64;
using Triple = std::array<double, 3>;

enum class Numbers { Grid, Decimal, Far, Huge, Subnormal, Any, kCount };

double randomNumber(Random& random, Numbers numbers) {
  const auto integer = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  switch (numbers) {
    case Numbers::Grid:
      return integer(0, 3) == 0 ? -0.0 : integer(-2, 2);
    case Numbers::Decimal:
      return integer(-300, 300) / 100.0;
    case Numbers::Far:  // most of them much closer together than all of them, so that first keys are equal
      return integer(0, 99) == 0 ? 1e15 : integer(-20, 20) / 1024.0;
    case Numbers::Huge:
      return integer(-3, 3) * 5e307;
    case Numbers::Subnormal:
      return integer(-9, 9) * 5e-324;
    default:
      return std::ldexp(integer(-5, 5), integer(-1060, 1000));
  }
}

std::vector<std::uint32_t> plainOrder(const std::vector<Triple>& triples) {
  std::vector<std::uint32_t> order(triples.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return triples[a] < triples[b]; });
  return order;
}

TriangleSoup randomSoup(Random& random, Numbers numbers, std::uint32_t triangles) {
  TriangleSoup soup;
  for (std::uint32_t i = 0; i < triangles; ++i)
    soup.vertices.push_back(
        {randomNumber(random, numbers), randomNumber(random, numbers), randomNumber(random, numbers)});
  std::uniform_int_distribution<std::uint32_t> vertex(0, triangles - 1);
  for (std::uint32_t i = 0; i < triangles; ++i)
    soup.triangles.push_back({vertex(random), vertex(random), vertex(random)});
  return soup;
}

bool before(const Vec3& a, const Vec3& b) { return Triple{a.x, a.y, a.z} < Triple{b.x, b.y, b.z}; }

struct Stopped : std::runtime_error {
  Stopped() : std::runtime_error("stopped") {}
};

}  // namespace

class TestSourceMesh : public QObject {
  Q_OBJECT

 private slots:
  void radixOrderIsTheOrder() {
    Random random(1);
    for (int numbers = 0; numbers < static_cast<int>(Numbers::kCount); ++numbers) {
      for (const std::size_t count : {0, 1, 2, 90, 100, 500, 30000}) {
        std::vector<Triple> triples(count);
        for (Triple& t : triples)
          for (double& x : t) x = randomNumber(random, static_cast<Numbers>(numbers));
        const auto order = lexicographicOrder(
            count, [&](std::size_t i, int axis) { return triples[i][axis]; }, [] {});
        QVERIFY2(order == plainOrder(triples), qPrintable(QString("numbers %1, %2").arg(numbers).arg(count)));
      }
    }
  }

  void verticesAndTrianglesAreInOrder() {
    Random random(2);
    for (int numbers = 0; numbers < static_cast<int>(Numbers::kCount); ++numbers) {
      for (const std::uint32_t count : {3U, 50U, 5000U}) {
        const TriangleSoup soup = randomSoup(random, static_cast<Numbers>(numbers), count);
        std::vector<std::uint32_t> order;
        const SourceMesh mesh = makeSourceMesh(soup, false, &order);

        std::vector<Vec3> expected = soup.vertices;
        std::sort(expected.begin(), expected.end(), before);
        expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
        QVERIFY(mesh.vertices == expected);
        const int scale = mesh.grid.scaleExponent();
        for (std::size_t v = 0; v < expected.size(); ++v) {
          const Vec3& p = expected[v];
          QVERIFY(!std::signbit(mesh.vertices[v].x) || p.x != 0);
          QVERIFY((mesh.scaled[v] == Vec3{std::ldexp(p.x, scale), std::ldexp(p.y, scale), std::ldexp(p.z, scale)}));
          const auto same = [&](const Vec3& q) { return q.x == p.x && q.y == p.y; };
          QCOMPARE(mesh.planIds[v], std::find_if(expected.begin(), expected.end(), same) - expected.begin());
          if (v > 200) break;  // the reference search is slow
        }

        std::vector<std::pair<std::array<Index, 3>, std::uint32_t>> turned;
        for (std::uint32_t t = 0; t < count; ++t) {
          std::array<Index, 3> f{};
          for (int k = 0; k < 3; ++k)
            f[k] = static_cast<Index>(
                std::lower_bound(expected.begin(), expected.end(), soup.vertices[soup.triangles[t][k]], before) -
                expected.begin());
          std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
          turned.emplace_back(f, t);
        }
        std::sort(turned.begin(), turned.end());
        QCOMPARE(mesh.triangles.size(), turned.size());
        for (std::size_t t = 0; t < turned.size(); ++t) {
          QVERIFY(mesh.triangles[t] == turned[t].first);
          QCOMPARE(mesh.inputTriangles[t], turned[t].second);
          QCOMPARE(order[t], turned[t].second);
        }
      }
    }
  }

  void trianglesAreClassifiedExactly() {
    Random random(3);
    std::map<std::pair<int, bool>, int> met;
    for (int numbers = 0; numbers < static_cast<int>(Numbers::kCount); ++numbers) {
      const SourceMesh mesh = makeSourceMesh(randomSoup(random, static_cast<Numbers>(numbers), 2000), false);
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& f = mesh.triangles[t];
        const Vec3 &a = mesh.vertices[f[0]], &b = mesh.vertices[f[1]], &c = mesh.vertices[f[2]];
        QCOMPARE(static_cast<int>(mesh.facing[t]), facing(a, b, c));
        QCOMPARE(mesh.degenerate[t] != 0, isDegenerate(a, b, c));
        if (mesh.facing[t] == 0) QVERIFY(mesh.normals[t][2].value == 0 && mesh.normals[t][2].error == 0);
        ++met[{mesh.facing[t], mesh.degenerate[t] != 0}];
        const auto low = [](double x, double y, double z) { return std::min({x, y, z}); };
        const auto high = [](double x, double y, double z) { return std::max({x, y, z}); };
        const Box box{{low(a.x, b.x, c.x), low(a.y, b.y, c.y), low(a.z, b.z, c.z)},
                      {high(a.x, b.x, c.x), high(a.y, b.y, c.y), high(a.z, b.z, c.z)}};
        std::vector<std::int32_t> stack;
        bool found = false;
        mesh.tree.visitOverlapping(box, stack, [&](std::int32_t id) {
          found = id == static_cast<std::int32_t>(t);
          return !found;
        });
        QCOMPARE(found, mesh.degenerate[t] == 0);
      }
    }
    QCOMPARE(met.size(), std::size_t{4});  // up, down, vertical, degenerate
  }

  // Boxes around turned strips: the tree has a frame of its own, finds all that meet, and few others.
  void treeOfATurnedLevelFindsNeighbours() {
    constexpr int kStrips = 100, kLength = 100;
    TriangleSoup soup;
    const double c = std::cos(0.3), s = std::sin(0.3);
    for (int i = 0; i <= kStrips; ++i)
      for (const int along : {0, kLength}) soup.vertices.push_back({100 + c * i - s * along, s * i + c * along, 0});
    for (std::uint32_t i = 0; i < kStrips; ++i) {
      const std::uint32_t a = 2 * i, b = a + 1, next = a + 2, last = a + 3;
      soup.triangles.push_back({a, next, last});
      soup.triangles.push_back({a, last, b});
    }
    const SourceMesh mesh = makeSourceMesh(soup, false);
    QVERIFY(!mesh.tree.isExactOn(mesh.grid));
    std::vector<std::int32_t> stack;
    std::size_t visitsOver = 0, visitsAlongAxes = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& f = mesh.triangles[t];
      const std::array corners{mesh.vertices[f[0]], mesh.vertices[f[1]], mesh.vertices[f[2]]};
      const Box box = boxOf(mesh, static_cast<Index>(t));
      std::vector<char> met(mesh.triangles.size(), 0);
      mesh.tree.visitOver(corners, box, stack, [&](std::int32_t id) {
        ++visitsOver;
        met[static_cast<std::size_t>(id)] = 1;
        return true;
      });
      for (std::size_t other = 0; other < mesh.triangles.size(); ++other) {
        const auto& g = mesh.triangles[other];
        if (std::any_of(f.begin(), f.end(), [&](Index v) { return v == g[0] || v == g[1] || v == g[2]; }))
          QVERIFY(met[other] != 0);
        if (overlap(box, boxOf(mesh, static_cast<Index>(other)))) ++visitsAlongAxes;
      }
      mesh.tree.visitOverlapping(box, stack, [&](std::int32_t id) {
        met[static_cast<std::size_t>(id)] = 2;
        return true;
      });
      QVERIFY(std::count(met.begin(), met.end(), 1) == 0);  // a box holds its triangle
    }
    // Triangles that an edit adds are found in the same frame.
    const auto count = static_cast<std::int32_t>(mesh.triangles.size());
    std::vector<std::int32_t> numbers(mesh.triangles.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    const SourceTree edited = SourceTree::edited(mesh.tree, numbers, {boxOf(mesh, 7)}, std::array{count});
    std::vector<std::int32_t> found;
    edited.visitOverlapping(boxOf(mesh, 7), stack, [&](std::int32_t id) {
      found.push_back(id);
      return true;
    });
    QVERIFY(std::ranges::count(found, 7) == 1 && std::ranges::count(found, count) == 1);
    QVERIFY2(visitsOver * 3 < visitsAlongAxes, qPrintable(QString("%1 %2").arg(visitsOver).arg(visitsAlongAxes)));
  }

  void sameMeshForAnyNumberOfThreads() {
    Random random(4);
    const TriangleSoup soup = randomSoup(random, Numbers::Decimal, 40000);
    const SourceMesh plain = makeSourceMesh(soup, true);
    for (const int threads : {1, 2, 4}) {
      SourceMesh mesh;
      runWithThreads(threads, [&] { mesh = makeSourceMesh(soup, true); });
      QVERIFY(mesh.vertices == plain.vertices);
      QVERIFY(mesh.triangles == plain.triangles);
      QVERIFY(mesh.inputTriangles == plain.inputTriangles);
      QVERIFY(mesh.facing == plain.facing);
      QVERIFY(std::all_of(mesh.facing.begin(), mesh.facing.end(), [](auto f) { return f >= 0; }));
    }
  }

  // Places of the plan are known again by where they are; those that changed their order are not.
  void placesAreRelated() {
    const TriangleSoup soup{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}};
    const SourceMesh plain = makeSourceMesh(soup, false);
    const double scale = std::ldexp(1, plain.grid.scaleExponent());
    const auto withPlaces = [&](const std::vector<double>& places) {
      SourceMesh mesh = plain;
      std::vector<Vec3> scaled;
      for (const double x : places) scaled.push_back({x * scale, scale, 0});
      addPlanPlaces(mesh, scaled);
      return mesh;
    };
    const SourceMesh before = withPlaces({1, 2, 0.5, 3, 2.5});
    QCOMPARE(relatePlanPlaces(before, before), (std::vector<Index>{3, 4, 5, 6, 7}));
    QCOMPARE(relatePlanPlaces(before, withPlaces({1, 7, 2, 3, 8})), (std::vector<Index>{3, 5, -1, 6, -1}));
    QCOMPARE(relatePlanPlaces(before, withPlaces({3, 1, 2, 0.5, 2.5})), (std::vector<Index>{4, 5, 6, -1, 7}));
    QCOMPARE(relatePlanPlaces(before, withPlaces({})), (std::vector<Index>(5, -1)));
    QVERIFY(relatePlanPlaces(plain, before).empty());
  }

  // An edit of one mesh to the other keeps what both have in common.
  void matchesAreEdits() {
    Random random(11);
    for (int round = 0; round < 50; ++round) {
      const TriangleSoup soup = randomSoup(random, Numbers::Decimal, 60);
      const auto base = std::make_shared<const SourceMesh>(makeSourceMesh(soup, false));
      TriangleSoup edited = soup;
      std::vector<std::uint32_t> keptVertices(soup.vertices.size()), keptTriangles;
      std::iota(keptVertices.begin(), keptVertices.end(), 0U);
      edited.triangles.clear();
      for (std::uint32_t t = 0; t < soup.triangles.size(); ++t) {
        if (random() % 8 == 0) continue;
        keptTriangles.push_back(t);
        edited.triangles.push_back(soup.triangles[t]);
      }
      const auto first = static_cast<std::uint32_t>(edited.vertices.size());
      edited.vertices.insert(edited.vertices.end(), {{0.125, 0, 1}, {3.5, 0.25, 1}, {0, 2.75, 1}});
      edited.triangles.push_back({first, first + 1, first + 2});
      const auto now = editSourceMesh(base, {edited, keptVertices, keptTriangles}, {});
      if (!now) continue;  // another scale
      const auto match = matchSourceMeshes(base, makeSourceMesh(edited, false), {});
      QVERIFY(match != nullptr);
      QVERIFY(match->base.lock() == base);
      const std::vector<std::array<Index, 3>> distinct(now->triangles.begin(), now->triangles.end());
      if (std::adjacent_find(distinct.begin(), distinct.end()) != distinct.end()) continue;
      QCOMPARE(match->vertexOf, now->edit->vertexOf);
      QCOMPARE(match->planOf, now->edit->planOf);
      QCOMPARE(match->triangleOf, now->edit->triangleOf);
      QCOMPARE(match->baseOf, now->edit->baseOf);
      QCOMPARE(match->addedTriangles, now->edit->addedTriangles);
      QCOMPARE(match->removed.size(), now->edit->removed.size());
      QCOMPARE(match->added.size(), std::size_t{1});
    }
  }

  // Also within the sorts: there are many more polls than stages.
  void makingCanBeCancelled() {
    Random random(5);
    const TriangleSoup soup = randomSoup(random, Numbers::Decimal, 200000);
    std::atomic<int> polls{0};
    makeSourceMesh(soup, false, nullptr, [&] { ++polls; });
    const int all = polls;
    QVERIFY(all > 300);
    for (int part = 0; part < 8; ++part) {
      polls = 0;
      const int limit = 1 + all * part / 8;
      QVERIFY_THROWS_EXCEPTION(Stopped, makeSourceMesh(soup, false, nullptr, [&] {
                                 if (++polls >= limit) throw Stopped();
                               }));
    }
  }
};

QTEST_APPLESS_MAIN(TestSourceMesh)
#include "test_source_mesh.moc"
