// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/distributed/rank_messages.hpp"

namespace footfall::detail {

void write(const RankStatistics& statistics, ByteWriter& out) {
  out.number(static_cast<std::uint64_t>(statistics.threads));
  out.number(statistics.cells);
  out.number(statistics.bytesSent);
  for (const double ms : {statistics.startUpMs, statistics.readingMs, statistics.runningMs, statistics.waitingMs,
                          statistics.communicationMs})
    out.real(ms);
}

RankStatistics readRankStatistics(ByteReader& in) {
  RankStatistics statistics;
  statistics.threads = static_cast<int>(in.number());
  statistics.cells = in.number();
  statistics.bytesSent = in.number();
  for (double* ms : {&statistics.startUpMs, &statistics.readingMs, &statistics.runningMs, &statistics.waitingMs,
                     &statistics.communicationMs})
    *ms = in.real();
  return statistics;
}

void write(const RankHello& hello, ByteWriter& out) {
  out.number(static_cast<std::uint64_t>(hello.threads));
  out.real(hello.beganMs);
}

RankHello readRankHello(ByteReader& in) {
  RankHello hello;
  hello.threads = static_cast<int>(in.number());
  hello.beganMs = in.real();
  return hello;
}

void write(const RankPlan& plan, ByteWriter& out) {
  out.number(plan.phase);
  out.number(plan.phases);
  for (const std::uint64_t word : plan.key) out.fixed(word);
  out.number(plan.ranks.size());
  for (const RankHello& rank : plan.ranks) write(rank, out);
  out.number(plan.stored.size());
  for (const Index cell : plan.stored) out.number(static_cast<std::uint64_t>(cell));
}

RankPlan readRankPlan(ByteReader& in) {
  RankPlan plan;
  plan.phase = in.number();
  plan.phases = in.number();
  for (std::uint64_t& word : plan.key) word = in.fixed();
  plan.ranks.resize(in.count(9));
  for (RankHello& rank : plan.ranks) rank = readRankHello(in);
  plan.stored.resize(in.count(1));
  for (Index& cell : plan.stored) cell = in.below(std::int64_t{1} << 31);
  return plan;
}

}  // namespace footfall::detail
