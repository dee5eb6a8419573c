// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/navigation/path_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <unordered_map>
#include <utility>

#include "core/exact/source_predicates.hpp"
#include "core/navigation/plan_crossing.hpp"
#include "core/navigation/plan_distance.hpp"

namespace footfall::detail {
namespace {

/// A directed line through two given points; points are fans, or kNoElement for the start.
struct Line {
  std::uint32_t from = kNoElement, to = kNoElement;
  bool operator==(const Line&) const = default;
};

/// Seen from `root`, through the side of `triangle`, between the lines `left` and `right`. Looking into the triangle,
/// the side's first corner is at the left. The root is never on the line of the side, except where it is one of its
/// two ends: then all of the triangle is in sight, and the line at that end does not matter.
struct Node {
  double length = 0;  ///< length from the start to the root
  std::uint32_t triangle = 0;
  std::uint32_t root = kNoElement;
  Line left, right;
  std::int32_t parent = -1;
  std::uint8_t side = 0;
  bool leftAtEnd = false, rightAtEnd = false;  ///< the side is in sight up to this end
  bool isFinal = false;                        ///< the goal is in sight, from the root or from `bend`
  std::uint32_t bend = kNoElement;
};

/// Lengths differ by no more than this share of themselves where only rounding tells them apart; see isOvertaken().
constexpr double kRounding = 0x1p-31;

/// How a root has been reached.
struct Reached {
  double length = std::numeric_limits<double>::infinity();  ///< the shortest one
  std::int32_t by = -1;                                     ///< the node from which it was reached last
  bool isOften = false;                                     ///< from several nodes, on ways of nearly that length
};

/// The view of a node: two nodes with equal views have the same paths behind them. Lines at ends are left out, as the
/// root and the end determine them.
struct View {
  std::uint32_t triangle, side, root;
  Line left, right;
  bool leftAtEnd, rightAtEnd;

  explicit View(const Node& node)
      : triangle(node.triangle),
        side(node.side),
        root(node.root),
        left(node.leftAtEnd ? Line{} : node.left),
        right(node.rightAtEnd ? Line{} : node.right),
        leftAtEnd(node.leftAtEnd),
        rightAtEnd(node.rightAtEnd) {}
  bool operator==(const View&) const = default;
};

struct ViewHash {
  std::size_t operator()(const View& view) const {
    std::uint64_t hash = 0;
    for (const std::uint32_t part : {view.triangle, view.side, view.root, view.left.from, view.left.to, view.right.from,
                                     view.right.to, view.leftAtEnd + 2U * view.rightAtEnd})
      hash = (hash ^ part) * 0x9E3779B97F4A7C15U;
    return static_cast<std::size_t>(hash ^ (hash >> 32));
  }
};

class Search {
 public:
  Search(const NavigationMesh& mesh, const SurfaceTopology& topology, const Vec3& start, const Vec3& goal)
      : mesh_(mesh), topology_(topology), start_(start), goal_(goal), reached_(topology.fanVertices.size()) {}

  SidePath run(std::uint32_t startTriangle, std::uint32_t goalTriangle, Poll poll) {
    goalTriangles_ = trianglesAt(goal_, goalTriangle);
    const std::vector<std::uint32_t> startTriangles = trianglesAt(start_, startTriangle);
    SidePath path;
    for (const std::uint32_t t : startTriangles) {
      if (!isGoal(t)) continue;
      path.found = true;
      path.startTriangle = t;
      return path;
    }
    for (const std::uint32_t t : startTriangles) leave(t, startTriangles);
    while (!open_.empty()) {
      const auto index = open_.top().second;
      open_.pop();
      if (++path.expanded % 1024 == 0) poll();
      if (nodes_[index].isFinal) {
        trace(index, path);
        return path;
      }
      const Node node = nodes_[index];
      if (!isOvertaken(node)) expand(node, index);
    }
    return path;
  }

 private:
  [[nodiscard]] const Vec3& point(std::uint32_t fan) const {
    return fan == kNoElement ? start_ : mesh_.vertices[topology_.fanVertices[fan]];
  }
  [[nodiscard]] int sideOf(const Line& line, const Vec3& p) const {
    return facing(point(line.from), point(line.to), p);
  }

  [[nodiscard]] bool isGoal(std::uint32_t t) const {
    return std::find(goalTriangles_.begin(), goalTriangles_.end(), t) != goalTriangles_.end();
  }

  /// The triangles around the corner or at the side on which p lies, `t` first; or t alone.
  [[nodiscard]] std::vector<std::uint32_t> trianglesAt(const Vec3& p, std::uint32_t t) const {
    std::vector<std::uint32_t> found{t};
    for (int i = 0; i < 3; ++i) {
      const Vec3& corner = point(topology_.fans[t][i]);
      if (corner.x == p.x && corner.y == p.y) {
        addFan(topology_.fans[t][i], found);
        return found;
      }
    }
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t behind = topology_.neighbours[t][i];
      if (behind != kNoElement && facing(point(topology_.fans[t][i]), point(topology_.fans[t][(i + 1) % 3]), p) == 0)
        found.push_back(behind);
    }
    return found;
  }

