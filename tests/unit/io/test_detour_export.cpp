// Tile sets for Detour, queried by Detour itself: it finds a way exactly where the path finder does.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <set>

#include "core/base/vector.hpp"
#include "core/io/formats/convex_polygons.hpp"
#include "core/io/formats/detour_export.hpp"
#include "footfall/path.hpp"
#include "footfall/report.hpp"
#include "footfall/run.hpp"
#include "tests/unit/environment_files.hpp"

#ifdef FOOTFALL_HAS_DETOUR
#include <DetourNavMesh.h>
#include <DetourNavMeshQuery.h>
#endif

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

struct Level {
  std::shared_ptr<const NavigationMesh> mesh;
  ExportHeader header;
  double scale = 1;
};

/// The default pipeline, and a filter behind it.
[[maybe_unused]] Level levelOf(const QString& file, const std::string& more = {}) {
  const auto source = importEnvironment(file.toStdString());
  const Pipeline pipeline = parsePipeline(formatPipeline(defaultPipeline(*source)) + more, "test");
  RunContext context;
  const RunResult run = runPipeline(source, pipeline, context);
  return {run.mesh, makeExportHeader(pipeline), run.mesh->frame.metresPerUnit};
}

[[maybe_unused]] QString sampleFile(const char* name) {
  return QString(FOOTFALL_SOURCE_DIR "/samples/%1/%1.obj").arg(name);
}

#ifdef FOOTFALL_HAS_DETOUR

struct Free {
  void operator()(dtNavMesh* mesh) const { dtFreeNavMesh(mesh); }
  void operator()(dtNavMeshQuery* query) const { dtFreeNavMeshQuery(query); }
};

/// Reads a file as Recast's demo does.
class DetourWorld {
 public:
  explicit DetourWorld(const std::string& bytes) {
    std::size_t at = 0;
    const auto read = [&](auto& value) {
      if (at + sizeof value > bytes.size()) qFatal("the file ends too early");
      std::memcpy(&value, bytes.data() + at, sizeof value);
      at += sizeof value;
    };
    int magic = 0, version = 0, tiles = 0;
    dtNavMeshParams parameters{};
    read(magic);
    read(version);
    read(tiles);
    read(parameters);
    if (magic != ('M' << 24 | 'S' << 16 | 'E' << 8 | 'T') || version != 1) qFatal("not a tile set");
    mesh_.reset(dtAllocNavMesh());
    if (dtStatusFailed(mesh_->init(&parameters))) qFatal("parameters that Detour refuses");
    for (int i = 0; i < tiles; ++i) {
      dtTileRef reference = 0;
      int size = 0;
      read(reference);
      read(size);
      auto* data = static_cast<unsigned char*>(dtAlloc(static_cast<std::size_t>(size), DT_ALLOC_PERM));
      std::memcpy(data, bytes.data() + at, static_cast<std::size_t>(size));
      at += static_cast<std::size_t>(size);
      if (dtStatusFailed(mesh_->addTile(data, size, DT_TILE_FREE_DATA, reference, nullptr))) qFatal("a refused tile");
    }
    if (at != bytes.size()) qFatal("something is behind the tiles");
    query_.reset(dtAllocNavMeshQuery());
    if (dtStatusFailed(query_->init(mesh_.get(), 65535))) qFatal("no query");
    corridor_.resize(65536);
  }

  [[nodiscard]] const dtNavMesh& mesh() const { return *mesh_; }

  /// The polygon at a place (Z up, metres), and how far from it; 0 where there is none.
  [[nodiscard]] dtPolyRef polygonAt(const Vec3& p, Vec3* nearest = nullptr) const {
    const std::array place = turned(p), extents{0.01f, 0.05f, 0.01f};
    std::array<float, 3> found{};
    dtPolyRef reference = 0;
    query_->findNearestPoly(place.data(), extents.data(), &filter_, &reference, found.data());
    if (nearest) *nearest = {found[0], -found[2], found[1]};
    return reference;
  }

