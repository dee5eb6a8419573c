// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/layers/piece_conflicts.hpp"

#include <algorithm>
#include <utility>

namespace footfall::detail {

void KnownConflicts::unite(Index into, Index from) {
  for (const Index other : others_[from]) {
    others_[other].erase(from);
    others_[other].insert(into);
    others_[into].insert(other);
  }
  others_[from].clear();
}

void ListedConflicts::beginUniting(std::span<const Index> triangles, std::size_t pieces) {
  known_ = KnownConflicts(pieces);
  Index last = -1, lastOther = -1;  // most triangles have the same pair of pieces as the one before
  for (const Index t : triangles) {
    const Index p = piece_[t];
    for (const Index o : overlaps_[t]) {
      if (piece_[o] == p || (p == last && piece_[o] == lastOther)) continue;
      known_.add(last = p, lastOther = piece_[o]);
    }
  }
}

bool ListedConflicts::overlapsPiece(Index triangle, Index piece) const {
  const auto others = overlaps_[triangle];
  return std::any_of(others.begin(), others.end(), [&](Index o) { return piece_[o] == piece; });
}

template <class Counts>
bool SearchedConflicts::overlapsAny(Index triangle, const GrowingTriangles& set, const Counts& counts) {
  const PlanTriangle plan = planTriangleOf(mesh_.vertices, mesh_.triangles[triangle]);
  return set.visitUntil(plan, [&](Index o) {
    if (o == triangle || !counts(o)) return false;
    ++tested_;
    return geometry_.overlap(plan, planTriangleOf(mesh_.vertices, mesh_.triangles[o]));
  });
}

SearchedConflicts::SearchedConflicts(const PlanKernel& kernel, const WalkableMesh& mesh,
                                     std::span<const Index> triangles, const std::vector<Index>& number,
                                     std::vector<Index>& piece, RunContext& context)
    : mesh_(mesh), number_(number), piece_(piece), context_(context), geometry_(kernel, mesh.vertices) {
  plans_.reserve(triangles.size());
  bounds_.reserve(triangles.size());
  for (const Index t : triangles) {
    plans_.push_back(planTriangleOf(mesh.vertices, mesh.triangles[t]));
    bounds_.push_back(planBoundsOf(plans_.back()));
  }
  growing_.build(bounds_, context);
}

bool SearchedConflicts::isBlocked(Index triangle) {
  const Index own = number_[triangle];
  return growing_.visitUntil(bounds_[own], [&](Index other) {
    if (haveApartInsides(bounds_[own], bounds_[other])) return false;
    ++tested_;
    return geometry_.overlap(plans_[own], plans_[other]);
  });
}

void SearchedConflicts::listMembers(std::span<const Index> triangles, std::size_t pieces) {
  trees_.clear();
  trees_.resize(pieces);
  members_.first.assign(pieces + 1, 0);
  for (const Index t : triangles) ++members_.first[piece_[t] + 1];
  for (std::size_t p = 0; p < pieces; ++p) members_.first[p + 1] += members_.first[p];
  members_.items.resize(triangles.size());
  std::vector<Index> next(members_.first.begin(), members_.first.end() - 1);
  for (const Index t : triangles) members_.items[next[piece_[t]]++] = t;
}

GrowingTriangles& SearchedConflicts::of(Index piece) {
  std::unique_ptr<GrowingTriangles>& tree = trees_[piece];
  if (!tree) {
    tree = std::make_unique<GrowingTriangles>(mesh_);
    tree->add(members_[piece], context_);
  }
  return *tree;
}

void SearchedConflicts::beginUniting(std::span<const Index> triangles, std::size_t pieces) {
  known_ = KnownConflicts(pieces);
  listMembers(triangles, pieces);
}

bool SearchedConflicts::overlap(Index p, Index q) {
  if (known_.contain(p, q)) return true;
  const GrowingTriangles *few = &of(p), *many = &of(q);
  if (few->size() > many->size()) std::swap(few, many);
  bool found = false;
  few->forEach([&](Index t) {
    if (found) return;
    context_.checkCancelled();
    found = overlapsAny(t, *many, [](Index /*other*/) { return true; });
  });
  if (found) known_.add(p, q);
  return found;
}

void SearchedConflicts::unite(Index into, Index from) {
  known_.unite(into, from);
  of(into);
  of(from);
  if (trees_[into]->size() < trees_[from]->size()) std::swap(trees_[into], trees_[from]);
  std::vector<Index> added;
  trees_[from]->forEach([&](Index t) { added.push_back(t); });
  trees_[from].reset();
  trees_[into]->add(added, context_);
}

bool SearchedConflicts::overlapsPiece(Index triangle, Index piece) {
  return overlapsAny(triangle, of(piece), [&](Index o) { return piece_[o] == piece; });
}

}  // namespace footfall::detail