  void addFan(std::uint32_t fan, std::vector<std::uint32_t>& found) const {
    for (std::size_t next = 0; next < found.size(); ++next) {
      const std::uint32_t t = found[next];
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t behind = topology_.neighbours[t][i];
        if (behind == kNoElement || (topology_.fans[t][i] != fan && topology_.fans[t][(i + 1) % 3] != fan)) continue;
        if (std::find(found.begin(), found.end(), behind) == found.end()) found.push_back(behind);
      }
    }
  }

  /// Leaves the start, which lies in `t`, through all sides that do not lead to another of its triangles.
  void leave(std::uint32_t t, const std::vector<std::uint32_t>& startTriangles) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t behind = topology_.neighbours[t][i];
      if (behind == kNoElement ||
          std::find(startTriangles.begin(), startTriangles.end(), behind) != startTriangles.end())
        continue;
      const std::uint32_t right = topology_.fans[t][i], left = topology_.fans[t][(i + 1) % 3];
      const Vec3 &a = point(right), &b = point(left);
      // The start is on this side or its line, but not at a shared corner: it is seen from other triangles.
      if (facing(a, b, start_) == 0) continue;
      Node node;
      node.left = {kNoElement, left};
      node.right = {kNoElement, right};
      node.leftAtEnd = node.rightAtEnd = true;
      push(node, t, i, -1);
    }
  }

  /// Enters what lies behind `side` of `t`.
  void push(Node node, std::uint32_t t, int side, std::int32_t parent) {
    node.triangle = topology_.neighbours[t][side];
    if (node.triangle == kNoElement) return;
    node.side = static_cast<std::uint8_t>(topology_.sideBehind(t, side));
    node.parent = parent;
    if (node.root != kNoElement) {
      if (isOvertaken(node)) return;
      Reached& reached = reached_[node.root];
      if (nodes_[parent].root != node.root) {
        const bool isAsLong = reached.length <= node.length * (1 + kRounding);
        reached.isOften = isAsLong && (reached.isOften || reached.by != parent);
        reached.by = parent;
      }
      reached.length = std::min(reached.length, node.length);
      if (reached.isOften && !isShortest(node)) return;
    }
    double bound = node.length + leastLength(node);
    if (!(bound >= node.length)) bound = node.length;  // not a number: coordinates so small that squares vanish
    open_.emplace(-bound, static_cast<std::int32_t>(nodes_.size()));
    nodes_.push_back(node);
  }

  /// The root has been reached on a shorter way, so whatever comes behind it has too. Lengths are sums of rounded
  /// numbers, fewer than 2^20 in any mesh that fits into memory: they are off by less than 2^-32 of themselves, and
  /// what is only longer by this may be as short and stays.
  [[nodiscard]] bool isOvertaken(const Node& node) const {
    return node.root != kNoElement && node.length > reached_[node.root].length * (1 + kRounding);
  }

  /// Returns true where no node with the same view that was compared here is as short. Only views of roots that
  /// were reached several times on ways of nearly one length need it. Corners that lie closer together than
  /// isOvertaken() tells apart, and blocks in rows, would otherwise be searched once for each combination of such ways.
  bool isShortest(const Node& node) {
    const auto [known, isNew] = views_.try_emplace(View(node), node.length);
    if (isNew) return true;
    if (node.length >= known->second) return false;
    known->second = node.length;
    return true;
  }

  /// A lower bound of the length from the root through the interval to the goal, but for rounding.
  [[nodiscard]] double leastLength(const Node& node) const {
    const auto& fans = topology_.fans[node.triangle];
    const std::uint32_t leftFan = fans[node.side], rightFan = fans[(node.side + 1) % 3];
    const Vec3 &l = point(leftFan), &r = point(rightFan), &root = point(node.root);
    Vec3 goal = goal_;
    const double dx = r.x - l.x, dy = r.y - l.y;
    if (const double behind = dx * (goal.y - l.y) - dy * (goal.x - l.x); behind < 0) {  // must be met from behind
      const double twice = 2 * behind / (dx * dx + dy * dy);
      goal.x += twice * dy;
      goal.y -= twice * dx;
    }
    if (node.root == leftFan || node.root == rightFan) return planDistance(root, goal);
    const Vec3 leftEnd = node.leftAtEnd ? l : endOn(node.left, l, r);
    const Vec3 rightEnd = node.rightAtEnd ? r : endOn(node.right, l, r);
    if (turns(root, leftEnd, goal) > 0) return planDistance(root, leftEnd) + planDistance(leftEnd, goal);
    if (turns(root, rightEnd, goal) < 0) return planDistance(root, rightEnd) + planDistance(rightEnd, goal);
    return planDistance(root, goal);
  }

  [[nodiscard]] Vec3 endOn(const Line& line, const Vec3& l, const Vec3& r) const {
    return pointBetween(l, r, crossingParameter(point(line.from), point(line.to), l, r));
  }

  static double turns(const Vec3& a, const Vec3& b, const Vec3& p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  }

  void expand(const Node& node, std::int32_t index) {
    const std::uint32_t t = node.triangle;
    const int rightSide = (node.side + 1) % 3, leftSide = (node.side + 2) % 3;
    const std::uint32_t left = topology_.fans[t][node.side];
    const std::uint32_t right = topology_.fans[t][rightSide], apex = topology_.fans[t][leftSide];
    const bool canTurnLeft = node.leftAtEnd && node.root != left && topology_.isOpen[left] != 0;
    const bool canTurnRight = node.rightAtEnd && node.root != right && topology_.isOpen[right] != 0;
    if (isGoal(t)) reachGoal(node, index, canTurnLeft ? left : kNoElement, canTurnRight ? right : kNoElement);

    const int ofLeft = node.root == left ? -1 : sideOf(node.left, point(apex));
    const int ofRight = node.root == right ? 1 : sideOf(node.right, point(apex));
    if (ofLeft < 0) {
      Node next = node;
      next.rightAtEnd = ofRight >= 0;
      if (next.rightAtEnd) next.right = {node.root, apex};
      push(next, t, leftSide, index);
    }
    if (ofRight > 0) {
      Node next = node;
      next.leftAtEnd = ofLeft <= 0;
      if (next.leftAtEnd) next.left = {node.root, apex};
      push(next, t, rightSide, index);
    }
    // Out of sight, around an end of the interval on the border of the surface. An apex exactly on the line makes its
    // side a part of that line: what lies behind it is out of sight as well.
    if (canTurnLeft && ofLeft >= 0) {
      Node next = node;
      next.root = left;
      next.length = node.length + planDistance(point(node.root), point(left));
      next.leftAtEnd = next.rightAtEnd = true;
      next.left = next.right = {left, apex};
      push(next, t, leftSide, index);
      if (ofLeft > 0) {
        next.right = {node.root, left};
        next.rightAtEnd = false;
        push(next, t, rightSide, index);
      }
    }
    if (canTurnRight && ofRight <= 0) {
      Node next = node;
      next.root = right;
      next.length = node.length + planDistance(point(node.root), point(right));
      next.leftAtEnd = next.rightAtEnd = true;
      next.left = next.right = {right, apex};
      push(next, t, rightSide, index);
      if (ofRight < 0) {
        next.left = {node.root, right};
        next.leftAtEnd = false;
        push(next, t, leftSide, index);
      }
    }
  }

  void reachGoal(const Node& node, std::int32_t index, std::uint32_t leftBend, std::uint32_t rightBend) {
    const auto& fans = topology_.fans[node.triangle];
    Node last = node;
    last.isFinal = true;
    last.parent = index;
    if (node.root != fans[node.side] && sideOf(node.left, goal_) > 0) {
      if (leftBend == kNoElement) return;
      last.bend = leftBend;
    } else if (node.root != fans[(node.side + 1) % 3] && sideOf(node.right, goal_) < 0) {
      if (rightBend == kNoElement) return;
      last.bend = rightBend;
    }
    if (last.bend != kNoElement) last.length += planDistance(point(node.root), point(last.bend));
    last.length += planDistance(point(last.bend == kNoElement ? node.root : last.bend), goal_);
    open_.emplace(-last.length, static_cast<std::int32_t>(nodes_.size()));
    nodes_.push_back(last);
  }

  void trace(std::int32_t index, SidePath& path) const {
    path.found = true;
    path.lastBend = nodes_[index].bend;
    for (std::int32_t i = nodes_[index].parent; i >= 0; i = nodes_[i].parent)
      path.crossings.push_back({nodes_[i].triangle, nodes_[i].side, nodes_[i].root});
    std::reverse(path.crossings.begin(), path.crossings.end());
    path.startTriangle = topology_.neighbours[path.crossings.front().triangle][path.crossings.front().side];
  }

  const NavigationMesh& mesh_;
  const SurfaceTopology& topology_;
  Vec3 start_, goal_;
  std::vector<std::uint32_t> goalTriangles_;
  std::vector<Node> nodes_;
  std::vector<Reached> reached_;                      ///< each fan, as a root
  std::unordered_map<View, double, ViewHash> views_;  ///< the shortest length to the root of each view
  /// The largest first: minus the least length, then the newest node, which is the nearest to a goal.
  std::priority_queue<std::pair<double, std::int32_t>> open_;
};

}  // namespace

SidePath searchPath(const NavigationMesh& mesh, const SurfaceTopology& topology, const Vec3& start,
                    std::uint32_t startTriangle, const Vec3& goal, std::uint32_t goalTriangle, Poll poll) {
  return Search(mesh, topology, start, goal).run(startTriangle, goalTriangle, poll);
}

}  // namespace footfall::detail