  struct Way {
    bool isFound = false;
    double planLength = 0;
  };
  Way way(const Vec3& from, const Vec3& to) {
    const dtPolyRef start = polygonAt(from), end = polygonAt(to);
    if (start == 0 || end == 0) qFatal("a place that Detour does not know");
    const std::array a = turned(from), b = turned(to);
    int count = 0;
    query_->findPath(start, end, a.data(), b.data(), &filter_, corridor_.data(), &count,
                     static_cast<int>(corridor_.size()));
    if (count == 0 || corridor_[static_cast<std::size_t>(count) - 1] != end) return {};
    std::vector<float> points(3 * 4096);
    int pointCount = 0;
    query_->findStraightPath(a.data(), b.data(), corridor_.data(), count, points.data(), nullptr, nullptr, &pointCount,
                             4096);
    Way way{true, 0};
    for (std::size_t i = 3; i < 3 * static_cast<std::size_t>(pointCount); i += 3)
      way.planLength += std::hypot(points[i] - points[i - 3], points[i + 2] - points[i - 1]);
    return way;
  }

 private:
  static std::array<float, 3> turned(const Vec3& p) {
    return {static_cast<float>(p.x), static_cast<float>(p.z), static_cast<float>(-p.y)};
  }

  std::unique_ptr<dtNavMesh, Free> mesh_;
  std::unique_ptr<dtNavMeshQuery, Free> query_;
  dtQueryFilter filter_;
  std::vector<dtPolyRef> corridor_;
};

/// Random places, by area, that are at least 2 mm away from the border of their triangles.
class Places {
 public:
  Places(const NavigationMesh& mesh, double scale) : mesh_(mesh), scale_(scale) {
    for (const Triangle& t : mesh.triangles)
      sums_.push_back((sums_.empty() ? 0 : sums_.back()) +
                      areaOf(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]));
  }
  /// A place and its triangle.
  std::pair<Vec3, std::size_t> next() {
    for (;;) {
      std::uniform_real_distribution<double> upTo(0, 1);
      const auto found = std::upper_bound(sums_.begin(), sums_.end(), upTo(random_) * sums_.back());
      const auto triangle = static_cast<std::size_t>(std::min(found, sums_.end() - 1) - sums_.begin());
      const Triangle& t = mesh_.triangles[triangle];
      double u = upTo(random_), v = upTo(random_);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const Vec3 &a = mesh_.vertices[t[0]], &b = mesh_.vertices[t[1]], &c = mesh_.vertices[t[2]];
      const double twice = std::fabs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
      const auto distance = [&](double share, const Vec3& p, const Vec3& q) {
        return share * twice / std::hypot(q.x - p.x, q.y - p.y) * scale_;
      };
      if (std::min({distance(1 - u - v, b, c), distance(u, c, a), distance(v, a, b)}) < 0.002) continue;
      return {a + u * (b - a) + v * (c - a), triangle};
    }
  }

 private:
  const NavigationMesh& mesh_;
  double scale_;
  std::vector<double> sums_;
  std::mt19937 random_{7};
};

/// The part of each triangle, over common edges and links.
std::vector<std::uint32_t> partsOf(const NavigationMesh& mesh) {
  std::vector<std::uint32_t> part(mesh.triangles.size());
  for (std::uint32_t i = 0; i < part.size(); ++i) part[i] = i;
  const auto find = [&](std::uint32_t i) {
    while (part[i] != i) i = part[i] = part[part[i]];
    return i;
  };
  const std::vector<std::uint32_t> opposite = oppositeEdges(mesh.triangles);
  for (std::uint32_t e = 0; e < opposite.size(); ++e)
    if (opposite[e] != kNoPolygon) part[find(e / 3)] = find(opposite[e] / 3);
  for (const StepLink& link : mesh.links) part[find(link.fromTriangle)] = find(link.toTriangle);
  for (std::uint32_t i = 0; i < part.size(); ++i) part[i] = find(i);
  return part;
}

