// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/steps/step_linker.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <unordered_set>

#include "core/base/disjoint_sets.hpp"
#include "core/base/index_and_box.hpp"
#include "core/base/parallel.hpp"
#include "core/base/sorted_list.hpp"
#include "core/environment/coordinate_grid.hpp"
#include "core/mesh/triangle_corners.hpp"

namespace footfall::detail {
namespace {

using Bounds = BoxTree<3>::Bounds;

constexpr Index kBordersPerTask = 64;
constexpr Index kDirectionsPerTask = 8192;
constexpr std::size_t kPolled = 1024;
/// The most times that left-out ways over gaps are added where other ways could not be proven.
constexpr int kMostRetries = 8;

/// Sorts findings by their borders, of which the first `known` are sorted; those of one pair stay in their order.
template <class Finding>
void sortBehind(std::vector<Finding>& findings, std::size_t known) {
  const auto isBefore = [](const Finding& a, const Finding& b) {
    return std::array{a.first, a.second} < std::array{b.first, b.second};
  };
  const auto middle = findings.begin() + static_cast<std::ptrdiff_t>(known);
  std::stable_sort(middle, findings.end(), isBefore);
  if (known > 0) std::inplace_merge(findings.begin(), middle, findings.end(), isBefore);
}

}  // namespace

StepLinker::StepLinker(const WalkableState& state, RunContext& context, const std::vector<char>* faces)
    : state_(state), context_(context), splits_(state, context, faces) {}

StepLinker::Worker StepLinker::makeWorker(const Limits& limits, double gap) const {
  const PlanKernel& kernel = *splits_.kernel();
  const int scale = kernel.mesh().grid.scaleExponent();
  const auto scaled = [&](double length) { return std::ldexp(length, scale); };
  Worker worker{{kernel, splits_.mesh().vertices},
                {kernel, state_.removed, kernel.levelOf(limits.step).value(), kernel.levelOf(limits.height).value()},
                {kernel.mesh(), state_.removed, scaled(limits.step), scaled(limits.height), scaled(gap)},
                {},
                {}};
  const StepsAtLimit atLimit = stepsAtLimit(state_.environment->grid, limits.step);
  const auto lower = kernel.levelOf(atLimit.lower), higher = kernel.levelOf(atLimit.higher);
  if (lower && higher) {
    worker.conditions.refuseBetween(*lower, *higher);
    worker.gaps.refuseBetween(scaled(atLimit.lower), scaled(atLimit.higher));
  }
  return worker;
}

Bounds StepLinker::boundsOf(const MeshBorder& border) const {
  return BorderSplits::boundsOf(splits_.vertex(border.from), splits_.vertex(border.to));
}

std::shared_ptr<const WalkableMesh> StepLinker::link(double step, double height, double gap, StepMemory* memory,
                                                     bool linksGaps) {
  const WalkableMesh& mesh = splits_.mesh();
  const bool hasGaps =
      std::any_of(mesh.links.begin(), mesh.links.end(), [](const MeshLink& link) { return link.isGap; });
  if (gap > 0 || hasGaps) gaps_.emplace(splits_, gap, context_);
  StepFindings found = findStretches({step, height}, gap);
  if (memory != nullptr) *memory = {state_.mesh, step, height, gap, splits_.borders(), found};
  if (!linksGaps) found.gaps = {};
  needless_.emplace(splits_, gap);
  needless_->takeFrom(found.gaps, found.stretches, context_);
  leftOut_ = needless_->count();
  undecided_ += found.undecided.size();
  stretches_ = std::move(found.stretches);
  if (gaps_) gaps_->add(std::move(found.gaps));
  std::unordered_map<Index, Index> borderOf;  // by side
  for (std::size_t i = 0; i < splits_.borders().size() && !mesh.links.empty(); ++i)
    borderOf[splits_.borders()[i].side] = static_cast<Index>(i);
  for (const MeshLink& link : mesh.links) {
    context_.checkCancelled();
    const auto find = [&](const std::array<Index, 2>& edge) {
      return borderOf.at(findSide(mesh.triangles, splits_.topology(), edge[0], edge[1]));
    };
    const Index first = find(link.from), second = find(link.to);
    if (link.isGap)
      gaps_->add(gaps_->findAgain(first, second, {gaps_->lineOf(first), gaps_->lineOf(second)}, nullptr));
    else
      stretches_.push_back({first, second, splits_.vertex(link.from[0]), splits_.vertex(link.from[1])});
  }
  return makeMesh();
}

std::shared_ptr<const WalkableMesh> StepLinker::relink(const WalkableMesh& earlier,
                                                       const std::optional<Limits>& limits) {
  const Adjacency topology = findEdges(earlier.triangles, earlier.vertices.size(), context_);
  const auto borderOf = [&](const std::array<Index, 2>& edge) {
    const Index side = findSide(earlier.triangles, topology, edge[0], edge[1]);
    if (side < 0) throw std::logic_error("a link without its triangle");
    return MeshBorder{side, -1, edge[0], edge[1], earlier.triangles[side / 3].face};
  };
  if (std::any_of(earlier.links.begin(), earlier.links.end(), [](const MeshLink& link) { return link.isGap; }))
    gaps_.emplace(splits_, 0, context_);
  std::optional<Worker> worker;
  if (limits) worker.emplace(makeWorker(*limits, 0));
  for (const MeshLink& link : earlier.links) {
    context_.checkCancelled();
    addRemains(earlier, borderOf(link.from), borderOf(link.to), link.isGap, worker ? &*worker : nullptr);
  }
  if (worker) {
    fallbacks_ += worker->geometry.fallbacks;
    undecided_ += worker->conditions.undecided();
    stretches_.insert(stretches_.end(), worker->found.stretches.begin(), worker->found.stretches.end());
  }
  return makeMesh();
}

StepLinker::Direction StepLinker::directionOf(const MeshBorder& border) const {
  const MeshVertex &a = splits_.vertex(border.from), &b = splits_.vertex(border.to);
  const double size = std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(b.x), std::fabs(b.y)});
  return {b.x - a.x, b.y - a.y, (a.error + b.error + size * 0x1p-51) * 2};
}

