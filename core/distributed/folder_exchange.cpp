// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/distributed/folder_exchange.hpp"

#include <chrono>
#include <filesystem>
#include <system_error>
#include <utility>

#include "core/partitioning/load_balancing.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

constexpr auto kPause = 5ms;
constexpr double kLookMs = 5;  // between two looks into the folder

double systemMs() {
  return std::chrono::duration<double, std::milli>(std::chrono::system_clock::now().time_since_epoch()).count();
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
  std::error_code ignored;
  fs::remove_all(options_.folder, ignored);
}

void FolderExchange::start() {
  std::error_code error;
  fs::create_directories(options_.folder, error);
  if (error)
    throw RunError(FOOTFALL_TEXT("%1: this folder for shares cannot be made (%2); name a folder that can be written"),
                   options_.folder, error.message());
  folder_.emplace(options_.folder);
  worker_ = std::thread([this] {
    Text problem;
    try {
      const auto poll = [this] {
        const std::lock_guard lock(mutex_);
        if (isStopping_) throw Cancelled();
      };
      problem = options_.work(options_.folder, poll);
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
  while (ranks_.empty()) {
    context.checkCancelled();
    lock.unlock();
    std::optional<std::vector<JobRank>> ranks;
    try {
      ranks = readRanks(options_.folder);
    } catch (const BadBytes& error) {
      throw RunError(FOOTFALL_TEXT("%1 %2"), options_.folder, std::string(error.what()));
    }
    lock.lock();
    if (ranks) {
      ranks_ = std::move(*ranks);
      return;
    }
    checkFailed();
    changed_.wait_for(lock, kPause);
  }
}

std::vector<char> FolderExchange::begin(const CellPhase& phase, RunContext& context) {
  std::unique_lock lock(mutex_);
  phase_ = phase;
  phase_.check = nullptr;
  beganMs_ = systemMs() - phase.nowMs;
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
  left_ = phase.costs.size();
  lookedMs_ = -1;
  return std::vector<char>(phase.costs.size(), 0);
}

void FolderExchange::look() {
  if (lookedMs_ >= 0 && clock_.wallMs() - lookedMs_ < kLookMs) return;
  lookedMs_ = clock_.wallMs();
  for (const Index cell : folder_->cellsOf(phase_))
    if (hasCome_[static_cast<std::size_t>(cell)] == 0) seen_.insert(cell);
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
