// The reason why two parts are apart: hand-made places with their answers, and all pairs of borders looked at one by
// one.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QElapsedTimer>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "core/navigation/link_obstacles.hpp"
#include "core/navigation/path_ground.hpp"
#include "core/navigation/separation_text.hpp"
#include "core/report/path_report.hpp"
#include "footfall/errors.hpp"
#include "footfall/path.hpp"
#include "footfall/report.hpp"
#include "footfall/run_context.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

constexpr double kHeight = 2;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
using Random = std::mt19937_64;

/// A level with all that a question needs.
struct Level {
  explicit Level(const Soup& soup, double givenStep = 0)
      : environment(soup.environment()),
        step(givenStep),
        mesh(std::make_shared<NavigationMesh>(navigationMesh(runFilters(environment, pipeline(givenStep))))),
        finder(mesh),
        separations(finder, environment, kHeight, givenStep),
        parts(findSurfaceParts(*mesh, finder.inside()->topology)) {}

  static std::string pipeline(double step) {
    return minimalPipeline(kHeight) +
           (step > 0 ? "\nStepFilter " + QString::number(step, 'g', 17).toStdString() + " 0\n" : "");
  }

  [[nodiscard]] PathResult path(const Vec3& from, const Vec3& to) const {
    PathResult result = finder.find(from, to, kHeight * 0.999);
    addSeparation(result, separations);
    return result;
  }

  [[nodiscard]] const SurfaceTopology& topology() const { return finder.inside()->topology; }

  /// The answer for two parts.
  [[nodiscard]] std::optional<Separation> between(std::uint32_t from, std::uint32_t to,
                                                  const RunContext* context = nullptr) const {
    const auto triangleOf = [this](std::uint32_t part) {
      return static_cast<std::uint32_t>(std::ranges::find(parts.of, part) - parts.of.begin());
    };
    return separations.find(triangleOf(from), triangleOf(to), context);
  }

  std::shared_ptr<const Environment> environment;
  double step;
  std::shared_ptr<const NavigationMesh> mesh;
  PathFinder finder;
  SeparationFinder separations;
  SurfaceParts parts;
};

QString textOf(const BorderLink& link) {
  return QString::fromStdString(
      barrierText(link, [](double x) { return QString::number(x, 'g', 6).toStdString(); }).str());
}

/// The least largest value on the way from one of `count` nodes to another (Floyd and Warshall).
double leastLargest(std::vector<std::vector<double>> way, std::size_t from, std::size_t to) {
  const std::size_t count = way.size();
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < count; ++j) way[i][j] = std::min(way[i][j], std::max(way[i][k], way[k][j]));
  return way[from][to];
}

/// All pairs of borders: first as far as an agent is high, over what it could climb; then whatever is nearest.
struct AllPairs {
  explicit AllPairs(const Level& level) {
    const std::vector<SurfaceBorder> borders = findBorders(*level.mesh, level.topology(), level.parts);
    const std::size_t count = level.parts.count;
    open.assign(count, std::vector<double>(count, kInfinity));
    any = open;
    const LinkObstacles obstacles(level.environment, kHeight, level.step);
    std::vector<std::int32_t> stack;
    for (std::size_t i = 0; i < borders.size(); ++i) {
      for (std::size_t j = i + 1; j < borders.size(); ++j) {
        const std::uint32_t a = borders[i].component, b = borders[j].component;
        auto link = linkBetween(borders[i], borders[j], level.step);
        if (a == b || !link) continue;
        any[a][b] = any[b][a] = std::min(any[a][b], excessOf(*link, kHeight, level.step));
        const bool crosses = obstacles.lookAt(*link, borders[i], borders[j], stack);
        const double excess = excessOf(*link, kHeight, level.step);
        if (crosses && !link->isClosed() && excess <= kHeight) open[a][b] = open[b][a] = std::min(open[a][b], excess);
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j)
        if (i != j && leastLargest(open, i, j) < kInfinity) any[i][j] = 0;
    }
  }
  std::vector<std::vector<double>> open, any;
};

