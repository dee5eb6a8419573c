// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/navigation/body_search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <unordered_map>
#include <utility>

#include "core/navigation/body_gates.hpp"

namespace footfall::detail {
namespace {

/// A search that has looked at so many orders goes on from the best few of each vertex only, so that it ends.
constexpr std::size_t kManyOrders = 50000, kMostOrders = 4;

/// A length that is longer by this factor only, by rounding, may be as short.
constexpr double kSlack = 1 + 0x1p-31;

/// A way in the direction in which it is followed, without its first gates, and without its last ones.
struct BodyStep {
  explicit BodyStep(const CorridorExit& exit)
      : way(exit.way),
        firstGate(exit.firstGate),
        gateCount(exit.gateCount),
        last(gateCount),
        isForward(exit.isForward) {}

  std::uint32_t way, firstGate, gateCount;
  std::uint32_t first = 0, last;  ///< gates, in the direction
  bool isForward;
};

/// Gates of a disc, made from gates of the axis.
class GateMaker {
 public:
  GateMaker(const CorridorNetwork& network, double radius) : network_(network), least_(radius * polygonFactor()) {}

  /// Adds gates behind those from number `begin` on. A way that goes on from another one has its last gate again, in
  /// most cases.
  void add(const BodyStep& step, std::size_t begin, std::vector<AxisGate>& gates) const {
    for (std::uint32_t i = step.first; i < step.last; ++i) {
      const std::uint32_t at = step.isForward ? i : step.gateCount - 1 - i;
      const CorridorGate& gate = network_.gates()[step.firstGate + at];
      const int left = step.isForward ? 0 : 1, right = 1 - left;
      if (gates.size() > begin && gates.back().ends.leftEnd == gate.ends[left] &&
          gates.back().ends.rightEnd == gate.ends[right])
        continue;
      gates.push_back({{endOf(gate, left), endOf(gate, right), gate.ends[left], gate.ends[right], false}, gate.place});
    }
  }

 private:
  [[nodiscard]] FieldVector endOf(const CorridorGate& gate, int side) const {
    return gate.distance > least_ ? gate.border[side] + gate.away[side] * least_ : gate.place;
  }

  const CorridorNetwork& network_;
  double least_;  ///< from an end to the border
};

class BodySearch {
 public:
  BodySearch(const CorridorNetwork& network, const BodyEnd& from, const BodyEnd& to, double radius, double distance,
             Poll poll)
      : network_(network),
        gates_(network, radius),
        from_(from),
        to_(to),
        least_(distance - 8 * network.field().margin()),
        poll_(poll) {
    for (const std::uint32_t end : endsOf(to.foot.way))
      for (std::uint32_t v = end; network.wayInward(v) != kNone; v = network.otherEnd(network.wayInward(v), v))
        outward_.push_back(network.wayInward(v));
  }

  std::optional<BodyWay> find() {
    const auto widest = widestNeck(network_, from_, to_);
    if (!widest || widest->distance < least_) return std::nullopt;
    if (from_.foot.way == to_.foot.way) startAtTarget();
    for (const std::uint32_t vertex : endsOf(from_.foot.way)) start(vertex);
    while (!queue_.empty()) {
      if (++expanded_ % 64 == 0) poll_();
      const auto [least, number] = queue_.top();
      queue_.pop();
      if (labels_[number].isAtTarget) {
        if (labels_[number].isPulled) return wayOf(number);
        pullToTarget(number);
      } else if (settle(number)) {
        expand(number);
      }
    }
    return std::nullopt;
  }

 private:
  static constexpr std::uint32_t kNone = CorridorFoot::kNone;

  /// An order of ways up to a vertex, or to the target.
  struct Label {
    std::uint32_t vertex = kNone, before = kNone;
    bool isAtTarget = false, isPulled = false;
    std::size_t firstStep = 0, lastStep = 0;  ///< of `steps_`, since the label before
    std::size_t gateCount = 0;                ///< from the start
    std::size_t nearGates = 0;                ///< gates next to the start, whose discs have it
    TautCone cone;
    /// Places of the funnel's chains, of `points_`: those on the left, then those on the right.
    std::size_t firstPoint = 0, leftPoints = 0, rightPoints = 0;
    AxisGate last;     ///< gate
    double least = 0;  ///< no way to the target with this order is shorter
  };

  [[nodiscard]] std::vector<std::uint32_t> endsOf(std::uint32_t way) const {
    const CorridorWay& w = network_.ways()[way];
    if (w.from == w.to) return {w.from};
    return {w.from, w.to};
  }
  /// Numbers of gates of a way before and behind a place on it, in a direction.
  [[nodiscard]] std::uint32_t gatesBefore(std::uint32_t number, bool isForward, const CorridorFoot& foot,
                                          bool isWithin) const {
    const CorridorWay& way = network_.ways()[number];
    const double place = way.along(foot.place);
    std::uint32_t count = 0;
    for (; count < way.gateCount; ++count) {
      const std::size_t at = isForward ? count : way.gateCount - 1 - count;
      const double gate = way.along(network_.gates()[way.firstGate + at].place);
      if (isForward ? gate > place : gate < place) break;
      if (!isWithin && gate == place) break;
    }
    return count;
  }

