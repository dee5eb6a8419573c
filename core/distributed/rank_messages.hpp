// The messages of ranks about themselves and about passes over cells, as bytes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/byte_stream.hpp"
#include "core/base/digest.hpp"
#include "core/base/index_and_box.hpp"

namespace footfall::detail {

/// The figures of one rank, in milliseconds of wall time.
struct RankStatistics {
  int threads = 1;
  std::uint64_t cells = 0;      ///< cells that it ran
  std::uint64_t bytesSent = 0;  ///< shares, to all other ranks
  double startUpMs = 0;         ///< time before anything was read
  double readingMs = 0;
  double runningMs = 0;        ///< time for its cells
  double waitingMs = 0;        ///< waiting for others: before cells are divided, and for shares after its own cells
  double communicationMs = 0;  ///< time in which messages were sent or received, while cells ran or not
};

/// The message of a rank before the first cells are divided.
struct RankHello {
  int threads = 1;
  double beganMs = 0;  ///< start by the system's clock
};

/// The message of rank 0 before each pass over the cells.
struct RankPlan {
  std::uint64_t phase = 0, phases = 0;  ///< CellPhase::number and count
  Digest::Value key{};
  std::vector<RankHello> ranks;
  std::vector<Index> stored;
};

void write(const RankStatistics& statistics, ByteWriter& out);
void write(const RankHello& hello, ByteWriter& out);
void write(const RankPlan& plan, ByteWriter& out);
// These throw BadBytes.
RankStatistics readRankStatistics(ByteReader& in);
RankHello readRankHello(ByteReader& in);
RankPlan readRankPlan(ByteReader& in);

}  // namespace footfall::detail
