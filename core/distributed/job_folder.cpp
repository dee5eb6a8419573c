// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/distributed/job_folder.hpp"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "core/distributed/share_file.hpp"
#include "core/io/export.hpp"
#include "footfall/errors.hpp"
#include "footfall/version.hpp"

namespace footfall::detail {
namespace {

namespace fs = std::filesystem;

// The kind of file takes the place of a share's cell.
constexpr ShareName kJob{{}, 0, 1}, kRanks{{}, 0, 2};

std::string pathOf(const std::string& folder, const char* name) { return (fs::path(folder) / name).string(); }
std::string jobFile(const std::string& folder) { return pathOf(folder, "job"); }
std::string ranksFile(const std::string& folder) { return pathOf(folder, "ranks"); }
std::string begunFile(const std::string& folder) { return pathOf(folder, "begun"); }

bool isThere(const std::string& path) {
  std::error_code error;
  return fs::exists(path, error);
}

std::string_view opened(std::string_view sealed, const ShareName& name) {
  const OpenedShare share = openShare(sealed);
  if (share.name != name) throw BadBytes("is something else");
  return share.bytes;
}

Text unusable(const std::string& path, const BadBytes& error) {
  return Text(FOOTFALL_TEXT("%1 %2; use the same version of Footfall everywhere, and a folder that all processes see"),
              path, std::string(error.what()));
}

Environment readEnvironment(ByteReader& in) {
  Environment environment;
  environment.source = in.text();
  environment.up = static_cast<UpAxis>(in.below(static_cast<int>(UpAxis::NegativeX) + 1));
  environment.metresPerUnit = in.real();
  environment.bothSides = in.below(2) != 0;
  environment.grid.step = in.real();
  environment.vertices.resize(in.count(3 * sizeof(double)));
  for (Vec3& v : environment.vertices) {
    v.x = in.real();
    v.y = in.real();
    v.z = in.real();
  }
  environment.triangles.resize(in.count(3));
  for (Triangle& triangle : environment.triangles)
    for (auto& corner : triangle)
      corner =
          static_cast<std::decay_t<decltype(corner)>>(in.below(static_cast<std::int64_t>(environment.vertices.size())));
  environment.obstacleOnly.resize(in.count(1));
  for (std::uint8_t& flag : environment.obstacleOnly) flag = static_cast<std::uint8_t>(in.below(2));
  return environment;
}

}  // namespace

void writeJob(const std::string& folder, const Environment& environment, const std::string& pipeline) {
  ByteWriter out;
  out.text(FOOTFALL_VERSION);
  out.text(pipeline);
  out.text(environment.source);
  out.number(static_cast<std::uint64_t>(environment.up));
  out.real(environment.metresPerUnit);
  out.number(environment.bothSides ? 1 : 0);
  out.real(environment.grid.step);
  out.number(environment.vertices.size());
  for (const Vec3& v : environment.vertices)
    for (const double coordinate : {v.x, v.y, v.z}) out.real(coordinate);
  out.number(environment.triangles.size());
  for (const Triangle& triangle : environment.triangles)
    for (const auto corner : triangle) out.number(static_cast<std::uint64_t>(corner));
  out.number(environment.obstacleOnly.size());
  for (const std::uint8_t flag : environment.obstacleOnly) out.number(flag != 0 ? 1 : 0);
  writeFileSafely(jobFile(folder), sealShare(kJob, out.bytes));
}

bool hasJob(const std::string& folder) { return isThere(jobFile(folder)); }

Job readJob(const std::string& folder) {
  const std::string path = jobFile(folder);
  try {
    const std::optional<std::string> sealed = contentOf(path);
    if (!sealed) throw BadBytes("is missing");
    ByteReader in(opened(*sealed, kJob));
    if (in.text() != FOOTFALL_VERSION) throw BadBytes("is of another version");
    Job job;
    job.pipeline = in.text();
    job.environment = readEnvironment(in);
    in.expectEnd();
    checkEnvironment(job.environment);
    return job;
  } catch (const BadBytes& error) {
    throw InputError(unusable(path, error));
  }
}

void sayBegun(const std::string& folder) noexcept {
  try {
    std::ofstream(begunFile(folder)).flush();
  } catch (const std::exception&) {
    // Only the message is lost.
  }
}

bool hasBegun(const std::string& folder) { return isThere(begunFile(folder)); }

double systemMs() {
  return std::chrono::duration<double, std::milli>(std::chrono::system_clock::now().time_since_epoch()).count();
}

void writeRanks(const std::string& folder, const std::vector<JobRank>& ranks) {
  ByteWriter out;
  out.number(ranks.size());
  for (const JobRank& rank : ranks) {
    out.number(static_cast<std::uint64_t>(rank.threads));
    out.real(rank.beganMs);
  }
  writeFileSafely(ranksFile(folder), sealShare(kRanks, out.bytes));
}

std::optional<std::vector<JobRank>> readRanks(const std::string& folder) {
  const std::string path = ranksFile(folder);
  try {
    const std::optional<std::string> sealed = contentOf(path);
    if (!sealed) return std::nullopt;
    ByteReader in(opened(*sealed, kRanks));
    std::vector<JobRank> ranks(in.count(9));
    for (JobRank& rank : ranks) {
      rank.threads = in.below(1 << 16);
      rank.beganMs = in.real();
      if (rank.threads < 1 || !std::isfinite(rank.beganMs)) throw BadBytes("has a number that is out of range");
    }
    in.expectEnd();
    if (ranks.empty()) throw BadBytes("has no ranks");
    return ranks;
  } catch (const BadBytes& error) {
    throw InputError(unusable(path, error));
  }
}

}  // namespace footfall::detail