  /// The gates of a label, all or since the one before, with those left out at the start.
  void addGates(const Label& label, std::size_t firstGate, std::vector<AxisGate>& gates) const {
    const std::size_t begin = gates.size();
    for (std::size_t s = label.firstStep; s < label.lastStep; ++s) gates_.add(steps_[s], begin, gates);
    for (std::size_t i = begin; i < gates.size(); ++i)
      if (i > begin || label.before != kNone)
        keepAhead(gates[i].ends, i > begin ? gates[i - 1].ends : labels_[label.before].last.ends);
    for (std::size_t i = begin; i < gates.size() && firstGate + (i - begin) < label.nearGates; ++i)
      gates[i].ends.isOpen = isBetween(gates[i], from_.place);
  }
  [[nodiscard]] std::size_t firstGateOf(const Label& label) const {
    return label.before == kNone ? 0 : labels_[label.before].gateCount;
  }

  /// Pulls the way of the label before through its own gates. Returns whether the shortest way may begin so.
  bool pull(Label& label) {
    const std::size_t first = firstGateOf(label);
    const bool isNear = label.before == kNone || labels_[label.before].nearGates == first;
    std::vector<AxisGate>& window = window_;
    window.clear();
    label.nearGates = label.before == kNone ? 0 : labels_[label.before].nearGates;
    addGates(label, first, window);
    for (std::size_t i = 0; isNear && i < window.size() && isInDisc(window[i], from_.place); ++i) {
      ++label.nearGates;
      window[i].ends.isOpen = isBetween(window[i], from_.place);
    }
    label.gateCount = first + window.size();
    if (!window.empty())
      label.last = window.back();
    else if (label.before != kNone)
      label.last = labels_[label.before].last;
    loadFunnel(label.before);
    for (const AxisGate& gate : window)
      if (!funnel_.pullThrough(gate.ends, [this](const TautApex& apex) { return isShortest(apex); })) return false;
    storeFunnel(label);
    return true;
  }

  void loadFunnel(std::uint32_t number) {
    if (number == kNone) {
      funnel_.apex = {{from_.place, TautPoint::kNoEnd}, 0};
      funnel_.left.assign(nullptr, 0);
      funnel_.right.assign(nullptr, 0);
      return;
    }
    const Label& label = labels_[number];
    funnel_.apex = label.cone.apex;
    funnel_.left.assign(points_.data() + label.firstPoint, label.leftPoints);
    funnel_.right.assign(points_.data() + label.firstPoint + label.leftPoints, label.rightPoints);
  }
  void storeFunnel(Label& label) {
    label.cone.apex = funnel_.apex;
    label.firstPoint = points_.size();
    label.leftPoints = funnel_.left.size();
    label.rightPoints = funnel_.right.size();
    for (const TautChain* chain : {&funnel_.left, &funnel_.right})
      for (std::size_t i = 0; i < chain->size(); ++i) points_.push_back(chain->at(i));
    if (label.leftPoints > 0) label.cone.left = funnel_.left.at(0).place;
    if (label.rightPoints > 0) label.cone.right = funnel_.right.at(0).place;
  }

  /// Puts all gates of a label from the start on into the window.
  void gatherGates(const Label& last) {
    std::vector<const Label*> labels{&last};
    while (labels.back()->before != kNone) labels.push_back(&labels_[labels.back()->before]);
    window_.clear();
    for (auto l = labels.rbegin(); l != labels.rend(); ++l) addGates(**l, firstGateOf(**l), window_);
  }

  /// Returns whether no other order has reached a bend on a shorter way.
  bool isShortest(const TautApex& apex) {
    const auto known = bends_.try_emplace(apex.point.end, apex.length).first;
    if (apex.length > known->second * kSlack) return false;
    known->second = std::min(known->second, apex.length);
    return true;
  }

  void push(Label&& label) {
    if (!pull(label)) return;
    const double before = label.before == kNone ? 0 : labels_[label.before].least;
    label.least = before;
    // A target in the disc of a gate may lie before the gate, and need not cross it.
    if (label.gateCount > 0 && !label.isAtTarget && !isInDisc(label.last, to_.place))
      label.least = std::max(before, leastThrough(label.cone, label.last, to_.place));
    queue_.emplace(label.least, static_cast<std::uint32_t>(labels_.size()));
    labels_.push_back(std::move(label));
  }