// The error of the product is at most |d| e' + |d'| e + 2 e e' and its own roundings.
bool StepLinker::mayBeOpposite(Index first, Index second) const {
  const Direction &d = directions_[first], &e = directions_[second];
  const double size = std::fabs(d.x) + std::fabs(d.y), other = std::fabs(e.x) + std::fabs(e.y);
  const double bound = (size + d.error) * e.error + (other + e.error) * d.error + size * other * 0x1p-50;
  return !(d.x * e.x + d.y * e.y > bound);
}

StepFindings StepLinker::findStretches(const Limits& limits, double gap) {
  const auto count = static_cast<Index>(splits_.borders().size());
  const int scale = splits_.kernel()->mesh().grid.scaleExponent();
  const double scaledStep = std::ldexp(limits.step, scale), scaledGap = std::ldexp(gap, scale);
  const auto append = [](auto& all, auto&& more) {
    all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  };
  PerThread<Worker> workers([&] { return makeWorker(limits, gap); });
  directions_.resize(count);
  parallelRanges(count, kDirectionsPerTask, [&](const auto& range) {
    context_.checkCancelled();
    for (Index i = range.begin(); i != range.end(); ++i) directions_[i] = directionOf(splits_.border(i));
  });
  const bool areAllNew = numberBefore_.empty();
  parallelRanges(count, kBordersPerTask, [&](const auto& range) {
    Worker& worker = workers.local();
    StepFindings& found = worker.found;
    const auto tryBoth = [&](Index i, Index other) {
      if (!mayBeOpposite(i, other)) return;
      const Index first = std::min(i, other), second = std::max(i, other);
      const std::size_t undecided = worker.conditions.undecided();
      const bool areOnOneLine = tryPair(first, second, worker);
      found.undecided.insert(found.undecided.end(), worker.conditions.undecided() - undecided, {first, second});
      if (gap > 0 && !areOnOneLine) append(found.gaps, gaps_->find(first, second, worker.gaps, worker.lines));
    };
    const auto queryFor = [&](Index i) {
      Bounds query = boundsOf(splits_.border(i));
      for (const int k : {0, 1, 2}) {
        query.lower[k] -= k < 2 ? scaledGap : scaledStep;
        query.upper[k] += k < 2 ? scaledGap : scaledStep;
      }
      return query;
    };
    std::vector<Bounds> row;
    for (Index place = range.begin(); place < range.end() && areAllNew; place += BoxTree<3>::kRow) {
      context_.checkCancelled();
      row.clear();
      for (Index k = place; k < std::min(place + BoxTree<3>::kRow, range.end()); ++k)
        row.push_back(queryFor(splits_.tree().idAt(k)));
      splits_.tree().visitOverlapping(place, row,
                                      [&](Index own, Index other) { tryBoth(splits_.tree().idAt(own), other); });
    }
    for (Index place = range.begin(); place != range.end() && !areAllNew; ++place) {
      context_.checkCancelled();
      const Index i = splits_.tree().idAt(place);
      if (isKnown(i)) continue;
      splits_.tree().visitOverlapping(queryFor(i), [&](Index other) {
        // Known borders do not search for others.
        if (other != i && (other > i || isKnown(other))) tryBoth(i, other);
      });
    }
  });
  StepFindings all = std::move(known_);
  const std::size_t knownStretches = all.stretches.size(), knownGaps = all.gaps.size();
  for (Worker& worker : workers) {
    fallbacks_ += worker.geometry.fallbacks;
    append(all.stretches, worker.found.stretches);
    append(all.gaps, worker.found.gaps);
    append(all.undecided, worker.found.undecided);
  }
  context_.checkCancelled();
  sortBehind(all.stretches, knownStretches);
  sortBehind(all.gaps, knownGaps);
  std::sort(all.undecided.begin(), all.undecided.end());
  return all;
}

