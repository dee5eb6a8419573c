// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts (over edges and steps) are linked where their borders come near each other (border_links.hpp). Of all chains of
// links from one part to the other, over any parts between, the result is the one whose largest link is least; the size
// of a link is what the agent lacks there (excessOf()): the larger of the gap in the plan beyond what it steps over, of
// the height that is climbed beyond its step, over what stands between, and of the height that a ceiling lacks. Walls,
// and points in which parts touch, count only where nothing else leads across, and then by distance.
//
// Sizes are rounded, and so is the choice between links whose sizes differ by rounding; it does not depend on threads.
// It is Kruskal's algorithm (a chain within a minimum spanning tree has the least largest link), over pairs of borders
// in bands of growing size, up to the agent's height. Beyond, no step is to be expected, and parts are joined one
// by one with what is nearest to them (Prim's algorithm).
//
// The sets of the two given parts are never joined: each link that would do so, in its turn, is a way. The first is the
// answer's; those that follow are other ways, once for each stretch of borders.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <queue>
#include <tuple>
#include <utility>

#include "core/base/disjoint_sets.hpp"
#include "core/base/infinity.hpp"
#include "core/base/parallel.hpp"
#include "core/base/poll.hpp"
#include "core/base/triangle_tree.hpp"
#include "core/navigation/link_obstacles.hpp"
#include "core/navigation/path_ground.hpp"
#include "footfall/path.hpp"

namespace footfall {
namespace detail {

/// The data prepared for a mesh and its environment.
struct SeparationGround {
  std::shared_ptr<const PathGround> ground;
  SurfaceParts parts;
  std::vector<SurfaceBorder> borders;
  TriangleTree tree;  ///< tree over the borders
  LinkObstacles obstacles;
  double gap = 0;  ///< width that the agent steps over
};

}  // namespace detail

using namespace detail;
namespace {

/// The box of what may have an excess of no more than `most` towards a border.
Box boxOf(const SurfaceBorder& e, double most, double step, double gap) {
  const auto low = [](double a, double b, double by) { return std::nextafter(std::min(a, b) - by, -kInfinity); };
  const auto high = [](double a, double b, double by) { return std::nextafter(std::max(a, b) + by, kInfinity); };
  const double up = std::nextafter(most + step, kInfinity),
               out = gap > 0 ? std::nextafter(most + gap, kInfinity) : most;
  return {{low(e.from.x, e.to.x, out), low(e.from.y, e.to.y, out), low(e.from.z, e.to.z, up)},
          {high(e.from.x, e.to.x, out), high(e.from.y, e.to.y, out), high(e.from.z, e.to.z, up)}};
}

/// Two borders that may be linked, by their numbers; the first is the smaller one.
struct Pair {
  double size = kInfinity;
  std::uint32_t a = 0, b = 0;
  bool isPoint = false;  ///< as large as others, but shared in no stretch of both borders
  bool operator<(const Pair& other) const {
    return std::tie(size, isPoint, a, b) < std::tie(other.size, other.isPoint, other.a, other.b);
  }
  bool operator>(const Pair& other) const { return other < *this; }
};

/// A link and the borders that it is between.
struct Join {
  BorderLink link;
  std::uint32_t a = 0, b = 0;
};

Join reversed(const Join& join) { return {detail::reversed(join.link), join.b, join.a}; }

/// One question. Parts that are linked are one set.
class SeparationSearch {
 public:
  SeparationSearch(const SeparationGround& ground, std::uint32_t from, std::uint32_t to, Poll poll)
      : ground_(ground), from_(from), to_(to), poll_(poll), sets_(ground.parts.count) {}

  std::optional<Separation> run() {
    if (!linkWithinReach() && !linkBeyond()) return std::nullopt;
    return chain();
  }

 private:
  static constexpr double kFirstBand = 1.0 / 64;  // share of the agent's height
  static constexpr double kGrowth = 4;
  static constexpr std::size_t kMostPairs = std::size_t{1} << 22;  // limit of pairs held at one time
  static constexpr std::size_t kPolled = 256;
  static constexpr int kMostJoined = 8;  // parts between two that are far from each other
  static constexpr std::size_t kMostWays = std::size_t{1} << 14;
  static constexpr std::size_t kMostOthers = 64;
  static constexpr double kAlsoLittle = 1.0 / 16;  // share of the agent's height, always allowed

  [[nodiscard]] bool isLinked() const { return !ways_.empty(); }
  /// The largest excess of another way.
  [[nodiscard]] double mostLack() const {
    return ways_.size() >= kMostWays
               ? -1
               : std::max(2 * ways_.front().link.excess, kAlsoLittle * ground_.obstacles.height());
  }
  static Index index(std::uint32_t component) { return static_cast<Index>(component); }

