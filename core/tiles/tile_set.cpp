// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/tile_set.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "core/base/byte_stream.hpp"
#include "core/io/input_file.hpp"
#include "core/io/output_files.hpp"
#include "footfall/up_axis.hpp"

namespace footfall::detail {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "footfall tiles";

std::string pathIn(const std::string& folder, const std::string& file) {
  return (std::filesystem::path(folder) / file).string();
}

std::string padded(std::uint64_t number, unsigned base, std::size_t width) {
  std::string text(width, '0');
  for (auto digit = text.rbegin(); digit != text.rend(); ++digit, number /= base)
    *digit = "0123456789abcdef"[number % base];
  return text;
}

std::string textOf(const Digest::Value& sum) { return padded(sum[0], 16, 16) + padded(sum[1], 16, 16); }

Box boxAround(const std::vector<Vec3>& places) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box box{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  for (const Vec3& place : places) {
    const std::array<double, 3> numbers{place.x, place.y, place.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.lower[axis] = std::min(box.lower[axis], numbers[axis]);
      box.upper[axis] = std::max(box.upper[axis], numbers[axis]);
    }
  }
  return box;
}

Digest::Value sumOf(const Json& json) {
  const std::string text = json.get<std::string>();
  if (text.size() != 32 || text.find_first_not_of("0123456789abcdef") != std::string::npos)
    throw BadBytes("is damaged");
  return {std::stoull(text.substr(0, 16), nullptr, 16), std::stoull(text.substr(16), nullptr, 16)};
}

TileEntry entryOf(const Json& json) {
  TileEntry entry;
  entry.file = json.at("file").get<std::string>();
  // Nothing outside the folder.
  if (std::filesystem::path(entry.file).filename() != entry.file) throw BadBytes("names a file that is not in it");
  entry.faces = json.at("faces").get<std::uint64_t>();
  entry.triangles = json.at("triangles").get<std::uint64_t>();
  entry.vertices = json.at("vertices").get<std::uint64_t>();
  entry.borders = json.at("borders").get<std::uint64_t>();
  entry.links = json.at("links").get<std::uint64_t>();
  entry.box.lower = json.at("box").at(0).get<std::array<double, 3>>();
  entry.box.upper = json.at("box").at(1).get<std::array<double, 3>>();
  entry.sum = sumOf(json.at("sum"));
  return entry;
}

TileSet setOf(const std::string& text) {
  const Json json = Json::parse(text);
  if (!json.is_object() || json.value("format", std::string()) != kFormat) throw BadBytes("is no index of tiles");
  if (json.at("version").get<std::uint64_t>() != kTileVersion) throw BadBytes("is an index of another version");
  TileSet set;
  set.frame.source = json.at("source").get<std::string>();
  const auto up = upAxisFrom(json.at("up").get<std::string>());
  set.frame.up = up ? *up : throw BadBytes("is damaged");
  set.frame.metresPerUnit = json.at("metres_per_unit").get<double>();
  if (!(set.frame.metresPerUnit > 0 && std::isfinite(set.frame.metresPerUnit))) throw BadBytes("is damaged");
  for (const Json& storey : json.at("storeys"))
    set.frame.storeys.push_back({storey.at("name").get<std::string>(), storey.at("height").get<double>()});
  set.pipeline = json.at("pipeline").get<std::string>();
  set.bothSides = json.at("both_sides").get<bool>();
  for (const Json& role : json.at("roles")) {
    const auto number = role.get<std::uint64_t>();
    if (number > static_cast<std::uint64_t>(PartRole::Ignored)) throw BadBytes("is damaged");
    set.roles.push_back(static_cast<PartRole>(number));
  }
  set.environment = sumOf(json.at("environment"));
  set.slice = {json.at("slice").at(0).get<std::uint32_t>(), json.at("slice").at(1).get<std::uint32_t>()};
  if (set.slice.number < 1 || set.slice.number > set.slice.count) throw BadBytes("is damaged");
  set.triangles = json.at("triangles").get<std::uint64_t>();
  for (const Json& tile : json.at("tiles")) set.tiles.push_back(entryOf(tile));
  return set;
}

}  // namespace

