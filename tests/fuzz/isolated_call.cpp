// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/isolated_call.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <exception>
#include <system_error>

namespace footfall::fuzz {
namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void failSystem(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

/// Runs in the child.
[[noreturn]] void answer(const std::function<std::string()>& call, int pipe, bool quiet) {
  if (quiet) {
    const int nothing = ::open("/dev/null", O_WRONLY);
    if (nothing >= 0) ::dup2(nothing, STDERR_FILENO);
  }
  std::string text;
  try {
    text = call();
  } catch (const std::exception& error) {
    text = std::string("it threw: ") + error.what();
  }
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t count = ::write(pipe, text.data() + sent, text.size() - sent);
    if (count <= 0) ::_exit(3);
    sent += static_cast<std::size_t>(count);
  }
  ::_exit(0);  // no destructors: the parent still has the same objects
}

/// Everything until the pipe's other end closes; false when that takes too long.
bool readAll(int pipe, std::string& text, Clock::time_point end) {
  for (std::array<char, 4096> buffer{};;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    pollfd poll{pipe, POLLIN, 0};
    const int ready = left > 0 ? ::poll(&poll, 1, static_cast<int>(left)) : 0;
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return false;
    const ssize_t count = ::read(pipe, buffer.data(), buffer.size());
    if (count <= 0) return true;
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace

std::string callIsolated(const std::function<std::string()>& call, std::chrono::seconds limit, bool quiet) {
  std::array<int, 2> pipe{};
  if (::pipe(pipe.data()) != 0) failSystem("pipe");
  const pid_t child = ::fork();
  if (child < 0) failSystem("fork");
  if (child == 0) {
    ::close(pipe[0]);
    answer(call, pipe[1], quiet);
  }
  ::close(pipe[1]);
  std::string text;
  const bool inTime = readAll(pipe[0], text, Clock::now() + limit);
  ::close(pipe[0]);
  if (!inTime) ::kill(child, SIGKILL);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (!inTime) return "it takes longer than " + std::to_string(limit.count()) + " s";
  if (WIFSIGNALED(status)) return "it was ended by signal " + std::to_string(WTERMSIG(status));
  if (WEXITSTATUS(status) != 0) return "it ended with exit code " + std::to_string(WEXITSTATUS(status));
  return text;
}

}  // namespace footfall::fuzz
