// Tiles of a run in files of one folder.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/tiles/tile_set.hpp"
#include "core/tiles/tile_store.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// The name of a file in the folder of a run that is under way.
inline constexpr const char* kUnfinishedRun = "unfinished";
/// The folder may also have these: the file that the other ranks look for, and the environment, packed for the run.
inline constexpr const char* kSeenByRanks = "ranks";
inline constexpr const char* kPackedForRun = "environment.ffenv";

/// Removes what this process has written unless the run ends well, or leaveUnfinished() was called. Its functions throw
/// what writeFilesSafely() and readTile() throw, and Cancelled.
class TileFolder : public TileStore {
 public:
  TileFolder(const std::string& folder, RunContext& context) : folder_(folder), context_(context) {}
  ~TileFolder() override;

  void add(const Tile& tile) override;
  Tile read(std::size_t number) override { return readTile(folder_, entries_[number], &context_); }
  void replace(std::size_t number, const Tile& tile) override;
  std::string write(const std::string& name, const Tile& tile) override;
  void take(std::size_t number, const std::string& written) override;

  bool begin(const std::string& what) override;
  void goOn() override { goesOn_ = leavesUnfinished_ = true; }
  void leaveUnfinished() { leavesUnfinished_ = true; }
  void keepCell(const std::string& name, const std::string& bytes) override;
  std::string keptCell(const std::string& name) override;
  bool has(const std::string& written) override;

  /// Leaves the folder with its index, and nothing else of the run.
  void finish(TileSet& set);

 private:
  [[nodiscard]] std::string pathOf(const std::string& file) const;

  std::string folder_;
  RunContext& context_;
  std::vector<std::string> written_;
  std::vector<TileEntry> entries_;
  bool goesOn_ = false, leavesUnfinished_ = false;
};

/// True when a run that did not end left the folder.
[[nodiscard]] bool hasUnfinished(const std::string& folder);

/// Returns whether the folder has only files of a run that was killed in its first moments.
[[nodiscard]] bool hasLeftoversOnly(const std::string& folder);

/// Removes what a run that did not end left in its folder. No other process may be at work there.
void removeUnfinished(const std::string& folder);

}  // namespace footfall::detail
