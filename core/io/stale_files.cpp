// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/stale_files.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>
#include <set>
#include <sstream>
#include <string_view>
#include <system_error>

namespace footfall::detail {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPrefix = ".footfall-", kSuffix = ".tmp";

template <class Number>
std::string hexOf(Number number) {
  std::array<char, 24> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number, 16).ptr};
}

/// A mark of the machine and its present start, because process numbers mean nothing on another machine. Containers
/// that share the kernel have process namespaces of their own.
std::string hostMark() {
  std::uint64_t mark = 1469598103934665603U;
  const auto add = [&mark](std::string_view text) {
    for (const char c : text) mark = (mark ^ static_cast<unsigned char>(c)) * 1099511628211U;
  };
  std::ifstream boot("/proc/sys/kernel/random/boot_id");
  add(std::string(std::istreambuf_iterator<char>(boot), {}));
  std::error_code error;
  add(fs::read_symlink("/proc/self/ns/pid", error).string());
  std::array<char, 256> name{};
  if (::gethostname(name.data(), name.size() - 1) == 0) add(name.data());
  return hexOf(static_cast<std::uint32_t>(mark ^ (mark >> 32)));
}

const std::string& host() {
  static const std::string kHost = hostMark();
  return kHost;
}

/// The start time of a process, in ticks since the machine's start; empty where there is no such process.
std::string startOf(long process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  const std::string text(std::istreambuf_iterator<char>(file), {});
  const std::size_t name = text.rfind(')');  // the name before it may contain anything
  if (name == std::string::npos) return {};
  constexpr int kFieldsBehind = 20;
  std::istringstream fields(text.substr(name + 1));
  std::string field;
  for (int i = 0; i < kFieldsBehind; ++i) fields >> field;
  return fields ? field : std::string();
}

/// The name contains "HOST-PROCESS-START-NUMBER".
bool isStale(std::string_view name) {
  if (!name.starts_with(kPrefix) || !name.ends_with(kSuffix)) return false;
  std::istringstream rest(std::string(name.substr(kPrefix.size(), name.size() - kPrefix.size() - kSuffix.size())));
  std::string machine, process, start, number;
  std::getline(rest, machine, '-');
  std::getline(rest, process, '-');
  std::getline(rest, start, '-');
  std::getline(rest, number);
  long id = 0;
  const auto read = std::from_chars(process.data(), process.data() + process.size(), id);
  const bool isName = read.ec == std::errc() && read.ptr == process.data() + process.size() && id > 0 &&
                      !start.empty() && !number.empty() && number.find('-') == std::string::npos;
  return isName && machine == host() && startOf(id) != start;
}

}  // namespace

std::string temporaryName(unsigned number) {
  const long process = ::getpid();
  const std::string start = startOf(process);
  // Without /proc it cannot be found out which processes have ended.
  const std::string place =
      start.empty() ? std::to_string(process) : host() + '-' + std::to_string(process) + '-' + start;
  return std::string(kPrefix) + place + '-' + std::to_string(number) + std::string(kSuffix);
}

void removeStaleFiles(const std::string& folder) {
  static std::mutex mutex;
  static std::set<std::string> done;
  {
    const std::lock_guard<std::mutex> lock(mutex);
    if (!done.insert(folder).second) return;
  }
  if (startOf(::getpid()).empty()) return;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (!isStale(at->path().filename().string())) continue;
    struct stat status {};
    if (::lstat(at->path().c_str(), &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == ::geteuid())
      ::unlink(at->path().c_str());
  }
}

}  // namespace footfall::detail
