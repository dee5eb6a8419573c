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

// The pauses between two looks for messages: while some are under way, and otherwise.
constexpr auto kBusyPause = 50us;
constexpr auto kIdlePause = 1ms;

}  // namespace

RankExchange::RankExchange(Transport& transport, Options options)
    : transport_(transport),
      rank_(transport.rank()),
      size_(transport.size()),
      options_(std::move(options)),
      hellos_(static_cast<std::size_t>(size_)),
      done_(static_cast<std::size_t>(size_)),
      group_(rank_, size_, [this](int to, std::string bytes) { post(to, static_cast<char>(Kind::Group) + bytes); }) {
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
      failHere({rank_, error.what()});
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

// Working threads are cancelled at once, not only threads that wait for other ranks.
void RankExchange::failHere(Failure failure) {
  {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::move(failure);
  }
  options_.stop();
}

void RankExchange::throwAs(const Failure& failure) {
  if (failure.kind == RankFailure::Cancelled) throw Cancelled();
  constexpr Pattern kProblem = FOOTFALL_TEXT("rank %1: %2");
  if (failure.kind == RankFailure::Input) throw InputError(kProblem, failure.rank, failure.problem);
  throw RunError(kProblem, failure.rank, failure.problem);
}

void RankExchange::throwFailure() const {
  const std::lock_guard lock(mutex_);
  if (failure_) throwAs(*failure_);
}

std::optional<std::string> RankExchange::failure() const {
  const std::lock_guard lock(mutex_);
  if (!failure_) return std::nullopt;
  return Text(FOOTFALL_TEXT("rank %1: %2"), failure_->rank, failure_->problem).str();
}

bool RankExchange::failedByInput() const {
  const std::lock_guard lock(mutex_);
  return failure_ && failure_->kind == RankFailure::Input;
}

bool RankExchange::hasFailed() const {
  const std::lock_guard lock(mutex_);
  return failure_ && failure_->kind != RankFailure::Cancelled;
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
      failHere({message->from, std::string("what it sent ") + error.what()});
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
      const Hello hello = readRankHello(in);
      const std::lock_guard lock(mutex_);
      hellos_[from] = hello;
      break;
    }
    case Kind::Plan: {
      Plan plan = readRankPlan(in);
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
      const RankStatistics done = readRankStatistics(in);
      const std::lock_guard lock(mutex_);
      done_[from] = done;
      break;
    }
    case Kind::Failed: {
      const auto kind = static_cast<RankFailure>(in.below(3));
      failHere({message.from, std::string(in.rest()), kind});
      break;
    }
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
    case Kind::Group: {
      const std::lock_guard lock(mutex_);
      group_.handle(message.from, in);
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
  if (failure_) throwAs(*failure_);
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
  write(hello, out);
  post(0, std::move(out.bytes));
}

void RankExchange::sendPlan(const Plan& plan) {
  ByteWriter out;
  out.bytes.push_back(static_cast<char>(Kind::Plan));
  write(plan, out);
  postToOthers(out.bytes);
}

// Rank 0 sends the numbers of the cells that it has already; all ranks make the same plan from them.
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
  // A rank with more passes than rank 0 would wait for shares that are never sent.
  if (plan.phase != phase.number || plan.phases != phase.count || plan.key != phase.key)
    throw RunError(differsFromFirst());
  return plan;
}

void RankExchange::throwDiffers(int rank) const {
  throw RunError(FOOTFALL_TEXT("rank %1: %2"), rank, differsFromFirst().str());
}

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
  phase_.check = nullptr;  // Its check belongs to this call.
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
      if (options_.leavesShares) throw;  // no other rank has it
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
  arrived.bytes.erase(0, kShareHead);  // The head was checked on arrival.
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
    write(own_, out);
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

std::vector<std::string> RankExchange::gather(std::string own, RunContext& context) {
  std::unique_lock lock(mutex_);
  return group_.gather(std::move(own), [&](const auto& ready) { wait(lock, context, ready); });
}

std::string RankExchange::fromFirst(std::string own, RunContext& context) {
  std::unique_lock lock(mutex_);
  return group_.fromFirst(std::move(own), [&](const auto& ready) { wait(lock, context, ready); });
}

void RankExchange::beginTasks(std::size_t count) {
  const std::lock_guard lock(mutex_);
  group_.beginTasks(count);
}

std::optional<std::size_t> RankExchange::nextTask(RunContext& context) {
  std::unique_lock lock(mutex_);
  return group_.nextTask([&](const auto& ready) { wait(lock, context, ready); });
}

void RankExchange::end(RunContext& context) {
  // Removed before the others are notified: they do not wait long for a silent rank.
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

void RankExchange::fail(const std::string& problem, RankFailure kind) noexcept {
  try {
    const std::lock_guard lock(mutex_);
    if (!isEnded_ && !isClosing_) {
      if (rank_ == 0)
        postToOthers(std::string(1, static_cast<char>(Kind::Stop)));
      else if (!isStopped_)
        post(0, std::string{static_cast<char>(Kind::Failed), static_cast<char>(kind)} + problem);
    }
  } catch (const std::exception&) {
    // There is no memory for a message here; the other ranks notice that this rank falls silent.
  }
  close();
}

void RankExchange::close() noexcept {
  try {
    const std::lock_guard lock(mutex_);
    if (!std::exchange(isClosing_, true)) postToOthers(std::string(1, static_cast<char>(Kind::Bye)));
  } catch (const std::exception&) {
    // There is no memory for a message, as above.
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
