// The messages of a RankGroup.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/byte_stream.hpp"

namespace footfall::detail {

/// The work of RankGroup on one rank. The owner carries the messages, and calls one function at a time.
class GroupMail {
 public:
  using Post = std::function<void(int to, std::string bytes)>;
  /// Returns when what it is given holds, to which handle() leads; or throws.
  using Wait = std::function<void(const std::function<bool()>& ready)>;

  GroupMail(int rank, int size, Post post);

  /// A message that another rank's `post` was given. Throws BadBytes.
  void handle(int from, ByteReader& in);

  std::vector<std::string> gather(std::string own, const Wait& wait);
  std::string fromFirst(std::string own, const Wait& wait);
  void beginTasks(std::size_t count);
  std::optional<std::size_t> nextTask(const Wait& wait);

 private:
  enum class Kind : char { Words, Ask, Task };
  /// A request for a task of a round, which rank 0 may not have begun.
  struct Ask {
    int rank = 0;
    std::uint64_t round = 0;
  };
  void deal();
  std::optional<std::size_t> nextFor(int rank);

  int rank_, size_;
  Post post_;
  std::vector<std::deque<std::string>> words_;  ///< words of each rank
  std::deque<Ask> asks_;
  std::deque<std::optional<std::size_t>> dealt_;  ///< tasks dealt to this rank
  std::uint64_t round_ = 0;
  /// One stretch of the round's unassigned tasks for each rank; on rank 0 only.
  std::vector<std::pair<std::size_t, std::size_t>> stretches_;
};

}  // namespace footfall::detail
