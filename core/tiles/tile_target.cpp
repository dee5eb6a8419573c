// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/tile_target.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <system_error>
#include <thread>

#include "core/base/process_usage.hpp"
#include "core/io/export.hpp"
#include "core/tiles/tile_folder.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {

namespace fs = std::filesystem;

FolderLock::FolderLock(const fs::path& folder) : file_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (file_ < 0 || ::flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  ::close(file_);
  throw InputError("--output: another run is using " + folder.string() + "; wait for it, or give a new name");
}

FolderLock::~FolderLock() {
  if (file_ >= 0) ::close(file_);
}

TileTarget::TileTarget(const std::string& path) : path_(path) {
  std::error_code error, ignored;
  isMade_ = fs::create_directory(path_, error);
  if (!isMade_ && !fs::exists(path_, ignored))
    throw RunError(path + ": cannot be made: " + error.message() + "; choose another place");
  if (isMade_ || fs::is_directory(path_, error)) lock_.emplace(path_);
  if (isMade_) return;
  isKept_ = hasUnfinished(path);                                   // the run goes on from there
  if (!isKept_ && hasLeftoversOnly(path)) removeUnfinished(path);  // of a run that was killed as it began
  if (!isKept_ && (!fs::is_directory(path_, error) || !fs::is_empty(path_, error)))
    throw InputError("--output: " + path + " already exists and is not an empty folder; give a new name");
}

TileTarget::~TileTarget() {
  if (isKept_) return;
  removeUnfinished(path_.string());
  std::error_code ignored;
  if (isMade_) fs::remove(path_, ignored);
}

FileOfRun::~FileOfRun() {
  std::error_code ignored;
  fs::remove(path_, ignored);
}

PackingMemory packingWithin(std::uint64_t memory) {
  PackingMemory packing;
  const auto share = [memory](std::uint64_t part) { return static_cast<std::size_t>(memory / part); };
  packing.scratch = std::min(packing.scratch, share(16));
  packing.cachedPages = std::min(packing.cachedPages, std::max<std::size_t>(share(16) / 49152, 3));
  packing.sortedFaces = std::min(packing.sortedFaces, std::max<std::size_t>(share(8) / 104, 500));
  packing.merged = std::min(packing.merged, share(16));
  return packing;
}

TileSlice parseSlice(const std::string& text) {
  TileSlice slice;
  if (text.empty()) return slice;
  const char* const end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, slice.number);
  const bool isDivided = number.ec == std::errc() && number.ptr != end && *number.ptr == '/';
  const auto count = isDivided ? std::from_chars(number.ptr + 1, end, slice.count) : number;
  if (!isDivided || count.ec != std::errc() || count.ptr != end || slice.number < 1 || slice.number > slice.count)
    throw InputError("--slice: \"" + text + "\" is not a slice; give K/N, such as 1/8 for the first of eight");
  return slice;
}

void checkOutside(const std::string& path, const std::string& folder, Pattern problem) {
  if (path.empty()) return;
  std::error_code ignored;
  const fs::path file = fs::weakly_canonical(fs::absolute(path), ignored);
  const fs::path tiles = fs::weakly_canonical(fs::absolute(folder), ignored);
  if (file == tiles || file.parent_path() == tiles) throw InputError(problem, path);
}

void checkShared(const std::string& file, const std::string& folder, RankGroup& ranks, RunContext& context) {
  constexpr double kPatienceMs = 10000;
  if (ranks.isFirst()) writeFileSafely(file, "The ranks look for this file.\n");
  ranks.fromFirst({}, context);
  const Stopwatch watch;
  std::error_code ignored;
  while (!fs::exists(file, ignored)) {
    context.checkCancelled();
    if (watch.wallMs() > kPatienceMs)
      throw RunError("--output: " + folder + " is not the folder that rank 0 made; give one that all machines share");
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  ranks.gather({}, context);
}

}  // namespace footfall::detail
