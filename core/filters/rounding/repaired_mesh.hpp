// A rounded mesh while it is repaired: which triangles are left, what is around a vertex, and how far repairs moved it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <vector>

#include "core/base/index_and_box.hpp"
#include "core/exact/source_predicates.hpp"
#include "core/filters/rounding/rounded_mesh.hpp"

namespace footfall::detail {

/// The triangles around each vertex, in the order in which they came there. Only few vertices are ever needed, so lists
/// are made on demand.
class Surroundings {
 public:
  void build(const std::vector<MeshTriangle>& triangles, std::size_t vertexCount) {
    first_.assign(vertexCount + 1, 0);
    for (const MeshTriangle& t : triangles)
      for (const Index v : t.corners) ++first_[v + 1];
    for (std::size_t v = 0; v < vertexCount; ++v) first_[v + 1] += first_[v];
    atStart_.resize(triangles.size() * 3);
    std::vector<Index> next(first_.begin(), first_.end() - 1);
    for (Index t = 0; t < static_cast<Index>(triangles.size()); ++t)
      for (const Index v : triangles[t].corners) atStart_[next[v]++] = t;
  }
  /// References stay valid.
  std::vector<Index>& operator[](Index vertex) {
    const auto [it, isNew] = lists_.try_emplace(vertex);
    if (isNew) it->second.assign(atStart_.begin() + first_[vertex], atStart_.begin() + first_[vertex + 1]);
    return it->second;
  }
  /// Restores the state after building.
  void reset() { lists_.clear(); }

 private:
  std::vector<Index> first_, atStart_;
  std::unordered_map<Index, std::vector<Index>> lists_;
};

/// The mesh that repairs work on. Borders have the obstacle flag (markBorders()).
class RepairedMesh {
 public:
  explicit RepairedMesh(RoundedMesh& mesh) : mesh_(mesh) {}