std::string tileFileName(std::size_t number) {
  return "tile-" + padded(number, 10, 7) + '.' + std::string(kTileExtension);
}

TileEntry writeTile(const std::string& folder, const std::string& file, const Tile& tile, const RunContext& context) {
  TileEntry entry;
  entry.file = file;
  entry.faces = tile.faces.size();
  entry.triangles = tile.triangles.size();
  entry.vertices = tile.places.size();
  entry.borders = tile.borders.size();
  entry.links = static_cast<std::uint64_t>(
      std::count_if(tile.links.begin(), tile.links.end(), [](const TileLink& link) { return link.hasFrom; }));
  entry.box = boxAround(tile.places);
  const std::array<OutputFile, 1> files{{{pathIn(folder, entry.file), encodeTile(tile, context)}}};
  entry.sum = Digest().add(files[0].bytes).value();
  writeFilesSafely(files, context);
  return entry;
}

bool beginsAsTileIndex(std::string_view text) {
  const std::string whole = formatTileIndex({});
  const std::size_t end = whole.find(kFormat) + std::string_view(kFormat).size();
  return text.substr(0, end) == std::string_view(whole).substr(0, end);
}

std::string formatTileIndex(const TileSet& set) {
  Json json;
  json["format"] = kFormat;
  json["version"] = kTileVersion;
  json["source"] = set.frame.source;
  json["up"] = nameOf(set.frame.up);
  json["metres_per_unit"] = set.frame.metresPerUnit;
  json["storeys"] = Json::array();
  for (const Storey& storey : set.frame.storeys)
    json["storeys"].push_back({{"name", storey.name}, {"height", storey.height}});
  json["pipeline"] = set.pipeline;
  json["both_sides"] = set.bothSides;
  json["roles"] = Json::array();
  for (const PartRole role : set.roles) json["roles"].push_back(static_cast<std::uint64_t>(role));
  json["environment"] = textOf(set.environment);
  json["slice"] = {set.slice.number, set.slice.count};
  json["triangles"] = set.triangles;
  json["tiles"] = Json::array();
  for (const TileEntry& tile : set.tiles)
    json["tiles"].push_back({{"file", tile.file},
                             {"faces", tile.faces},
                             {"triangles", tile.triangles},
                             {"vertices", tile.vertices},
                             {"borders", tile.borders},
                             {"links", tile.links},
                             {"box", Json::array({tile.box.lower, tile.box.upper})},
                             {"sum", textOf(tile.sum)}});
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

TileSet readTileIndex(const std::string& folder, RunContext* context) {
  const std::string path = pathIn(folder, kTileIndex);
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored))
    failInput(folder, 0, FOOTFALL_TEXT("is no folder of tiles"),
              FOOTFALL_TEXT("give the one that `footfall run --memory` wrote"));
  if (!std::filesystem::exists(path, ignored))
    failInput(folder, 0, FOOTFALL_TEXT("has no index.json: it is no folder of tiles, or the run did not end"),
              kRunTilesAgain);
  const std::string text = readInputFile(path, context);
  try {
    return setOf(text);
  } catch (const BadBytes& error) {
    failInput(path, 0, error.what(), kRunTilesAgain);
  } catch (const nlohmann::json::exception&) {
    failInput(path, 0, FOOTFALL_TEXT("is damaged"), kRunTilesAgain);
  }
}

Tile readTile(const std::string& folder, const TileEntry& entry, RunContext* context) {
  const std::string path = pathIn(folder, entry.file), bytes = readInputFile(path, context);
  if (Digest().add(bytes).value() != entry.sum)
    failInput(path, 0, FOOTFALL_TEXT("is damaged, or of another run than the index"), kRunTilesAgain);
  try {
    return decodeTile(bytes, Poll(context));
  } catch (const BadBytes& error) {
    failInput(path, 0, error.what(), kRunTilesAgain);
  }
}

}  // namespace footfall::detail