bool StepLinker::tryPair(Index first, Index second, Worker& worker) const {
  const MeshBorder &e = splits_.border(first), &f = splits_.border(second);
  MeshGeometry& geometry = worker.geometry;
  if (geometry.orientation(e.from, e.to, f.from) != 0 || geometry.orientation(e.from, e.to, f.to) != 0) return false;
  const int axis = BorderSplits::axisBetween(splits_.vertex(e.from), splits_.vertex(e.to), geometry);
  if (axis < 0) return true;
  const auto compare = [&](Index a, Index b) { return geometry.compare(a, b, axis); };
  const int direction = compare(e.to, e.from);
  if (compare(f.to, f.from) != -direction) return true;  // the walkable sides are the same
  const Index begin = direction * compare(e.from, f.to) >= 0 ? e.from : f.to;
  const Index end = direction * compare(e.to, f.from) <= 0 ? e.to : f.from;
  if (direction * compare(begin, end) >= 0) return true;
  addFree({first, second, splits_.vertex(begin), splits_.vertex(end)}, axis, direction, worker);
  return true;
}

void StepLinker::addFree(const Stretch& whole, int axis, int direction, Worker& worker) const {
  const MeshBorder &e = splits_.border(whole.first), &f = splits_.border(whole.second);
  SharedStretch stretch;
  stretch.faces = {e.face, f.face};
  stretch.begin = whole.begin;
  stretch.end = whole.end;
  stretch.axis = axis;
  stretch.direction = direction;
  const Bounds own = boundsOf(e), other = boundsOf(f);
  for (int k = 0; k < 3; ++k) {
    stretch.box.lower[k] = k < 2 ? std::max(own.lower[k], other.lower[k]) : std::min(own.lower[k], other.lower[k]);
    stretch.box.upper[k] = k < 2 ? std::min(own.upper[k], other.upper[k]) : std::max(own.upper[k], other.upper[k]);
  }
  const auto lines = [&] {
    std::vector<KnownLine> known = splits_.linesOf(e, worker.geometry);
    const std::vector<KnownLine> others = splits_.linesOf(f, worker.geometry);
    known.insert(known.end(), others.begin(), others.end());
    return known;
  };
  for (const auto& [from, to] : worker.conditions.find(stretch, lines, worker.geometry))
    worker.found.stretches.push_back({whole.first, whole.second, from, to});
}

