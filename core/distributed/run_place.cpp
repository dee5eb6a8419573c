// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/distributed/run_place.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string_view>
#include <thread>
#include <utility>

#include "core/base/byte_stream.hpp"
#include "core/base/child_process.hpp"
#include "core/base/process_usage.hpp"
#include "core/distributed/share_file.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kOurs = "footfall-mpi: ";
constexpr std::chrono::milliseconds kEndPause{200};  // pause between two looks into Slurm's queue
constexpr int kNoProgram = 127, kTookTooLong = 124;

bool isProgram(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error) && ::access(path.c_str(), X_OK) == 0;
}

bool canBeFound(const std::string& program) {
  if (program.find('/') != std::string::npos) return isProgram(program);
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (isProgram(fs::path(folder.empty() ? "." : folder) / program)) return true;
  return false;
}

// Quotes a word for a shell.
std::string quoted(const std::string& word) {
  std::string result = "'";
  for (const char c : word) {
    if (c == '\'')
      result += "'\\''";
    else
      result += c;
  }
  return result + '\'';
}

// Slurm's name for the job, by which it is ended.
std::string nameOf(const std::string& job) { return fs::path(job).filename().string(); }

std::string outputOf(const std::string& job) { return (fs::path(job) / "output.txt").string(); }

// srun if Slurm can start MPI's processes itself, else mpirun, which gets the machines from Slurm. Each machine runs
// one process with all its threads.
std::string scriptOf(const std::string& job, const RunPrograms& programs) {
  const std::string cells = quoted(programs.footfallMpi) + " cells " + quoted(job);
  return "threads=${SLURM_CPUS_ON_NODE:-1}\n"
         "if srun --mpi=list 2>&1 | grep -qw pmix; then\n"
         "  exec srun --mpi=pmix --kill-on-bad-exit=1 --cpus-per-task=$threads " +
         cells + " --threads $threads\nelse\n  exec " + quoted(programs.mpirun) + " --bind-to none " + cells +
         " --threads $threads\nfi";
}

using Lines = std::vector<std::string>;

bool isText(const std::string& line) { return line.find_first_not_of("-*= ") != std::string::npos; }

// The lines with which Open MPI begins and ends a message.
bool isDashes(const std::string& line) { return line.size() >= 20 && line.find_first_not_of('-') == std::string::npos; }

// Its lines as one.
std::string paragraphAt(Lines::const_iterator line, Lines::const_iterator end) {
  std::string text;
  for (; line != end && isText(*line); ++line) {
    if (!text.empty()) text += ' ';
    text.append(*line, line->find_first_not_of(' '));
  }
  return text;
}

/// Thrown for a program that takes too long; it is ended.
struct TookTooLong {};

ChildResult runWithin(double ms, const std::vector<std::string>& command) {
  const Stopwatch watch;
  try {
    return runChild(command, [&] {
      if (watch.wallMs() > ms) throw TookTooLong();
    });
  } catch (const TookTooLong&) {
    return {.status = kTookTooLong, .output = {}, .errors = {}};
  } catch (const RunError&) {
    return {.status = kNoProgram, .output = {}, .errors = {}};
  }
}

void cancelJob(const std::string& job, const RunPrograms& programs) {
  runWithin(programs.answerMs, {programs.scancel, "--name", nameOf(job)});
}

// An sbatch that was ended may have submitted the job, which then comes into the queue a little later.
void endJob(const std::string& job, const RunPrograms& programs) {
  for (const Stopwatch watch; watch.wallMs() < programs.endMs;) {
    cancelJob(job, programs);
    std::this_thread::sleep_for(kEndPause);
    const ChildResult queue = runWithin(programs.answerMs, {programs.squeue, "--noheader", "--name", nameOf(job)});
    if (queue.status == kNoProgram) return;
    if (queue.status == 0 && queue.output.find_first_not_of(" \n") == std::string::npos) return;
  }
}

void add(std::vector<std::string>& command, std::initializer_list<std::string> words) {
  command.insert(command.end(), words);
}

}  // namespace

RunPrograms findPrograms(const std::string& folder) {
  RunPrograms programs;
  const fs::path beside = fs::path(folder) / "footfall-mpi";
  if (const char* given = std::getenv("FOOTFALL_MPI"); given != nullptr && *given != '\0')
    programs.footfallMpi = given;
  else if (isProgram(beside))
    programs.footfallMpi = beside.string();
  if (const char* given = std::getenv("FOOTFALL_MPIRUN"); given != nullptr && *given != '\0')
    programs.mpirun = given;
  else if (canBeFound("mpirun.openmpi"))  // used if several MPIs are installed
    programs.mpirun = "mpirun.openmpi";
  return programs;
}

