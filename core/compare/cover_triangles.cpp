// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/cover_triangles.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>

#include "core/base/disjoint_sets.hpp"

namespace footfall::detail::comparison {
namespace {

/// The area between a piece below it and one above it, from one vertical line to another.
struct Trapezoid {
  std::uint32_t below, above;  ///< indices of pieces
  double left, right;
};

class PartSweep {
 public:
  PartSweep(const std::vector<CoverPiece>& borders, Poll poll) : poll_(poll) {
    for (const CoverPiece& piece : borders)
      if (piece.from.x < piece.to.x) pieces_.push_back(piece);
    byEnd_.resize(pieces_.size());
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) byEnd_[i] = i;
    byStart_ = byEnd_;
    std::ranges::sort(byStart_, {}, [this](std::uint32_t i) { return std::pair(pieces_[i].from.x, i); });
    std::ranges::sort(byEnd_, {}, [this](std::uint32_t i) { return std::pair(pieces_[i].to.x, i); });
  }

  std::vector<CoverTriangle> run() {
    std::size_t start = 0, end = 0, rounds = 0;
    while (end < byEnd_.size()) {
      if (++rounds % 256 == 0) poll_();
      const double ending = pieces_[byEnd_[end]].to.x;
      const double x = start < byStart_.size() ? std::min(ending, pieces_[byStart_[start]].from.x) : ending;
      std::erase_if(active_, [&](std::uint32_t i) { return pieces_[i].to.x <= x; });
      while (end < byEnd_.size() && pieces_[byEnd_[end]].to.x <= x) ++end;
      while (start < byStart_.size() && pieces_[byStart_[start]].from.x <= x) active_.push_back(byStart_[start++]);
      if (end == byEnd_.size()) {
        closeAll(x, {});
        break;
      }
      const double next = start < byStart_.size() ? std::min(pieces_[byEnd_[end]].to.x, pieces_[byStart_[start]].from.x)
                                                  : pieces_[byEnd_[end]].to.x;
      closeAll(x, pairsBetween(x, next));
    }
    return triangles();
  }

 private:
  using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

  [[nodiscard]] double heightAt(std::uint32_t i, double x) const {
    const CoverCorner &a = pieces_[i].from, &b = pieces_[i].to;
    return x <= a.x ? a.y : x >= b.x ? b.y : a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y);
  }

  /// The area's pieces from below to above, in pairs.
  Pairs pairsBetween(double x, double next) {
    const double middle = x / 2 + next / 2;
    std::vector<std::pair<double, std::uint32_t>> order;
    order.reserve(active_.size());
    for (const std::uint32_t i : active_) order.emplace_back(heightAt(i, middle), i);
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < order.size(); ++i) active_[i] = order[i].second;
    Pairs pairs;
    int depth = 0;
    std::uint32_t below = 0;
    for (const std::uint32_t i : active_) {
      const int before = depth;
      depth += pieces_[i].isBelowPart ? 1 : -1;
      if (before == 0 && depth == 1) below = i;
      if (before == 1 && depth == 0) pairs.emplace_back(below, i);
    }
    return pairs;
  }

  /// Pairs that go on stay open; the others end at x, and new ones begin.
  void closeAll(double x, const Pairs& pairs) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> open;
    for (const auto& pair : pairs) {
      const auto known = open_.find(pair);
      open.emplace(pair, known == open_.end() ? x : known->second);
      if (known != open_.end()) open_.erase(known);
    }
    for (const auto& [pair, left] : open_)
      if (left < x) done_.push_back({pair.first, pair.second, left, x});
    open_ = std::move(open);
  }

  [[nodiscard]] CoverCorner cornerAt(std::uint32_t i, double x) const {
    const CoverPiece& piece = pieces_[i];
    if (x <= piece.from.x) return piece.from;
    if (x >= piece.to.x) return piece.to;
    return {x, heightAt(i, x), CoverCorner::kNoPoint};
  }

  /// Trapezoids that have a stretch of a vertical line in common are one region.
  [[nodiscard]] std::vector<std::uint32_t> regions() const {
    struct Side {
      double x, low, high;
      std::uint32_t trapezoid;
      bool isLeft;
    };
    std::vector<Side> sides;
    for (std::uint32_t i = 0; i < done_.size(); ++i) {
      const Trapezoid& t = done_[i];
      sides.push_back({t.left, heightAt(t.below, t.left), heightAt(t.above, t.left), i, true});
      sides.push_back({t.right, heightAt(t.below, t.right), heightAt(t.above, t.right), i, false});
    }
    std::ranges::sort(sides, {}, [](const Side& s) { return std::tuple(s.x, s.low, s.high, s.trapezoid); });
    DisjointSets sets(done_.size());
    for (std::size_t i = 0; i < sides.size(); ++i) {
      for (std::size_t j = i + 1; j < sides.size() && sides[j].x == sides[i].x && sides[j].low < sides[i].high; ++j) {
        if (sides[j].isLeft != sides[i].isLeft)
          sets.unite(static_cast<Index>(sides[i].trapezoid), static_cast<Index>(sides[j].trapezoid));
      }
    }
    std::vector<std::uint32_t> region(done_.size());
    std::map<Index, std::uint32_t> numbers;
    for (std::size_t i = 0; i < region.size(); ++i)
      region[i] =
          numbers.emplace(sets.find(static_cast<Index>(i)), static_cast<std::uint32_t>(numbers.size())).first->second;
    return region;
  }

  [[nodiscard]] std::vector<CoverTriangle> triangles() const {
    const std::vector<std::uint32_t> region = regions();
    std::vector<CoverTriangle> result;
    result.reserve(2 * done_.size());
    for (std::size_t i = 0; i < done_.size(); ++i) {
      const Trapezoid& t = done_[i];
      const CoverCorner a = cornerAt(t.below, t.left), b = cornerAt(t.below, t.right), c = cornerAt(t.above, t.right),
                        d = cornerAt(t.above, t.left);
      if (b.y < c.y) result.push_back({{a, b, c}, region[i]});
      if (a.y < d.y) result.push_back({{a, c, d}, region[i]});
    }
    return result;
  }

  Poll poll_;
  std::vector<CoverPiece> pieces_;
  std::vector<std::uint32_t> byStart_, byEnd_;
  std::vector<std::uint32_t> active_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> open_;  ///< open trapezoids with their left ends
  std::vector<Trapezoid> done_;
};

}  // namespace

std::vector<CoverTriangle> triangulatePart(const std::vector<CoverPiece>& borders, Poll poll) {
  return PartSweep(borders, poll).run();
}

}  // namespace footfall::detail::comparison
