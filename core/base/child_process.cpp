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

#include "core/base/process_usage.hpp"
#include "footfall/errors.hpp"

extern char** environ;

namespace footfall::detail {
namespace {

constexpr int kPollMs = 20;
constexpr double kKilledMs = 2000;
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

/// What a program writes, as far as it was read.
class Outputs {
 public:
  explicit Outputs(ChildResult& result) : output_(makePipe()), errors_(makePipe()), result_(result) {}

  [[nodiscard]] int outputEnd() const { return output_.to.number(); }
  [[nodiscard]] int errorsEnd() const { return errors_.to.number(); }
  /// The ends that the program has for its own.
  void closeWritten() {
    output_.to.close();
    errors_.to.close();
  }
  [[nodiscard]] bool areOpen() const { return output_.from.number() >= 0 || errors_.from.number() >= 0; }

  /// Waits for more, 20 ms at most.
  void read() {
    std::array<pollfd, 2> waiting = {pollfd{output_.from.number(), POLLIN, 0},
                                     pollfd{errors_.from.number(), POLLIN, 0}};
    if (::poll(waiting.data(), waiting.size(), kPollMs) <= 0) return;
    if (waiting[0].revents != 0) read(output_.from, result_.output);
    if (waiting[1].revents != 0) read(errors_.from, result_.errors);
    if (result_.errors.size() > kMostErrors) result_.errors.resize(kMostErrors);
  }

 private:
  void read(Descriptor& from, std::string& text) {
    const ssize_t count = ::read(from.number(), buffer_.data(), buffer_.size());
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) return;
    if (count <= 0) return from.close();
    text.append(buffer_.data(), static_cast<std::size_t>(count));
  }

  Pipe output_, errors_;
  ChildResult& result_;
  std::vector<char> buffer_ = std::vector<char>(1 << 16);
};

/// A process that does not outlive this, and nor do those that it has started: they are a group.
class Child {
 public:
  Child(Outputs& outputs, ChildEnding ending, double graceMs) : outputs_(outputs), ending_(ending), graceMs_(graceMs) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// The error of starting it, or 0.
  int start(const std::vector<std::string>& arguments) {
    std::vector<char*> pointers;
    for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, outputs_.outputEnd(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, outputs_.errorsEnd(), STDERR_FILENO);
    // Footfall's programs wait for signals themselves; what is blocked here must not be so there.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
    const int error = posix_spawnp(&id_, pointers[0], &actions, &attributes, pointers.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) id_ = -1;
    return error;
  }
  ~Child() {
    if (id_ < 0) return;
    if (ending_ == ChildEnding::Asked) {
      ::kill(-id_, SIGTERM);
      if (isGoneWithin(graceMs_)) return;
    }
    ::kill(-id_, SIGKILL);
    isGoneWithin(kKilledMs);
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
  // What they still write is read: else a full pipe would keep them from ending.
  bool isGoneWithin(double ms) {
    for (const Stopwatch watch; watch.wallMs() < ms;) {
      if (!isReaped_) isReaped_ = ::waitpid(id_, nullptr, WNOHANG) == id_;
      if (isReaped_ && ::kill(-id_, 0) != 0) return true;
      if (outputs_.areOpen())
        outputs_.read();
      else
        ::poll(nullptr, 0, kPollMs);
    }
    return false;
  }

  Outputs& outputs_;
  ChildEnding ending_;
  double graceMs_;
  pid_t id_ = -1;  ///< and that of its group
  bool isReaped_ = false;
};

}  // namespace

ChildResult runChild(const std::vector<std::string>& arguments, Poll poll, ChildEnding ending, double graceMs) {
  ChildResult result;
  Outputs outputs(result);
  Child child(outputs, ending, graceMs);
  if (const int error = child.start(arguments); error != 0) {
    result.status = 127;
    result.errors = std::strerror(error);
    return result;
  }
  outputs.closeWritten();
  while (outputs.areOpen()) {
    poll();
    outputs.read();
  }
  result.status = child.wait(poll);
  return result;
}

}  // namespace footfall::detail