QString chainError(const Level& level, std::uint32_t from, std::uint32_t to, int& far, int& others) {
  const auto found = level.between(from, to);
  if (!found) return "nothing found";
  std::uint32_t here = from;
  for (const BorderLink& link : found->links) {
    if (link.fromComponent != here) return "the chain is broken";
    here = link.toComponent;
  }
  if (here != to) return "the chain ends elsewhere";
  const AllPairs all(level);
  const double open = leastLargest(all.open, from, to);
  if (open < kInfinity) {
    const double size = found->barrier().excess;
    // Mending one of the other places alone must do, and the way back has as many.
    for (const BorderLink& link : found->others) {
      if (link.excess < size || link.excess > std::max(2 * size, kHeight / 16))
        return "another way lacks less, or much";
      const auto reach = [&](std::uint32_t a, std::uint32_t b) { return a == b ? 0 : leastLargest(all.open, a, b); };
      if (reach(from, link.fromComponent) > link.excess || reach(link.toComponent, to) > link.excess)
        return "another way leads elsewhere";
      ++others;
    }
    if (level.between(to, from)->others.size() != found->others.size()) return "another number of ways back";
    return size == open ? QString() : QString("%1 instead of %2").arg(size, 0, 'g', 17).arg(open, 0, 'g', 17);
  }
  ++far;
  double largest = 0;
  for (const BorderLink& link : found->links)
    if (leastLargest(all.open, link.fromComponent, link.toComponent) == kInfinity)
      largest = std::max(largest, std::max({link.gap, std::fabs(link.rise) - level.step, 0.0}));
  const double expected = leastLargest(all.any, from, to);
  return largest == expected ? QString() : QString("far: %1 instead of %2").arg(largest).arg(expected);
}

}  // namespace

class TestSeparation : public QObject {
  Q_OBJECT
 private slots:
  void saysWhatIsInTheWay_data() {
    QTest::addColumn<QString>("expected");
    QTest::addColumn<int>("links");
    QTest::newRow("step up") << "a step of 0.43 up" << 1;
    QTest::newRow("step down") << "a step of 0.43 down" << 1;
    QTest::newRow("gap") << "a gap of 0.125" << 1;
    QTest::newRow("gap and step") << "a gap of 0.125 and a step of 0.25 up" << 1;
    QTest::newRow("stairs") << "a step of 0.5 up" << 3;
    QTest::newRow("wall without thickness") << "an obstacle edge: a wall without thickness" << 1;
    QTest::newRow("low wall without thickness") << "an obstacle of 0.3 to climb over" << 1;
    QTest::newRow("thick wall") << "a wall; the parts are 0.25 apart" << 1;
    QTest::newRow("low thick wall") << "an obstacle of 0.75 to climb over" << 1;
    QTest::newRow("beam") << "a place with only 1.5 of free height" << 1;
    QTest::newRow("corner") << "the parts only touch in a point, which is too narrow for an agent" << 1;
    QTest::newRow("beside a wall") << "a gap of 0.5" << 1;
    QTest::newRow("wall of two panels") << "a wall; the parts are 0.25 apart" << 1;
  }

  /// The way goes from (1, 1) to (7, 1), whatever the height.
  void saysWhatIsInTheWay() {
    QFETCH(QString, expected);
    QFETCH(int, links);
    const QString name = QTest::currentDataTag();
    const auto ground = [] { return Soup().floor(0, 0, 4, 2, 0); };
    Soup soup = Soup().floor(0, 0, 8, 2, 0);
    double height = 0;
    if (name == "step up") soup = ground().box({4, 0, -1}, {8, 2, height = 0.43});
    if (name == "step down") soup = ground().floor(4, 0, 8, 2, height = -0.43).wall(4, 0, 4, 2, -0.43, 0);
    if (name == "gap") soup = ground().floor(4.125, 0, 8, 2, 0);
    if (name == "gap and step") soup = ground().floor(4.125, 0, 8, 2, height = 0.25);
    if (name == "stairs")
      soup = Soup()
                 .floor(0, 0, 2, 2, 0)
                 .box({2, 0, -1}, {4, 2, 0.25})
                 .box({4, 0, -1}, {6, 2, 0.75})
                 .box({6, 0, -1}, {8, 2, height = 1});
    if (name == "wall without thickness") soup.wall(4, 0, 4, 2, 0, 3);
    if (name == "low wall without thickness") soup.wall(4, 0, 4, 2, 0, 0.3);
    if (name == "thick wall") soup = ground().floor(4.25, 0, 8, 2, 0).box({4, 0, -1}, {4.25, 2, 3});
    if (name == "low thick wall") soup.box({4, 0, -1}, {4.25, 2, 0.75});
    if (name == "beam") soup.box({4, 0, 1.5}, {4.25, 2, 3});
    if (name == "corner") soup = ground().floor(4, 2, 8, 4, 0);
    // The parts are 0.25 apart where the wall stands, and 0.5 behind its end.
    if (name == "beside a wall")
      soup =
          Soup().floor(0, 0, 4, 4, 0).floor(4.25, 0, 8, 2, 0).floor(4.5, 2, 8, 4, 0).box({4, -1, -1}, {4.25, 2.5, 3});
    if (name == "wall of two panels")
      soup = ground().floor(4.25, 0, 8, 2, 0).wall(4.125, 0, 4.125, 1, 0, 3).wall(4.125, 1, 4.125, 2, 0, 3);
    const Level level(soup);
    const Vec3 goal = name == "corner" ? Vec3{7, 3, height} : Vec3{7, 1, height};
    const PathResult path = level.path({1, 1, 0}, goal);
    QCOMPARE(path.status, PathStatus::NotConnected);
    QVERIFY(path.separation);
    QCOMPARE(textOf(path.separation->barrier()), expected);
    QCOMPARE(static_cast<int>(path.separation->links.size()), links);
    // The other way round it is the same, but for up and down.
    const PathResult back = level.path(goal, {1, 1, 0});
    QCOMPARE(back.separation->barrier().size(), path.separation->barrier().size());
    QCOMPARE(back.separation->barrier().kind, path.separation->barrier().kind);
  }

