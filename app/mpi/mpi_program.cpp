// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mpi/mpi_program.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <nlohmann/json.hpp>

#include "core/base/worker_arena.hpp"
#include "core/distributed/job_folder.hpp"
#include "footfall/errors.hpp"
#include "footfall/filter.hpp"
#include "footfall/pipeline.hpp"

namespace footfall::app {
using namespace detail;
namespace {

using Json = nlohmann::ordered_json;

std::string format(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof(text), pattern, value);
  return text;
}

/// The rank by name of the program that started the process; null if it was started alone.
const char* rankByName() {
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK", "SLURM_PROCID"})
    if (const char* rank = std::getenv(name)) return rank;
  return nullptr;
}

}  // namespace

bool MpiProgram::isFirstByName() {
  const char* rank = rankByName();
  return rank == nullptr || std::strcmp(rank, "0") == 0;
}

MpiProgram::~MpiProgram() {
  exchange_ = nullptr;
  transport_ = nullptr;
}

void MpiProgram::addOptions(CLI::App& command) {
  command
      .add_option("--work", workFolder_,
                  "Keep finished cells in this folder, which all processes must see, until the run succeeds: a run "
                  "that was killed continues from there, with any number of processes")
      ->type_name("FOLDER")
      ->excludes(command.get_option("--memory"));
  command.add_flag("--progress", showsProgress_,
                   "Show a progress bar even if standard error is no terminal, as for processes of mpirun");
}

void MpiProgram::begin(int threads) {
  isBegun_ = true;
  transport_ = std::make_unique<MpiTransport>();
  RankExchange::Options options;
  options.threads = threads > 0 ? threads : machineThreads();
  options.startUpMs = total_.wallMs();
  options.workFolder = workFolder_;
  options.leavesShares = leavesShares_;
  options.note = [this](const Text& note) { tell(note); };
  options.stop = [this] {
    isStopped_ = true;
    const std::lock_guard lock(contextMutex_);
    if (context_ != nullptr) context_->cancel();
  };
  exchange_ = std::make_unique<RankExchange>(*transport_, std::move(options));
}

void MpiProgram::runCells(const std::string& job, int threads) {
  workFolder_ = job;
  leavesShares_ = true;
  begin(threads);
  if (writes()) sayBegun(job);
  CommandSession session(threads, true);
  setContext(&session.context());
  const auto forget = [](MpiProgram* running) { running->setContext(nullptr); };
  const std::unique_ptr<MpiProgram, decltype(forget)> forgotten(this, forget);
  const Stopwatch reading;
  Job given = readJob(job);
  const auto environment = std::make_shared<const Environment>(std::move(given.environment));
  const Pipeline pipeline = parsePipeline(given.pipeline, job);
  exchange_->setReadingMs(reading.wallMs());
  session.run(environment, pipeline, {}, nullptr, exchange_.get());
  exchange_->collect(session.context());
  end();
}

void MpiProgram::setContext(RunContext* context) {
  const std::lock_guard lock(contextMutex_);
  context_ = context;
  if (isStopped_ && context_ != nullptr) context_->cancel();
}

std::optional<std::string> MpiProgram::failure() const { return exchange_ ? exchange_->failure() : std::nullopt; }
bool MpiProgram::failedByInput() const { return exchange_ && exchange_->failedByInput(); }

RunResult MpiProgram::run(CommandSession& session, const std::shared_ptr<const Environment>& environment,
                          const Pipeline& pipeline, const PipelineOptions& options, double loadMs) {
  exchange_->setReadingMs(loadMs);
  if (writes() && transport_->size() > 1 &&
      std::none_of(pipeline.steps.begin(), pipeline.steps.end(),
                   [](const PipelineStep& step) { return step.enabled && step.filter->kind == FilterKind::Strategy; }))
    tell(
        Text(Pattern{"the pipeline has no parallel block, so that one process does everything; put AutoStrategy and "
                     "Collapse around its VerticalClearanceFilter"}));
  RunResult result = session.run(environment, pipeline, options, nullptr, exchange_.get());
  ranks_ = exchange_->collect(session.context());
  mergingMs_ = result.times.merging;
  return result;
}

