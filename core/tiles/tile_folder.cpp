// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/tile_folder.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "core/base/byte_stream.hpp"
#include "core/io/export.hpp"
#include "core/io/input_file.hpp"
#include "core/io/output_files.hpp"
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

constexpr const char* kTile = "tile-";
constexpr const char* kCell = "cell-";         // tiles and outcomes of cells begin with it
constexpr const char* kOutcome = ".cell";      // and outcomes end with that
constexpr const char* kBeside = ".footfall-";  // name of a file that a killed process had not renamed yet

bool isTile(const std::string& name) { return name.starts_with(kTile) && name.ends_with(kTileExtension); }

bool isOfCell(const std::string& name) {
  return name.starts_with(kCell) && (name.ends_with(kTileExtension) || name.ends_with(kOutcome));
}

bool isBeside(const std::string& name) { return name.starts_with(kBeside); }

// Removes the files of the folder that `isGone` selects, as far as the folder can be listed.
template <class IsGone>
void removeFiles(const std::string& folder, const IsGone& isGone) {
  std::error_code error;
  std::vector<fs::path> gone;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
    if (isGone(at->path().filename().string())) gone.push_back(at->path());
  for (const fs::path& path : gone) fs::remove(path, error);
}

}  // namespace

TileFolder::~TileFolder() {
  if (leavesUnfinished_) return;
  std::error_code ignored;
  for (const std::string& file : written_) fs::remove(pathOf(file), ignored);
}

std::string TileFolder::pathOf(const std::string& file) const { return (fs::path(folder_) / file).string(); }

void TileFolder::add(const Tile& tile) {
  entries_.push_back(writeTile(folder_, tileFileName(entries_.size() + 1), tile, context_));
  written_.push_back(entries_.back().file);
}

void TileFolder::replace(std::size_t number, const Tile& tile) {
  entries_[number] = writeTile(folder_, tileFileName(number + 1), tile, context_);
}

std::string TileFolder::write(const std::string& name, const Tile& tile) {
  const TileEntry entry = writeTile(folder_, name + '.' + std::string(kTileExtension), tile, context_);
  written_.push_back(entry.file);
  return encodeEntry(entry);
}

// The file keeps its other name as well, for a run that goes on from here, where the disk can do that.
void TileFolder::take(std::size_t number, const std::string& written) {
  TileEntry entry = decodeEntry(written);
  const std::string file = tileFileName(number + 1);
  std::error_code error;
  fs::remove(pathOf(file), error);
  fs::create_hard_link(pathOf(entry.file), pathOf(file), error);
  if (error) fs::rename(pathOf(entry.file), pathOf(file), error);
  if (error)
    throw RunError(
        FOOTFALL_TEXT("%1: cannot be renamed: %2; check which other program writes into the folder, and run again"),
        pathOf(entry.file), error.message());
  entry.file = file;
  if (number < entries_.size()) {
    entries_[number] = std::move(entry);
    return;
  }
  entries_.push_back(std::move(entry));
  written_.push_back(file);
}

bool TileFolder::begin(const std::string& what) {
  const std::string path = pathOf(kUnfinishedRun);
  std::error_code ignored;
  if (fs::exists(path, ignored)) {
    if (readInputFile(path, &context_) != what)
      throw InputError(FOOTFALL_TEXT("%1: has a run that did not end, of another environment, other filters or another "
                                     "bound; remove the folder, or give a new name"),
                       folder_);
    removeFiles(folder_, [](const std::string& name) { return isTile(name) || name == kTileIndex || isBeside(name); });
    return true;
  }
  written_.emplace_back(kUnfinishedRun);
  writeFileSafely(path, what);
  return false;
}

void TileFolder::keepCell(const std::string& name, const std::string& bytes) {
  written_.push_back(name + kOutcome);
  ByteWriter out;
  for (const std::uint64_t word : Digest().add(bytes).value()) out.fixed(word);
  const std::array<OutputFile, 1> files{{{pathOf(name + kOutcome), out.bytes + bytes}}};
  writeFilesSafely(files, context_);
}

std::string TileFolder::keptCell(const std::string& name) {
  const std::string path = pathOf(name + kOutcome);
  std::error_code ignored;
  if (!goesOn_ || !fs::exists(path, ignored)) return {};
  const std::string all = readInputFile(path, &context_);
  try {
    ByteReader in(all);
    Digest::Value sum;
    for (std::uint64_t& word : sum) word = in.fixed();
    return Digest().add(in.rest()).value() == sum ? std::string(in.rest()) : std::string();
  } catch (const BadBytes&) {
    return {};
  }
}

bool TileFolder::has(const std::string& written) {
  const TileEntry entry = decodeEntry(written);
  std::error_code ignored;
  const std::string path = pathOf(entry.file);
  return fs::file_size(path, ignored) > 0 && !ignored &&
         Digest().add(readInputFile(path, &context_)).value() == entry.sum;
}

void TileFolder::finish(TileSet& set) {
  std::vector<std::string> kept;
  for (const TileEntry& entry : entries_) {
    if (entry.triangles == 0) continue;
    set.tiles.push_back(entry);
    kept.push_back(entry.file);
  }
  written_.emplace_back(kTileIndex);
  writeFileSafely(pathOf(kTileIndex), formatTileIndex(set));
  written_.clear();
  removeFiles(folder_, [&kept](const std::string& name) {
    return isOfCell(name) || name == kSeenByRanks || name == kPackedForRun ||
           (isTile(name) && std::find(kept.begin(), kept.end(), name) == kept.end());
  });
  std::error_code ignored;
  fs::remove(pathOf(kUnfinishedRun), ignored);
}

void removeUnfinished(const std::string& folder) {
  removeFiles(folder, [](const std::string& name) {
    return isTile(name) || isOfCell(name) || isBeside(name) || name == kTileIndex || name == kUnfinishedRun ||
           name == kSeenByRanks || name == kPackedForRun;
  });
}

bool hasLeftoversOnly(const std::string& folder) {
  std::error_code error;
  std::size_t count = 0;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error), ++count) {
    const std::string name = at->path().filename().string();
    if (!isBeside(name) && name != kPackedForRun && name != kSeenByRanks) return false;
  }
  return !error && count > 0;
}

bool hasUnfinished(const std::string& folder) {
  std::ifstream file(fs::path(folder) / kUnfinishedRun, std::ios::binary);
  std::string start(256, '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  return beginsAsTileIndex(start);
}

}  // namespace footfall::detail
