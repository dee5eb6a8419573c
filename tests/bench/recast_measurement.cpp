// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/recast_measurement.hpp"

#include <Recast.h>
#include <malloc.h>

#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

#include "core/base/disjoint_sets.hpp"
#include "core/base/process_usage.hpp"

namespace footfall::bench {
using namespace detail;
namespace {

template <auto release>
struct Release {
  template <class T>
  void operator()(T* object) const {
    release(object);
  }
};

// Keeps the last error, as the reason of a failure.
class Log : public rcContext {
 public:
  Log() : rcContext(true) { enableTimer(false); }
  [[noreturn]] void fail(const std::string& stage) const {
    throw std::runtime_error(stage + (error_.empty() ? "" : ": " + error_));
  }

 protected:
  void doLog(const rcLogCategory category, const char* message, const int length) override {
    if (category == RC_LOG_ERROR) error_.assign(message, static_cast<std::size_t>(length));
  }

 private:
  std::string error_;
};

struct Soup {
  std::vector<float> vertices;  // Y up
  std::vector<int> triangles;
};

Soup toSoup(const Environment& environment) {
  Soup soup;
  for (const Vec3& v : environment.vertices)
    for (const double c : {v.x, v.z, -v.y}) soup.vertices.push_back(static_cast<float>(c));
  for (const Triangle& t : environment.triangles)
    for (const std::uint32_t corner : t) soup.triangles.push_back(static_cast<int>(corner));
  return soup;
}

constexpr double kDemoClimb = 0.9;  // metres

rcConfig makeConfig(const Soup& soup, double metresPerUnit, const RecastCell& cell, double climb, double radius = 0) {
  constexpr double kAgentHeight = 2;  // metres
  constexpr float kSlope = 45;
  constexpr int kRegionMinSize = 8, kRegionMergeSize = 20;  // this and what follows: the demo's defaults
  constexpr double kEdgeMaxLength = 12;
  constexpr float kEdgeMaxError = 1.3F, kDetailSampleDistance = 6, kDetailSampleError = 1;
  constexpr int kCornersOfPolygon = 6;
  rcConfig config{};
  config.cs = static_cast<float>(cell.size / metresPerUnit);
  config.ch = static_cast<float>(cell.height / metresPerUnit);
  config.walkableSlopeAngle = kSlope;
  config.walkableHeight = static_cast<int>(std::ceil(kAgentHeight / cell.height));
  config.walkableClimb = static_cast<int>(std::floor(climb / cell.height));
  config.walkableRadius = static_cast<int>(std::ceil(radius / cell.size));
  config.maxEdgeLen = static_cast<int>(kEdgeMaxLength / cell.size);
  config.maxSimplificationError = kEdgeMaxError;
  config.minRegionArea = kRegionMinSize * kRegionMinSize;
  config.mergeRegionArea = kRegionMergeSize * kRegionMergeSize;
  config.maxVertsPerPoly = kCornersOfPolygon;
  config.detailSampleDist = config.cs * kDetailSampleDistance;
  config.detailSampleMaxError = config.ch * kDetailSampleError;
  rcCalcBounds(soup.vertices.data(), static_cast<int>(soup.vertices.size() / 3), config.bmin, config.bmax);
  rcCalcGridSize(config.bmin, config.bmax, config.cs, &config.width, &config.height);
  constexpr long long kMostCells = 1LL << 29U;  // 4 GB of pointers, before there is any span
  if (static_cast<long long>(config.width) * config.height > kMostCells) {
    throw std::runtime_error("a grid of " + std::to_string(config.width) + " x " + std::to_string(config.height) +
                             " cells");
  }
  return config;
}

// Recast packs the index of a cell's first span into 24 bits and does not look whether it fits.
constexpr int kMostSpans = (1 << 24) - 1;

using PolyMesh = std::unique_ptr<rcPolyMesh, Release<rcFreePolyMesh>>;
using CompactField = std::unique_ptr<rcCompactHeightfield, Release<rcFreeCompactHeightfield>>;

/// The field includes what is walkable in it.
CompactField buildCompactField(Log& log, const Soup& soup, const rcConfig& config) {
  const auto need = [&log](bool done, const char* stage) {
    if (!done) log.fail(stage);
  };
  const auto vertices = static_cast<int>(soup.vertices.size() / 3);
  const auto triangles = static_cast<int>(soup.triangles.size() / 3);
  std::unique_ptr<rcHeightfield, Release<rcFreeHeightField>> field(rcAllocHeightfield());
  need(rcCreateHeightfield(&log, *field, config.width, config.height, config.bmin, config.bmax, config.cs, config.ch),
       "heightfield");
  std::vector<unsigned char> areas(static_cast<std::size_t>(triangles), 0);
  rcMarkWalkableTriangles(&log, config.walkableSlopeAngle, soup.vertices.data(), vertices, soup.triangles.data(),
                          triangles, areas.data());
  need(rcRasterizeTriangles(&log, soup.vertices.data(), vertices, soup.triangles.data(), areas.data(), triangles,
                            *field, config.walkableClimb),
       "rasterizing");
  rcFilterLowHangingWalkableObstacles(&log, config.walkableClimb, *field);
  rcFilterLedgeSpans(&log, config.walkableHeight, config.walkableClimb, *field);
  rcFilterWalkableLowHeightSpans(&log, config.walkableHeight, *field);
  if (rcGetHeightFieldSpanCount(&log, *field) > kMostSpans) throw std::runtime_error("more than 2^24 spans");

  CompactField compact(rcAllocCompactHeightfield());
  need(rcBuildCompactHeightfield(&log, config.walkableHeight, config.walkableClimb, *field, *compact),
       "compact heightfield");
  return compact;
}

PolyMesh build(const Soup& soup, const rcConfig& config) {
  Log log;
  const auto need = [&log](bool done, const char* stage) {
    if (!done) log.fail(stage);
  };
  const CompactField compact = buildCompactField(log, soup, config);
  need(rcErodeWalkableArea(&log, config.walkableRadius, *compact), "eroding");
  need(rcBuildDistanceField(&log, *compact), "distance field");
  need(rcBuildRegions(&log, *compact, 0, config.minRegionArea, config.mergeRegionArea), "regions");
  std::unique_ptr<rcContourSet, Release<rcFreeContourSet>> contours(rcAllocContourSet());
  need(rcBuildContours(&log, *compact, config.maxSimplificationError, config.maxEdgeLen, *contours), "contours");
  PolyMesh mesh(rcAllocPolyMesh());
  need(rcBuildPolyMesh(&log, *contours, config.maxVertsPerPoly, *mesh), "polygon mesh");
  std::unique_ptr<rcPolyMeshDetail, Release<rcFreePolyMeshDetail>> detail(rcAllocPolyMeshDetail());
  need(rcBuildPolyMeshDetail(&log, *mesh, *compact, config.detailSampleDist, config.detailSampleMaxError, *detail),
       "detail mesh");
  return mesh;
}

double planAreaOf(const rcPolyMesh& mesh) {
  long long twice = 0;  // twice the area, in cells
  for (int p = 0; p < mesh.npolys; ++p) {
    const unsigned short* polygon = mesh.polys + 2 * p * mesh.nvp;
    int corners = 0;
    while (corners < mesh.nvp && polygon[corners] != RC_MESH_NULL_IDX) ++corners;
    for (int k = 0; k < corners; ++k) {
      const unsigned short* a = mesh.verts + 3 * polygon[k];
      const unsigned short* b = mesh.verts + 3 * polygon[(k + 1) % corners];
      twice += static_cast<long long>(b[0]) * a[2] - static_cast<long long>(a[0]) * b[2];
    }
  }
  return std::abs(static_cast<double>(twice)) / 2 * mesh.cs * mesh.cs;
}

}  // namespace

Json measureRecast(const Environment& environment, double metresPerUnit, const RecastCell& cell,
                   const Repetition& repetition, double radius) {
  const Soup soup = toSoup(environment);
  const rcConfig config = makeConfig(soup, metresPerUnit, cell, kDemoClimb, radius);
  ::malloc_trim(0);  // Memory freed by reading the file must not hide what Recast takes.
  const std::uint64_t before = residentMemory().now;
  Samples samples;
  PolyMesh mesh;
  std::uint64_t peak = 0;
  const auto once = [&] {
    mesh.reset();
    const Stopwatch watch;
    mesh = build(soup, config);
    samples.add("wall_ms", watch.wallMs());
    samples.add("cpu_ms", watch.cpuMs());
  };
  const int runs = repeat(repetition, once, [&] {
    peak = residentMemory().peak;
    samples.clear();
  });
  return {{"runs", runs},
          {"wall_ms", samples.median("wall_ms")},
          {"cpu_ms", samples.median("cpu_ms")},
          {"least_cpu_ms", samples.least("cpu_ms")},
          {"peak_bytes", peak > before ? peak - before : 0},
          {"plan_area", planAreaOf(*mesh)},
          {"polygons", mesh->npolys}};
}

RecastPlaces findRecastPlaces(const Environment& environment, double metresPerUnit, const RecastCell& cell,
                              double climb) {
  const Soup soup = toSoup(environment);
  const rcConfig config = makeConfig(soup, metresPerUnit, cell, climb);
  Log log;
  const CompactField field = buildCompactField(log, soup, config);
  const auto spanCount = static_cast<std::size_t>(field->spanCount);
  DisjointSets sets(spanCount);
  RecastPlaces found;
  std::vector<Index> spans;
  for (int y = 0; y < field->height; ++y) {
    for (int x = 0; x < field->width; ++x) {
      const rcCompactCell& own = field->cells[x + y * field->width];
      for (unsigned i = own.index, end = own.index + static_cast<unsigned>(own.count); i < end; ++i) {
        if (field->areas[i] == RC_NULL_AREA) continue;
        const rcCompactSpan& span = field->spans[i];
        for (int direction = 0; direction < 4; ++direction) {
          if (rcGetCon(span, direction) == RC_NOT_CONNECTED) continue;
          const int nextX = x + rcGetDirOffsetX(direction), nextY = y + rcGetDirOffsetY(direction);
          const unsigned next =
              field->cells[nextX + nextY * field->width].index + static_cast<unsigned>(rcGetCon(span, direction));
          if (field->areas[next] != RC_NULL_AREA) sets.unite(static_cast<Index>(i), static_cast<Index>(next));
        }
        const double cs = field->cs, ch = field->ch;
        found.places.push_back(
            {field->bmin[0] + (x + 0.5) * cs, -(field->bmin[2] + (y + 0.5) * cs), field->bmin[1] + span.y * ch});
        spans.push_back(static_cast<Index>(i));
      }
    }
  }
  std::vector<std::uint32_t> partOf(spanCount, std::numeric_limits<std::uint32_t>::max());
  for (const Index span : spans) {
    std::uint32_t& part = partOf[sets.find(span)];
    if (part == std::numeric_limits<std::uint32_t>::max()) part = found.partCount++;
    found.parts.push_back(part);
  }
  return found;
}

}  // namespace footfall::bench
