// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <string_view>
#include <utility>

#include "core/base/process_usage.hpp"
#include "footfall/errors.hpp"

extern char** environ;

namespace footfall::detail {
namespace {

constexpr int kPollMs = 20;
constexpr double kWatchMs = 10;  ///< time between two checks of a program's memory
constexpr int kPipeBytes = 1 << 20;
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

[[noreturn]] void failStarting(int error) {
  if (error == EMFILE || error == ENFILE)
    throw RunError(
        FOOTFALL_TEXT("no other program can be started: too many files are open; close some, or raise the "
                      "limit (ulimit -n)"));
  throw RunError(Text(FOOTFALL_TEXT("no other program can be started (%1)"), std::strerror(error)));
}

Pipe makePipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) failStarting(errno);
  Pipe pipe{Descriptor(ends[0]), Descriptor(ends[1])};
  // A pipe may get number 0, 1 or 2 where standard input or output is closed; the started program needs these numbers.
  for (Descriptor* end : {&pipe.from, &pipe.to}) {
    if (end->number() > STDERR_FILENO) continue;
    const int moved = ::fcntl(end->number(), F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    if (moved < 0) failStarting(errno);
    *end = Descriptor(moved);
  }
  ::fcntl(pipe.to.number(), F_SETPIPE_SZ, kPipeBytes);  // a larger pipe is only faster
  return pipe;
}

/// The resident memory of a process; 0 where it is not known, as after its end.
std::uint64_t residentBytes(pid_t process) {
  const std::string name = "/proc/" + std::to_string(process) + "/statm";
  const Descriptor file(::open(name.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.number() < 0) return 0;
  std::array<char, 128> text{};
  const ssize_t count = ::read(file.number(), text.data(), text.size());
  if (count <= 0) return 0;
  const std::string_view words(text.data(), static_cast<std::size_t>(count));
  const std::size_t second = std::min(words.find(' '), words.size() - 1) + 1;  // the first is the address space
  std::uint64_t pages = 0;
  std::from_chars(words.data() + second, words.data() + words.size(), pages);
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

/// The outputs of a program, as far as they have been read.
class Outputs {
 public:
  explicit Outputs(ChildResult& result) : output_(makePipe()), errors_(makePipe()), result_(result) {}

  [[nodiscard]] int outputEnd() const { return output_.to.number(); }
  [[nodiscard]] int errorsEnd() const { return errors_.to.number(); }
  /// Closes the ends of the pipes that the program writes to.
  void closeWritten() {
    output_.to.close();
    errors_.to.close();
  }
  [[nodiscard]] std::uint64_t size() const { return result_.output.size(); }
  [[nodiscard]] bool areOpen() const { return output_.from.number() >= 0 || errors_.from.number() >= 0; }

  /// Waits for more output, 20 ms at most.
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
  std::vector<char> buffer_ = std::vector<char>(1 << 18);
};

/// A process that does not outlive this object. The processes that it has started do not either, because they share its
/// process group.
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
    // Footfall's programs block signals and wait for them; the started program must not inherit the blocked set.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setpgroup(&attributes, 0);
    sigset_t ignored;  // signals that a program may ignore here must end the started program
    sigemptyset(&ignored);
    sigaddset(&ignored, SIGPIPE);
    posix_spawnattr_setsigdefault(&attributes, &ignored);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
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
  [[nodiscard]] pid_t id() const { return id_; }
  /// Waits for the end of the process, which may run long after it has closed its output. Waiting goes on as long as
  /// `poll` returns true.
  template <class Polling>
  int wait(const Polling& poll) {
    int status = 0;
    for (pid_t ended = 0; ended != id_;) {
      ended = ::waitpid(id_, &status, WNOHANG);
      if (ended < 0 && errno != EINTR) break;
      if (ended == id_) continue;
      if (!poll()) return 0;
      ::poll(nullptr, 0, kPollMs);
    }
    id_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  // Output is read while waiting; a full pipe would keep the processes from ending.
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
  pid_t id_ = -1;  ///< also the number of its process group
  bool isReaped_ = false;
};

/// Checks from time to time what a program uses.
class LimitWatch {
 public:
  explicit LimitWatch(const ChildLimits& limits) : limits_(limits) {}

  [[nodiscard]] ChildEnd look(pid_t process, std::uint64_t written) const {
    const double now = total_.wallMs();
    if (now > limits_.wallMs) return ChildEnd::Time;
    if (written > limits_.bytes) return ChildEnd::Memory;
    if (limits_.bytes == ChildLimits().bytes || now - last_ < kWatchMs) return ChildEnd::Itself;
    last_ = now;
    return residentBytes(process) > limits_.bytes ? ChildEnd::Memory : ChildEnd::Itself;
  }

 private:
  const ChildLimits& limits_;
  Stopwatch total_;
  mutable double last_ = 0;
};

}  // namespace

ChildResult runChild(const std::vector<std::string>& arguments, Poll poll, ChildEnding ending, double graceMs,
                     const ChildLimits& limits) {
  ChildResult result;
  Outputs outputs(result);
  Child child(outputs, ending, graceMs);
  if (const int error = child.start(arguments); error != 0) {
    if (error == EAGAIN || error == ENOMEM)
      throw RunError(
          FOOTFALL_TEXT("no other program can be started: there are too many processes, or too little "
                        "memory is left; close other programs"));
    result.status = 127;
    result.errors = std::strerror(error);
    return result;
  }
  outputs.closeWritten();
  const LimitWatch watch(limits);
  // Returns whether the program is within its limits.
  const auto isWithin = [&] {
    poll();
    result.end = watch.look(child.id(), outputs.size());
    return result.end == ChildEnd::Itself;
  };
  while (outputs.areOpen()) {
    if (!isWithin()) return result;
    outputs.read();
  }
  result.status = child.wait(isWithin);
  return result;
}

}  // namespace footfall::detail
