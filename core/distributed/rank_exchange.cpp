// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/distributed/rank_exchange.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/distributed/job_folder.hpp"
#include "core/partitioning/load_balancing.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

using namespace std::chrono_literals;

// How often the exchange's thread looks for messages: while some are under way, and else.
constexpr auto kBusyPause = 50us;
constexpr auto kIdlePause = 1ms;

Text differs() {
  return Text(
      FOOTFALL_TEXT("this rank works on something else than rank 0: another file of the environment, another "
                    "pipeline or another version of the program; give all ranks the same"));
}

}  // namespace

RankExchange::RankExchange(Transport& transport, Options options)
    : transport_(transport),
      rank_(transport.rank()),
      size_(transport.size()),
      options_(std::move(options)),
      hellos_(static_cast<std::size_t>(size_)),
      done_(static_cast<std::size_t>(size_)) {
  own_.threads = options_.threads;
  own_.startUpMs = options_.startUpMs;
  pump_ = std::thread([this] { pump(); });
  try {
    if (!options_.workFolder.empty())
      folder_.emplace(options_.workFolder,
                      options_.leavesShares ? WorkFolder::Making::Nothing : WorkFolder::Making::Folder);
  } catch (const std::exception& error) {
    fail(error.what());
    throw;
  }
}

RankExchange::~RankExchange() { fail("ended early"); }

// --- The exchange's thread ---

void RankExchange::pump() {
  std::optional<Stopwatch> closing;
  while (true) {
    const Stopwatch watch;
    bool isBusy = false;
    try {
      isBusy = sendOutgoing();
      isBusy = receiveAll() || isBusy;
    } catch (const std::exception& error) {
      failHere(rank_, error.what());
    }
    const bool isIdle = transport_.isIdle();
    std::unique_lock lock(mutex_);
    if (isBusy || !isIdle) own_.communicationMs += watch.wallMs();
    if (isClosing_) {
      if (!closing) closing.emplace();
      if (isIdle && outgoing_.empty() && byes_ + 1 >= static_cast<std::size_t>(size_)) return;
      if (closing->wallMs() > options_.patienceMs) {
        isCutOff_ = true;
        return;
      }
    }
    const Stopwatch pause;
    if (outgoing_.empty()) changed_.wait_for(lock, isIdle ? kIdlePause : kBusyPause);
    if (!isIdle) own_.communicationMs += pause.wallMs();
  }
}

// Whoever works hears of it at once, not only where it waits for other ranks.
void RankExchange::failHere(int rank, const std::string& problem) {
  {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_.emplace(rank, problem);
  }
  options_.stop();
}

void RankExchange::throwFailure() const {
  const std::lock_guard lock(mutex_);
  if (failure_) throw RunError(FOOTFALL_TEXT("rank %1: %2"), failure_->first, failure_->second);
}

std::optional<std::string> RankExchange::failure() const {
  const std::lock_guard lock(mutex_);
  if (!failure_) return std::nullopt;
  return Text(FOOTFALL_TEXT("rank %1: %2"), failure_->first, failure_->second).str();
}

bool RankExchange::sendOutgoing() {
  std::deque<std::pair<int, std::string>> messages;
  {
    const std::lock_guard lock(mutex_);
    messages.swap(outgoing_);
  }
  for (auto& [to, bytes] : messages) transport_.send(to, std::move(bytes));
  return !messages.empty();
}

bool RankExchange::receiveAll() {
  bool any = false;
  while (const std::optional<Transport::Message> message = transport_.receive()) {
    any = true;
    try {
      handle(*message);
    } catch (const BadBytes& error) {
      failHere(message->from, std::string("what it sent ") + error.what());
    }
  }
  if (any) changed_.notify_all();
  return any;
}

