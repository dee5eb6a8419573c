// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

#include "footfall/errors.hpp"

extern char** environ;

namespace footfall::detail {
namespace {

constexpr int kPollMs = 20;
constexpr int kGraceMs = 5000;
constexpr std::size_t kMostErrors = 64 * 1024;

class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { close(); }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_ = -1;
};

struct Pipe {
  Descriptor from, to;
};

Pipe makePipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw RunError(Text(FOOTFALL_TEXT("no other program can be started (%1)"), std::strerror(errno)));
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

/// A process that does not outlive this.
class Child {
 public:
  explicit Child(ChildEnding ending) : ending_(ending) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// The error of starting it, or 0.
  int start(const std::vector<std::string>& arguments, int output, int errors) {
    std::vector<char*> pointers;
    for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
    // Footfall's programs wait for signals themselves; what is blocked here must not be so there.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
    const int error = posix_spawnp(&id_, pointers[0], &actions, &attributes, pointers.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) id_ = -1;
    return error;
  }
  ~Child() {
    if (id_ < 0) return;
    if (ending_ == ChildEnding::Asked) {
      ::kill(id_, SIGTERM);
      for (int waited = 0; waited < kGraceMs; waited += kPollMs) {
        if (::waitpid(id_, nullptr, WNOHANG) == id_) return;
        ::poll(nullptr, 0, kPollMs);
      }
    }
    ::kill(id_, SIGKILL);
    while (::waitpid(id_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  /// Waits for its end; it may go on long after it has closed its output.
  int wait(const Poll& poll) {
    int status = 0;
    for (pid_t ended = 0; ended != id_;) {
      ended = ::waitpid(id_, &status, WNOHANG);
      if (ended < 0 && errno != EINTR) break;
      if (ended == id_) continue;
      poll();
      ::poll(nullptr, 0, kPollMs);
    }
    id_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  ChildEnding ending_;
  pid_t id_ = -1;
};

}  // namespace

ChildResult runChild(const std::vector<std::string>& arguments, Poll poll, ChildEnding ending) {
  Pipe output = makePipe(), errors = makePipe();
  ChildResult result;
  Child child(ending);
  if (const int error = child.start(arguments, output.to.number(), errors.to.number()); error != 0) {
    result.status = 127;
    result.errors = std::strerror(error);
    return result;
  }
  output.to.close();
  errors.to.close();
  std::vector<char> buffer(1 << 16);
  std::array<pollfd, 2> waiting = {pollfd{output.from.number(), POLLIN, 0}, pollfd{errors.from.number(), POLLIN, 0}};
  while (waiting[0].fd >= 0 || waiting[1].fd >= 0) {
    poll();
    if (::poll(waiting.data(), waiting.size(), kPollMs) <= 0) continue;
    for (pollfd& one : waiting) {
      if (one.fd < 0 || one.revents == 0) continue;
      const ssize_t count = ::read(one.fd, buffer.data(), buffer.size());
      if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
      if (count <= 0) {
        one.fd = -1;
        continue;
      }
      std::string& text = one.fd == output.from.number() ? result.output : result.errors;
      text.append(buffer.data(), static_cast<std::size_t>(count));
      if (result.errors.size() > kMostErrors) result.errors.resize(kMostErrors);
    }
  }
  result.status = child.wait(poll);
  return result;
}

}  // namespace footfall::detail
