// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/layers/layer_cover.hpp"

#include <algorithm>
#include <cmath>

#include "core/exact/face_geometry.hpp"

namespace footfall::detail {
namespace {

// Scaled coordinates are below 2^37, so corners of all squares are doubles.
constexpr double kHalfSide = 0x1p37;
constexpr int kDeepest = 24;
constexpr std::size_t kSquaresOfPiece = 4;

}  // namespace

LayerCover::LayerCover(const PlanKernel& kernel, const WalkableMesh& mesh, RunContext& context)
    : kernel_(kernel), mesh_(mesh), context_(context), geometry_(kernel, mesh.vertices) {}

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
bool LayerCover::isInside(const Square& square, const PlanTriangle& t) const {
  const double side = std::ldexp(2 * kHalfSide, -square.level);
  const double left = -kHalfSide + side * square.x, bottom = -kHalfSide + side * square.y;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t n = (k + 1) % 3;
    for (const double x : {left, left + side})
      for (const double y : {bottom, bottom + side})
        if (filteredOrientation({t.x[k], t.y[k], t.error}, {t.x[n], t.y[n], t.error}, {x, y, 0},
                                kernel_.sign().slack) != 1)
          return false;
  }
  return true;
}

LayerCover::Piece LayerCover::pieceOf(std::span<const Index> triangles) const {
  Piece piece{triangles, {}};
  std::vector<std::pair<double, Index>> largest;
  for (const Index t : triangles) {
    const BoxTree<2>::Bounds b =
        planBoundsOf(planTriangleOf(mesh_.vertices, mesh_.triangles[static_cast<std::size_t>(t)]));
    const double size = std::min(b.upper[0] - b.lower[0], b.upper[1] - b.lower[1]);
    if (!std::isfinite(size)) continue;
    largest.emplace_back(-size, t);
    std::push_heap(largest.begin(), largest.end());
    if (largest.size() <= kSquaresOfPiece) continue;
    std::pop_heap(largest.begin(), largest.end());
    largest.pop_back();
  }
  for (const auto& [size, t] : largest) {
    const PlanTriangle p = planTriangleOf(mesh_.vertices, mesh_.triangles[static_cast<std::size_t>(t)]);
    const double x = (p.x[0] + p.x[1] + p.x[2]) / 3 + kHalfSide, y = (p.y[0] + p.y[1] + p.y[2]) / 3 + kHalfSide;
    if (!(x >= 0 && y >= 0 && x < 2 * kHalfSide && y < 2 * kHalfSide)) continue;
    for (int level = 0; level <= kDeepest; ++level) {
      const double side = std::ldexp(2 * kHalfSide, -level);
      const Square square{level, static_cast<std::uint32_t>(x / side), static_cast<std::uint32_t>(y / side)};
      if (side > -size || !isInside(square, p)) continue;
      piece.inside.push_back(square);
      break;
    }
  }
  return piece;
}

std::vector<const LayerCover::Runs*> LayerCover::knownFor(const Piece& piece) const {
  std::vector<const Runs*> known;
  for (const Square& square : piece.inside) {
    if (const auto node = nodes_.find(keyOf(square)); node != nodes_.end()) known.push_back(&node->second.within);
    for (Square at = square; at.level >= 0; at = {at.level - 1, at.x / 2, at.y / 2})
      if (const auto node = nodes_.find(keyOf(at)); node != nodes_.end()) known.push_back(&node->second.around);
  }
  return known;
}

std::uint32_t LayerCover::firstInDoubt(const std::vector<const Runs*>& known, std::uint32_t layer) const {
  for (bool moved = true; moved;) {
    moved = false;
    for (const Runs* runs : known) {
      const std::uint32_t next = runs->firstMissing(layer);
      moved = moved || next != layer;
      layer = next;
    }
  }
  return layer;
}

bool LayerCover::overlaps(const Piece& piece, const GrowingTriangles& layer) {
  for (const Index t : piece.triangles) {
    context_.checkCancelled();
    const PlanTriangle own = planTriangleOf(mesh_.vertices, mesh_.triangles[static_cast<std::size_t>(t)]);
    const bool found = layer.visitUntil(own, [&](Index o) {
      context_.checkCancelled();
      return geometry_.overlap(own, planTriangleOf(mesh_.vertices, mesh_.triangles[static_cast<std::size_t>(o)]));
    });
    if (found) return true;
  }
  return false;
}

bool LayerCover::isFree(const Piece& piece, std::uint32_t layer) {
  return firstInDoubt(knownFor(piece), layer) == layer && !overlaps(piece, layers_[layer]);
}

std::uint32_t LayerCover::firstFree(const Piece& piece) {
  const std::vector<const Runs*> known = knownFor(piece);
  for (std::uint32_t layer = firstInDoubt(known, 0); layer < layerCount(); layer = firstInDoubt(known, layer + 1))
    if (!overlaps(piece, layers_[layer])) return layer;
  return layerCount();
}

void LayerCover::add(const Piece& piece, std::uint32_t layer) {
  if (layer == layerCount()) layers_.emplace_back(mesh_);
  for (const Square& square : piece.inside) {
    nodes_[keyOf(square)].around.insert(layer);
    for (Square at = square; --at.level >= 0;) {
      at.x /= 2;
      at.y /= 2;
      nodes_[keyOf(at)].within.insert(layer);
    }
  }
  layers_[layer].add(piece.triangles, context_);
}

}  // namespace footfall::detail
