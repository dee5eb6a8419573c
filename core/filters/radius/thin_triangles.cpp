// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/radius/thin_triangles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <tuple>
#include <vector>

#include "core/base/index_and_box.hpp"
#include "core/exact/source_predicates.hpp"

namespace footfall::detail {
namespace {

using Vertex = std::uint32_t;

constexpr double kLong = 8;       // share of the width
constexpr double kMeetings = 16;  // meetings per triangle: five times as many as levels of all kinds have
constexpr double kMostMeetings = 1 << 18;
constexpr std::size_t kPolled = 255;

class ThinTriangles {
 public:
  ThinTriangles(NavigationMesh& mesh, double width, const Poll& poll) : mesh_(mesh), width_(width), poll_(poll) {}

  void divide() {
    // About how many margins meet thin triangles, if each is as long as it is wide.
    double meetings = 0;
    for (Index t = 0; t < count(); ++t) {
      if ((t & kPolled) == 0) poll_();
      if (const int k = longestIfThin(t); k >= 0) meetings += lengthOf(t, k) / width_;
    }
    if (meetings < std::min(kMeetings * static_cast<double>(count()), kMostMeetings)) return;
    findNeighbors();
    for (Index t = 0; t < count(); ++t) enqueue(t);
    std::size_t left = 4 * mesh_.vertices.size();
    while (!queue_.empty() && left > 0) {
      const Long edge = queue_.top();
      queue_.pop();
      const int k = longestIfThin(edge.triangle);
      if (k < 0 || from(edge.triangle, k) != edge.from || to(edge.triangle, k) != edge.to) continue;
      if (neighborsOf(edge.triangle)[k] < 0 || !split(edge.triangle, k)) continue;
      --left;
      poll_();
      improve();
    }
  }

 private:
  /// An edge to be divided, the longest first; equal ones in the order of their vertices.
  struct Long {
    double length = 0;
    Vertex from = 0, to = 0;
    Index triangle = -1;
    bool operator<(const Long& other) const {
      return std::tie(length, other.from, other.to, other.triangle) < std::tie(other.length, from, to, triangle);
    }
  };

  [[nodiscard]] Index count() const { return static_cast<Index>(mesh_.triangles.size()); }
  [[nodiscard]] Vertex from(Index t, int k) const { return mesh_.triangles[t][k]; }
  [[nodiscard]] Vertex to(Index t, int k) const { return mesh_.triangles[t][next(k)]; }
  [[nodiscard]] const Vec3& place(Vertex v) const { return mesh_.vertices[v]; }
  std::array<Index, 3>& neighborsOf(Index t) { return neighbors_[t]; }
  [[nodiscard]] bool isLevel(Index t) const {
    const auto& c = mesh_.triangles[t];
    return place(c[0]).z == place(c[1]).z && place(c[1]).z == place(c[2]).z;
  }
  [[nodiscard]] double lengthOf(Index t, int k) const {
    const Vec3 &a = place(from(t, k)), &b = place(to(t, k));
    return std::hypot(b.x - a.x, b.y - a.y);
  }

  /// The longest side, or -1.
  [[nodiscard]] int longestIfThin(Index t) const {
    if (!isLevel(t)) return -1;
    int longest = 0;
    for (int k = 1; k < 3; ++k)
      if (lengthOf(t, k) > lengthOf(t, longest)) longest = k;
    const double length = lengthOf(t, longest);
    if (length <= kLong * width_) return -1;
    const Vec3 &a = place(from(t, 0)), &b = place(from(t, 1)), &c = place(from(t, 2));
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    return area < width_ * length ? longest : -1;
  }

