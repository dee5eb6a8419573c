// A job for processes that run the cells of another one's run: environment, pipeline, and who they are.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "footfall/environment.hpp"

namespace footfall::detail {

struct Job {
  Environment environment;
  std::string pipeline;  ///< formatPipeline()
};

/// Writes the environment as it is, with all that was edited: what filters see of it, to the last bit. Throws RunError.
void writeJob(const std::string& folder, const Environment& environment, const std::string& pipeline);
bool hasJob(const std::string& folder);
/// Throws InputError where there is no job, or one of another version of the program.
Job readJob(const std::string& folder);

/// One process of those that run a job.
struct JobRank {
  int threads = 1;
  double beganMs = 0;  ///< start of its run: systemMs()
};

/// All processes of the job have been started, whatever they have to read now. Leaves folders that are not there alone,
/// and never throws: it is for those who wait.
void sayBegun(const std::string& folder) noexcept;
bool hasBegun(const std::string& folder);

/// The system's clock.
double systemMs();

/// Says who runs the job, in the order of their ranks. Throws RunError.
void writeRanks(const std::string& folder, const std::vector<JobRank>& ranks);
/// Empty while the ranks are not written. Throws InputError where another version of the program wrote them, or where
/// they are damaged.
std::optional<std::vector<JobRank>> readRanks(const std::string& folder);

}  // namespace footfall::detail
