// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/layers/layer_cover.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/parallel.hpp"
#include "core/exact/face_geometry.hpp"

namespace footfall::detail {
namespace {

// Scaled coordinates are below 2^37, so corners of all squares are doubles.
constexpr double kHalfSide = 0x1p37;
constexpr int kDeepest = 24;
double areaOf(const BoxTree<2>::Bounds& box) { return (box.upper[0] - box.lower[0]) * (box.upper[1] - box.lower[1]); }

constexpr std::size_t kSquaresOfPiece = 4, kPiecesPerTask = 64;
constexpr std::uint32_t kManyLayers = 8;       ///< from so many on, squares prove that pieces overlap
constexpr std::uint32_t kVeryManyLayers = 64;  ///< from so many on, four of each triangle
constexpr std::size_t kMostMiddles = 8;
constexpr std::size_t kFewTriangles = 16;  ///< most triangles of a piece without a tree
constexpr std::size_t kFewLookUps = 16;  ///< most look-ups among all triangles of a piece before a tree is made of them

}  // namespace

LayerCover::LayerCover(const LayerInput& input, const std::vector<std::span<const Index>>& pieces,
                       const IndexLists& overlaps, RunContext& context)
    : input_(input), overlaps_(overlaps), context_(context), pieces_(pieces.size()) {
  if (input.knowsAll) return;
  geometry_.emplace(*input.kernel, *input.vertices);
  forRanges(pieces.size(), kPiecesPerTask, [&](std::size_t first, std::size_t last) {
    context.checkCancelled();
    for (std::size_t p = first; p < last; ++p) pieces_[p] = pieceOf(pieces[p]);
  });
  std::vector<MemberTree::Bounds> bounds;
  bounds.reserve(pieces.size());
  for (const Piece& piece : pieces_) bounds.push_back(piece.bounds);
  added_.build(bounds, context);
}

void LayerCover::Runs::insert(std::uint32_t number) {
  auto next = runs_.upper_bound(number);
  if (next != runs_.begin()) {
    const auto before = std::prev(next);
    if (number < before->second) return;
    if (number == before->second) {
      ++before->second;
      if (next != runs_.end() && next->first == before->second) {
        before->second = next->second;
        runs_.erase(next);
      }
      return;
    }
  }
  std::uint32_t end = number + 1;
  if (next != runs_.end() && next->first == end) {
    end = next->second;
    runs_.erase(next);
  }
  runs_.emplace(number, end);
}

std::uint32_t LayerCover::Runs::firstMissing(std::uint32_t number) const {
  const auto next = runs_.upper_bound(number);
  if (next == runs_.begin()) return number;
  return std::max(number, std::prev(next)->second);
}

std::uint64_t LayerCover::keyOf(const Square& square) {
  return static_cast<std::uint64_t>(square.level) << 56 | static_cast<std::uint64_t>(square.x) << 28 | square.y;
}

// Decides by rounded coordinates with their bounds. False has no meaning.
bool LayerCover::holds(const PlanTriangle& t, double x, double y) const {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t n = (k + 1) % 3;
    if (filteredOrientation({t.x[k], t.y[k], t.error}, {t.x[n], t.y[n], t.error}, {x, y, 0},
                            input_.kernel->sign().slack) != 1)
      return false;
  }
  return true;
}

bool LayerCover::isInside(const Square& square, const PlanTriangle& t) const {
  const double side = std::ldexp(2 * kHalfSide, -square.level);
  const double left = -kHalfSide + side * square.x, bottom = -kHalfSide + side * square.y;
  for (const double x : {left, left + side})
    for (const double y : {bottom, bottom + side})
      if (!holds(t, x, y)) return false;
  return true;
}

bool LayerCover::hasMiddleIn(const Piece& piece, const Piece& other) {
  const std::size_t step = piece.all.triangles.size() / kMostMiddles + 1;
  for (std::size_t i = 0; i < piece.all.triangles.size(); i += step) {
    const PlanTriangle own = planOf(piece.all.triangles[i]);
    const double x = (own.x[0] + own.x[1] + own.x[2]) / 3, y = (own.y[0] + own.y[1] + own.y[2]) / 3;
    const BoxTree<2>::Bounds place{{x, y}, {x, y}};
    if (areApart(place, other.bounds) || !holds(own, x, y)) continue;
    Index found = -1;
    const auto test = [&](Index o) {
      if (found < 0 && holds(planOf(o), x, y)) found = o;
    };
    if (other.all.tree.size() > 0)
      other.all.tree.visitOverlapping(place, test);
    else
      for (const Index o : other.all.triangles)
        if (!areApart(place, boundsOf(o))) test(o);
    if (found < 0) continue;
    found_.push_back({piece.all.triangles[i], found});
    return true;
  }
  return false;
}