  void theReportNamesThePlace() {
    const Level level(Soup().floor(0, 0, 4, 2, 0).floor(4, 0, 8, 2, 0.43));
    const PathResult path = level.path({1, 1, 0}, {7, 1, 0.43});
    QCOMPARE(QString::fromStdString(formatFailure(path, UpAxis::Z)),
             QString("no way leads from the start to the target; the nearest place that can be reached lies 3.031 from "
                     "it; the parts are nearest at 4 1 0: a step of 0.43 up"));
    const std::string json = formatPathJson(*level.mesh, path);
    QVERIFY(json.find("\"kind\": \"open\"") != std::string::npos);
    QVERIFY(json.find("\"rise\": 0.43") != std::string::npos);
    // Turned back to where Y is up.
    QVERIFY(formatFailure(path, UpAxis::Y).find("nearest at 4 0 -1:") != std::string::npos);
  }

  void noOtherChainIsEasier() {
    Random random(4711);
    const auto at = [&](int count) { return static_cast<double>(random() % static_cast<unsigned>(count)); };
    int compared = 0, far = 0, others = 0;
    for (int round = 0; round < 150; ++round) {
      Soup soup;
      const int parts = 3 + static_cast<int>(at(6));
      for (int i = 0; i < parts; ++i) {
        const double x = at(60) / 8, y = at(60) / 8, z = at(round % 3 == 0 ? 40 : 12) / 8;
        soup.floor(x, y, x + 0.5 + at(16) / 8, y + 0.5 + at(16) / 8, z);
        if (at(3) == 0) soup.wall(x, y, x + 1, y + at(3) / 2, z, z + at(24) / 8);
        if (at(4) == 0) soup.box({x, y, z - 1}, {x + 0.25, y + 1, z + at(20) / 8});
      }
      const Level level(soup, round % 2 == 0 ? 0 : 0.25 + at(3) / 8);
      const std::uint32_t count = level.parts.count;
      for (std::uint32_t to = 1; to < std::min(count, 9U); ++to) {
        const QString error = chainError(level, 0, to, far, others);
        ++compared;
        QVERIFY2(error.isEmpty(), qPrintable(QString("round %1, part %2: %3").arg(round).arg(to).arg(error)));
      }
    }
    QVERIFY2(compared > 300 && far > 20 && others > 50,
             qPrintable(QString("%1, %2, %3").arg(compared).arg(far).arg(others)));
  }

  void gapsLackWhatIsBeyondTheWidestOne() {
    const auto number = [](double x) { return QString::number(x, 'g', 6).toStdString(); };
    const Level level(Soup().floor(0, 0, 4, 2, 0).floor(4.125, 0, 8, 2, 0.25), 0.375);
    const auto last = static_cast<std::uint32_t>(level.mesh->triangles.size()) - 1;
    const auto textAt = [&](double gap, double excess) {
      const SeparationFinder separations(level.finder, level.environment, kHeight, 0.375, nullptr, gap);
      const auto found = separations.find(0, last);
      return found && found->gap == gap && found->barrier().excess == excess
                 ? QString::fromStdString(lackText(found->barrier(), *found, number).str())
                 : QString();
    };
    QCOMPARE(textAt(0, 0.125), QString("a gap of 0.125 and a step of 0.25 up"));
    QCOMPARE(textAt(0.0625, 0.0625), QString("a gap of 0.125 and a step of 0.25 up, 0.0625 too wide"));
    QCOMPARE(textAt(0.25, 0),
             QString("a gap of 0.125 and a step of 0.25 up; narrow and low enough, but StepFilter does not link it"));
  }