/// Asks Detour for `pairs` ways, and the path finder for so many of them: it is slow where whole levels are searched.
/// The others it would find within one part, where there are no drops. With drops, lengths are not compared: the path
/// finder leaves them for last.
void compareWays(const Level& level, const DetourFile& file, int pairs, int searched) {
  DetourWorld world(file.bytes);
  const PathFinder finder(level.mesh);
  const std::vector<std::uint32_t> parts = partsOf(*level.mesh);
  const bool hasDrops = !level.mesh->drops.empty();
  Places places(*level.mesh, level.scale);
  int found = 0, measured = 0;
  double ours = 0, theirs = 0, shortest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < (hasDrops ? searched : pairs); ++i) {
    const auto [from, start] = places.next();
    const auto [to, end] = places.next();
    const DetourWorld::Way way = world.way(level.scale * from, level.scale * to);
    bool isReached = parts[start] == parts[end];
    double exact = 0;
    if (i < searched) {
      const PathResult path = finder.find(from, to, 0.001 / level.scale);
      if (!hasDrops) QCOMPARE(path.reached(), isReached);
      isReached = path.reached();
      exact = path.planLength * level.scale;
    }
    if (isReached != way.isFound)
      QFAIL(qPrintable(QString("%1 %2 %3 to %4 %5 %6: %7")
                           .arg(from.x)
                           .arg(from.y)
                           .arg(from.z)
                           .arg(to.x)
                           .arg(to.y)
                           .arg(to.z)
                           .arg(way.isFound ? "only Detour finds a way" : "only the path finder does")));
    found += way.isFound ? 1 : 0;
    if (!way.isFound || hasDrops || exact < 0.01) continue;
    ++measured;
    ours += exact;
    theirs += way.planLength;
    shortest = std::min(shortest, way.planLength / exact);
  }
  qInfo("%zu polygons, %zu tiles, %zu jumps, %d of %d reached, lengths by %.4f, at least %.5f", file.polygons,
        file.tiles, file.jumps, found, hasDrops ? searched : pairs, measured > 0 ? theirs / ours : 1,
        measured > 0 ? shortest : 1);
  QVERIFY(found > 0);
  if (measured == 0) return;
  // Detour goes straight through a corridor of polygons that it chose by the middles of their edges.
  QVERIFY2(theirs < 1.1 * ours, qPrintable(QString::number(theirs / ours)));
  // Detour's way is shorter over gaps, which are no polygons there.
  QVERIFY2(shortest > 0.98, qPrintable(QString::number(shortest)));
}

#endif

}  // namespace

class TestDetourExport : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    if (!hasDetour()) QSKIP("this build has no Detour; install librecast-dev");
  }