  /// The set of each component.
  [[nodiscard]] std::vector<Index> numberSets() {
    std::vector<Index> of(ground_.parts.count);
    for (std::size_t i = 0; i < of.size(); ++i) of[i] = sets_.find(static_cast<Index>(i));
    return of;
  }

  void accept(const Join& join) {
    const Index from = sets_.find(index(from_)), to = sets_.find(index(to_));
    const Index a = sets_.find(index(join.link.fromComponent)), b = sets_.find(index(join.link.toComponent));
    if (a == from && b == to) {
      ways_.push_back(join);
    } else if (a == to && b == from) {
      ways_.push_back(reversed(join));
    } else {
      sets_.unite(a, b);
      links_.push_back(join);
    }
  }

  /// The link of linkBetween(), with its excess; walls are not looked for yet.
  [[nodiscard]] std::optional<BorderLink> linkOf(std::uint32_t a, std::uint32_t b) const {
    auto link = linkBetween(ground_.borders[a], ground_.borders[b], ground_.obstacles.step());
    if (link) link->excess = excessOf(*link);
    return link;
  }
  [[nodiscard]] double excessOf(const BorderLink& link) const {
    return detail::excessOf(link, ground_.obstacles.height(), ground_.obstacles.step(), ground_.gap);
  }

  // --- Kruskal, as far as an agent is high

  bool linkWithinReach() {
    const double height = ground_.obstacles.height();
    double done = -1;
    for (double band = height * kFirstBand; done < height;) {
      std::vector<Pair> pairs;
      // Bands grow more slowly when very many borders lie equally near to each other.
      for (int attempt = 0; !collect(done, band, attempt < 16 ? kMostPairs : SIZE_MAX, pairs); ++attempt)
        band = std::max(done, 0.0) + (band - std::max(done, 0.0)) / 4;
      std::sort(pairs.begin(), pairs.end());
      linkInOrder(pairs, band);
      if (isLinked() && band >= mostLack()) return true;
      done = band;
      band = std::min(kGrowth * band, isLinked() ? std::min(mostLack(), height) : height);
    }
    return isLinked();
  }

  /// All pairs of different sets that are farther than `done` and not farther than `band`. False when there are more
  /// than `most`.
  bool collect(double done, double band, std::size_t most, std::vector<Pair>& pairs) {
    const std::vector<Index> sets = numberSets();
    const std::vector<SurfaceBorder>& borders = ground_.borders;
    pairs.clear();
    std::mutex access;
    std::atomic<std::size_t> count{0};
    forRanges(borders.size(), kPolled, [&](std::size_t first, std::size_t last) {
      poll_();
      if (count > most) return;
      std::vector<std::int32_t> stack;
      std::vector<Pair> found;
      for (std::size_t i = first; i < last; ++i) {
        const Box around = boxOf(borders[i], band, ground_.obstacles.step(), ground_.gap);
        ground_.tree.visitOverlapping(around, stack, [&](std::int32_t id) {
          const auto j = static_cast<std::size_t>(id);
          if (j <= i || sets[borders[i].component] == sets[borders[j].component]) return true;
          const auto a = static_cast<std::uint32_t>(i), b = static_cast<std::uint32_t>(j);
          const auto link = linkOf(a, b);
          if (link && !link->isClosed() && link->excess > done && link->excess <= band)
            found.push_back({link->excess, a, b, !link->isInterval});
          return true;
        });
      }
      if ((count += found.size()) > most) return;
      const std::scoped_lock lock(access);
      pairs.insert(pairs.end(), found.begin(), found.end());
    });
    return count <= most;
  }

  /// Links over or under something are larger by that, and wait until it is their turn.
  void linkInOrder(const std::vector<Pair>& pairs, double band) {
    std::size_t next = 0, polls = 0;
    while (next < pairs.size() || (!waiting_.empty() && waiting_.top().size <= band)) {
      if (++polls % kPolled == 0) poll_();
      const bool isWaiting = !waiting_.empty() && (next == pairs.size() || waiting_.top() < pairs[next]);
      const Pair pair = isWaiting ? waiting_.top() : pairs[next];
      if (isLinked() && pair.size > mostLack()) return;
      if (isWaiting)
        waiting_.pop();
      else
        ++next;
      const SurfaceBorder &a = ground_.borders[pair.a], &b = ground_.borders[pair.b];
      if (sets_.find(index(a.component)) == sets_.find(index(b.component))) continue;
      BorderLink link = *linkOf(pair.a, pair.b);
      if (!ground_.obstacles.lookAt(link, a, b, stack_) || link.isClosed()) continue;
      link.excess = excessOf(link);
      if (link.excess > pair.size) {
        waiting_.push({link.excess, pair.a, pair.b, pair.isPoint});
        continue;
      }
      accept({link, pair.a, pair.b});
    }
  }

