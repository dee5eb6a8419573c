// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/isolated.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <new>
#include <sstream>
#include <stdexcept>

namespace footfall::bench {
namespace {

using Clock = std::chrono::steady_clock;

std::uint64_t kilobytesOf(const std::string& field) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind(field, 0) == 0) return std::stoull(line.substr(field.size()));
  }
  throw std::runtime_error("/proc/self/status has no " + field);
}

void limitMemory(std::uint64_t beyondNow) {
  if (beyondNow == 0) return;
  const rlim_t bytes = kilobytesOf("VmSize:") * 1024 + beyondNow;
  const rlimit limit{bytes, bytes};
  setrlimit(RLIMIT_AS, &limit);
}

void writeAll(int descriptor, const std::string& text) {
  std::size_t written = 0;
  while (written < text.size()) {
    const ssize_t count = ::write(descriptor, text.data() + written, text.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return;  // the reader will find that something is missing
    written += static_cast<std::size_t>(count);
  }
}

struct Ended {
  std::string output;
  std::string problem;  // empty: it ended by itself with exit code 0
  std::uint64_t peakBytes = 0;
};

// Forks; `inChild` gets the descriptor to write to and must not return.
Ended runChild(const std::function<void(int)>& inChild, const Limits& limits) {
  std::fflush(nullptr);  // the child must not write once more what is still in our buffers
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error(std::string("pipe: ") + std::strerror(errno));
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error(std::string("fork: ") + std::strerror(errno));
  if (child == 0) {
    ::close(ends[0]);
    inChild(ends[1]);
    ::_exit(127);
  }
  ::close(ends[1]);
  Ended ended;
  const auto deadline = Clock::now() + limits.time;
  bool late = false;
  for (char buffer[1 << 16];;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) {
      late = true;
      ::kill(child, SIGKILL);
      break;
    }
    pollfd waiting{ends[0], POLLIN, 0};
    if (::poll(&waiting, 1, static_cast<int>(left)) <= 0) continue;
    const ssize_t count = ::read(ends[0], buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    ended.output.append(buffer, static_cast<std::size_t>(count));
  }
  ::close(ends[0]);
  int status = 0;
  rusage usage{};
  while (::wait4(child, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  ended.peakBytes = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  if (late) {
    ended.problem = "takes more than " + std::to_string(limits.time.count()) + " s";
  } else if (WIFSIGNALED(status)) {
    ended.problem = std::string("ended by a signal: ") + ::strsignal(WTERMSIG(status));
  } else if (WEXITSTATUS(status) != 0) {
    ended.problem = "exit code " + std::to_string(WEXITSTATUS(status));
  }
  return ended;
}

void addFailures(const Json& value, const std::string& place, std::vector<std::string>& failures) {
  if (!value.is_structured()) return;
  if (value.is_object() && value.contains("fails"))
    failures.push_back(place + ": " + (value["fails"].is_string() ? value["fails"].get<std::string>() : value.dump()));
  for (const auto& [key, inner] : value.items()) {
    if (key == "recast") continue;
    std::string name = key;
    for (const char* field : {"name", "series"})
      if (inner.is_object() && inner.contains(field) && inner[field].is_string()) name = inner[field];
    addFailures(inner, place.empty() ? name : place + ", " + name, failures);
  }
}

}  // namespace

std::vector<std::string> failuresIn(const Json& results) {
  std::vector<std::string> failures;
  addFailures(results, "", failures);
  return failures;
}

int reportFailures(const std::string& program, const Json& results) {
  const std::vector<std::string> failures = failuresIn(results);
  for (const std::string& failure : failures)
    std::fprintf(stderr, "%s: not measured: %s\n", program.c_str(), failure.c_str());
  return failures.empty() ? 0 : 1;
}

Json runIsolated(const std::function<Json()>& work, const Limits& limits) {
  const Ended ended = runChild(
      [&](int output) {
        Json result;
        try {
          limitMemory(limits.memoryBytes);
          result = work();
        } catch (const std::bad_alloc&) {
          result = {{"fails", "memory ran out"}};
        } catch (const std::exception& error) {
          result = {{"fails", error.what()}};
        }
        writeAll(output, result.dump(-1, ' ', false, Json::error_handler_t::replace));
        ::_exit(0);  // Skips the destructors and buffers of the copied process.
      },
      limits);
  if (!ended.problem.empty()) return {{"fails", ended.problem}};
  return Json::parse(ended.output);
}

Json runProgram(const std::vector<std::string>& command, const Limits& limits) {
  std::vector<char*> arguments;
  for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  const Ended ended = runChild(
      [&](int output) {
        ::dup2(output, STDOUT_FILENO);
        ::execvp(arguments[0], arguments.data());
      },
      limits);
  if (!ended.problem.empty()) return {{"fails", command[0] + ": " + ended.problem}};
  return {{"output", ended.output}, {"peak_bytes", ended.peakBytes}};
}

ResidentMemory residentMemory() { return {kilobytesOf("VmRSS:") * 1024, kilobytesOf("VmHWM:") * 1024}; }

}  // namespace footfall::bench