  void start(std::uint32_t vertex) {
    const std::uint32_t way = from_.foot.way;
    if (network_.neckBetween(way, from_.foot, network_.footAt(way, vertex)).distance < least_) return;
    const bool isForward = vertex == network_.ways()[way].to;
    Label label;
    label.firstStep = steps_.size();
    steps_.emplace_back(network_.exitAlong(way, isForward)).first = gatesBefore(way, isForward, from_.foot, true);
    goOn(std::move(label), way, vertex);
  }

  /// Both ends are on one way.
  void startAtTarget() {
    const std::uint32_t way = from_.foot.way;
    if (network_.neckBetween(way, from_.foot, to_.foot).distance < least_) return;
    const bool isForward = network_.ways()[way].along(from_.foot.place) <= network_.ways()[way].along(to_.foot.place);
    Label label;
    label.isAtTarget = true;
    label.firstStep = steps_.size();
    BodyStep& step = steps_.emplace_back(network_.exitAlong(way, isForward));
    step.first = gatesBefore(way, isForward, from_.foot, true);
    step.last = std::max(step.first, gatesBefore(way, isForward, to_.foot, false));
    label.lastStep = steps_.size();
    push(std::move(label));
  }

  /// Returns whether a way may lead on from a vertex to which another way led.
  [[nodiscard]] bool leadsOn(const CorridorExit& exit, std::uint32_t last) const {
    if (exit.way == last || exit.least < least_) return false;
    return !exit.isOutward || std::ranges::find(outward_, exit.way) != outward_.end();
  }

  /// Goes on where only one way leads on, and pushes the label. `way` leads to `vertex`.
  void goOn(Label&& label, std::uint32_t way, std::uint32_t vertex) {
    for (std::size_t count = 0; count < network_.ways().size(); ++count) {
      const CorridorExit* next = nullptr;
      int ways = 0;
      for (const CorridorExit& exit : network_.exitsAt(vertex)) {
        if (exit.way == to_.foot.way) ways = 2;
        if (!leadsOn(exit, way)) continue;
        ++ways;
        next = &exit;
      }
      if (ways == 0) return;
      if (ways > 1) break;
      steps_.emplace_back(*next);
      way = next->way;
      vertex = next->next;
    }
    label.lastStep = steps_.size();
    if (hasPassed(label.before, vertex)) return;
    label.vertex = vertex;
    push(std::move(label));
  }

  /// Returns whether a label is worth going on from.
  bool settle(std::uint32_t number) {
    const Label& label = labels_[number];
    const TautApex& apex = label.cone.apex;
    if (apex.point.end != TautPoint::kNoEnd && apex.length > bends_.at(apex.point.end) * kSlack) return false;
    const Arrival own = arrivalAt(label.cone, label.last);
    const FieldVector left = label.last.ends.left, right = label.last.ends.right;
    std::vector<Arrival>& arrivals = arrivals_[label.vertex];
    if (expanded_ > kManyOrders && arrivals.size() >= kMostOrders) return false;
    for (const Arrival& other : arrivals) {
      const double across = std::max(lengthOf(left - other.place), lengthOf(right - other.place));
      if (own.least > (other.length + across) * kSlack) return false;
    }
    arrivals.push_back(own);
    return true;
  }

  [[nodiscard]] bool hasPassed(std::uint32_t number, std::uint32_t vertex) const {
    for (; number != kNone; number = labels_[number].before)
      if (labels_[number].vertex == vertex) return true;
    return false;
  }

  void expand(std::uint32_t number) {
    const std::uint32_t vertex = labels_[number].vertex, last = steps_[labels_[number].lastStep - 1].way;
    for (const CorridorExit& exit : network_.exitsAt(vertex)) {
      const std::uint32_t way = exit.way;
      if (way == to_.foot.way && network_.neckBetween(way, network_.footAt(way, vertex), to_.foot).distance >= least_) {
        Label label;
        label.before = number;
        label.isAtTarget = true;
        label.firstStep = steps_.size();
        steps_.emplace_back(exit).last = gatesBefore(way, exit.isForward, to_.foot, false);
        label.lastStep = steps_.size();
        push(std::move(label));
      }
      if (!leadsOn(exit, last)) continue;
      Label label;
      label.before = number;
      label.firstStep = steps_.size();
      steps_.emplace_back(exit);
      goOn(std::move(label), way, exit.next);
    }
  }

