// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/tile_report.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/counted_text.hpp"
#include "core/base/process_usage.hpp"
#include "footfall/version.hpp"

namespace footfall::detail {
namespace {

constexpr std::uint64_t kMegabyte = std::uint64_t{1} << 20;

}  // namespace

std::uint64_t peakOf(const TileRunResult& result) {
  std::uint64_t peak = peakRssBytes();
  for (const TileRankStatistics& rank : result.ranks) peak = std::max(peak, rank.peakBytes);
  return peak;
}

std::string formatTileStatistics(const std::string& source, std::uint64_t memory, const TileRunResult& result) {
  nlohmann::ordered_json json;
  json["footfall"] = FOOTFALL_VERSION;
  json["environment"] = {{"source", source}, {"triangles", result.set.triangles}};
  json["pipeline"] = result.set.pipeline;
  json["memory"] = {{"bound_bytes", memory}, {"peak_bytes", peakOf(result)}};
  json["cells"] = {{"count", result.counts.cells},
                   {"made_smaller", result.counts.refused},
                   {"taken_over", result.counts.takenOver},
                   {"triangles_read", result.counts.collected},
                   {"most_triangles_at_once", result.counts.largestCell}};
  std::uint64_t triangles = 0, links = 0;
  for (const TileEntry& tile : result.set.tiles) {
    triangles += tile.triangles;
    links += tile.links;
  }
  json["tiles"] = {{"count", result.set.tiles.size()}, {"triangles", triangles}, {"links", links}};
  json["times_ms"] = {{"wall", result.wallMs}, {"cpu", result.cpuMs}};
  json["ranks"] = nlohmann::ordered_json::array();
  for (const TileRankStatistics& rank : result.ranks)
    json["ranks"].push_back({{"rank", json["ranks"].size()},
                             {"cells", rank.counts.cells},
                             {"triangles_read", rank.counts.collected},
                             {"bytes_read", rank.bytesRead},
                             {"peak_bytes", rank.peakBytes},
                             {"wall_ms", rank.wallMs},
                             {"cpu_ms", rank.cpuMs}});
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

std::string tileSummary(const std::string& folder, const TileRunResult& result) {
  std::uint64_t triangles = 0;
  for (const TileEntry& tile : result.set.tiles) triangles += tile.triangles;
  const auto counted = [](std::uint64_t count, const char* one, const char* many) {
    return countedText(count, Pattern{one}, Pattern{many}).str();
  };
  return folder + ": " + counted(result.set.tiles.size(), "1 tile", "%1 tiles") + ", " +
         counted(triangles, "1 walkable triangle", "%1 walkable triangles") + " of " +
         counted(result.set.triangles, "1 triangle", "%1 triangles") + "; peak memory " +
         std::to_string((peakOf(result) + kMegabyte - 1) / kMegabyte) + " MB" +
         (result.ranks.size() > 1 ? ", the most of " + std::to_string(result.ranks.size()) + " ranks\n" : "\n");
}

}  // namespace footfall::detail
