// rapidcheck generators of small soups that shrink to smaller ones, and how often suites try.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <rapidcheck.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "tests/support/soup.hpp"

namespace footfall::test {

/// The number of cases of a property: `usual`, times the environment variable FOOTFALL_TEST_ROUNDS (default 1).
inline int rounds(int usual) {
  const char* text = std::getenv("FOOTFALL_TEST_ROUNDS");
  const double factor = text != nullptr ? std::atof(text) : 1;
  return std::max(1, static_cast<int>(usual * (factor > 0 ? factor : 1)));
}

/// The seed of random cases: fixed, so that every run of a suite is the same, unless the environment variable
/// FOOTFALL_TEST_SEED chooses another.
inline std::uint64_t seed() {
  const char* text = std::getenv("FOOTFALL_TEST_SEED");
  return text != nullptr ? std::strtoull(text, nullptr, 10) : 20240229;
}

/// rc::check with a number of cases of its own and the seed above.
template <class Property>
bool check(const std::string& name, int cases, Property property) {
  rc::detail::TestParams params;
  params.maxSuccess = rounds(cases);
  params.seed = seed();
  const auto result = rc::detail::checkTestable(property, rc::detail::TestMetadata{name, name}, params);
  std::cerr << name << ": ";
  rc::detail::printResultMessage(result, std::cerr);
  std::cerr << std::endl;
  return result.template is<rc::detail::SuccessResult>();
}

/// Numbers that decide the corners of one triangle.
using TriangleNumbers = std::array<int, 9>;

template <class T>
rc::Gen<std::vector<T>> upTo(int size, rc::Gen<T> element) {
  return rc::gen::resize(size, rc::gen::container<std::vector<T>>(rc::gen::resize(rc::kNominalSize, element)));
}

inline rc::Gen<int> below(int count) { return rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, count)); }

template <std::size_t N>
rc::Gen<std::array<int, N>> numbersBelow(int count) {
  return rc::gen::container<std::array<int, N>>(below(count));
}

/// Triangles on a grid so small that most of what happens is degenerate: x and y below `plan`, z below `height`.
inline rc::Gen<std::vector<TriangleNumbers>> gridTriangles(int triangles, int plan, int height) {
  return upTo(triangles, rc::gen::map(numbersBelow<9>(1 << 20), [=](TriangleNumbers n) {
                for (std::size_t i = 0; i < 9; ++i) n[i] %= i % 3 == 2 ? height : plan;
                return n;
              }));
}

inline Soup soupOf(const std::vector<TriangleNumbers>& triangles) {
  Soup soup;
  const auto number = [](int n) { return static_cast<double>(n); };
  for (const auto& n : triangles)
    soup.triangle({number(n[0]), number(n[1]), number(n[2])}, {number(n[3]), number(n[4]), number(n[5])},
                  {number(n[6]), number(n[7]), number(n[8])});
  return soup;
}

/// A kind and six small numbers: a piece of a building.
using PartNumbers = std::array<int, 7>;

inline Soup buildingOf(const std::vector<PartNumbers>& parts) {
  Soup soup;
  for (const auto& n : parts) {
    const double x0 = n[1] % 5, y0 = n[2] % 5, x1 = x0 + 1 + n[3] % 4, y1 = y0 + 1 + n[4] % 4;
    const double z0 = n[5] % 4, z1 = z0 + 1 + n[6] % 3;
    switch (n[0] % 8) {
      case 0:
        soup.floor(x0, y0, x1, y1, z0);
        break;
      case 1:
        soup.wall(x0, y0, x1, y0, z0, z1);
        break;
      case 2:
        soup.wall(x0, y0, x0, y1, z0, z1);
        break;
      case 3:
        soup.wall(x0, y0, x1, y1, z0, z1);
        break;
      case 4:
        soup.ramp(x0, y0, x1, y1, z0, z1);
        break;
      case 5:
        soup.box({x0, y0, z0}, {x1, y1, z1});
        break;
      case 6:
        soup.ceiling(x0, y0, x1, y1, z1);
        break;
      default:
        soup.quad({x0, y0, z0}, {x1, y0, z0}, {x1, y1, z1}, {x0, y1, z1});
        break;
    }
  }
  return soup;
}

inline rc::Gen<std::vector<PartNumbers>> buildingParts(int parts) { return upTo(parts, numbersBelow<7>(64)); }

/// A walk that climbs over itself: level squares and ramps in turn, each number one step (direction, and up, down or
/// level).
inline Soup walkOf(const std::vector<int>& steps) {
  Soup soup = Soup().floor(0, 0, 1, 1, 0);
  int x = 0, y = 0, z = 0;
  for (const int step : steps) {
    const int dx = std::array{1, 0, -1, 0}[static_cast<std::size_t>(step % 4)];
    const int dy = std::array{0, 1, 0, -1}[static_cast<std::size_t>(step % 4)];
    const int to = z + std::array{1, 1, 0, -1}[static_cast<std::size_t>(step / 4 % 4)];
    x += dx, y += dy;
    const auto height = [&](int cx, int cy) {  // The height of a corner, 0 or 1 along either axis.
      const bool far = dx + dy > 0 ? (dx != 0 ? cx : cy) == 1 : (dx != 0 ? cx : cy) == 0;
      return Vec3{double(x + cx), double(y + cy), double(far ? to : z)};
    };
    soup.quad(height(0, 0), height(1, 0), height(1, 1), height(0, 1));
    z = to;
    x += dx, y += dy;
    soup.floor(x, y, x + 1, y + 1, z);
  }
  return soup;
}

}  // namespace footfall::test