  void saysWhatIsMissing_data() {
    QTest::addColumn<QString>("expected");
    QTest::addColumn<double>("excess");
    QTest::newRow("step up") << "a step of 0.5 up, 0.125 too high" << 0.125;
    QTest::newRow("step down") << "a step of 0.5 down, 0.125 too high" << 0.125;
    QTest::newRow("gap under a low step") << "a gap of 0.125 and a step of 0.25 up" << 0.125;
    QTest::newRow("noise") << "a gap of 8.88178e-16 and a step of 0.25 up" << std::ldexp(1.0, -50);
    QTest::newRow("low wall") << "an obstacle of 0.5 to climb over, 0.125 too high" << 0.125;
    QTest::newRow("beam") << "a place with only 1.75 of free height, 0.25 too low" << 0.25;
    QTest::newRow("beam over a step") << "a place with only 1.75 of free height, 0.25 too low" << 0.25;
    QTest::newRow("wall") << "an obstacle edge: a wall without thickness" << 0.0;
  }

  /// The way goes from (1, 1) to (7, 1), whatever the height, for an agent who climbs 0.375.
  void saysWhatIsMissing() {
    QFETCH(QString, expected);
    QFETCH(double, excess);
    const QString name = QTest::currentDataTag();
    const auto ground = [] { return Soup().floor(0, 0, 4, 2, 0); };
    Soup soup = Soup().floor(0, 0, 8, 2, 0);
    double height = 0;
    if (name == "step up") soup = ground().floor(4, 0, 8, 2, height = 0.5).wall(4, 0, 4, 2, 0, 0.5);
    if (name == "step down") soup = ground().floor(4, 0, 8, 2, height = -0.5).wall(4, 0, 4, 2, -0.5, 0);
    if (name == "gap under a low step") soup = ground().floor(4.125, 0, 8, 2, height = 0.25);
    if (name == "noise") soup = ground().floor(std::nextafter(4.0, 5), 0, 8, 2, height = 0.25);
    if (name == "low wall") soup.wall(4, 0, 4, 2, 0, 0.5);
    if (name == "beam") soup.box({4, 0, 1.75}, {4.25, 2, 3});
    if (name == "beam over a step") soup = ground().floor(4, 0, 8, 2, height = 0.25).wall(4, 0, 4, 2, 2, 3);
    if (name == "wall") soup.wall(4, 0, 4, 2, 0, 3);
    const Level level(soup, 0.375);
    const PathResult path = level.path({1, 1, 0}, {7, 1, height});
    QCOMPARE(path.status, PathStatus::NotConnected);
    QVERIFY(path.separation);
    const BorderLink& barrier = path.separation->barrier();
    const auto text =
        lackText(barrier, *path.separation, [](double x) { return QString::number(x, 'g', 6).toStdString(); });
    QCOMPARE(QString::fromStdString(text.str()), expected);
    QCOMPARE(barrier.excess, excess);
    QCOMPARE(path.separation->step, 0.375);
    QVERIFY(path.separation->others.empty());
    // The obstacle is named: of the two triangles of a wall that of its middle, both or one.
    const bool isEmpty = name.contains("gap") || name == "noise";
    QCOMPARE(barrier.triangles.empty(), isEmpty);
    for (const std::uint32_t t : barrier.triangles)
      for (const std::uint32_t v : level.environment->triangles[t]) QVERIFY(level.environment->vertices[v].x >= 4);
    if (name == "step up") QVERIFY(barrier.triangles.front() >= 4);  // the riser
  }