double MpiProgram::overheadMs() const { return ranks_[0].startUpMs + ranks_[0].waitingMs + mergingMs_; }

std::string MpiProgram::statistics(std::string json) {
  Json all = Json::parse(json);
  Json list = Json::array();
  for (std::size_t i = 0; i < ranks_.size(); ++i) {
    const RankStatistics& rank = ranks_[i];
    list.push_back({{"rank", i},
                    {"threads", rank.threads},
                    {"cells", rank.cells},
                    {"bytes_sent", rank.bytesSent},
                    {"start_up_ms", rank.startUpMs},
                    {"reading_ms", rank.readingMs},
                    {"running_ms", rank.runningMs},
                    {"waiting_ms", rank.waitingMs},
                    {"communication_ms", rank.communicationMs}});
  }
  all["distributed"] = {{"t_distributed_ms", total_.wallMs()},
                        {"t_overhead_ms", overheadMs()},
                        {"merging_ms", mergingMs_},
                        {"ranks", std::move(list)}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

// Threads are numbered rank by rank.
std::string MpiProgram::trace(std::string json) {
  Json all = Json::parse(json);
  for (Json& event : all["traceEvents"]) {
    if (event["name"] != "thread_name" || event["tid"] == 0) continue;
    int thread = event["tid"].get<int>() - 1;
    std::size_t rank = 0;
    while (rank + 1 < ranks_.size() && thread >= ranks_[rank].threads) thread -= ranks_[rank++].threads;
    event["args"]["name"] = "rank " + std::to_string(rank) + ", thread " + std::to_string(thread);
  }
  return all.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string MpiProgram::summary(std::string text) {
  text += "ranks:\n  rank  threads  cells  sent (MB)  start-up  reading  running  waiting  communication (ms)\n";
  for (std::size_t i = 0; i < ranks_.size(); ++i) {
    const RankStatistics& rank = ranks_[i];
    text += format("  %4.0f", static_cast<double>(i)) + format("  %7.0f", rank.threads) +
            format("  %5.0f", static_cast<double>(rank.cells)) +
            format("  %9.2f", static_cast<double>(rank.bytesSent) / 1e6) + format("  %8.1f", rank.startUpMs) +
            format("  %7.1f", rank.readingMs) + format("  %7.1f", rank.runningMs) + format("  %7.1f", rank.waitingMs) +
            format("  %13.1f\n", rank.communicationMs);
  }
  return text + format("  t_distributed %.1f ms", total_.wallMs()) + format(", t_overhead %.1f ms\n", overheadMs());
}

void MpiProgram::end() {
  RunContext none;
  RunContext* context = context_;
  exchange_->end(context != nullptr ? *context : none);
  drop();
}

// The last ones first.
void MpiProgram::drop() {
  while (!dropped_.empty()) dropped_.pop_back();
}

// All ranks find wrong options by themselves. mpirun ends the others as soon as one leaves with an exit code: they
// leave together, after rank 0 has reported the error.
void MpiProgram::meetOthers() {
  if (isBegun_ || rankByName() == nullptr) return;
  workFolder_.clear();
  leavesShares_ = false;
  try {
    begin(1);
  } catch (const std::exception&) {
    // Each for itself, then.
  }
}

bool MpiProgram::fail(const std::string& problem, RankFailure kind) {
  meetOthers();
  if (!exchange_) return transport_ ? writes() : isFirstByName();
  const bool wasStopped = exchange_->wasStopped();
  exchange_->fail(problem, kind);
  drop();
  // Rank 0 reports, unless it is busy and cannot be stopped: then this rank ends all and must say why.
  return (writes() || exchange_->isCutOff()) && !wasStopped;
}

void MpiProgram::leave(int exitCode) {
  if (exchange_ && exchange_->isCutOff()) MpiTransport::abort(exitCode == 0 ? 1 : exitCode);
  exchange_ = nullptr;
  transport_ = nullptr;
}

void MpiProgram::tell(const Text& note) const {
  const std::string line = "footfall-mpi: note: rank " + std::to_string(transport_->rank()) + ": " + note.str() + '\n';
  std::cerr << line;
}

}  // namespace footfall::app