void RankExchange::handle(const Transport::Message& message) {
  const auto from = static_cast<std::size_t>(message.from);
  ByteReader in(message.bytes);
  switch (static_cast<Kind>(in.take(1)[0])) {
    case Kind::Hello: {
      const Hello hello{static_cast<int>(in.number()), in.real()};
      const std::lock_guard lock(mutex_);
      hellos_[from] = hello;
      break;
    }
    case Kind::Plan: {
      Plan plan = readPlan(in);
      const std::lock_guard lock(mutex_);
      plans_.push_back(std::move(plan));
      break;
    }
    case Kind::Share: {
      Incoming share{message.from, openShare(in.rest()).name, std::string(in.rest())};
      const std::lock_guard lock(mutex_);
      shares_.push_back(std::move(share));
      break;
    }
    case Kind::Done: {
      RankStatistics done;
      done.threads = static_cast<int>(in.number());
      done.cells = in.number();
      done.bytesSent = in.number();
      for (double* ms : {&done.startUpMs, &done.readingMs, &done.runningMs, &done.waitingMs, &done.communicationMs})
        *ms = in.real();
      const std::lock_guard lock(mutex_);
      done_[from] = done;
      break;
    }
    case Kind::Failed:
      failHere(message.from, std::string(in.rest()));
      break;
    case Kind::End: {
      const std::lock_guard lock(mutex_);
      isEnded_ = true;
      break;
    }
    case Kind::Stop: {
      {
        const std::lock_guard lock(mutex_);
        isStopped_ = true;
      }
      options_.stop();
      break;
    }
    case Kind::Bye: {
      const std::lock_guard lock(mutex_);
      ++byes_;
      break;
    }
    default:
      throw BadBytes("is no message");
  }
}

// --- What other threads call; mutex_ is held where a function has no lock of its own ---

void RankExchange::post(int to, std::string bytes) {
  outgoing_.emplace_back(to, std::move(bytes));
  changed_.notify_all();
}

void RankExchange::postToOthers(const std::string& bytes) {
  for (int rank = 0; rank < size_; ++rank)
    if (rank != rank_) post(rank, bytes);
}

void RankExchange::checkFailed() const {
  if (failure_) throw RunError(FOOTFALL_TEXT("rank %1: %2"), failure_->first, failure_->second);
  if (isStopped_) throw Cancelled();
}

void RankExchange::wait(std::unique_lock<std::mutex>& lock, RunContext& context, const std::function<bool()>& ready) {
  while (!ready()) {
    checkFailed();
    context.checkCancelled();
    changed_.wait_for(lock, 2 * kIdlePause);
  }
  checkFailed();
}

void RankExchange::greet(const CellPhase& phase) {
  const Hello hello{own_.threads, systemMs() - phase.nowMs};
  if (rank_ == 0) {
    hellos_[0] = hello;
    return;
  }
  ByteWriter out;
  out.bytes.push_back(static_cast<char>(Kind::Hello));
  out.number(static_cast<std::uint64_t>(hello.threads));
  out.real(hello.beganMs);
  post(0, std::move(out.bytes));
}

void RankExchange::sendPlan(const Plan& plan) {
  ByteWriter out;
  out.bytes.push_back(static_cast<char>(Kind::Plan));
  out.number(plan.phase);
  out.number(plan.phases);
  for (const std::uint64_t word : plan.key) out.fixed(word);
  out.number(plan.ranks.size());
  for (const Hello& rank : plan.ranks) {
    out.number(static_cast<std::uint64_t>(rank.threads));
    out.real(rank.beganMs);
  }
  out.number(plan.stored.size());
  for (const Index cell : plan.stored) out.number(static_cast<std::uint64_t>(cell));
  postToOthers(out.bytes);
}

RankExchange::Plan RankExchange::readPlan(ByteReader& in) {
  Plan plan;
  plan.phase = in.number();
  plan.phases = in.number();
  for (std::uint64_t& word : plan.key) word = in.fixed();
  plan.ranks.resize(in.count(9));
  for (Hello& rank : plan.ranks) {
    rank.threads = static_cast<int>(in.number());
    rank.beganMs = in.real();
  }
  plan.stored.resize(in.count(1));
  for (Index& cell : plan.stored) cell = in.below(std::int64_t{1} << 31);
  return plan;
}

// Rank 0 says which cells are there already; all ranks find the same from that.
RankExchange::Plan RankExchange::makePlan(std::unique_lock<std::mutex>& lock, const CellPhase& phase,
                                          RunContext& context) {
  wait(lock, context, [this] {
    return std::any_of(done_.begin(), done_.end(), [](const auto& done) { return done.has_value(); }) ||
           std::all_of(hellos_.begin(), hellos_.end(), [](const auto& hello) { return hello.has_value(); });
  });
  for (int rank = 1; rank < size_; ++rank)
    if (done_[static_cast<std::size_t>(rank)]) throwDiffers(rank);
  hasPlanned_ = true;
  Plan plan{phase.number, phase.count, phase.key, {}, {}};
  for (const auto& hello : hellos_) plan.ranks.push_back(*hello);
  std::vector<WorkFolder::Stored> stored;
  if (folder_) {
    std::vector<Text> notes;
    lock.unlock();
    stored = folder_->load(phase, notes);
    for (const Text& note : notes) options_.note(note);
    lock.lock();
  }
  for (const WorkFolder::Stored& share : stored) plan.stored.push_back(share.cell);
  sendPlan(plan);
  if (options_.leavesShares && phase.number == 0) sayRanks(plan);
  for (WorkFolder::Stored& share : stored) {
    if (!phase.isLast()) postToOthers(static_cast<char>(Kind::Share) + share.sealed);
    shares_.push_back({-1, {phase.key, phase.number, static_cast<std::uint64_t>(share.cell)}, std::move(share.sealed)});
  }
  return plan;
}

