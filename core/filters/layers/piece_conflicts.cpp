// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/layers/piece_conflicts.hpp"

#include <algorithm>
#include <utility>

namespace footfall::detail {
namespace {

constexpr int kFewLookUps = 8;          ///< most look-ups among all members of a piece before a tree is made of them
constexpr std::size_t kFewOthers = 64;  ///< most members of other groups that are compared one by one

}  // namespace

void KnownConflicts::unite(Index into, Index from) {
  for (const Index other : others_[from]) {
    others_[other].erase(from);
    others_[other].insert(into);
    others_[into].insert(other);
  }
  others_[from].clear();
}

PieceConflicts::PieceConflicts(const LayerInput& input, std::span<const Index> triangles, std::vector<Index>& piece,
                               RunContext& context)
    : input_(input), triangles_(triangles), piece_(piece), context_(context) {
  if (!input.knowsAll) geometry_.emplace(*input.kernel, *input.vertices);
}

bool PieceConflicts::test(Index triangle, Index other) {
  if (triangle == other || isOf(groupOf(triangle), other) || groupOf(other) == kSettled) return false;
  if (haveApartInsides(boundsOf(triangle), boundsOf(other))) return false;
  ++counts_.tested;
  if (!geometry_->overlap(input_.plan->planOf(triangle), input_.plan->planOf(other))) return false;
  counts_.found.push_back({triangle, other});
  return true;
}

void PieceConflicts::begin(Index piece) {
  growing_ = piece;
  main_ = -1;
  late_.clear();
  lookUps_ = 0;
  tree_.clear();
  others_ = {};
  for (const Index t : taken_)
    if (groupOf(t) >= 0 && groupOf(t) < static_cast<Index>(sizes_.size())) sizes_[groupOf(t)] = 0;
  taken_.clear();
}

bool PieceConflicts::isBlocked(Index triangle) {
  const auto known = input_.overlaps[triangle];
  if (std::any_of(known.begin(), known.end(), [&](Index o) { return piece_[o] == growing_; })) return true;
  if (knowsAllOf(triangle)) return false;
  const auto visit = [&](Index other) { return test(triangle, other); };
  if (others_.visitUntil(boundsOf(triangle), visit)) return true;
  if (isOf(main_, triangle)) return false;
  return visitLate(visit) ||
         tree_.visitUntil(boundsOf(triangle), [&](Index number) { return visit(triangles_[number]); });
}

template <class Visit>
bool PieceConflicts::visitLate(const Visit& visit) {
  if (!late_.empty() && lookUps_++ < kFewLookUps) return std::any_of(late_.begin(), late_.end(), visit);
  for (const Index member : std::exchange(late_, {})) addToTree(member);
  return false;
}

void PieceConflicts::addToTree(Index triangle) {
  if (tree_.isEmpty()) {
    std::vector<Bounds> bounds;
    bounds.reserve(triangles_.size());
    for (const Index t : triangles_) bounds.push_back(boundsOf(t));
    tree_.build(bounds, context_);
  }
  tree_.insert(input_.number[triangle]);
}

// The main group has most members, or at least half as many as another one: a change is paid by the members since.
void PieceConflicts::chooseMain(Index group) {
  if (static_cast<Index>(sizes_.size()) <= group) sizes_.resize(group + 1, 0);
  ++sizes_[group];
  if (group == main_ || (main_ >= 0 && sizes_[group] <= 2 * sizes_[main_])) return;
  main_ = group;
  late_.clear();
  tree_.clear();
  others_ = {};
  for (const Index member : taken_) place(member);
}

void PieceConflicts::place(Index triangle) {
  if (isOf(main_, triangle))
    late_.push_back(triangle);
  else
    addTo(others_, {&triangle, 1});
}

void PieceConflicts::take(Index triangle) {
  if (knowsAllOf(triangle)) return;
  if (input_.group.empty()) {
    addToTree(triangle);
    return;
  }
  if (groupOf(triangle) >= 0) chooseMain(groupOf(triangle));
  place(triangle);
  taken_.push_back(triangle);
}

void PieceConflicts::add(Index triangle, Members& members) {
  members.all.push_back(triangle);
  if (members.main >= 0 && !isOf(members.main, triangle) && !knowsAllOf(triangle)) members.others.push_back(triangle);
}

void PieceConflicts::listMembers(std::size_t pieces) {
  members_.clear();
  members_.resize(pieces);
  for (const Index t : triangles_) members_[piece_[t]].all.push_back(t);
  if (input_.group.empty()) return;
  for (Members& members : members_) {
    GroupVote vote;
    for (const Index t : members.all) vote.add(groupOf(t));
    members.main = vote.main();
    for (const Index t : members.all)
      if (!isOf(members.main, t) && !knowsAllOf(t)) members.others.push_back(t);
  }
}

void PieceConflicts::addTo(GrowingBoxes& tree, std::span<const Index> triangles) {
  for (const Index t : triangles) tree.add(t, boundsOf(t));
  tree.settle(context_);
}

template <class Counts>
bool PieceConflicts::overlapsAny(Index triangle, Members& members, const Counts& counts) {
  if (knowsAllOf(triangle)) return false;
  const auto visit = [&](Index other) { return counts(other) && test(triangle, other); };
  const auto isAny = [&](const std::vector<Index>& some) { return std::any_of(some.begin(), some.end(), visit); };
  if (isOf(members.main, triangle) && members.others.size() <= kFewOthers) return isAny(members.others);
  if (!members.tree) {
    if (members.lookUps++ < kFewLookUps) return isAny(members.all);
    members.tree = std::make_unique<GrowingBoxes>();
    addTo(*members.tree, members.all);
  }
  return members.tree->visitUntil(boundsOf(triangle), visit);
}

void PieceConflicts::beginUniting(std::size_t pieces) {
  known_ = KnownConflicts(pieces);
  listMembers(pieces);
  auto addKnown = [this, last = Index{-1}, lastOther = Index{-1}](Index t, Index o) mutable {
    const Index p = piece_[t], q = piece_[o];
    if (p == q || (p == last && q == lastOther)) return;  // most triangles have the pieces of the one before
    known_.add(last = p, lastOther = q);
  };
  for (const Index t : triangles_)
    for (const Index o : input_.overlaps[t]) addKnown(t, o);
  for (const auto& [t, o] : counts_.found) addKnown(t, o);
}

bool PieceConflicts::overlap(Index p, Index q) {
  if (known_.contain(p, q)) return true;
  Members *few = &members_[p], *many = &members_[q];
  if (few->all.size() > many->all.size()) std::swap(few, many);
  const auto overlapsOneOf = [&](const std::vector<Index>& some, Members& members) {
    return std::any_of(some.begin(), some.end(), [&](Index t) {
      context_.checkCancelled();
      return overlapsAny(t, members, [](Index /*other*/) { return true; });
    });
  };
  const bool haveOneMain = few->main >= 0 && few->main == many->main;
  const bool found = haveOneMain ? overlapsOneOf(few->others, *many) || overlapsOneOf(many->others, *few)
                                 : overlapsOneOf(few->all, *many);
  if (found) known_.add(p, q);
  return found;
}

void PieceConflicts::unite(Index into, Index from) {
  known_.unite(into, from);
  Members &all = members_[into], &added = members_[from];
  if (all.all.size() < added.all.size()) std::swap(all, added);
  for (const Index t : added.all) add(t, all);
  if (all.tree) addTo(*all.tree, added.all);
  added = {};
}

bool PieceConflicts::overlapsPiece(Index triangle, Index piece) {
  const auto isThere = [&](Index o) { return piece_[o] == piece; };
  const auto known = input_.overlaps[triangle];
  return std::any_of(known.begin(), known.end(), isThere) || overlapsAny(triangle, members_[piece], isThere);
}

void PieceConflicts::move(Index triangle, Index to) {
  if (input_.knowsAll) return;
  add(triangle, members_[to]);
  if (members_[to].tree) addTo(*members_[to].tree, {&triangle, 1});
}

SearchCounts PieceConflicts::takeCounts() {
  if (geometry_) counts_.fallbacks = geometry_->fallbacks;
  return std::move(counts_);
}

}  // namespace footfall::detail