  /// Call this before anything is repaired, if anything is.
  void start() {
    alive_.assign(mesh_.triangles.size(), 1);
    around_.build(mesh_.triangles, mesh_.vertices.size());
    for (const Vec3& v : mesh_.vertices)
      largest_ = std::max({largest_, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  }

  [[nodiscard]] const Vec3& place(Index v) const { return mesh_.vertices[v]; }
  [[nodiscard]] const MeshTriangle& operator[](Index t) const { return mesh_.triangles[t]; }
  [[nodiscard]] bool isAlive(Index t) const { return alive_[t] != 0; }
  /// The largest coordinate.
  [[nodiscard]] double largest() const { return largest_; }
  /// The triangles around a vertex; gone ones are among them.
  [[nodiscard]] const std::vector<Index>& around(Index v) { return around_[v]; }

  /// True when three places turn to the left, exactly.
  [[nodiscard]] bool isLeftTurn(Index a, Index b, Index c) const {
    const Vec3 &p = place(a), &q = place(b), &r = place(c);
    // Differences, products and the last difference lose at most 4 u (|l| + |r|) together, u = 2^-53, and the bound 2 u
    // more; underflows lose less than 2^-1000. An overflow makes the bound infinite or NaN.
    const double left = (q.x - p.x) * (r.y - p.y), right = (q.y - p.y) * (r.x - p.x);
    if (left - right > (std::fabs(left) + std::fabs(right)) * 0x1p-50 + 0x1p-1000) return true;
    return facing(p, q, r) > 0;
  }
  [[nodiscard]] bool isUpright(Index t) const {
    const auto& c = mesh_.triangles[t].corners;
    return isLeftTurn(c[0], c[1], c[2]);
  }

  /// The triangle with the edge from a to b, and the number of that edge; or -1.
  [[nodiscard]] Index across(Index a, Index b, int& k) {
    for (const Index t : around_[a]) {
      if (alive_[t] == 0) continue;
      for (k = 0; k < 3; ++k)
        if (mesh_.triangles[t].corners[k] == a && mesh_.triangles[t].corners[next(k)] == b) return t;
    }
    return -1;
  }

  /// Visits the triangles that have an edge from a to b. There is one at most, unless repairs joined needles.
  template <class Visit>
  void visitSide(Index a, Index b, const Visit& visit) {
    for (const Index t : around_[a]) {
      if (alive_[t] == 0) continue;
      for (int k = 0; k < 3; ++k)
        if (mesh_.triangles[t].corners[k] == a && mesh_.triangles[t].corners[next(k)] == b) visit(t);
    }
  }
  /// Returns whether no other triangle is on the same side of one of its edges.
  [[nodiscard]] bool isConforming(Index t) {
    int found = 0;
    for (int k = 0; k < 3; ++k)
      visitSide(mesh_.triangles[t].corners[k], mesh_.triangles[t].corners[next(k)], [&](Index) { ++found; });
    return found == 3;
  }
  /// True when the changed part is conforming.
  [[nodiscard]] bool isConforming() {
    return std::all_of(saved_.begin(), saved_.end(),
                       [&](const Saved& saved) { return !isAlive(saved.number) || isConforming(saved.number); });
  }

  // Changes, which undoAll() takes back until a triangle is added.
  void kill(Index t) {
    save(t);
    alive_[t] = 0;
  }
  void replace(Index t, const MeshTriangle& by) {
    save(t);
    for (const Index v : mesh_.triangles[t].corners)
      if (std::find(by.corners.begin(), by.corners.end(), v) == by.corners.end()) std::erase(around_[v], t);
    const std::array<Index, 3> before = mesh_.triangles[t].corners;
    mesh_.triangles[t] = by;
    for (const Index v : by.corners)
      if (std::find(before.begin(), before.end(), v) == before.end()) around_[v].push_back(t);
  }
  void setLayer(Index t, Index asOf) {
    if (!mesh_.layers.empty()) mesh_.layers[t] = mesh_.layers[asOf];
  }
  void markObstacle(Index t, int k) {
    save(t);
    mesh_.triangles[t].obstacleEdges |= static_cast<std::uint8_t>(1 << k);
  }
  /// Adds a triangle in the layer of another one.
  Index add(const MeshTriangle& triangle, Index asOf) {
    const auto t = static_cast<Index>(mesh_.triangles.size());
    saved_.clear();
    mesh_.triangles.push_back(triangle);
    if (!mesh_.layers.empty()) mesh_.layers.push_back(mesh_.layers[asOf]);
    alive_.push_back(1);
    for (const Index v : triangle.corners) around_[v].push_back(t);
    return t;
  }
  /// Restores the state at the start.
  void undoAll() {
    for (auto it = saved_.rbegin(); it != saved_.rend(); ++it) {
      mesh_.triangles[it->number] = it->triangle;
      if (!mesh_.layers.empty()) mesh_.layers[it->number] = it->layer;
      alive_[it->number] = 1;
    }
    saved_.clear();
    around_.reset();
    drifts_.clear();
  }

  /// The distance of a triangle's edges from their places before any repair.
  [[nodiscard]] double drift(Index t) const {
    const auto found = drifts_.find(t);
    return found == drifts_.end() ? 0 : found->second;
  }
  void setDrift(Index t, double drift) {
    double& own = drifts_[t];
    own = std::max(own, drift);
  }

  /// Removes what is gone.
  void compact() {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (alive_[t] == 0) continue;
      if (!mesh_.layers.empty()) mesh_.layers[kept] = mesh_.layers[t];
      mesh_.triangles[kept++] = mesh_.triangles[t];
    }
    mesh_.triangles.resize(kept);
    if (!mesh_.layers.empty()) mesh_.layers.resize(kept);
  }

 private:
  struct Saved {
    Index number = -1;
    MeshTriangle triangle;
    std::uint32_t layer = 0;
  };
  void save(Index t) { saved_.push_back({t, mesh_.triangles[t], mesh_.layers.empty() ? 0 : mesh_.layers[t]}); }

  RoundedMesh& mesh_;
  std::vector<char> alive_;
  Surroundings around_;
  std::vector<Saved> saved_;
  std::unordered_map<Index, double> drifts_;
  double largest_ = 0;
};

}  // namespace footfall::detail