void RankExchange::sayRanks(const Plan& plan) const {
  std::vector<JobRank> ranks;
  for (const Hello& rank : plan.ranks) ranks.push_back({rank.threads, rank.beganMs});
  writeRanks(options_.workFolder, ranks);
}

RankExchange::Plan RankExchange::awaitPlan(std::unique_lock<std::mutex>& lock, const CellPhase& phase,
                                           RunContext& context) {
  wait(lock, context, [this] { return !plans_.empty(); });
  Plan plan = std::move(plans_.front());
  plans_.pop_front();
  // A rank with more passes than rank 0 would wait for shares that nobody sends.
  if (plan.phase != phase.number || plan.phases != phase.count || plan.key != phase.key) throw RunError(differs());
  return plan;
}

void RankExchange::throwDiffers(int rank) const { throw RunError(FOOTFALL_TEXT("rank %1: %2"), rank, differs().str()); }

std::vector<char> RankExchange::schedule(const Plan& plan) const {
  std::vector<char> isStored(phase_.costs.size(), 0);
  for (const Index cell : plan.stored) {
    if (static_cast<std::size_t>(cell) >= isStored.size()) throw RunError(Pattern{"the plan names no cell"});
    isStored[static_cast<std::size_t>(cell)] = 1;
  }
  std::vector<std::size_t> cells;
  std::vector<double> costs;
  for (std::size_t cell = 0; cell < isStored.size(); ++cell) {
    if (isStored[cell] != 0) continue;
    cells.push_back(cell);
    costs.push_back(phase_.costs[cell]);
  }
  std::vector<char> mine(isStored.size(), 0);
  const LoadBalance balance = assignLongestFirst(costs, static_cast<std::size_t>(size_));
  for (const std::size_t i : balance.bins[static_cast<std::size_t>(rank_)]) mine[cells[i]] = 1;
  return mine;
}

std::vector<char> RankExchange::begin(const CellPhase& phase, RunContext& context) {
  std::unique_lock lock(mutex_);
  const double before = clock_.wallMs();
  phase_ = phase;
  phase_.check = nullptr;  // which is for this call
  keys_.push_back(phase.key);
  if (ranks_.empty()) greet(phase);
  const Plan plan = rank_ == 0 ? makePlan(lock, phase, context) : awaitPlan(lock, phase, context);
  ranks_ = plan.ranks;
  std::vector<char> mine = schedule(plan);
  const auto own = static_cast<std::size_t>(std::count(mine.begin(), mine.end(), 1));
  own_.cells += own;
  cellsExpected_ = merges() ? mine.size() - own : 0;
  phaseMs_ = clock_.wallMs();
  finishedMs_ = 0;
  own_.waitingMs += phaseMs_ - before;
  return mine;
}

bool RankExchange::wantsOwn() const { return folder_ || rank_ != 0 || (size_ > 1 && !phase_.isLast()); }

void RankExchange::give(Index cell, std::string bytes) {
  const ShareName name{phase_.key, phase_.number, static_cast<std::uint64_t>(cell)};
  const std::string sealed = sealShare(name, bytes);
  if (folder_) {
    try {
      folder_->store(name, sealed);
    } catch (const RunError& error) {
      if (options_.leavesShares) throw;  // nobody else has it
      std::unique_lock lock(mutex_);
      const bool isFirst = !std::exchange(folderFails_, true);
      lock.unlock();
      if (isFirst)
        options_.note(Text(FOOTFALL_TEXT("%1. The run goes on; if it is killed, this part is lost"), error.text()));
    }
  }
  const std::lock_guard lock(mutex_);
  const std::string message = static_cast<char>(Kind::Share) + sealed;
  const std::size_t before = outgoing_.size();
  if (!phase_.isLast())
    postToOthers(message);
  else if (rank_ != 0 && !options_.leavesShares)
    post(0, message);
  own_.bytesSent += (outgoing_.size() - before) * message.size();
}

