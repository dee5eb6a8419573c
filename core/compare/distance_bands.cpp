// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/distance_bands.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/vector.hpp"
#include "core/compare/comparison_distances.hpp"
#include "core/compare/comparison_surface.hpp"

namespace footfall::detail {
namespace {

using comparison::ComparedSurfaces;

constexpr std::size_t kPollEvery = 1024;

/// A corner of a piece, with its distance in parts of the scale: from 0 to kCount.
struct Corner {
  Vec3 place;
  double level = 0;
};
using Outline = std::vector<Corner>;

/// The part of a convex outline on one side of `level`: above it for sign 1, below it for sign -1.
Outline clip(const Outline& outline, double level, int sign) {
  Outline kept;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Corner &a = outline[i], &b = outline[i + 1 == outline.size() ? 0 : i + 1];
    const double above = sign * (a.level - level), next = sign * (b.level - level);
    if (above >= 0) kept.push_back(a);
    if ((above > 0 && next < 0) || (above < 0 && next > 0)) {
      const double share = above / (above - next);
      kept.push_back({a.place + share * (b.place - a.place), level});
    }
  }
  return kept;
}

std::size_t bandOf(double level) {
  return std::min(static_cast<std::size_t>(std::max(level, 0.0)), DistanceBands::kCount - 1);
}

class BandMaker {
 public:
  BandMaker(const ComparedSurfaces& surfaces, std::vector<double> distances)
      : surfaces_(surfaces), distances_(std::move(distances)) {
    summarize();
  }

  DistanceBands make(std::size_t mostTriangles, RunContext& context) {
    const auto& triangles = surfaces_.surfaces[0].triangles;
    std::vector<std::size_t> order(triangles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    // The triangles with the largest distances stay where there is no room for all.
    if (triangles.size() > mostTriangles)
      std::stable_sort(order.begin(), order.end(),
                       [&](std::size_t a, std::size_t b) { return highest(triangles[a]) > highest(triangles[b]); });
    std::size_t made = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (i % kPollEvery == 0) context.checkCancelled();
      if (made >= mostTriangles) {
        bands_.leftOut = order.size() - i;
        break;
      }
      made += add(triangles[order[i]]);
    }
    return std::move(bands_);
  }

 private:
  void summarize() {
    const auto& samples = surfaces_.surfaces[0].positions;
    long double sum = 0, squares = 0;
    bands_.samples = samples.size();
    bands_.largest = -1;
    for (const std::uint32_t v : samples) {
      const double d = distances_[v];
      if (d > bands_.largest) {
        bands_.largest = d;
        bands_.farthest = surfaces_.positions.places[v];
      }
      sum += d;
      squares += static_cast<long double>(d) * d;
    }
    const auto count = static_cast<long double>(samples.size());
    bands_.mean = static_cast<double>(sum / count);
    bands_.rms = static_cast<double>(std::sqrt(squares / count));
  }

  [[nodiscard]] double highest(const Triangle& t) const {
    return std::max({distances_[t[0]], distances_[t[1]], distances_[t[2]]});
  }

  [[nodiscard]] Corner corner(std::uint32_t v) const {
    const double part = bands_.largest > 0 ? distances_[v] / bands_.largest : 0;
    return {surfaces_.positions.places[v], part * static_cast<double>(DistanceBands::kCount)};
  }

  /// Returns how many pieces the triangle gave.
  std::size_t add(const Triangle& t) {
    Outline rest{corner(t[0]), corner(t[1]), corner(t[2])};
    const auto [low, high] = std::minmax({rest[0].level, rest[1].level, rest[2].level});
    const std::size_t first = bandOf(low), last = bandOf(high);
    std::size_t made = 0;
    for (std::size_t band = first; band <= last; ++band) {
      Outline piece = rest;
      if (band < last) {
        piece = clip(rest, static_cast<double>(band + 1), -1);
        rest = clip(rest, static_cast<double>(band + 1), 1);
      }
      for (std::size_t k = 2; k < piece.size(); ++k, ++made)
        bands_.triangles[band].push_back({piece[0].place, piece[k - 1].place, piece[k].place});
    }
    return made;
  }

  const ComparedSurfaces& surfaces_;
  std::vector<double> distances_;  ///< of the positions in use
  DistanceBands bands_;
};

}  // namespace

DistanceBands findDistanceBands(const NavigationMesh& from, const NavigationMesh& to, std::size_t mostTriangles,
                                RunContext& context) {
  const ComparedSurfaces surfaces = comparison::makeSurfaces(from, to, 0, context);
  if (surfaces.surfaces[0].triangles.empty() || surfaces.surfaces[1].triangles.empty()) return {};
  return BandMaker(surfaces, comparison::distancesOfPositions(surfaces, context)).make(mostTriangles, context);
}

Rgb colourOfBand(std::size_t band) {
  // The colours go from red (0) over green to blue (1) at full saturation: one component falls while the next rises.
  const double place = static_cast<double>(band) / static_cast<double>(DistanceBands::kCount - 1) * 4;
  const auto part = [](double share) { return static_cast<int>(std::lround(255 * std::clamp(share, 0.0, 1.0))); };
  return {part(2 - place), place <= 2 ? part(place) : part(4 - place), part(place - 2)};
}

}  // namespace footfall::detail