LayerCover::Piece LayerCover::pieceOf(std::span<const Index> triangles) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Piece piece;
  piece.all.triangles = triangles;
  piece.bounds = {{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
  for (const Index t : triangles) {
    const BoxTree<2>::Bounds& b = boundsOf(t);
    for (std::size_t k = 0; k < 2; ++k) {
      piece.bounds.lower[k] = std::min(piece.bounds.lower[k], b.lower[k]);
      piece.bounds.upper[k] = std::max(piece.bounds.upper[k], b.upper[k]);
    }
  }
  if (input_.group.empty()) return piece;
  GroupVote vote;
  for (const Index t : triangles) vote.add(input_.group[t]);
  piece.main = vote.main();
  for (const Index t : triangles)
    if (input_.group[t] != kSettled && (input_.group[t] < 0 || input_.group[t] != piece.main))
      piece.otherList.push_back(t);
  piece.others.triangles = piece.otherList;
  return piece;
}

void LayerCover::addSquareAt(double x, double y, const PlanTriangle& triangle, double size,
                             std::vector<Square>& squares) const {
  x += kHalfSide;
  y += kHalfSide;
  if (!(x >= 0 && y >= 0 && x < 2 * kHalfSide && y < 2 * kHalfSide)) return;
  for (int level = 0; level <= kDeepest; ++level) {
    const double side = std::ldexp(2 * kHalfSide, -level);
    const Square square{level, static_cast<std::uint32_t>(x / side), static_cast<std::uint32_t>(y / side)};
    if (side > size || !isInside(square, triangle)) continue;
    const bool isThere =
        std::any_of(squares.begin(), squares.end(), [&](const Square& other) { return keyOf(other) == keyOf(square); });
    if (!isThere) squares.push_back(square);
    return;
  }
}

std::vector<LayerCover::Square> LayerCover::squaresIn(std::span<const Index> triangles) const {
  std::vector<std::pair<double, Index>> largest;
  for (const Index t : triangles) {
    const BoxTree<2>::Bounds& b = boundsOf(t);
    const double size = std::min(b.upper[0] - b.lower[0], b.upper[1] - b.lower[1]);
    if (!std::isfinite(size)) continue;
    largest.emplace_back(-size, t);
    std::push_heap(largest.begin(), largest.end());
    if (largest.size() <= kSquaresOfPiece) continue;
    std::pop_heap(largest.begin(), largest.end());
    largest.pop_back();
  }
  std::vector<Square> squares;
  for (const auto& [size, t] : largest) {
    const PlanTriangle p = planOf(t);
    const double x = (p.x[0] + p.x[1] + p.x[2]) / 3, y = (p.y[0] + p.y[1] + p.y[2]) / 3;
    addSquareAt(x, y, p, -size, squares);
    if (layerCount() < kVeryManyLayers) continue;
    for (std::size_t k = 0; k < 3; ++k) addSquareAt((x + p.x[k]) / 2, (y + p.y[k]) / 2, p, -size, squares);
  }
  return squares;
}

void LayerCover::findSquares() {
  forRanges(pieces_.size(), kPiecesPerTask, [&](std::size_t first, std::size_t last) {
    context_.checkCancelled();
    for (std::size_t p = first; p < last; ++p) pieces_[p].inside = squaresIn(pieces_[p].all.triangles);
  });
  nodes_.clear();
  for (const std::vector<Index>& layer : layers_)
    for (const Index p : layer) addSquares(pieces_[p]);
}

void LayerCover::addSquares(const Piece& piece) {
  for (const Square& square : piece.inside) {
    nodes_[keyOf(square)].around.insert(piece.layer);
    for (Square at = square; --at.level >= 0;) {
      at.x /= 2;
      at.y /= 2;
      nodes_[keyOf(at)].within.insert(piece.layer);
    }
  }
}

void LayerCover::lookUp(const Piece& piece) {
  known_.clear();
  for (const Square& square : piece.inside) {
    if (const auto node = nodes_.find(keyOf(square)); node != nodes_.end()) known_.push_back(&node->second.within);
    for (Square at = square; at.level >= 0; at = {at.level - 1, at.x / 2, at.y / 2})
      if (const auto node = nodes_.find(keyOf(at)); node != nodes_.end()) known_.push_back(&node->second.around);
  }
}

std::uint32_t LayerCover::firstInDoubt(std::uint32_t layer) const {
  for (bool moved = true; moved;) {
    moved = false;
    for (; layer < layerCount() && blockedFor_[layer] == piece_; ++layer) moved = true;
    for (const Runs* runs : known_) {
      const std::uint32_t next = runs->firstMissing(layer);
      moved = moved || next != layer;
      layer = next;
    }
  }
  return layer;
}

void LayerCover::findNear(std::uint32_t layer) {
  for (const Near& near : near_) nearOf_[pieces_[near.piece].layer] = -1;
  near_.clear();
  nearOf_.resize(layerCount(), -1);
  if (layer >= layerCount()) return;
  if (layer + 1 == layerCount()) {  // of thousands of layers, often only the last one is in doubt
    for (const Index other : layers_[layer]) addNear(other);
    return;
  }
  added_.visitUntil(pieces_[piece_].bounds, [&](Index other) {
    if (pieces_[other].layer >= layer) addNear(other);
    return false;
  });
}

void LayerCover::addNear(Index other) {
  const BoxTree<2>::Bounds& bounds = pieces_[other].bounds;
  if (haveApartInsides(bounds, pieces_[piece_].bounds)) return;
  const auto number = static_cast<Index>(near_.size());
  Index& first = nearOf_[pieces_[other].layer];
  // A larger one is tried first: it overlaps the piece more often.
  if (first < 0 || areaOf(bounds) > areaOf(pieces_[near_[first].piece].bounds)) {
    near_.push_back({other, first});
    first = number;
  } else {
    near_.push_back({other, near_[first].next});
    near_[first].next = number;
  }
}

bool LayerCover::overlapsAnyOf(std::uint32_t layer) {
  for (Index near = nearOf_[layer]; near >= 0; near = near_[near].next)
    if (overlap(pieces_[piece_], pieces_[near_[near].piece])) return true;
  return false;
}

void LayerCover::needTree(Set& set, std::size_t lookUps) {
  set.lookUps += lookUps;
  if (set.lookUps <= kFewLookUps || set.triangles.size() <= kFewTriangles || set.tree.size() > 0) return;
  set.tree.build(
      {set.triangles.begin(), set.triangles.end()}, [&](Index t) { return boundsOf(t); }, context_);
}

bool LayerCover::overlap(Piece& piece, Piece& other) {
  if (piece.main >= 0 && piece.main == other.main)
    return overlap(piece.others, other.all) || overlap(other.others, piece.all);
  const bool isSmaller = piece.all.triangles.size() <= other.all.triangles.size();
  Piece& few = isSmaller ? piece : other;
  Piece& many = isSmaller ? other : piece;
  needTree(many.all, few.all.triangles.size());
  if (hasMiddleIn(few, many)) return true;
  std::vector<Index> near;
  for (const Index t : few.all.triangles)
    if (!haveApartInsides(boundsOf(t), many.bounds)) near.push_back(t);
  return overlapAny(near, many.all);
}

bool LayerCover::overlap(Set& some, Set& others) {
  const bool isSmaller = some.triangles.size() <= others.triangles.size();
  return overlapAny((isSmaller ? some : others).triangles, isSmaller ? others : some);
}

bool LayerCover::overlapAny(std::span<const Index> triangles, Set& set) {
  if (set.triangles.empty()) return false;
  for (const Index t : triangles) {
    context_.checkCancelled();
    const Index group = input_.group.empty() ? -1 : input_.group[t];
    if (group == kSettled) continue;
    const BoxTree<2>::Bounds& bounds = boundsOf(t);
    const PlanTriangle own = planOf(t);
    Index found = -1;
    const auto test = [&](Index o) {
      if (found >= 0 || (group >= 0 && (input_.group[o] == group || input_.group[o] == kSettled))) return;
      if (!haveApartInsides(bounds, boundsOf(o)) && geometry_->overlap(own, planOf(o))) found = o;
    };
    needTree(set, 1);
    if (set.tree.size() > 0)
      set.tree.visitOverlapping(bounds, test);
    else
      for (const Index o : set.triangles) test(o);
    if (found < 0) continue;
    found_.push_back({t, found});
    return true;
  }
  return false;
}

std::uint32_t LayerCover::firstFree(Index piece) {
  piece_ = piece;
  for (const Index other : overlaps_[piece])
    if (other < piece) blockedFor_[pieces_[other].layer] = piece;
  if (input_.knowsAll) return firstInDoubt(0);
  lookUp(pieces_[piece]);
  std::uint32_t layer = firstInDoubt(0);
  findNear(layer);
  while (layer < layerCount() && overlapsAnyOf(layer)) layer = firstInDoubt(layer + 1);
  return layer;
}

bool LayerCover::isFree(std::uint32_t layer) {
  return firstInDoubt(layer) == layer && (input_.knowsAll || !overlapsAnyOf(layer));
}

void LayerCover::add(Index piece, std::uint32_t layer) {
  if (layer == layerCount()) {
    layers_.emplace_back();
    blockedFor_.push_back(-1);
    const bool isTime = layerCount() == kManyLayers || layerCount() == kVeryManyLayers;
    if (isTime && !input_.knowsAll) findSquares();
  }
  pieces_[piece].layer = layer;
  if (input_.knowsAll) return;
  if (layerCount() >= kManyLayers) addSquares(pieces_[piece]);
  layers_[layer].push_back(piece);
  added_.insert(piece);
}

}  // namespace footfall::detail
