// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/distributed/group_mail.hpp"

#include <algorithm>
#include <utility>

namespace footfall::detail {

GroupMail::GroupMail(int rank, int size, Post post)
    : rank_(rank), size_(size), post_(std::move(post)), words_(static_cast<std::size_t>(size)) {}

void GroupMail::handle(int from, ByteReader& in) {
  switch (static_cast<Kind>(in.take(1)[0])) {
    case Kind::Words:
      words_[static_cast<std::size_t>(from)].emplace_back(in.rest());
      break;
    case Kind::Ask:
      asks_.push_back({from, in.number()});
      deal();
      break;
    case Kind::Task:
      dealt_.push_back(in.rest().empty() ? std::nullopt : std::optional<std::size_t>(in.number()));
      break;
    default:
      throw BadBytes("is no message");
  }
}

std::vector<std::string> GroupMail::gather(std::string own, const Wait& wait) {
  if (rank_ != 0) {
    post_(0, static_cast<char>(Kind::Words) + own);
    return {};
  }
  words_[0].push_back(std::move(own));
  wait([this] { return std::none_of(words_.begin(), words_.end(), [](const auto& words) { return words.empty(); }); });
  std::vector<std::string> all;
  for (std::deque<std::string>& words : words_) {
    all.push_back(std::move(words.front()));
    words.pop_front();
  }
  return all;
}

std::string GroupMail::fromFirst(std::string own, const Wait& wait) {
  if (rank_ == 0) {
    for (int rank = 1; rank < size_; ++rank) post_(rank, static_cast<char>(Kind::Words) + own);
    return own;
  }
  wait([this] { return !words_[0].empty(); });
  std::string words = std::move(words_[0].front());
  words_[0].pop_front();
  return words;
}

void GroupMail::beginTasks(std::size_t count) {
  ++round_;
  stretches_.clear();
  const auto ranks = static_cast<std::size_t>(size_);
  const auto endOf = [&](std::size_t part) { return count / ranks * part + count % ranks * part / ranks; };
  for (std::size_t rank = 0; rank < ranks; ++rank) stretches_.emplace_back(endOf(rank), endOf(rank + 1));
  deal();
}

void GroupMail::deal() {
  for (; !asks_.empty() && asks_.front().round <= round_; asks_.pop_front()) {
    ByteWriter out;
    out.bytes.push_back(static_cast<char>(Kind::Task));
    if (const std::optional<std::size_t> task = nextFor(asks_.front().rank)) out.number(*task);
    post_(asks_.front().rank, std::move(out.bytes));
  }
}

// One behind the other, as neighbours have things in common; then from the end of what most is left of.
std::optional<std::size_t> GroupMail::nextFor(int rank) {
  const auto left = [](const auto& stretch) { return stretch.second - stretch.first; };
  if (auto& own = stretches_[static_cast<std::size_t>(rank)]; left(own) > 0) return own.first++;
  const auto longest = std::max_element(stretches_.begin(), stretches_.end(),
                                        [&](const auto& a, const auto& b) { return left(a) < left(b); });
  return left(*longest) > 0 ? std::optional(--longest->second) : std::nullopt;
}

std::optional<std::size_t> GroupMail::nextTask(const Wait& wait) {
  if (rank_ == 0) {
    wait([] { return true; });
    return nextFor(0);
  }
  ByteWriter out;
  out.bytes.push_back(static_cast<char>(Kind::Ask));
  out.number(round_);
  post_(0, std::move(out.bytes));
  wait([this] { return !dealt_.empty(); });
  const std::optional<std::size_t> task = dealt_.front();
  dealt_.pop_front();
  return task;
}

}  // namespace footfall::detail
