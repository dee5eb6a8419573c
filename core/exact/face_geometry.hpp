// The points and lines that meet on one floor triangle, with their exact predicates. Reused from face to face by one
// thread.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/exact/plan_kernel.hpp"

namespace footfall {

/// Open-addressing table that numbers distinct keys in the order of their arrival.
template <class Key>
class NumberedTable {
 public:
  void clear() {
    keys_.clear();
    slots_.assign(kFirstSlots, -1);
  }
  /// The number of `key`, and whether it is new.
  std::pair<Index, bool> insert(const Key& key) {
    if (keys_.size() * 2 >= slots_.size()) grow();
    std::size_t slot = hash(key) & (slots_.size() - 1);
    for (; slots_[slot] >= 0; slot = (slot + 1) & (slots_.size() - 1))
      if (keys_[slots_[slot]] == key) return {slots_[slot], false};
    slots_[slot] = static_cast<Index>(keys_.size());
    keys_.push_back(key);
    return {slots_[slot], true};
  }
  const Key& operator[](Index i) const { return keys_[i]; }
  [[nodiscard]] std::size_t size() const { return keys_.size(); }

 private:
  static constexpr std::size_t kFirstSlots = 64;
  static std::uint64_t hash(const Key& key) {
    static_assert(sizeof(Key) % sizeof(Index) == 0);
    const auto* words = reinterpret_cast<const Index*>(&key);
    std::uint64_t h = 0x243F6A8885A308D3ULL;
    for (std::size_t i = 0; i < sizeof(Key) / sizeof(Index); ++i) {
      h = (h ^ static_cast<std::uint32_t>(words[i])) * 0x9E3779B97F4A7C15ULL;
      h ^= h >> 29;
    }
    return h;
  }
  void grow() {
    slots_.assign(slots_.size() < kFirstSlots ? kFirstSlots : slots_.size() * 2, -1);
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      std::size_t slot = hash(keys_[i]) & (slots_.size() - 1);
      while (slots_[slot] >= 0) slot = (slot + 1) & (slots_.size() - 1);
      slots_[slot] = static_cast<Index>(i);
    }
  }
  std::vector<Key> keys_;
  std::vector<Index> slots_;
};

class FaceGeometry {
 public:
  explicit FaceGeometry(const PlanKernel& kernel) : kernel_(kernel) {}

  /// Starts on a face: its corners become the points 0, 1, 2 and its edges (corner k to k + 1) the lines 0, 1, 2.
  void start(Index face);

  [[nodiscard]] const PlanKernel& kernel() const { return kernel_; }
  [[nodiscard]] Index face() const { return face_; }
  [[nodiscard]] Index origin() const { return origin_; }

  Index point(const PlanPoint& p);
  Index line(const PlanLine& l);
  /// The line of a source edge, by the plan ids of its ends (different ones).
  Index edgeLine(Index planA, Index planB);
  [[nodiscard]] const PlanPoint& operator[](Index point) const { return points_[point]; }
  [[nodiscard]] const PlanLine& lineAt(Index line) const { return lines_[line]; }
  [[nodiscard]] std::size_t pointCount() const { return points_.size(); }
  [[nodiscard]] std::size_t lineCount() const { return lines_.size(); }

  /// Bit k: the point is known to lie on the face's edge k.
  [[nodiscard]] std::uint8_t border(Index point) const { return border_[point]; }
  void addBorder(Index point, std::uint8_t mask) { border_[point] |= mask; }
  /// +1 when the face's edge k runs along its line's direction, -1 against it.
  [[nodiscard]] int edgeDirection(int k) const { return edgeDirection_[k]; }

  /// The crossing of two lines that are not parallel, in canonical form.
  Index crossing(Index line1, Index line2);

  /// Sign of the line at the point: +1 left of it.
  int side(Index line, Index point);
  /// Side of the face's edge k: +1 inside, 0 on it.
  int sideOfEdge(int k, Index point);
  int orientation(Index a, Index b, Index c);
  int compare(Index a, Index b, int axis);

  [[nodiscard]] const ApproximatePoint& approximate(Index point) const { return approximate_[point]; }

  ExactFallbacks fallbacks;

 private:
  struct ApproximateLine {
    double a = 0, b = 0, c = 0, errorA = -1, errorB = 0, errorC = 0;
  };
  [[nodiscard]] bool isCornerOf(Index triangle, Index vertex) const;
  /// Provenance: the point was made on that line.
  [[nodiscard]] bool isKnownOn(const PlanLine& line, const PlanPoint& point) const;
  const Homogeneous<mpz_class>& exact(Index point);
  const std::array<mpz_class, 3>& exactLine(Index line);

  const PlanKernel& kernel_;
  Index face_ = -1;
  Index origin_ = -1;
  std::array<int, 3> edgeDirection_{};
  NumberedTable<PlanPoint> points_;
  NumberedTable<PlanLine> lines_;
  std::vector<Homogeneous<ErrorDouble>> homogeneous_;
  std::vector<ApproximatePoint> approximate_;
  std::vector<std::uint8_t> border_;
  std::vector<ApproximateLine> approximateLines_;
  std::vector<std::array<ErrorDouble, 3>> coefficients_;
  std::unordered_map<Index, Homogeneous<mpz_class>> exactPoints_;
  std::unordered_map<Index, std::array<mpz_class, 3>> exactLines_;
};

/// Orientation of three rounded points relative to one origin, or kUnknownSign.
int filteredOrientation(const ApproximatePoint& a, const ApproximatePoint& b, const ApproximatePoint& c, double slack);

}  // namespace footfall
