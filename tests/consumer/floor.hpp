// The level that the programs beside this file begin with.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <footfall/environment.hpp>
#include <memory>

/// A floor of `size` x `size` squares of one metre.
inline std::shared_ptr<const footfall::Environment> floorOf(std::uint32_t size) {
  auto level = std::make_shared<footfall::Environment>();
  for (std::uint32_t y = 0; y <= size; ++y)
    for (std::uint32_t x = 0; x <= size; ++x) level->vertices.push_back({double(x), double(y), 0});
  for (std::uint32_t y = 0; y < size; ++y) {
    for (std::uint32_t x = 0; x < size; ++x) {
      const std::uint32_t a = y * (size + 1) + x, b = a + 1, c = b + size + 1, d = c - 1;
      level->triangles.push_back({a, b, c});
      level->triangles.push_back({a, c, d});
    }
  }
  return level;
}
