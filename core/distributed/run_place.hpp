// The places where a run's cells can run: this process, several here, machines of a list, or Slurm.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/poll.hpp"
#include "footfall/text.hpp"

namespace footfall::detail {

/// The largest number of processes, for any kind.
inline constexpr int kMostProcesses = 1024;

struct RunPlace {
  enum class Kind : std::uint8_t {
    ThisProcess,
    Processes,  ///< several on this machine
    Hosts,      ///< machines of a host file, by mpirun
    Slurm       ///< machines of a partition, by sbatch
  };
  Kind kind = Kind::ThisProcess;
  int processes = 2;      ///< number of processes; for Slurm, of machines with a process each
  std::string hostFile;   ///< for Hosts: file with a machine a line, as mpirun takes it
  std::string partition;  ///< Slurm's partition; empty: its usual one
  std::string folder;     ///< Hosts and Slurm: a folder that all machines see under this name
  bool operator==(const RunPlace&) const = default;
};

/// The programs that start processes; a name without a folder is looked for in PATH.
struct RunPrograms {
  std::string footfallMpi = "footfall-mpi", mpirun = "mpirun", sbatch = "sbatch", scancel = "scancel",
              squeue = "squeue";
  /// Time limits of Slurm's commands when a job is cancelled: of each, and of all together.
  double answerMs = 3000, endMs = 10000;
};
/// `folder` is that of the calling program; footfall-mpi is looked for there first. FOOTFALL_MPI and FOOTFALL_MPIRUN in
/// the environment come before both.
RunPrograms findPrograms(const std::string& folder);

/// The reason why runs cannot go to that place, and what to do; empty: no problem is visible from here.
Text problemOf(const RunPlace& place, const RunPrograms& programs);

/// Starts the processes of a job (writeJob()) and waits for them. `threads` of each, 0: all that it may have. Returns
/// what went wrong, by their own words where they have any. `poll` may throw, which ends them; of Slurm, waits for up
/// to `endMs` until its queue does not have the job any more, whose name there is that of the folder.
Text runJob(const std::string& job, const RunPlace& place, const RunPrograms& programs, int threads, Poll poll);

/// The command line of runJob().
std::vector<std::string> commandOf(const std::string& job, const RunPlace& place, const RunPrograms& programs,
                                   int threads);

/// The useful part of the output of failed processes: the line of ours; else the first paragraph of mpirun's message
/// between dashes, or the line right before (of ssh); else the last line.
std::string problemIn(const std::string& output);

}  // namespace footfall::detail