  /// A wall with doors: one too low by 0.25, one with a kerb too high by 0.125, one with a gap of 0.5 beside it.
  void otherWaysAreCountedOnce() {
    const auto level = [](double kerb, double lintel) {
      Soup soup;
      soup.floor(0, 0, 4, 12, 0).floor(4, 0, 8, 12, 0);
      soup.wall(4, 0, 4, 2, 0, 3).wall(4, 3, 4, 6, 0, 3).wall(4, 7, 4, 12, 0, 3);
      soup.wall(4, 2, 4, 3, 0, kerb).wall(4, 6, 4, 7, lintel, 3);
      return Level(soup, 0.375);
    };
    const PathResult path = level(0.5, 1.75).path({1, 1, 0}, {7, 1, 0});
    QVERIFY(path.separation);
    QCOMPARE(path.separation->barrier().kind, LinkKind::Obstacle);
    QCOMPARE(path.separation->barrier().excess, 0.125);
    QCOMPARE(path.separation->others.size(), std::size_t{1});
    QCOMPARE(path.separation->others[0].kind, LinkKind::LowCeiling);
    QCOMPARE(path.separation->others[0].excess, 0.25);
    QVERIFY(path.separation->others[0].from.y > 6 && path.separation->others[0].from.y < 7);
    const std::string text = formatFailure(path, UpAxis::Z);
    QVERIFY2(
        text.find("; 1 more way: a place with only 1.75 of free height, 0.25 too low, at 4 6.") != std::string::npos,
        text.c_str());
    // More than twice as much is no way to be named.
    QVERIFY(level(0.5, 1.5).path({1, 1, 0}, {7, 1, 0}).separation->others.empty());
    // The lower door is mended first once it is the one that lacks least.
    const PathResult other = level(0.75, 1.875).path({1, 1, 0}, {7, 1, 0});
    QCOMPARE(other.separation->barrier().kind, LinkKind::LowCeiling);
    QCOMPARE(other.separation->barrier().excess, 0.125);
    QVERIFY(other.separation->others.empty());
  }

  /// A step's edges lack something towards others: to a balcony it is 2 from the tread and 2.5 from the floor.
  void edgesOfStepsAreBordersToOthers() {
    const Level level(Soup().floor(0, 0, 4, 2, 0).floor(4, 0, 8, 2, 0.5).floor(0, 0, 4, 2, 2.5), 0.5);
    QCOMPARE(level.parts.count, 2U);
    const PathResult path = level.path({1, 1, 0}, {1, 1, 2.5});
    QVERIFY(path.separation);
    QCOMPARE(path.separation->links.size(), std::size_t{1});
    QCOMPARE(path.separation->barrier().rise, 2.0);
    QCOMPARE(path.separation->barrier().excess, 1.5);
    QCOMPARE(path.separation->barrier().from.z, 0.5);
  }

  /// An agent that climbs higher never has a larger excess.
  void higherStepsNeverLackMore() {
    Random random(1147);
    const auto at = [&](int count) { return static_cast<double>(random() % static_cast<unsigned>(count)); };
    int compared = 0;
    for (int round = 0; round < 60; ++round) {
      Soup soup = Soup().floor(-1, 0, 0, 2, 0).floor(4, 0, 5, 2, 1);
      for (int i = 0; i < 5; ++i) {
        const double x = at(24) / 8, y = at(12) / 8;
        soup.floor(x, y, x + 0.5 + at(16) / 8, y + 0.5 + at(16) / 8, at(12) / 8);
      }
      double last = kInfinity;
      for (const double step : {0.125, 0.25, 0.5, 1.0}) {
        const Level level(soup, step);
        const auto found = level.path({-0.875, 1, 0}, {4.875, 1, 1}).separation;
        if (!found || found->barrier().isClosed()) break;
        QVERIFY(found->barrier().excess <= last);
        last = found->barrier().excess;
        ++compared;
      }
    }
    QVERIFY2(compared > 60, qPrintable(QString::number(compared)));
  }

  void manyPartsAreFastAndCanBeCancelled() {
    Soup soup;
    for (int x = 0; x < 120; ++x)
      for (int y = 0; y < 120; ++y) soup.floor(x, y, x + 0.9375, y + 0.875, (x + y) % 3 * 0.25);
    const Level level(soup);
    const std::uint32_t last = level.parts.count - 1;
    QElapsedTimer timer;
    timer.start();
    const auto found = level.between(0, last);
    qInfo("%u parts, %lld ms", last + 1, static_cast<long long>(timer.elapsed()));
    QVERIFY(found && found->links.size() > 100);
    QCOMPARE(found->barrier().size(), 0.25);
    RunContext cancelled;
    cancelled.cancel();
    QVERIFY_EXCEPTION_THROWN((void)level.between(0, last, &cancelled), Cancelled);
  }
};

QTEST_GUILESS_MAIN(TestSeparation)
#include "test_separation.moc"
