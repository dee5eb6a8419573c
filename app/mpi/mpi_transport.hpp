// Messages between ranks by MPI.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mpi.h>

#include <list>
#include <string>
#include <vector>

#include "core/distributed/rank_exchange.hpp"

namespace footfall::app {

/// MPI from its beginning to its end; one object a process. Signals that the program waits for must be blocked before,
/// since MPI has threads of its own.
class MpiTransport : public detail::Transport {
 public:
  /// Throws RunError.
  MpiTransport();
  /// Every rank has to come here.
  ~MpiTransport() override;
  MpiTransport(const MpiTransport&) = delete;
  MpiTransport& operator=(const MpiTransport&) = delete;

  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int size() const override { return size_; }
  void send(int to, std::string bytes) override;
  std::optional<Message> receive() override;
  bool isIdle() override;

  /// Ends all ranks at once, this one with them.
  [[noreturn]] static void abort(int exitCode);

 private:
  struct Sending {
    std::string bytes;
    MPI_Request request = MPI_REQUEST_NULL;
  };
  void post(int to, std::string piece);

  int rank_ = 0, size_ = 1;
  std::list<Sending> sending_;           ///< MPI has their addresses
  std::vector<std::string> beginnings_;  ///< beginnings of each rank's messages that come in several pieces
};

}  // namespace footfall::app
