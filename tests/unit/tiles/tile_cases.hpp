// Runs within a bound of memory for tests: pipelines, soups, and tiles joined against a run with everything in memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <rapidcheck.h>

#include <QString>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/base/worker_arena.hpp"
#include "core/environment/part_rules.hpp"
#include "core/io/export.hpp"
#include "core/tiles/tile_join.hpp"
#include "core/tiles/tile_run.hpp"
#include "footfall/edit.hpp"
#include "footfall/run.hpp"
#include "tests/support/soup_generators.hpp"
#include "tests/unit/packed_round_trip.hpp"
#include "tests/unit/program_run.hpp"

namespace footfall::test {

using namespace detail;

inline constexpr std::uint64_t kEnough = std::uint64_t{4} << 30;

/// Tests before and behind a clearance, two clearances, blocks, no clearance, nothing at all.
inline const std::vector<std::string> kPipelines{
    "SlopeFilter 45\nVerticalClearanceFilter 2\n",
    "DuplicationFilter 0\nDegeneracyFilter\nSlopeFilter 50\nVerticalClearanceFilter 1.5\nSlopeFilter 30\n",
    "VerticalClearanceFilter 1\nSlopeFilter 60\nDegeneracyFilter\nVerticalClearanceFilter 2\n",
    "GridStrategy 3 2\nSlopeFilter 45\nVerticalClearanceFilter 1\nCollapse\nVerticalClearanceFilter 3\n",
    "VerticalClearanceFilter 0.5\n",
    "SlopeFilter 40\n",
    "",
    "SlopeFilter 45\nVerticalClearanceFilter 2\nAreaFilter 2.5\n",
    "SlopeFilter 60\nAreaFilter 1\nAreaFilter 0.25\n",
    "SlopeFilter 60\nLayerSubdivisionFilter\n",
    "SlopeFilter 45\nVerticalClearanceFilter 1\nAreaFilter 1\nLayerSubdivisionFilter\n",
    "SlopeFilter 60\nSimplificationFilter\n",
    "SlopeFilter 45\nVerticalClearanceFilter 1\nAreaFilter 1\nSimplificationFilter\nLayerSubdivisionFilter\n",
    "VerticalClearanceFilter 1\nLayerSubdivisionFilter\nSimplificationFilter\nSimplificationFilter\n"};

/// Steps small and large, one that is more than the clearance, before and behind areas, in a block.
inline const std::vector<std::string> kStepPipelines{
    "SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.5 0\n",
    "SlopeFilter 60\nVerticalClearanceFilter 1\nStepFilter 1 0\nAreaFilter 2.5\n",
    "SlopeFilter 60\nVerticalClearanceFilter 1\nAreaFilter 0.75\nStepFilter 1 0\nAreaFilter 3\nAreaFilter 4\n",
    "VerticalClearanceFilter 0.5\nStepFilter 2.5 0\n",
    "GridStrategy 2 2\nVerticalClearanceFilter 0.25\nStepFilter 1 0\nCollapse\nAreaFilter 1\n"};

/// The same with filters over borders behind them.
inline const std::vector<std::string> kLinkedPipelines{
    "SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.5 0\nSimplificationFilter\nLayerSubdivisionFilter\n",
    "SlopeFilter 60\nVerticalClearanceFilter 1\nStepFilter 1 0\nAreaFilter 1\nLayerSubdivisionFilter\n",
    "SlopeFilter 60\nVerticalClearanceFilter 1\nAreaFilter 0.75\nStepFilter 1 1\nAreaFilter 2\nSimplificationFilter\n",
    "VerticalClearanceFilter 0.5\nStepFilter 2.5 2\nLayerSubdivisionFilter\nSimplificationFilter\n"};

inline const std::string kDefault =
    "SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.4 0.05\nAreaFilter 1\nSimplificationFilter\n"
    "LayerSubdivisionFilter\n";
inline const std::string kUsualSteps = "SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.4 0.05\nAreaFilter 1\n";

/// The same with gaps.
inline const std::vector<std::string> kGapPipelines{
    "SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.5 0.3\n",
    "SlopeFilter 60\nVerticalClearanceFilter 1\nStepFilter 1 1.5\nAreaFilter 2.5\n",
    "SlopeFilter 60\nVerticalClearanceFilter 1\nAreaFilter 0.75\nStepFilter 1 1\nAreaFilter 3\n",
    "VerticalClearanceFilter 0.5\nStepFilter 2.5 2\n"};

inline rc::Gen<Soup> anySoup() {
  return rc::gen::oneOf(rc::gen::map(gridTriangles(20, 3, 3), [](const auto& numbers) { return soupOf(numbers); }),
                        rc::gen::map(gridTriangles(24, 1000, 20), [](const auto& numbers) { return soupOf(numbers); }),
                        rc::gen::map(buildingParts(12), [](const auto& numbers) { return buildingOf(numbers); }),
                        rc::gen::map(upTo(20, below(64)), [](const auto& steps) { return walkOf(steps); }));
}

inline void pack(const Environment& environment, const std::string& target) {
  EnvironmentPacker packer("a soup", target, nullptr, kLittle);
  for (const Vec3& vertex : environment.vertices) packer.addVertex(vertex);
  for (std::size_t t = 0; t < environment.triangles.size(); ++t)
    packer.addFace(environment.triangles[t], environment.partOf.empty() ? 0 : environment.partOf[t]);
  packer.finish(environment);
}

/// Runs in a folder of its own; returns the bytes of all files there.
inline std::map<std::string, QByteArray> makeTiles(const PackedEnvironment& environment, const std::string& pipeline,
                                                   const std::string& folder, std::uint64_t mostFaces,
                                                   int threads = 0) {
  std::filesystem::create_directory(folder);
  RunContext context;
  OneRank ranks;
  onThreads(threads, [&](int) {
    return runIntoTiles(environment, parsePipeline(pipeline, "test"), folder, {kEnough, mostFaces}, ranks, context);
  });
  std::map<std::string, QByteArray> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    files[entry.path().filename().string()] = readAll(entry.path().string());
  return files;
}

inline std::string bytesOf(const NavigationMesh& mesh) {
  return formatObj(mesh, {}) + std::to_string(mesh.sourceTriangles.size()) + ' ' + std::to_string(mesh.layerCount);
}

/// The bytes of tiles.
class TilesInMemory : public TileStore {
 public:
  void add(const Tile& tile) override { tiles.push_back(encodeTile(tile)); }
  Tile read(std::size_t number) override { return decodeTile(tiles[number]); }
  void replace(std::size_t number, const Tile& tile) override { tiles[number] = encodeTile(tile); }
  std::string write(const std::string& /*name*/, const Tile& tile) override { return encodeTile(tile); }
  void take(std::size_t number, const std::string& written) override {
    tiles.resize(std::max(tiles.size(), number + 1));
    tiles[number] = written;
  }

