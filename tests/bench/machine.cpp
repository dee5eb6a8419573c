// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/machine.hpp"

#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>

namespace footfall::bench {
namespace {

Json processorName() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(std::min(line.find(": ") + 2, line.size()));
  return {};
}

Json memoryBytes() {
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGE_SIZE);
  return pages > 0 && size > 0 ? Json(static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(size)) : Json();
}

Json systemName() {
  utsname name{};
  if (uname(&name) != 0) return {};
  return std::string(name.sysname) + ' ' + name.release + ", " + name.machine;
}

Json loadOfLastMinute() {
  double load = 0;
  return getloadavg(&load, 1) == 1 ? Json(load) : Json();
}

}  // namespace

int processorCount() { return static_cast<int>(std::max(1U, std::thread::hardware_concurrency())); }

Json describeMachine() {
  return {{"processor", processorName()},
          {"processors", processorCount()},
          {"memory_bytes", memoryBytes()},
          {"system", systemName()},
          {"load", loadOfLastMinute()}};
}

}  // namespace footfall::bench
