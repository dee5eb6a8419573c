// The walkable area of levels that somebody turned, scaled or moved is that of the reference, on the grid and off it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>

#include "core/io/import.hpp"
#include "tests/reference/product_check.hpp"
#include "tests/support/changed_level.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/unit/environment_files.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

constexpr std::size_t kTriangles = 200;  // of each level: the reference takes seconds for a thousand

struct Level {
  const char* name;
  double metre;  ///< in its units
};
constexpr std::array kLevels{
    Level{"house", 1},     Level{"villa", 1},    Level{"arena", 1},      Level{"tower", 1},     Level{"rooms", 1},
    Level{"docks", 1},     Level{"nav_test", 1}, Level{"level", 0.175},  Level{"ot", 20},       Level{"turbine", 20},
    Level{"dutility", 20}, Level{"complex", 20}, Level{"steelribs", 20}, Level{"fortitude", 20}};

/// The triangles that are nearest in the plan to a floor in the middle of the file.
Environment partOf(const Environment& level) {
  const auto middleOf = [&](const Triangle& t) {
    const Vec3 &a = level.vertices[t[0]], &b = level.vertices[t[1]], &c = level.vertices[t[2]];
    return Vec3{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, 0};
  };
  const auto facesUp = [&](const Triangle& t) {
    const Vec3 &a = level.vertices[t[0]], &b = level.vertices[t[1]], &c = level.vertices[t[2]];
    return (b.x - a.x) * (c.y - a.y) > (b.y - a.y) * (c.x - a.x);
  };
  std::size_t first = level.triangles.size() / 2;
  while (first > 0 && !facesUp(level.triangles[first])) --first;
  const Vec3 middle = middleOf(level.triangles[first]);
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < level.triangles.size(); ++i) {
    const Vec3 p = middleOf(level.triangles[i]);
    order.emplace_back((p.x - middle.x) * (p.x - middle.x) + (p.y - middle.y) * (p.y - middle.y), i);
  }
  std::sort(order.begin(), order.end());
  order.resize(std::min(order.size(), kTriangles));
  Environment part;
  part.metresPerUnit = level.metresPerUnit;
  for (const auto& [distance, i] : order) {
    Triangle corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = static_cast<std::uint32_t>(part.vertices.size());
      part.vertices.push_back(level.vertices[level.triangles[i][k]]);
    }
    part.triangles.push_back(corners);
  }
  return part;
}

QString pathOf(const QString& name) {
  const QString sample = QStringLiteral(FOOTFALL_SOURCE_DIR "/samples/%1/%1.obj").arg(name);
  return QFile::exists(sample) ? sample : sharedEnvironments() + "/" + name + ".obj";
}

}  // namespace

class TestTurnedReference : public QObject {
  Q_OBJECT

 private slots:
  void agrees_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("metre");
    QTest::addColumn<double>("degrees");
    QTest::addColumn<double>("scale");
    QTest::addColumn<double>("offset");
    for (const Level& level : kLevels) {
      const auto add = [&level](const char* how, const LevelChange& change) {
        QTest::addRow("%s %s", level.name, how)
            << QString(level.name) << level.metre << change.degrees << change.scale << change.offset;
      };
      add("turned by 17 degrees", {17, 1, 0});
      add("turned by 45 degrees", {45, 1, 0});
      add("turned by 90 degrees", {90, 1, 0});
      add("scaled by 0.0254", {0, 0.0254, 0});
      add("moved by 10 km", {0, 1, 10000 * level.metre});
    }
  }

  void agrees() {
    QFETCH(QString, name);
    QFETCH(double, metre);
    QFETCH(double, degrees);
    QFETCH(double, scale);
    QFETCH(double, offset);
    const QString path = pathOf(name);
    if (!QFile::exists(path)) QSKIP("the real environments are not there; set FOOTFALL_SHARED to their folder");
    if (part_.first != name) part_ = {name, partOf(*importEnvironment(path.toStdString()))};
    for (const GridChoice grid : {GridChoice::On, GridChoice::Off}) {
      // The reference takes limits as they are given. Without a step of the grid in them the filters do so, too.
      Environment level = *changedLevel(part_.second, {degrees, scale, offset}, grid);
      level.grid = {};
      const double clearance = 2 * metre * scale;
      const NavigationMesh mesh =
          navigationMesh(runFilters(std::make_shared<Environment>(level), minimalPipeline(clearance, 45.01)));
      QVERIFY2(mesh.triangles.size() > 1, "there is no ground to compare");
      const std::string error = reference::checkProduct(level, 45.01, clearance, reference::Rounding::MayClose);
      QVERIFY2(error.empty(), ((grid == GridChoice::On ? "on the grid: " : "off the grid: ") + error).c_str());
    }
  }

 private:
  std::pair<QString, Environment> part_;
};

QTEST_APPLESS_MAIN(TestTurnedReference)
#include "test_turned_reference.moc"
