// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mpi/mpi_transport.hpp"

#include <cstdlib>
#include <cstring>
#include <utility>

#include "footfall/errors.hpp"

namespace footfall::app {
namespace {

constexpr int kTag = 1;
// MPI counts bytes in an int.
constexpr std::size_t kLargestPiece = std::size_t{1} << 30;
// The last byte of a piece.
constexpr char kMore = 0, kLast = 1;

// Lets ranks of Open MPI on one machine pass messages through its memory: looking for networks first takes a fifth of a
// second. Settings given to mpirun take precedence.
void stayOnThisMachine() {
  const char* all = std::getenv("OMPI_COMM_WORLD_SIZE");
  const char* here = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
  if (all != nullptr && here != nullptr && std::strcmp(all, here) == 0) setenv("OMPI_MCA_pml", "ob1", 0);
}

}  // namespace

MpiTransport::MpiTransport() {
  stayOnThisMachine();
  int provided = MPI_THREAD_SINGLE;
  if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided) != MPI_SUCCESS ||
      provided < MPI_THREAD_SERIALIZED)
    throw RunError("MPI cannot be called by threads; use an MPI that can, such as Open MPI");
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
  beginnings_.resize(static_cast<std::size_t>(size_));
}

MpiTransport::~MpiTransport() { MPI_Finalize(); }

void MpiTransport::send(int to, std::string bytes) {
  while (bytes.size() > kLargestPiece) {
    post(to, bytes.substr(0, kLargestPiece) + kMore);
    bytes.erase(0, kLargestPiece);
  }
  post(to, std::move(bytes) + kLast);
}

void MpiTransport::post(int to, std::string piece) {
  Sending& sending = sending_.emplace_back();
  sending.bytes = std::move(piece);
  MPI_Isend(sending.bytes.data(), static_cast<int>(sending.bytes.size()), MPI_BYTE, to, kTag, MPI_COMM_WORLD,
            &sending.request);
}

std::optional<detail::Transport::Message> MpiTransport::receive() {
  while (true) {
    int isThere = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, kTag, MPI_COMM_WORLD, &isThere, &status);
    if (isThere == 0) return std::nullopt;
    int size = 0;
    MPI_Get_count(&status, MPI_BYTE, &size);
    std::string bytes(static_cast<std::size_t>(size), '\0');
    MPI_Recv(bytes.data(), size, MPI_BYTE, status.MPI_SOURCE, kTag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    const bool isLast = !bytes.empty() && bytes.back() == kLast;
    if (!bytes.empty()) bytes.pop_back();
    std::string& beginning = beginnings_[static_cast<std::size_t>(status.MPI_SOURCE)];
    if (!isLast) {
      beginning += bytes;
      continue;
    }
    if (!beginning.empty()) bytes.insert(0, std::exchange(beginning, {}));
    return Message{status.MPI_SOURCE, std::move(bytes)};
  }
}

bool MpiTransport::isIdle() {
  for (auto sending = sending_.begin(); sending != sending_.end();) {
    int isDone = 0;
    MPI_Test(&sending->request, &isDone, MPI_STATUS_IGNORE);
    sending = isDone != 0 ? sending_.erase(sending) : std::next(sending);
  }
  return sending_.empty();
}

void MpiTransport::abort(int exitCode) {
  MPI_Abort(MPI_COMM_WORLD, exitCode);
  std::abort();  // MPI_Abort does not return
}

}  // namespace footfall::app