  /// The taut way to the target, through all gates of a label but those next to the target that it need not cross.
  std::vector<TautApex> pulled(std::uint32_t number) {
    gatherGates(labels_[number]);
    for (auto gate = window_.rbegin(); gate != window_.rend() && isInDisc(*gate, to_.place); ++gate)
      gate->ends.isOpen = gate->ends.isOpen || isBetween(*gate, to_.place);
    window_.push_back({{to_.place, to_.place, TautPoint::kNoEnd, TautPoint::kNoEnd, false}, to_.place});
    loadFunnel(kNone);
    std::vector<TautApex> passed{funnel_.apex};
    for (const AxisGate& gate : window_)
      funnel_.pullThrough(gate.ends, [&passed](const TautApex& apex) {
        passed.push_back(apex);
        return true;
      });
    // The funnel ends at the target, so one of its chains leads there.
    for (const TautChain* chain : {&funnel_.left, &funnel_.right})
      for (std::size_t i = 0; i < chain->size() && (chain == &funnel_.left || funnel_.left.size() == 0); ++i)
        passed.push_back({chain->at(i), passed.back().lengthTo(chain->at(i).place)});
    if (lengthOf(to_.place - passed.back().point.place) > 0 || passed.size() == 1)
      passed.push_back({{to_.place, TautPoint::kNoEnd}, passed.back().lengthTo(to_.place)});
    return passed;
  }

  void pullToTarget(std::uint32_t number) {
    Label& label = labels_[number];
    label.isPulled = true;
    label.least = std::max(label.least, pulled(number).back().length);
    queue_.emplace(label.least, number);
  }

  /// The way again, from its start.
  [[nodiscard]] BodyWay wayOf(std::uint32_t number) {
    BodyWay way;
    for (const TautApex& bend : pulled(number)) way.corners.push_back(bend.point.place);
    way.expanded = expanded_;
    const auto pass = [&](std::uint32_t w, const CorridorFoot& a, const CorridorFoot& b) {
      const CorridorNeck neck = network_.neckBetween(w, a, b);
      if (neck.distance < way.neck.distance) way.neck = neck;
    };
    for (std::uint32_t n = number; n != kNone; n = labels_[n].before) {
      const Label& label = labels_[n];
      for (std::size_t s = label.lastStep; s-- > label.firstStep;) {
        const std::uint32_t w = steps_[s].way;
        const CorridorWay& corridor = network_.ways()[w];
        const bool isFirst = label.before == kNone && s == label.firstStep;
        const bool isLast = label.isAtTarget && s + 1 == label.lastStep;
        const std::uint32_t begin = steps_[s].isForward ? corridor.from : corridor.to;
        const std::uint32_t end = steps_[s].isForward ? corridor.to : corridor.from;
        pass(w, isFirst ? from_.foot : network_.footAt(w, begin), isLast ? to_.foot : network_.footAt(w, end));
      }
    }
    return way;
  }

  const CorridorNetwork& network_;
  GateMaker gates_;
  BodyEnd from_, to_;
  double least_;
  Poll poll_;
  std::vector<std::uint32_t> outward_;  ///< ways that lead to the target from the cycles of its part
  std::vector<BodyStep> steps_;
  std::vector<Label> labels_;
  std::vector<AxisGate> window_;
  std::vector<TautPoint> points_;
  TautFunnel funnel_;
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
  std::unordered_map<std::uint32_t, double> bends_;  ///< of each end of a gate, the shortest way to it
  std::unordered_map<std::uint32_t, std::vector<Arrival>> arrivals_;
  std::size_t expanded_ = 0;
};

}  // namespace

double polygonFactor() {
  static const double factor = 1 / std::cos(CorridorNetwork::kTurn / 2);
  return factor;
}

std::optional<BodyWay> findBodyWay(const CorridorNetwork& network, const BodyEnd& from, const BodyEnd& to,
                                   double radius, double distance, Poll poll) {
  return BodySearch(network, from, to, radius, distance, poll).find();
}

std::optional<CorridorNeck> widestNeck(const CorridorNetwork& network, const BodyEnd& from, const BodyEnd& to) {
  std::optional<CorridorNeck> best;
  if (from.foot.way == to.foot.way) best = network.neckBetween(from.foot.way, from.foot, to.foot);
  const CorridorWay &first = network.ways()[from.foot.way], &last = network.ways()[to.foot.way];
  for (const std::uint32_t a : {first.from, first.to})
    for (const std::uint32_t b : {last.from, last.to}) {
      const auto route = network.widestRoute(a, b);
      if (!route) continue;
      CorridorNeck neck = network.neckBetween(from.foot.way, from.foot, network.footAt(from.foot.way, a));
      const CorridorNeck end = network.neckBetween(to.foot.way, network.footAt(to.foot.way, b), to.foot);
      if (end.distance < neck.distance) neck = end;
      if (*route != CorridorFoot::kNone) {
        const CorridorWay& way = network.ways()[*route];
        const CorridorNeck middle =
            network.neckBetween(*route, network.footAt(*route, way.from), network.footAt(*route, way.to));
        if (middle.distance < neck.distance) neck = middle;
      }
      if (!best || neck.distance > best->distance) best = neck;
    }
  return best;
}

}  // namespace footfall::detail
