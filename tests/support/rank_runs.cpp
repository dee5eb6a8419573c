// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/rank_runs.hpp"

#include <deque>
#include <mutex>
#include <optional>
#include <thread>

#include "core/pipeline/runner.hpp"
#include "footfall/errors.hpp"

namespace footfall::test {
using namespace detail;
namespace {

struct Mail {
  std::mutex mutex;
  std::vector<std::deque<Transport::Message>> boxes;
};

class MailTransport : public Transport {
 public:
  MailTransport(Mail& mail, int rank) : mail_(mail), rank_(rank) {}
  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int size() const override { return static_cast<int>(mail_.boxes.size()); }
  void send(int to, std::string bytes) override {
    const std::lock_guard lock(mail_.mutex);
    mail_.boxes[static_cast<std::size_t>(to)].push_back({rank_, std::move(bytes)});
  }
  std::optional<Message> receive() override {
    const std::lock_guard lock(mail_.mutex);
    auto& box = mail_.boxes[static_cast<std::size_t>(rank_)];
    if (box.empty()) return std::nullopt;
    Message message = std::move(box.front());
    box.pop_front();
    return message;
  }
  bool isIdle() override { return true; }

 private:
  Mail& mail_;
  int rank_;
};

}  // namespace

RankOutcome runOnRanks(const std::shared_ptr<const Environment>& environment, const Pipeline& pipeline,
                       const RankOptions& options) {
  const auto count = static_cast<std::size_t>(options.ranks);
  Mail mail;
  mail.boxes.resize(count);
  RankOutcome outcome;
  std::vector<char> hasResult(count, 0), isCutOff(count, 0);
  std::mutex mutex;
  const auto runRank = [&](int rank) {
    MailTransport transport(mail, rank);
    RunContext context([&](const RunEvent& event) {
      if (event.kind == RunEvent::Kind::CellFinished) options.cellDone(rank);
    });
    std::optional<RankExchange> exchange;
    try {
      RankExchange::Options own;
      own.threads = options.threads;
      own.patienceMs = options.patienceMs(rank);
      own.workFolder = options.workFolder;
      own.leavesShares = options.leavesShares;
      own.note = [&](const Text& note) {
        const std::lock_guard lock(mutex);
        outcome.notes.push_back(note);
      };
      own.stop = [&context] { context.cancel(); };
      exchange.emplace(transport, std::move(own));
      const auto ownEnvironment = options.environmentOf ? options.environmentOf(rank) : environment;
      const Pipeline ownPipeline = options.pipelineOf ? options.pipelineOf(rank) : pipeline;
      RunResult result = runTogether(ownEnvironment, ownPipeline, context, *exchange, options.threads);
      hasResult[static_cast<std::size_t>(rank)] = result.mesh ? 1 : 0;
      std::vector<RankStatistics> ranks = exchange->collect(context);
      exchange->end(context);
      if (rank == 0) {
        outcome.result = std::move(result);
        outcome.ranks = std::move(ranks);
      }
    } catch (const std::exception& error) {
      if (exchange) exchange->fail(error.what());
      if (rank == 0) outcome.error = error.what();
    }
    options.ended(rank);
    isCutOff[static_cast<std::size_t>(rank)] = exchange && exchange->isCutOff() ? 1 : 0;
  };
  std::vector<std::thread> threads;
  for (int rank = 0; rank < options.ranks; ++rank) threads.emplace_back(runRank, rank);
  for (std::thread& thread : threads) thread.join();
  outcome.hasResult.assign(hasResult.begin(), hasResult.end());
  outcome.isCutOff.assign(isCutOff.begin(), isCutOff.end());
  return outcome;
}

std::vector<std::string> runAsGroup(int ranks, const std::function<void(RankGroup&, RunContext&)>& body,
                                    const std::function<void(int rank, const RunEvent&)>& event) {
  const auto count = static_cast<std::size_t>(ranks);
  Mail mail;
  mail.boxes.resize(count);
  std::vector<std::string> errors(count);
  const auto runRank = [&](int rank) {
    MailTransport transport(mail, rank);
    RunContext context([&](const RunEvent& told) {
      if (event) event(rank, told);
    });
    RankExchange::Options options;
    options.stop = [&context] { context.cancel(); };
    RankExchange exchange(transport, std::move(options));
    std::string& error = errors[static_cast<std::size_t>(rank)];
    try {
      body(exchange, context);
      exchange.end(context);
    } catch (const Cancelled&) {
      error = exchange.failure().value_or("cancelled");
      exchange.fail(error, RankFailure::Cancelled);
    } catch (const InputError& problem) {
      error = problem.what();
      exchange.fail(error, RankFailure::Input);
    } catch (const std::exception& problem) {
      error = problem.what();
      exchange.fail(error);
    }
  };
  std::vector<std::thread> threads;
  for (int rank = 0; rank < ranks; ++rank) threads.emplace_back(runRank, rank);
  for (std::thread& thread : threads) thread.join();
  return errors;
}

}  // namespace footfall::test
