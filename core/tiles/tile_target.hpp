// The folder and the temporary files of a run into tiles, and its share of the memory for packing.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "core/distributed/rank_group.hpp"
#include "core/io/packed/environment_packer.hpp"
#include "core/tiles/tile_set.hpp"
#include "footfall/run_context.hpp"
#include "footfall/text.hpp"

namespace footfall::detail {

/// A lock on a folder that lives as long as the process. On file systems without folder locks, it always succeeds.
class FolderLock {
 public:
  /// Throws InputError when another run uses the folder.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int file_;
};

/// The target folder of a run into tiles. It is made where it is missing. Unless keep() was called, the destructor
/// restores its former state; the folder of an unfinished run is always kept, because the next run continues it.
class TileTarget {
 public:
  /// Throws RunError when the folder cannot be made, and InputError when it is not empty or another run uses it.
  explicit TileTarget(const std::string& path);
  ~TileTarget();
  TileTarget(const TileTarget&) = delete;
  TileTarget& operator=(const TileTarget&) = delete;

  void keep() { isKept_ = true; }

 private:
  std::filesystem::path path_;
  bool isMade_ = false, isKept_ = false;
  std::optional<FolderLock> lock_;
};

/// A file that exists only during a run.
class FileOfRun {
 public:
  explicit FileOfRun(std::string path) : path_(std::move(path)) {}
  ~FileOfRun();
  FileOfRun(const FileOfRun&) = delete;
  FileOfRun& operator=(const FileOfRun&) = delete;

 private:
  std::string path_;
};

/// Bounds of packing that keep it within `memory` bytes. They use half of it: lists of what was read, and as much again
/// while these are sorted.
PackingMemory packingWithin(std::uint64_t memory);

/// The slice of a text such as "2/8"; all for an empty text. Throws InputError for any other text.
TileSlice parseSlice(const std::string& text);

/// Throws InputError with `problem` when the file lies in the folder of the tiles, which may contain only tiles and
/// their index. An empty path is not checked.
void checkOutside(const std::string& path, const std::string& folder, Pattern problem);

/// Throws RunError where the folder of rank 0 is not that of this rank: rank 0 writes the file, and all ranks must see
/// it there. A network may take a while to show it.
void checkShared(const std::string& file, const std::string& folder, RankGroup& ranks, RunContext& context);

}  // namespace footfall::detail
