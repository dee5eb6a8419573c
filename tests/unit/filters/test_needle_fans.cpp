// Needles around one corner: the same obstacles as without fans, at a price that does not grow with their number.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <span>
#include <vector>

#include "core/assembly/walkable_state.hpp"
#include "core/filters/clearance/clearance_candidates.hpp"
#include "core/filters/clearance/clearance_clipper.hpp"
#include "core/filters/clearance/needle_fans.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

/// `discs` discs of `needles` triangles around one place of the plan, `gap` apart. Each corner of the rim is moved up
/// by up to `rise` and turned by up to `turn` of a needle.
Soup stackedDiscs(int discs, int needles, double gap, double rise, double turn) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(0, 1);
  Soup soup;
  for (int disc = 0; disc < discs; ++disc) {
    std::vector<Vec3> rim;
    for (int i = 0; i < needles; ++i) {
      const double angle = 2 * std::numbers::pi * (i + turn * any(random)) / needles;
      rim.push_back({3 + 50 * std::cos(angle), -7 + 50 * std::sin(angle), disc * gap + rise * any(random)});
    }
    for (int i = 0; i < needles; ++i) soup.triangle({3, -7, disc * gap}, rim[i], rim[(i + 1) % needles]);
  }
  return soup;
}

std::vector<Index> obstaclesOf(std::span<const ClearanceCandidate> candidates) {
  std::vector<Index> result;
  for (const ClearanceCandidate& candidate : candidates) result.push_back(candidate.obstacle);
  return result;
}

}  // namespace

class TestNeedleFans : public QObject {
  Q_OBJECT

 private slots:
  void obstaclesAreTheSame_data();
  void obstaclesAreTheSame();
  void visitsDoNotGrowWithNeedles();
  void fewNeedlesMakeNoFan();
};

void TestNeedleFans::obstaclesAreTheSame_data() {
  QTest::addColumn<double>("gap");
  QTest::addColumn<double>("rise");
  QTest::addColumn<double>("turn");
  QTest::newRow("level, far apart") << 3.0 << 0.0 << 0.0;
  QTest::newRow("level, near each other") << 0.5 << 0.0 << 0.0;
  QTest::newRow("level and turned") << 0.5 << 0.0 << 0.9;
  QTest::newRow("slanted and turned") << 0.7 << 1.0 << 0.9;
  QTest::newRow("in one plane") << 0.0 << 0.0 << 0.9;
}

// Another fan, walls and boxes stand among the needles, and some face down.
void TestNeedleFans::obstaclesAreTheSame() {
  QFETCH(double, gap);
  QFETCH(double, rise);
  QFETCH(double, turn);
  Soup soup = stackedDiscs(3, 150, gap, rise, turn);
  soup.add(stackedDiscs(1, 140, gap, rise, turn).mapped([](const Vec3& p) { return Vec3{p.x + 20, p.y, p.z + 1}; }));
  soup.add(stackedDiscs(1, 150, gap, 0, turn).mapped([](const Vec3& p) { return Vec3{6 - p.x, p.y, p.z + 1.2}; }));
  soup.box({10, 0, -1}, {14, 9, 2}).wall(0, -20, 30, 10, 0.5, 1.5).floor(10, -60, 80, 50, 1.25);
  const StatePtr state = runFilters(soup.environment(), "SlopeFilter 45\n");
  const PlanKernel kernel(state->kernel->sharedMesh(), {2.0});
  const SourceMesh& mesh = kernel.mesh();
  const std::unique_ptr<const NeedleFans> fans = NeedleFans::find(mesh, {});
  QVERIFY(fans != nullptr);
  const auto isFloor = [](Index face) { return face % 3 != 0; };
  ClearanceCandidates plain(kernel, isFloor, 1, {}), fanned(kernel, isFloor, 1, {});
  fanned.useFans(fans.get());
  ClearanceClipper plainClipper(kernel, isFloor, 1, {}), fannedClipper(kernel, isFloor, 1, {});
  fannedClipper.useFans(fans.get());
  std::size_t inFans = 0, found = 0;
  for (Index face = 0; face < static_cast<Index>(mesh.triangles.size()); ++face) {
    if (mesh.facing[face] <= 0) continue;
    const std::vector<Index> expected = obstaclesOf(plain.find(face)), same = obstaclesOf(fanned.find(face));
    inFans += fans->contains(face) ? 1 : 0;
    const bool isRemoved = plainClipper.clip(face, nullptr).removed;
    QCOMPARE(fannedClipper.clip(face, nullptr).removed, isRemoved);
    const bool isKnown = plain.areKnownToCover(), isKnownInFan = fanned.areKnownToCover();
    QVERIFY(isRemoved || !(isKnown || isKnownInFan));
    if (isKnown || isKnownInFan) {  // not all are found
      QVERIFY(isKnown == isKnownInFan || plain.openSquares() != nullptr || fanned.openSquares() != nullptr);
      continue;
    }
    QCOMPARE(fanned.openSquares() != nullptr, plain.openSquares() != nullptr);
    if (plain.openSquares() != nullptr) continue;  // nor here
    QVERIFY2(same == expected, qPrintable(QString("face %1").arg(face)));
    QCOMPARE(fanned.dependsOnFloors(), plain.dependsOnFloors());
    found += expected.size();
  }
  QVERIFY(inFans > 500 && found > 100);
}

// Boxes alone would make each of n needles meet n / 4 others on each disc.
void TestNeedleFans::visitsDoNotGrowWithNeedles() {
  for (const int needles : {500, 2000}) {
    const StatePtr state = runFilters(stackedDiscs(3, needles, 0.5, 0, 0).environment(), "SlopeFilter 45\n");
    const SourceMesh& mesh = state->kernel->mesh();
    const std::unique_ptr<const NeedleFans> fans = NeedleFans::find(mesh, {});
    QVERIFY(fans != nullptr);
    std::vector<std::int32_t> stack;
    std::size_t visits = 0;
    for (Index face = 0; face < static_cast<Index>(mesh.triangles.size()); ++face) {
      QVERIFY(fans->contains(face));
      fans->visit(face, clearanceBox(mesh, face, 2), stack, [&](Index) {
        ++visits;
        return true;
      });
    }
    QVERIFY2(visits < 40 * mesh.triangles.size(), qPrintable(QString::number(visits)));
  }
}

void TestNeedleFans::fewNeedlesMakeNoFan() {
  const StatePtr state = runFilters(stackedDiscs(1, 100, 1, 0, 0).environment(), "SlopeFilter 45\n");
  QVERIFY(NeedleFans::find(state->kernel->mesh(), {}) == nullptr);
}

QTEST_GUILESS_MAIN(TestNeedleFans)
#include "test_needle_fans.moc"
