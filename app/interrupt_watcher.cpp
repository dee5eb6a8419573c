// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/interrupt_watcher.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <system_error>

namespace footfall::app {

InterruptWatcher::InterruptWatcher(RunContext& context) {
  sigset_t watched;
  sigemptyset(&watched);
  sigaddset(&watched, SIGINT);
  sigaddset(&watched, SIGTERM);
  sigaddset(&watched, SIGHUP);  // A closed terminal sends no signal to the programs that were started.
  pthread_sigmask(SIG_BLOCK, &watched, &previousMask_);
  try {
    signals_ = signalfd(-1, &watched, SFD_CLOEXEC | SFD_NONBLOCK);
    stop_ = eventfd(0, EFD_CLOEXEC);
    if (signals_ < 0 || stop_ < 0) throw std::system_error(errno, std::generic_category(), "waiting for signals");
    thread_ = std::thread([this, &context] {
      std::array<pollfd, 2> waiting = {pollfd{signals_, POLLIN, 0}, pollfd{stop_, POLLIN, 0}};
      while (true) {
        if (poll(waiting.data(), waiting.size(), -1) < 0 && errno != EINTR) return;
        signalfd_siginfo received;
        if (read(signals_, &received, sizeof(received)) == sizeof(received)) context.cancel();
        if ((waiting[1].revents & POLLIN) != 0) return;
      }
    });
  } catch (...) {
    restore();
    throw;
  }
}

InterruptWatcher::~InterruptWatcher() {
  const std::uint64_t one = 1;
  // Writing 1 to a fresh eventfd cannot fail.
  [[maybe_unused]] const auto written = write(stop_, &one, sizeof(one));
  thread_.join();
  restore();
}

void InterruptWatcher::restore() noexcept {
  if (signals_ >= 0) close(signals_);
  if (stop_ >= 0) close(stop_);
  pthread_sigmask(SIG_SETMASK, &previousMask_, nullptr);
}

}  // namespace footfall::app
