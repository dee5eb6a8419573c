// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/distributed/folder_exchange.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <system_error>
#include <thread>
#include <utility>

#include "core/partitioning/load_balancing.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

constexpr auto kPause = 5ms;
// The pause between two looks into the folder is a part of the time that the last one took, because of large and of
// remote folders.
constexpr double kLookMs = 5;
constexpr double kMostLookMs = 1000;
constexpr double kPausesOfLook = 10;
constexpr double kLookOfWaiting = 0.01;  // a queue may take hours
constexpr double kRemoveMs = 2000;       // processes that are ending may still write

/// Thrown to end processes whose results have all arrived.
struct AllArrived : std::exception {};

// A network folder may report a file as missing until the folder is listed.
void listFolder(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;) entry.increment(error);
}

void removeAll(const fs::path& folder) {
  std::error_code error;
  for (const Stopwatch watch; fs::remove_all(folder, error) == static_cast<std::uintmax_t>(-1) || error;) {
    if (watch.wallMs() > kRemoveMs) return;  // The remainder takes room and does no harm.
    std::this_thread::sleep_for(kPause);
  }
}

}  // namespace

FolderExchange::FolderExchange(Options options) : options_(std::move(options)) {}

FolderExchange::~FolderExchange() {
  {
    const std::lock_guard lock(mutex_);
    isStopping_ = true;
  }
  if (!worker_.joinable()) return;  // there was no folder to be made
  worker_.join();
  removeAll(options_.folder);
}

void FolderExchange::start() {
  folder_.emplace(options_.folder);
  worker_ = std::thread([this] {
    Text problem;
    try {
      const auto poll = [this] {
        const std::lock_guard lock(mutex_);
        if (isStopping_ && left_ == 0 && phase_.isLast()) throw AllArrived();
        if (isStopping_) throw Cancelled();
      };
      problem = options_.work(options_.folder, poll);
    } catch (const AllArrived&) {
      // This is no failure.
    } catch (const InputError& failed) {
      problem = failed.text();
    } catch (const RunError& failed) {
      problem = failed.text();
    } catch (const std::exception& failed) {
      problem = Text(Pattern{"%1"}, std::string(failed.what()));
    }
    const std::lock_guard lock(mutex_);
    failure_ = std::move(problem);
    endedMs_ = clock_.wallMs();
    changed_.notify_all();
  });
}

void FolderExchange::checkFailed() const {
  if (!failure_.empty()) throw RunError(failure_);
  if (endedMs_ >= 0 && clock_.wallMs() - endedMs_ > options_.patienceMs)
    throw RunError(FOOTFALL_TEXT("the processes ended, and their results are not in %1; name a folder that all of them "
                                 "see"),
                   options_.folder);
}

void FolderExchange::throwFailure() const {
  const std::lock_guard lock(mutex_);
  if (!failure_.empty()) throw RunError(failure_);
}

void FolderExchange::awaitRanks(std::unique_lock<std::mutex>& lock, RunContext& context) {
  std::optional<Stopwatch> written;  // since the job was
  for (double nextMs = 0; ranks_.empty(); changed_.wait_for(lock, kPause)) {
    context.checkCancelled();
    const double begunMs = clock_.wallMs();
    if (begunMs >= nextMs) {
      lock.unlock();
      listFolder(options_.folder);
      std::optional<std::vector<JobRank>> ranks = readRanks(options_.folder);
      if (!written && hasJob(options_.folder)) written.emplace();
      lock.lock();
      if (ranks) {
        ranks_ = std::move(*ranks);
        return;
      }
      nextMs = nextLook(begunMs, written ? written->wallMs() * kLookOfWaiting : 0);
    }
    checkFailed();
    if (options_.startMs > 0 && written && written->wallMs() > options_.startMs && !hasBegun(options_.folder))
      throw RunError(FOOTFALL_TEXT("not all processes have begun within %1 s; run again, or run on this program alone"),
                     static_cast<std::int64_t>(options_.startMs / 1000));
  }
}

double FolderExchange::nextLook(double begunMs, double atLeastMs) const {
  const double nowMs = clock_.wallMs();
  return nowMs + std::clamp(std::max(kPausesOfLook * (nowMs - begunMs), atLeastMs), kLookMs, kMostLookMs);
}

std::vector<char> FolderExchange::begin(const CellPhase& phase, RunContext& context) {
  std::unique_lock lock(mutex_);
  phase_ = phase;
  phase_.check = nullptr;
  beganMs_ = systemMs() - phase.nowMs;
  left_ = phase.costs.size();  // Set before the arrival of all shares can be checked.
  if (!worker_.joinable()) {
    start();
    awaitRanks(lock, context);
    lock.unlock();
    options_.ranksKnown(threadsOfRanks());
    lock.lock();
  }
  rankOf_.assign(phase.costs.size(), 0);
  const LoadBalance balance = assignLongestFirst(phase.costs, ranks_.size());
  for (std::size_t rank = 0; rank < balance.bins.size(); ++rank)
    for (const std::size_t cell : balance.bins[rank]) rankOf_[cell] = static_cast<int>(rank);
  hasCome_.assign(phase.costs.size(), 0);
  seen_.clear();
  nextLookMs_ = 0;
  return std::vector<char>(phase.costs.size(), 0);
}

void FolderExchange::look() {
  const double begunMs = clock_.wallMs();
  if (begunMs < nextLookMs_) return;
  for (const Index cell : folder_->cellsOf(phase_))
    if (hasCome_[static_cast<std::size_t>(cell)] == 0) seen_.insert(cell);
  nextLookMs_ = nextLook(begunMs, 0);
}

std::optional<ArrivedShare> FolderExchange::take() {
  std::unique_lock lock(mutex_);
  if (left_ == 0) return std::nullopt;
  if (seen_.empty()) look();
  if (seen_.empty()) {
    checkFailed();
    return std::nullopt;
  }
  const Index cell = *seen_.begin();
  seen_.erase(seen_.begin());
  hasCome_[static_cast<std::size_t>(cell)] = 1;
  --left_;
  ArrivedShare arrived;
  arrived.cell = cell;
  arrived.hasTimes = true;
  const int rank = rankOf_[static_cast<std::size_t>(cell)];
  arrived.shiftMs = ranks_[static_cast<std::size_t>(rank)].beganMs - beganMs_;
  arrived.firstThread = options_.threads;  // threads of this process come first
  for (int before = 0; before < rank; ++before) arrived.firstThread += ranks_[static_cast<std::size_t>(before)].threads;
  lock.unlock();
  try {
    arrived.bytes = folder_->read({phase_.key, phase_.number, static_cast<std::uint64_t>(cell)});
  } catch (const BadBytes& error) {
    throw RunError(FOOTFALL_TEXT("the share of cell %1 that arrived cannot be used (%2); give all processes the same "
                                 "version of the program"),
                   cell + 1, std::string(error.what()));
  }
  return arrived;
}

int FolderExchange::threads() const {
  int sum = options_.threads;
  for (const int threads : threadsOfRanks()) sum += threads;
  return sum;
}

std::vector<int> FolderExchange::threadsOfRanks() const {
  const std::lock_guard lock(mutex_);
  std::vector<int> threads;
  for (const JobRank& rank : ranks_) threads.push_back(rank.threads);
  return threads;
}

}  // namespace footfall::detail