#ifdef FOOTFALL_HAS_DETOUR
  void waysAreTheSame_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<std::string>("more");
    for (const char* name : {"house", "rooms", "villa", "tower", "arena", "docks"}) {
      QTest::newRow(name) << sampleFile(name) << std::string();
      QTest::addRow("%s with drops", name) << sampleFile(name) << std::string("DropFilter 3\n");
    }
    if (sharedEnvironments().isEmpty()) return;
    for (const char* name : {"nav_test", "level", "ot", "turbine", "dutility", "complex", "steelribs", "fortitude"})
      QTest::newRow(name) << sharedEnvironments() + '/' + name + ".obj" << std::string();
    QTest::newRow("complex with drops") << sharedEnvironments() + "/complex.obj" << std::string("DropFilter 60\n");
  }
  void waysAreTheSame() {
    QFETCH(QString, file);
    QFETCH(std::string, more);
    const Level level = levelOf(file, more);
    const DetourFile written = formatDetour(*level.mesh, level.header);
    QCOMPARE(written.tiles, 1U);
    compareWays(level, written, 1000, level.mesh->triangles.size() > 4000 ? 30 : 100);
  }

  void tilesAreJoined_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<std::string>("more");
    for (const char* name : {"house", "villa", "tower"})
      QTest::newRow(name) << sampleFile(name) << std::string("DropFilter 3\n");
    if (!sharedEnvironments().isEmpty())
      for (const char* name : {"nav_test", "complex"})
        QTest::newRow(name) << sharedEnvironments() + '/' + name + ".obj" << std::string();
  }
  void tilesAreJoined() {
    QFETCH(QString, file);
    QFETCH(std::string, more);
    const Level level = levelOf(file, more);
    const DetourFile whole = formatDetour(*level.mesh, level.header);
    const DetourFile parts =
        formatDetour(*level.mesh, level.header, {}, {.polygons = (whole.polygons + whole.jumps) / 5});
    QVERIFY2(parts.tiles >= 5, qPrintable(QString::number(parts.tiles)));
    compareWays(level, parts, 500, level.mesh->triangles.size() > 4000 ? 30 : 100);
  }

  void whatDoesNotFitIsRefused() {
    const Level level = levelOf(sampleFile("house"));
    QVERIFY(messageOf<InputError>([&] {
              formatDetour(*level.mesh, level.header, {}, {.polygons = 1});
            }).contains("too many polygons"));
  }

  void heightsAreThoseOfTheMesh() {
    const Level level = levelOf(sampleFile("house"));
    const DetourWorld world(formatDetour(*level.mesh, level.header).bytes);
    Places places(*level.mesh, level.scale);
    for (int i = 0; i < 1000; ++i) {
      const Vec3 place = level.scale * places.next().first;
      Vec3 nearest;
      QVERIFY(world.polygonAt(place, &nearest) != 0);
      QVERIFY2(length(nearest - place) < 1e-4, qPrintable(QString::number(length(nearest - place))));
    }
  }

  void theHeaderHasTheAgent() {
    Level level = levelOf(sampleFile("house"));
    level.header.numbers.radius = 0.25;
    const DetourWorld world(formatDetour(*level.mesh, level.header).bytes);
    const dtMeshHeader& header = *world.mesh().getTile(0)->header;
    QCOMPARE(header.walkableHeight, 2.0f);
    QCOMPARE(header.walkableClimb, 0.4f);
    QCOMPARE(header.walkableRadius, 0.25f);
    QCOMPARE(header.version, 7);
  }

  void layersAreAreas() {
    const Level level = levelOf(sampleFile("tower"));
    QVERIFY(level.mesh->layerCount > 1);
    const auto areasOf = [&](const ExportOptions& options) {
      const DetourWorld world(formatDetour(*level.mesh, level.header, options).bytes);
      const dtMeshTile* tile = world.mesh().getTile(0);
      std::set<int> areas;
      for (int i = 0; i < tile->header->polyCount; ++i) areas.insert(tile->polys[i].getArea());
      return areas;
    };
    std::set<int> expected;
    for (std::uint32_t i = 0; i < level.mesh->layerCount; ++i) expected.insert(std::min(kFirstLayerArea + int(i), 63));
    QVERIFY(areasOf({}) == expected);
    ExportOptions one;
    one.layers = false;
    QVERIFY(areasOf(one) == std::set<int>{kGroundArea});
  }

  void whatIsLeftOutIsNotThere() {
    const Level level = levelOf(sampleFile("house"), "DropFilter 3\n");
    QVERIFY(!level.mesh->drops.empty());
    const DetourFile all = formatDetour(*level.mesh, level.header);
    ExportOptions options;
    options.drops = false;
    const DetourFile none = formatDetour(*level.mesh, level.header, options);
    QVERIFY(all.jumps >= none.jumps + level.mesh->drops.size());
    options.steps = false;
    QVERIFY(formatDetour(*level.mesh, level.header, options).bytes != none.bytes);
  }

  void theSameBytesAndMetres() {
    Level level = levelOf(sampleFile("rooms"));
    QVERIFY(formatDetour(*level.mesh, level.header).bytes == formatDetour(*level.mesh, level.header).bytes);
    NavigationMesh small = *level.mesh;
    small.frame.metresPerUnit = 0.5;
    ExportHeader header = level.header;
    const DetourWorld world(formatDetour(small, header).bytes);
    QCOMPARE(world.mesh().getTile(0)->header->walkableHeight, 1.0f);
    Places places(small, 0.5);
    QVERIFY(world.polygonAt(0.5 * places.next().first) != 0);
  }

  void nothingWalkableIsAFileWithoutTiles() {
    const DetourWorld world(formatDetour({}, {}).bytes);
    QVERIFY(world.polygonAt({0, 0, 0}) == 0);
  }

  void saveWritesIt() {
    const TemporaryFolder folder;
    const Level level = levelOf(sampleFile("rooms"));
    const double error = save(*level.mesh, folder.path("level.bin"), {}, level.header);
    QVERIFY(error < 1e-5);
    QCOMPARE(readAll(folder.path("level.bin")).toStdString(), formatDetour(*level.mesh, level.header).bytes);
    QCOMPARE(folder.files(), QStringList{"level.bin"});
    QVERIFY(messageOf<RunError>([&] { save(*level.mesh, "/nowhere/level.bin"); }).contains("folder does not exist"));
    const std::vector<ExportExtra> extras{{"crate", {}}};
    QVERIFY(messageOf<InputError>([&] {
              save(*level.mesh, folder.path("b.bin"), {}, {}, extras);
            }).contains("placed obstacles"));
    QCOMPARE(folder.files(), QStringList{"level.bin"});
  }
#endif
};

QTEST_GUILESS_MAIN(TestDetourExport)
#include "test_detour_export.moc"