  // --- Prim, from the set with fewer borders

  bool linkBeyond() {
    for (int joined = 0;; ++joined) {
      const std::vector<Index> sets = numberSets();
      std::array<std::size_t, 2> sizes{};
      for (const SurfaceBorder& border : ground_.borders)
        for (std::size_t k = 0; k < 2; ++k)
          if (sets[border.component] == sets[k == 0 ? from_ : to_]) ++sizes[k];
      if (joined == 0) fromSmaller_ = sizes[0] <= sizes[1];
      const Index own = sets[fromSmaller_ ? from_ : to_], other = sets[fromSmaller_ ? to_ : from_];
      const auto isTarget = [&](Index set) { return joined < kMostJoined ? set != own : set == other; };
      const std::optional<Pair> nearest = nearestPair(sets, own, isTarget);
      if (!nearest) return false;
      const SurfaceBorder &a = ground_.borders[nearest->a], &b = ground_.borders[nearest->b];
      BorderLink link = *linkOf(nearest->a, nearest->b);
      ground_.obstacles.lookAt(link, a, b, stack_);
      link.excess = excessOf(link);
      accept({link, nearest->a, nearest->b});
      if (isLinked()) return true;
    }
  }

  template <class IsTarget>
  std::optional<Pair> nearestPair(const std::vector<Index>& sets, Index own, const IsTarget& isTarget) {
    const std::vector<SurfaceBorder>& borders = ground_.borders;
    std::vector<std::uint32_t> asking;
    Box whole{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
    bool anyTarget = false;
    for (std::uint32_t i = 0; i < borders.size(); ++i) {
      const Box box = boxOf(borders[i], 0, 0, 0);
      for (std::size_t k = 0; k < 3; ++k) {
        whole.lower[k] = std::min(whole.lower[k], box.lower[k]);
        whole.upper[k] = std::max(whole.upper[k], box.upper[k]);
      }
      if (sets[borders[i].component] == own) asking.push_back(i);
      anyTarget = anyTarget || isTarget(sets[borders[i].component]);
    }
    if (asking.empty() || !anyTarget) return std::nullopt;
    double extent = 0;
    for (std::size_t k = 0; k < 3; ++k) extent = std::max(extent, whole.upper[k] - whole.lower[k]);
    std::optional<Pair> best;
    for (double reach = ground_.obstacles.height() * kFirstBand; !best; reach *= kGrowth) {
      for (std::size_t n = 0; n < asking.size(); ++n) {
        if (n % 64 == 0) poll_();
        visitNear(asking[n], best ? best->size : reach, [&](std::uint32_t j) {
          if (!isTarget(sets[borders[j].component])) return;
          const Pair pair = pairOf(asking[n], j);
          if (pair.size <= reach && (!best || pair < *best)) best = pair;
        });
      }
      if (reach > 4 * extent) break;
    }
    return best;
  }

  template <class Visit>
  void visitNear(std::uint32_t i, double reach, const Visit& visit) {
    ground_.tree.visitOverlapping(boxOf(ground_.borders[i], reach, ground_.obstacles.step(), ground_.gap), stack_,
                                  [&](std::int32_t id) {
                                    visit(static_cast<std::uint32_t>(id));
                                    return true;
                                  });
  }

  [[nodiscard]] Pair pairOf(std::uint32_t i, std::uint32_t j) const {
    Pair pair{kInfinity, std::min(i, j), std::max(i, j)};
    if (const auto link = linkOf(pair.a, pair.b)) {
      pair.size = link->excess;
      pair.isPoint = !link->isInterval;
    }
    return pair;
  }

  // --- The chain

  [[nodiscard]] Separation chain() {
    // Links make two trees, and the first way leads from one to the other.
    std::vector<Join> joins = links_;
    joins.push_back(ways_.front());
    std::vector<std::vector<Join>> at(ground_.parts.count);
    for (const Join& join : joins) {
      at[join.link.fromComponent].push_back(join);
      at[join.link.toComponent].push_back(reversed(join));
    }
    std::vector<std::optional<Join>> reachedBy(ground_.parts.count);
    std::queue<std::uint32_t> open({from_});
    while (!open.empty() && !reachedBy[to_]) {
      const std::uint32_t here = open.front();
      open.pop();
      for (const Join& join : at[here]) {
        const std::uint32_t next = join.link.toComponent;
        if (next == from_ || reachedBy[next]) continue;
        reachedBy[next] = join;
        open.push(next);
      }
    }
    Separation separation;
    separation.height = ground_.obstacles.height();
    separation.step = ground_.obstacles.step();
    separation.gap = ground_.gap;
    for (std::uint32_t here = to_; here != from_; here = separation.links.back().fromComponent)
      separation.links.push_back(finished(*reachedBy[here]));
    std::reverse(separation.links.begin(), separation.links.end());
    const auto rank = [](const BorderLink& link) { return std::pair(link.isClosed(), link.excess); };
    for (std::size_t i = 1; i < separation.links.size(); ++i)
      if (rank(separation.links[separation.largest]) < rank(separation.links[i])) separation.largest = i;
    if (!separation.barrier().isClosed()) addOthers(separation);
    return separation;
  }

  [[nodiscard]] BorderLink finished(const Join& join) {
    BorderLink link = join.link;
    ground_.obstacles.findTriangles(link, ground_.borders[join.a], ground_.borders[join.b], stack_);
    return link;
  }

  /// Ways between neighbouring borders on both sides are one; the least of them stands for all.
  void addOthers(Separation& separation) {
    using Ends = std::array<double, 6>;
    DisjointSets stretches(ways_.size());
    std::map<Ends, Index> wayAt;
    for (std::size_t i = 0; i < ways_.size(); ++i) {
      const SurfaceBorder &a = ground_.borders[ways_[i].a], &b = ground_.borders[ways_[i].b];
      for (const Vec3& p : {a.from, a.to})
        for (const Vec3& q : {b.from, b.to}) {
          const auto [found, isNew] = wayAt.try_emplace(Ends{p.x, p.y, p.z, q.x, q.y, q.z}, static_cast<Index>(i));
          if (!isNew) stretches.unite(found->second, static_cast<Index>(i));
        }
    }
    // Ways come least first, and the smallest number stands for its set.
    for (std::size_t i = 1; i < ways_.size() && separation.others.size() < kMostOthers; ++i)
      if (stretches.find(static_cast<Index>(i)) == static_cast<Index>(i))
        separation.others.push_back(finished(ways_[i]));
  }

  const SeparationGround& ground_;
  std::uint32_t from_, to_;
  Poll poll_;
  DisjointSets sets_;
  std::vector<Join> links_;
  std::vector<Join> ways_;  ///< ways from the set of the first part to that of the other one
  std::priority_queue<Pair, std::vector<Pair>, std::greater<>> waiting_;
  std::vector<std::int32_t> stack_;
  bool fromSmaller_ = true;
};

TriangleTree treeOver(const std::vector<SurfaceBorder>& borders, Poll poll) {
  std::vector<Box> boxes;
  std::vector<std::int32_t> ids;
  boxes.reserve(borders.size());
  for (const SurfaceBorder& border : borders) {
    boxes.push_back(boxOf(border, 0, 0, 0));
    ids.push_back(static_cast<std::int32_t>(ids.size()));
  }
  TriangleTree tree;
  if (!boxes.empty()) tree.build(boxes, ids, poll);
  return tree;
}

}  // namespace

SeparationFinder::SeparationFinder(const PathFinder& finder, std::shared_ptr<const Environment> environment,
                                   double height, double step, const RunContext* context, double gap) {
  const Poll poll(context);
  const std::shared_ptr<const PathGround>& ground = finder.inside();
  SurfaceParts parts = findSurfaceParts(*ground->mesh, ground->topology);
  std::vector<SurfaceBorder> borders = findBorders(*ground->mesh, ground->topology, parts);
  TriangleTree tree = treeOver(borders, poll);
  inside_ = std::make_unique<const SeparationGround>(
      SeparationGround{ground, std::move(parts), std::move(borders), std::move(tree),
                       LinkObstacles(std::move(environment), height, step, poll), gap});
}

SeparationFinder::~SeparationFinder() = default;

std::optional<Separation> SeparationFinder::find(std::uint32_t fromTriangle, std::uint32_t toTriangle,
                                                 const RunContext* context) const {
  const std::vector<std::uint32_t>& components = inside_->parts.of;
  for (const std::uint32_t triangle : {fromTriangle, toTriangle})
    if (triangle >= components.size())
      throw InputError(FOOTFALL_TEXT("there is no triangle %1; the mesh has %2"), triangle, components.size());
  const std::uint32_t from = components[fromTriangle], to = components[toTriangle];
  if (from == to) return std::nullopt;
  return SeparationSearch(*inside_, from, to, Poll(context)).run();
}

void addSeparation(PathResult& result, const SeparationFinder& separations, const RunContext* context) {
  if (result.status == PathStatus::NotConnected)
    result.separation = separations.find(result.start->triangle, result.target->triangle, context);
}

}  // namespace footfall
