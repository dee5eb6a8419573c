// Where a run's cells are run: by this process, by several here, on machines of a list, or by Slurm.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/poll.hpp"
#include "footfall/text.hpp"

namespace footfall::detail {

/// What can be asked for, of any kind.
inline constexpr int kMostProcesses = 1024;

struct RunPlace {
  enum class Kind : std::uint8_t {
    ThisProcess,
    Processes,  ///< several on this machine
    Hosts,      ///< of a host file, by mpirun
    Slurm       ///< of a partition, by sbatch
  };
  Kind kind = Kind::ThisProcess;
  int processes = 2;      ///< of Slurm: machines, with a process each
  std::string hostFile;   ///< of Hosts: a machine a line, as mpirun takes it
  std::string partition;  ///< of Slurm; empty: Slurm's usual one
  std::string folder;     ///< of Hosts and Slurm: one that all machines see under this name
  bool operator==(const RunPlace&) const = default;
};

/// The programs that start processes; a name without a folder is looked for in PATH.
struct RunPrograms {
  std::string footfallMpi = "footfall-mpi", mpirun = "mpirun", sbatch = "sbatch", scancel = "scancel",
              squeue = "squeue";
  /// Of Slurm's, when a job is cancelled: how long each of them may take, and all together.
  double answerMs = 3000, endMs = 10000;
};
/// `folder`: that of the program that asks, where footfall-mpi is looked for first. FOOTFALL_MPI and FOOTFALL_MPIRUN in
/// the environment come before both.
RunPrograms findPrograms(const std::string& folder);

/// What keeps runs from that place, and what to do; empty: nothing that can be seen from here.
Text problemOf(const RunPlace& place, const RunPrograms& programs);

/// Starts the processes of a job (writeJob()) and waits for them. `threads` of each, 0: all that it may have. Returns
/// what went wrong, by their own words where they have any. `poll` may throw, which ends them; of Slurm, waits for up
/// to `endMs` until its queue does not have the job any more, whose name there is that of the folder.
Text runJob(const std::string& job, const RunPlace& place, const RunPrograms& programs, int threads, Poll poll);

/// The command line of runJob().
std::vector<std::string> commandOf(const std::string& job, const RunPlace& place, const RunPrograms& programs,
                                   int threads);

/// What is worth telling of what failed processes wrote: the line of ours; else what mpirun says in dashes, its first
/// paragraph, or the line right before (of ssh); else the last line.
std::string problemIn(const std::string& output);

}  // namespace footfall::detail