  std::vector<std::string> tiles;
};

/// Empty when tiles of cells with at most so many triangles of their own, in any order, are joined to the same bytes.
inline QString differenceOf(const PackedEnvironment& environment, const std::string& pipeline,
                            const std::vector<std::uint64_t>& cells, std::uint64_t memory = kEnough) {
  RunContext context;
  const Pipeline parsed = parsePipeline(pipeline, "test");
  const auto level = applyPartRules(std::make_shared<Environment>(environment.readAll()), {});
  if (level->triangles.empty()) return {};
  const RunResult whole = runPipeline(level, parsed, context, nullptr, 1);
  std::vector<std::uint32_t> sources = whole.mesh->sourceTriangles;
  if (level->edit)
    for (std::uint32_t& source : sources) source = level->edit->keptTriangles[source];
  TileRunOptions options{memory};
  options.roles = rolesOf(environment.head(), {});
  for (const std::uint64_t most : cells) {
    TilesInMemory store;
    OneRank ranks;
    options.mostFaces = most;
    runCells(environment, parsed, options, store, ranks, context);
    TileJoiner joiner;
    for (auto tile = store.tiles.rbegin(); tile != store.tiles.rend(); ++tile) joiner.add(decodeTile(*tile));
    std::shared_ptr<NavigationMesh> joined = joiner.join(context);
    joined->frame = environment.head().frame();
    if (bytesOf(*joined) != bytesOf(*whole.mesh) || joined->sourceTriangles != sources ||
        joined->layers != whole.mesh->layers || joined->connections != whole.mesh->connections ||
        joined->links.size() != whole.mesh->links.size())
      return QString("cells of %1: %2").arg(most).arg(QString::fromStdString(pipeline));
  }
  return {};
}

/// The file of an environment, packed; empty where it is not there.
inline std::string packed(const std::string& path, const TemporaryFolder& folder) {
  if (!std::filesystem::exists(path)) return {};
  const std::string target = folder.path("level.ffenv");
  packEnvironment(path, target, {}, nullptr);
  return target;
}

inline std::string sample(const std::string& name) {
  return std::string(FOOTFALL_SOURCE_DIR) + "/samples/" + name + "/" + name + ".obj";
}

/// Any soups, in cells of few triangles and of all, with each pipeline.
inline bool checkSoups(const char* title, int count, const std::vector<std::string>& pipelines) {
  return check(title, count, [&pipelines] {
    const auto environment = (*anySoup()).environment();
    if (environment->triangles.empty()) return;
    const TemporaryFolder folder;
    pack(*environment, folder.path("soup.ffenv"));
    const PackedEnvironment opened(folder.path("soup.ffenv"));
    for (const std::string& pipeline : pipelines) {
      const QString difference = differenceOf(opened, pipeline, {1, 3, 1000});
      if (!difference.isEmpty()) RC_FAIL(toText(*environment) + difference.toStdString());
    }
  });
}

}  // namespace footfall::test
