// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/tile_folder.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

#include "core/base/byte_stream.hpp"
#include "core/io/export.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

namespace fs = std::filesystem;

std::string encodeEntry(const TileEntry& entry) {
  ByteWriter out;
  out.text(entry.file);
  for (const std::uint64_t count : {entry.faces, entry.triangles, entry.vertices, entry.borders, entry.links})
    out.number(count);
  for (const auto& corner : {entry.box.lower, entry.box.upper})
    for (const double x : corner) out.real(x);
  for (const std::uint64_t word : entry.sum) out.fixed(word);
  return std::move(out.bytes);
}

TileEntry decodeEntry(const std::string& bytes) {
  ByteReader in(bytes);
  TileEntry entry;
  entry.file = in.text();
  for (std::uint64_t* count : {&entry.faces, &entry.triangles, &entry.vertices, &entry.borders, &entry.links})
    *count = in.number();
  for (auto* corner : {&entry.box.lower, &entry.box.upper})
    for (double& x : *corner) x = in.real();
  for (std::uint64_t& word : entry.sum) word = in.fixed();
  in.expectEnd();
  return entry;
}

}  // namespace

TileFolder::~TileFolder() {
  std::error_code ignored;
  for (const std::string& file : written_) fs::remove(fs::path(folder_) / file, ignored);
}

void TileFolder::add(const Tile& tile) {
  entries_.push_back(writeTile(folder_, tileFileName(entries_.size() + 1), tile, context_));
  remember(entries_.back());
}

void TileFolder::replace(std::size_t number, const Tile& tile) {
  entries_[number] = writeTile(folder_, tileFileName(number + 1), tile, context_);
}

std::string TileFolder::write(const std::string& name, const Tile& tile) {
  const TileEntry entry = writeTile(folder_, name + '.' + std::string(kTileExtension), tile, context_);
  remember(entry);
  return encodeEntry(entry);
}

void TileFolder::take(std::size_t number, const std::string& written) {
  TileEntry entry = decodeEntry(written);
  const std::string file = tileFileName(number + 1);
  std::error_code error;
  fs::rename(fs::path(folder_) / entry.file, fs::path(folder_) / file, error);
  if (error)
    throw RunError(FOOTFALL_TEXT("%1: cannot be renamed: %2; look who else writes into the folder, and run it again"),
                   (fs::path(folder_) / entry.file).string(), error.message());
  entry.file = file;
  if (number < entries_.size()) {
    entries_[number] = std::move(entry);
    return;
  }
  entries_.push_back(std::move(entry));
  remember(entries_.back());
}

void TileFolder::finish(TileSet& set) {
  std::error_code ignored;  // what the index does not name does no harm
  for (const TileEntry& entry : entries_) {
    if (entry.triangles > 0)
      set.tiles.push_back(entry);
    else
      fs::remove(fs::path(folder_) / entry.file, ignored);
  }
  written_.emplace_back(kTileIndex);
  writeFileSafely((fs::path(folder_) / kTileIndex).string(), formatTileIndex(set));
  keep();
}

}  // namespace footfall::detail