  // Finds neighbours on level floors; none beyond obstacle edges and where more than two sides meet.
  void findNeighbors() {
    struct Side {
      Vertex low = 0, high = 0;
      Index side = -1;
    };
    std::vector<Side> sides;
    for (Index t = 0; t < count(); ++t) {
      if ((t & kPolled) == 0) poll_();
      if (!isLevel(t)) continue;
      for (int k = 0; k < 3; ++k)
        sides.push_back({std::min(from(t, k), to(t, k)), std::max(from(t, k), to(t, k)), 3 * t + k});
    }
    for (const auto& [a, b] : mesh_.obstacleEdges) sides.push_back({std::min(a, b), std::max(a, b), -1});
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
      return std::tie(a.low, a.high, a.side) < std::tie(b.low, b.high, b.side);
    });
    poll_();
    neighbors_.assign(mesh_.triangles.size(), {-1, -1, -1});
    for (std::size_t i = 0; i < sides.size();) {
      std::size_t end = i + 1;
      while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) ++end;
      const Index a = sides[i].side, b = sides[end - 1].side;
      if (end - i == 2 && a >= 0 && from(a / 3, a % 3) == to(b / 3, b % 3)) {
        neighbors_[a / 3][a % 3] = b / 3;
        neighbors_[b / 3][b % 3] = a / 3;
      }
      i = end;
    }
  }

  void enqueue(Index t) {
    const int k = longestIfThin(t);
    if (k >= 0 && neighbors_[t][k] >= 0) queue_.push({lengthOf(t, k), from(t, k), to(t, k), t});
  }

  [[nodiscard]] bool facesUp(Vertex a, Vertex b, Vertex c) const { return facing(place(a), place(b), place(c)) > 0; }

  /// The side of a neighbour that begins where this one ends.
  [[nodiscard]] int sideFrom(Index t, Vertex begin) const {
    const auto& c = mesh_.triangles[t];
    return c[0] == begin ? 0 : c[1] == begin ? 1 : 2;
  }
  void setTriangle(Index t, const Triangle& corners, const std::array<Index, 3>& neighbors) {
    mesh_.triangles[t] = corners;
    neighbors_[t] = neighbors;
    changed_.push_back(t);
  }
  /// `t` has a new number for the neighbour at its side that begins at a vertex.
  void renumber(Index t, Vertex begin, Index neighbor) {
    if (t >= 0) neighbors_[t][sideFrom(t, begin)] = neighbor;
  }

  /// Moves the last vertex about between a and b, inside the triangles at their edge, to a place of few digits: exact
  /// numbers that are made of it are short.
  bool placeBetween(Vertex a, Vertex b, Vertex c, Vertex d) {
    const Vec3 p = place(a), q = place(b);
    const auto m = static_cast<Vertex>(mesh_.vertices.size() - 1);
    int exponent = 0;
    std::frexp(width_, &exponent);
    for (int finer = 3; finer <= 15; finer += 4) {
      const double unit = std::ldexp(1.0, exponent - finer);
      mesh_.vertices[m] = {unit * std::round((p.x / 2 + q.x / 2) / unit), unit * std::round((p.y / 2 + q.y / 2) / unit),
                           p.z};
      if (facesUp(a, m, c) && facesUp(m, b, c) && facesUp(m, a, d) && facesUp(b, m, d)) return true;
    }
    return false;
  }

  bool split(Index t, int k) {
    const Index n = neighbors_[t][k];
    const Vertex a = from(t, k), b = to(t, k), c = to(t, next(k));
    const int j = sideFrom(n, b);
    const Vertex d = to(n, next(j));
    const auto m = static_cast<Vertex>(mesh_.vertices.size());
    mesh_.vertices.emplace_back();
    if (!placeBetween(a, b, c, d)) {
      mesh_.vertices.pop_back();
      return false;
    }
    const Index beyondBc = neighbors_[t][next(k)], beyondCa = neighbors_[t][previous(k)];
    const Index beyondAd = neighbors_[n][next(j)], beyondDb = neighbors_[n][previous(j)];
    const Index t2 = count(), n2 = t2 + 1;
    mesh_.triangles.resize(mesh_.triangles.size() + 2);
    neighbors_.resize(mesh_.triangles.size());
    mesh_.sourceTriangles.push_back(mesh_.sourceTriangles[t]);
    mesh_.sourceTriangles.push_back(mesh_.sourceTriangles[n]);
    setTriangle(t, {a, m, c}, {n, t2, beyondCa});
    setTriangle(t2, {m, b, c}, {n2, beyondBc, t});
    setTriangle(n, {m, a, d}, {t, beyondAd, n2});
    setTriangle(n2, {b, m, d}, {t2, n, beyondDb});
    renumber(beyondBc, c, t2);
    renumber(beyondDb, b, n2);
    return true;
  }

  /// Flips around what changed, as long as something gets better.
  void improve() {
    std::size_t left = 64 + 16 * changed_.size();
    touched_.clear();
    while (!changed_.empty()) {
      const Index t = changed_.back();
      changed_.pop_back();
      touched_.push_back(t);
      for (int k = 0; k < 3 && left > 0; ++k) {
        if (neighbors_[t][k] < 0 || !flipIfBetter(t, k)) continue;
        --left;
        break;  // both are looked at again
      }
    }
    std::sort(touched_.begin(), touched_.end());
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
    for (const Index t : touched_) enqueue(t);
  }

  bool flipIfBetter(Index t, int k) {
    const Index n = neighbors_[t][k];
    const Vertex a = from(t, k), b = to(t, k), c = to(t, next(k));
    const int j = sideFrom(n, b);
    const Vertex d = to(n, next(j));
    if (!isInCircle(place(a), place(b), place(c), place(d)) || !facesUp(a, d, c) || !facesUp(d, b, c)) return false;
    const Index beyondBc = neighbors_[t][next(k)], beyondCa = neighbors_[t][previous(k)];
    const Index beyondAd = neighbors_[n][next(j)], beyondDb = neighbors_[n][previous(j)];
    setTriangle(t, {a, d, c}, {beyondAd, n, beyondCa});
    setTriangle(n, {d, b, c}, {beyondDb, beyondBc, t});
    renumber(beyondAd, d, t);
    renumber(beyondBc, c, n);
    return true;
  }

  // Rounded, and in doubt it is not: what is flipped is better by more than a rounding, so that there is an end. Which
  // triangles cover the floor changes nothing of what is covered; that they face up is exact.
  static bool isInCircle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const double ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x, cy = c.y - d.y;
    const double aa = ax * ax + ay * ay, bb = bx * bx + by * by, cc = cx * cx + cy * cy;
    const double u = aa * (bx * cy - by * cx), v = bb * (cx * ay - cy * ax), w = cc * (ax * by - ay * bx);
    constexpr double kBetter = 1e-9;  // far more than the some ten roundings of these sums
    return u + v + w > kBetter * (std::fabs(u) + std::fabs(v) + std::fabs(w));
  }

  NavigationMesh& mesh_;
  double width_;
  Poll poll_;
  std::vector<std::array<Index, 3>> neighbors_;  ///< across the side that begins at each corner, or -1
  std::priority_queue<Long> queue_;
  std::vector<Index> changed_, touched_;
};

}  // namespace

void divideThinTriangles(NavigationMesh& product, double width, const Poll& poll) {
  if (product.layers.empty()) ThinTriangles(product, width, poll).divide();
}

}  // namespace footfall::detail
