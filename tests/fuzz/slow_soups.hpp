// Soups that may take long, and others made of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "footfall/environment.hpp"

namespace footfall::fuzz {

using Triangles = std::vector<std::array<Vec3, 3>>;

/// Makes and changes soups of at most `most` triangles. What it does follows from the seed alone, on any machine.
class SlowSoups {
 public:
  /// `noisy`: every second soup has coordinates that are off by their last bits as floats.
  SlowSoups(std::uint64_t seed, std::size_t most, bool noisy = false) : engine_(seed), most_(most), noisy_(noisy) {}

  /// Inputs that cause much work: floors above each other, slabs or blades over a floor, needles, walls, ramps, crates
  /// at all angles, furniture.
  Triangles make();
  /// A soup with a few runs of its triangles copied, moved, turned, stretched or snapped, or taken from `other`.
  Triangles mutate(const Triangles& soup, const Triangles& other);

 private:
  double number(double low, double high);
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
  void change(Triangles& soup, std::size_t first, std::size_t last);
  void addNoise(Triangles& soup, std::size_t first, std::size_t last);

  std::mt19937_64 engine_;
  std::size_t most_;
  bool noisy_;
};

}  // namespace footfall::fuzz