Text problemOf(const RunPlace& place, const RunPrograms& programs) {
  if (place.kind == RunPlace::Kind::ThisProcess) return {};
  if (!canBeFound(programs.footfallMpi))
    return Text(FOOTFALL_TEXT("%1 was not found; install the package footfall-mpi, or run on this program alone"),
                programs.footfallMpi);
  if (place.kind == RunPlace::Kind::Slurm) {
    if (canBeFound(programs.sbatch)) return {};
    return Text(FOOTFALL_TEXT("%1 was not found; Slurm has to be installed on this machine, too"), programs.sbatch);
  }
  if (!canBeFound(programs.mpirun))
    return Text(FOOTFALL_TEXT("%1 was not found; install Open MPI (Debian: openmpi-bin)"), programs.mpirun);
  std::error_code error;
  if (place.kind == RunPlace::Kind::Hosts &&
      (::access(place.hostFile.c_str(), R_OK) != 0 || fs::is_directory(place.hostFile, error)))
    return Text(FOOTFALL_TEXT("%1: this host file cannot be read; name a file with a machine in each line"),
                place.hostFile);
  return {};
}

std::vector<std::string> commandOf(const std::string& job, const RunPlace& place, const RunPrograms& programs,
                                   int threads) {
  const std::string count = std::to_string(place.processes);
  std::vector<std::string> command;
  if (place.kind == RunPlace::Kind::Slurm) {
    command = {programs.sbatch, "--wait",   "--quiet",           "--job-name", nameOf(job),
               "--nodes",       count,      "--ntasks-per-node", "1",          "--exclusive",
               "--no-requeue",  "--output", outputOf(job),       "--chdir",    job};
    if (!place.partition.empty()) add(command, {"--partition", place.partition});
    add(command, {"--wrap", scriptOf(job, programs)});
    return command;
  }
  command = {programs.mpirun, "--bind-to", "none", "-n", count};
  if (::geteuid() == 0) add(command, {"--allow-run-as-root"});
  if (place.kind == RunPlace::Kind::Hosts)
    // Fills one machine after the other, even without slots= in the file. Nobody is there to answer a prompt of ssh.
    add(command, {"--hostfile", place.hostFile, "--map-by", "node", "--mca", "plm_rsh_args", "-o BatchMode=yes"});
  else  // Needed without a network, and where one process may not read another's memory.
    add(command, {"--oversubscribe", "--host", "localhost:" + count, "--mca", "plm", "isolated", "--mca", "btl",
                  "self,vader", "--mca", "btl_vader_single_copy_mechanism", "none", "--mca", "pml", "ob1"});
  add(command, {programs.footfallMpi, "cells", job});
  if (threads > 0) add(command, {"--threads", std::to_string(threads)});
  return command;
}

std::string problemIn(const std::string& output) {
  Lines lines;
  std::istringstream in(output);
  for (std::string line; std::getline(in, line);) {
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
    const bool isOurs = line.find(kOurs) == 0;
    if (isOurs && line.find("note: ") != kOurs.size()) return line.substr(kOurs.size());
    if (!isOurs) lines.push_back(std::move(line));
  }
  const auto dashes = std::find_if(lines.begin(), lines.end(), isDashes);
  if (dashes != lines.end()) {
    if (dashes != lines.begin() && isText(dashes[-1])) return dashes[-1];
    if (std::string told = paragraphAt(dashes + 1, lines.end()); !told.empty()) return told;
  }
  const auto last = std::find_if(lines.rbegin(), lines.rend(), isText);
  return last == lines.rend() ? std::string() : *last;
}

Text runJob(const std::string& job, const RunPlace& place, const RunPrograms& programs, int threads, Poll poll) {
  if (Text problem = problemOf(place, programs); !problem.empty()) return problem;
  const std::vector<std::string> command = commandOf(job, place, programs, threads);
  ChildResult result;
  try {
    result = runChild(command, poll, ChildEnding::Asked);
  } catch (const Cancelled&) {
    if (place.kind == RunPlace::Kind::Slurm) endJob(job, programs);
    throw;
  } catch (...) {
    if (place.kind == RunPlace::Kind::Slurm) cancelJob(job, programs);
    throw;
  }
  if (result.status == 0) return {};
  std::string told = problemIn(result.errors + '\n' + result.output);
  if (place.kind == RunPlace::Kind::Slurm) {
    try {
      if (const auto output = contentOf(outputOf(job)); output && !problemIn(*output).empty())
        told = problemIn(*output);
    } catch (const BadBytes&) {
      // The output of sbatch is the only information.
    }
  }
  if (told.empty()) return Text(FOOTFALL_TEXT("%1 ended with exit code %2"), command[0], result.status);
  return Text(FOOTFALL_TEXT("%1 (exit code %2 of %3)"), told, result.status, command[0]);
}

}  // namespace footfall::detail