std::optional<ArrivedShare> RankExchange::take() {
  std::unique_lock lock(mutex_);
  checkFailed();
  const auto found = std::find_if(shares_.begin(), shares_.end(),
                                  [this](const Incoming& share) { return share.name.phase == phase_.number; });
  if (found == shares_.end()) return std::nullopt;
  Incoming share = std::move(*found);
  shares_.erase(found);
  if (share.name.key != phase_.key || share.name.cell >= phase_.costs.size())
    throw RunError(FOOTFALL_TEXT("rank %1: %2"), share.from, Text(Pattern{"its share is of something else"}));
  if (cellsExpected_ > 0 && --cellsExpected_ == 0 && finishedMs_ > 0) own_.waitingMs += clock_.wallMs() - finishedMs_;
  ArrivedShare arrived;
  arrived.cell = static_cast<Index>(share.name.cell);
  if (share.from >= 0) {
    const auto from = static_cast<std::size_t>(share.from);
    arrived.hasTimes = true;
    arrived.shiftMs = ranks_[from].beganMs - ranks_[static_cast<std::size_t>(rank_)].beganMs;
    for (std::size_t rank = 0; rank < from; ++rank) arrived.firstThread += ranks_[rank].threads;
  }
  lock.unlock();
  arrived.bytes = std::move(share.sealed);
  arrived.bytes.erase(0, kShareHead);  // which was checked when it came
  return arrived;
}

void RankExchange::ownFinished() {
  const std::lock_guard lock(mutex_);
  finishedMs_ = clock_.wallMs();
  own_.runningMs += finishedMs_ - phaseMs_;
}

int RankExchange::threads() const {
  int sum = 0;
  for (const Hello& rank : ranks_) sum += rank.threads;
  return std::max(sum, options_.threads);
}

std::vector<RankStatistics> RankExchange::collect(RunContext& context) {
  std::unique_lock lock(mutex_);
  if (rank_ != 0) {
    ByteWriter out;
    out.bytes.push_back(static_cast<char>(Kind::Done));
    out.number(static_cast<std::uint64_t>(own_.threads));
    out.number(own_.cells);
    out.number(own_.bytesSent);
    for (const double ms : {own_.startUpMs, own_.readingMs, own_.runningMs, own_.waitingMs, own_.communicationMs})
      out.real(ms);
    post(0, std::move(out.bytes));
    return {own_};
  }
  done_[0] = own_;
  // A rank that has a block where this one has none waits for a plan.
  const auto isAlone = [this](int rank) { return !hasPlanned_ && hellos_[static_cast<std::size_t>(rank)].has_value(); };
  wait(lock, context, [&] {
    for (int rank = 1; rank < size_; ++rank)
      if (isAlone(rank)) throwDiffers(rank);
    return std::all_of(done_.begin(), done_.end(), [](const auto& done) { return done.has_value(); });
  });
  std::vector<RankStatistics> all;
  for (const auto& done : done_) all.push_back(*done);
  return all;
}

void RankExchange::end(RunContext& context) {
  // Before the others are told: they do not wait long for a rank that says nothing.
  if (rank_ == 0 && folder_ && !options_.leavesShares)
    for (const Digest::Value& key : keys_) folder_->remove(key);
  {
    std::unique_lock lock(mutex_);
    if (rank_ == 0) {
      isEnded_ = true;
      postToOthers(std::string(1, static_cast<char>(Kind::End)));
    } else {
      wait(lock, context, [this] { return isEnded_; });
    }
  }
  close();
}

void RankExchange::fail(const std::string& problem) noexcept {
  try {
    const std::lock_guard lock(mutex_);
    if (!isEnded_ && !isClosing_) {
      if (rank_ == 0)
        postToOthers(std::string(1, static_cast<char>(Kind::Stop)));
      else if (!isStopped_)
        post(0, static_cast<char>(Kind::Failed) + problem);
    }
  } catch (const std::exception&) {
    // Without memory for a message the others hear of it when this rank says nothing more.
  }
  close();
}

void RankExchange::close() noexcept {
  try {
    const std::lock_guard lock(mutex_);
    if (!std::exchange(isClosing_, true)) postToOthers(std::string(1, static_cast<char>(Kind::Bye)));
  } catch (const std::exception&) {
    // As above.
  }
  if (pump_.joinable()) pump_.join();
}

bool RankExchange::wasStopped() const {
  const std::lock_guard lock(mutex_);
  return isStopped_;
}

bool RankExchange::isCutOff() const {
  const std::lock_guard lock(mutex_);
  return isCutOff_;
}

}  // namespace footfall::detail