// The borders on the line of the earlier one, at its height.
std::vector<Index> StepLinker::remainsOf(const WalkableMesh& earlier, const MeshBorder& old) {
  const PlanKernel& kernel = *splits_.kernel();
  const MeshVertex &a = earlier.vertices[old.from], &b = earlier.vertices[old.to];
  const Index origin = kernel.mesh().triangles[old.face][0];
  const auto isOn = [&](Index number, Index face) {
    const PlanPoint& point = splits_.vertex(number).point;
    return kernel.orientation(a.point, b.point, point, origin, fallbacks_) == 0 &&
           (face == old.face || kernel.compareHeight(point, face, old.face, fallbacks_) == 0);
  };
  std::vector<Index> numbers;
  splits_.tree().visitOverlapping(BorderSplits::boundsOf(a, b), [&](Index i) {
    const MeshBorder& border = splits_.border(i);
    if (isOn(border.from, border.face) && isOn(border.to, border.face)) numbers.push_back(i);
  });
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

void StepLinker::addRemains(const WalkableMesh& earlier, const MeshBorder& from, const MeshBorder& to, bool isGap,
                            Worker* worker) {
  MeshGeometry& geometry = splits_.geometry();
  const MeshVertex &begin = earlier.vertices[from.from], &end = earlier.vertices[from.to];
  const int axis = BorderSplits::axisBetween(begin, end, geometry);
  if (axis < 0 || BorderSplits::axisBetween(earlier.vertices[to.from], earlier.vertices[to.to], geometry) < 0) return;
  const std::vector<Index> own = remainsOf(earlier, from), others = remainsOf(earlier, to);
  const int direction = geometry.compare(end, begin, axis);
  const auto order = [&](const MeshVertex& a, const MeshVertex& b) { return direction * geometry.compare(a, b, axis); };
  for (const Index first : own)
    for (const Index second : others) {
      if (isGap) {
        addGap(first, second, earlier, {from, to}, worker);
        continue;
      }
      const MeshBorder &e = splits_.border(first), &f = splits_.border(second);
      if (order(splits_.vertex(e.from), splits_.vertex(e.to)) >= 0 ||
          order(splits_.vertex(f.to), splits_.vertex(f.from)) >= 0)
        continue;
      Stretch stretch{first, second, begin, end};
      for (const Index p : {e.from, f.to})
        if (order(splits_.vertex(p), stretch.begin) > 0) stretch.begin = splits_.vertex(p);
      for (const Index p : {e.to, f.from})
        if (order(splits_.vertex(p), stretch.end) < 0) stretch.end = splits_.vertex(p);
      if (order(stretch.begin, stretch.end) >= 0) continue;
      if (worker != nullptr)
        addFree(stretch, axis, direction, *worker);
      else
        stretches_.push_back(stretch);
    }
}

// Where both borders still exist, the link keeps its vertices.
void StepLinker::addGap(Index first, Index second, const WalkableMesh& earlier, const std::array<MeshBorder, 2>& edges,
                        Worker* worker) {
  std::array<GapBorder, 2> lines;
  for (const int i : {0, 1})
    lines[i] = gaps_->lineOf(earlier.vertices[edges[i].from], earlier.vertices[edges[i].to], edges[i].face);
  std::vector<GapStretch> found = gaps_->findAgain(first, second, lines, worker != nullptr ? &worker->gaps : nullptr);
  if (found.empty()) return;
  for (const auto& [border, edge] : {std::pair(first, edges[0]), std::pair(second, edges[1])})
    for (const Index v : {edge.from, edge.to}) splits_.insert(splits_.border(border).edge, earlier.vertices[v]);
  gaps_->add(std::move(found));
}

// Both borders of a stretch end with it, and get all vertices that either has inside it, until nothing changes. No new
// places arise, so this ends.
void StepLinker::splitAtSteps() {
  std::vector<Index> changed;
  for (std::size_t i = 0; i < stretches_.size(); ++i) {
    if (i % kPolled == 0) context_.checkCancelled();
    const Stretch& s = stretches_[i];
    for (const Index number : {s.first, s.second}) {
      const Index edge = splits_.border(number).edge;
      stretchesAt_[edge].push_back(i);
      for (const MeshVertex* end : {&s.begin, &s.end})
        if (splits_.insert(edge, *end)) changed.push_back(edge);
    }
  }
  spreadSplits(changed);
}

// Each round adds gaps that were left out, and adds none twice, so this ends. Gaps that are still needed after the last
// round count as undecided.
void StepLinker::splitAtGaps() {
  DisjointSets rows(static_cast<std::size_t>(splits_.topology().edgeCount()));
  for (const Stretch& s : stretches_) rows.unite(splits_.border(s.first).edge, splits_.border(s.second).edge);
  const auto split = [&] { gaps_->split(rows, [&](const std::vector<Index>& changed) { spreadSplits(changed); }); };
  split();
  for (int round = 0; needless_; ++round) {
    std::vector<GapStretch> needed = needless_->takeNeeded(
        gaps_->lostParts(), stretches_, [&] { return gaps_->ways(); }, context_);
    leftOut_ = needless_->count();
    if (needed.empty()) break;
    if (round == kMostRetries) {
      undecided_ += needed.size();
      break;
    }
    gaps_->add(std::move(needed));
    split();
  }
  needless_.reset();
}

// Spreads vertices from edges that got some to all edges that must have them too.
void StepLinker::spreadSplits(const std::vector<Index>& changed) {
  std::vector<Index> open;
  std::unordered_set<Index> isOpen;
  const auto push = [&](Index edge) {
    if (isOpen.insert(edge).second) open.push_back(edge);
  };
  for (const Index edge : changed) push(edge);
  while (!open.empty()) {
    context_.checkCancelled();
    const Index own = open.back();
    open.pop_back();
    isOpen.erase(own);
    const auto found = stretchesAt_.find(own);
    if (found == stretchesAt_.end()) continue;
    for (const std::size_t i : found->second) {
      const Stretch& s = stretches_[i];
      const Index first = splits_.border(s.first).edge, second = splits_.border(s.second).edge;
      const Index other = own == first ? second : first;
      if (other == own) continue;
      for (const MeshVertex& place : splits_.between(own, s.begin, s.end))
        if (splits_.insert(other, place)) push(other);
    }
  }
}

void StepLinker::addStepLinks(std::vector<MeshLink>& links) {
  // The vertices of a border between two places, in its own direction.
  const auto chainOf = [&](const MeshBorder& border, const MeshVertex& a, const MeshVertex& b) {
    MeshGeometry& geometry = splits_.geometry();
    const int axis = BorderSplits::axisBetween(a, b, geometry), direction = geometry.compare(b, a, axis);
    const auto order = [&](std::size_t i, const MeshVertex& place) {
      return direction * geometry.compare(splits_.chainVertex(border, i), place, axis);
    };
    std::size_t low = 0, high = splits_.chainLength(border);
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      if (order(middle, a) >= 0)
        high = middle;
      else
        low = middle + 1;
    }
    std::vector<Index> chain;
    for (; low < splits_.chainLength(border) && order(low, b) <= 0; ++low)
      chain.push_back(splits_.chainNumber(border, low));
    return chain;
  };
  for (const Stretch& s : stretches_) {
    context_.checkCancelled();
    const std::vector<Index> from = chainOf(splits_.border(s.first), s.begin, s.end);
    const std::vector<Index> to = chainOf(splits_.border(s.second), s.end, s.begin);
    for (std::size_t i = 0; i + 1 < from.size(); ++i) {
      const std::size_t j = to.size() - 1 - i;
      MeshLink link{{from[i], from[i + 1]}, {to[j - 1], to[j]}};
      if (link.to < link.from) std::swap(link.from, link.to);
      links.push_back(link);
    }
  }
}

std::shared_ptr<const WalkableMesh> StepLinker::makeMesh() {
  directions_ = {};
  splits_.dropTree();
  splitAtSteps();
  if (gaps_ && !gaps_->isEmpty()) splitAtGaps();
  context_.checkCancelled();
  std::shared_ptr<WalkableMesh> result = splits_.makeMesh(context_);
  addStepLinks(result->links);
  if (gaps_) {
    const std::vector<MeshLink> links = gaps_->links();
    result->links.insert(result->links.end(), links.begin(), links.end());
    undecided_ += gaps_->undecided();
    fallbacks_ += gaps_->fallbacks();
  }
  sortOnce(result->links);
  splits_.replaceKernel(splits_.kernel());  // collects the fall-backs that its geometry has counted
  fallbacks_ += splits_.fallbacks();
  return result;
}

}  // namespace footfall::detail
