// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/pipe_output.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <ctime>

namespace footfall::detail {
namespace {

constexpr int kPollMs = 20;
constexpr std::size_t kPiece = std::size_t{1} << 16;

class File {
 public:
  explicit File(int number) : number_(number) {}
  ~File() {
    if (number_ >= 0) ::close(number_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  [[nodiscard]] int number() const { return number_; }
  /// Some devices report lost data only here.
  int close() {
    const int number = number_;
    number_ = -1;
    return ::close(number);
  }

 private:
  int number_;
};

/// While this object lives, a pipe without a reader sends no signal to this thread. The write fails instead, however
/// the program handles signals.
class NoPipeSignal {
 public:
  NoPipeSignal() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    sigset_t waiting;
    sigpending(&waiting);
    wasWaiting_ = sigismember(&waiting, SIGPIPE) == 1;
    pthread_sigmask(SIG_BLOCK, &pipe_, &previous_);
  }
  ~NoPipeSignal() {
    const timespec none{0, 0};
    if (!wasWaiting_)
      while (sigtimedwait(&pipe_, nullptr, &none) < 0 && errno == EINTR) continue;
    pthread_sigmask(SIG_SETMASK, &previous_, nullptr);
  }
  NoPipeSignal(const NoPipeSignal&) = delete;
  NoPipeSignal& operator=(const NoPipeSignal&) = delete;

 private:
  sigset_t pipe_{}, previous_{};
  bool wasWaiting_ = false;
};

bool isFifo(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && S_ISFIFO(status.st_mode);
}

void waitFor(int descriptor, short event) {
  pollfd waiting{descriptor, event, 0};
  ::poll(&waiting, 1, kPollMs);
}

/// Returns the descriptor, or -1 with `errno`. A FIFO can be opened for writing only while it has a reader.
int openToWrite(const std::string& path, const Poll& poll) {
  while (true) {
    poll();
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (descriptor >= 0 || (errno != EINTR && (errno != ENXIO || !isFifo(path)))) return descriptor;
    ::poll(nullptr, 0, kPollMs);
  }
}

}  // namespace

int writeToPipe(const std::string& path, std::string_view text, const Poll& poll) {
  File file(openToWrite(path, poll));
  if (file.number() < 0) return errno;
  const NoPipeSignal quiet;
  while (!text.empty()) {
    poll();
    const ssize_t count = ::write(file.number(), text.data(), std::min(text.size(), kPiece));
    if (count >= 0) {
      text.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno == EAGAIN) {
      waitFor(file.number(), POLLOUT);
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return file.close() == 0 ? 0 : errno;
}

int readFromPipe(const std::string& path, std::size_t most, std::string& text, const Poll& poll) {
  poll();
  const File file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
  if (file.number() < 0) return errno;
  // A FIFO without a writer is at its end at once. Before the first writer comes, poll() reports neither bytes nor a
  // hang-up; it reports a hang-up when the last writer has left.
  bool hasBegun = !isFifo(path);
  std::array<char, kPiece> piece;
  while (text.size() <= most) {
    poll();
    pollfd waiting{file.number(), POLLIN, 0};
    const int ready = ::poll(&waiting, 1, kPollMs);
    if (ready < 0 && errno != EINTR) return errno;
    if (ready <= 0) continue;
    const ssize_t count = ::read(file.number(), piece.data(), piece.size());
    if (count > 0) {
      hasBegun = true;
      text.append(piece.data(), static_cast<std::size_t>(count));
    } else if (count == 0 && (hasBegun || (waiting.revents & POLLHUP) != 0)) {
      return 0;
    } else if (count < 0 && errno != EAGAIN && errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

}  // namespace footfall::detail
