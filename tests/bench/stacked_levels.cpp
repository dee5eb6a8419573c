// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/stacked_levels.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>

namespace footfall::bench {
namespace {

constexpr double kTurn = 6.283185307179586;

class Builder {
 public:
  Builder() { environment_.metresPerUnit = 1; }

  /// A place on the grid of 1/64 m between two bounds.
  double between(double low, double high) {
    const double share = static_cast<double>(random_() % 65536) / 65536;
    return std::floor((low + (high - low) * share) * 64) / 64;
  }
  std::uint32_t vertex(double x, double y, double z) {
    environment_.vertices.push_back({x, y, z});
    return static_cast<std::uint32_t>(environment_.vertices.size()) - 1;
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { environment_.triangles.push_back({a, b, c}); }
  void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    triangle(a, b, c);
    triangle(a, c, d);
  }
  void floor(double x0, double y0, double x1, double y1, double z) {
    quad(vertex(x0, y0, z), vertex(x1, y0, z), vertex(x1, y1, z), vertex(x0, y1, z));
  }
  void box(const Vec3& low, const Vec3& size) {
    std::array<std::uint32_t, 8> corner{};
    for (std::size_t k = 0; k < 8; ++k)
      corner[k] = vertex(low.x + ((k & 1U) != 0 ? size.x : 0), low.y + ((k & 2U) != 0 ? size.y : 0),
                         low.z + ((k & 4U) != 0 ? size.z : 0));
    for (const std::array<std::size_t, 4>& face : std::array<std::array<std::size_t, 4>, 6>{
             {{4, 5, 7, 6}, {0, 2, 3, 1}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}}})
      quad(corner[face[0]], corner[face[1]], corner[face[2]], corner[face[3]]);
  }
  /// Turns everything around the origin.
  void turn(double angle) {
    for (Vec3& v : environment_.vertices)
      v = {std::cos(angle) * v.x - std::sin(angle) * v.y, std::sin(angle) * v.x + std::cos(angle) * v.y, v.z};
  }
  std::shared_ptr<const Environment> take() { return std::make_shared<const Environment>(std::move(environment_)); }

 private:
  Environment environment_;
  std::mt19937 random_{1};
};

/// Decks of squares of 2 m, 3 m above each other, with 60 boxes each.
Builder decks(int storeys, int squares) {
  Builder builder;
  const double side = 2.0 * squares;
  for (int k = 0; k < storeys; ++k) {
    for (int i = 0; i < squares; ++i)
      for (int j = 0; j < squares; ++j)
        if (k == 0 || j != 1 || i == 0 || i > 4) builder.floor(2.0 * i, 2.0 * j, 2.0 * i + 2, 2.0 * j + 2, 3.0 * k);
    for (int b = 0; b < 60; ++b)
      builder.box({builder.between(0, side - 3), builder.between(5, side - 3), 3.0 * k},
                  {builder.between(0.5, 2), builder.between(0.5, 2), builder.between(0.5, 2)});
  }
  return builder;
}

/// 16 blocks of 12 storeys with a shaft, treads of 0.2 m and boxes.
Builder towers() {
  Builder builder;
  for (int block = 0; block < 16; ++block) {
    const double x = 16 * (block % 4), y = 16 * (block / 4);
    for (int k = 0; k < 12; ++k) {
      const double z = 3 * k;
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j)
          if (k == 0 || i < 1 || i > 2 || j < 1 || j > 2)
            builder.floor(x + 2 * i, y + 2 * j, x + 2 * i + 2, y + 2 * j + 2, z);
      for (int tread = 0; tread < 15; ++tread) {
        const bool isFirst = tread < 8;
        const double along = isFirst ? 2 + 0.5 * tread : 5.5 - 0.5 * (tread - 8);
        builder.box({x + along, y + (isFirst ? 2 : 4), z + 0.2 * tread}, {0.5, 2, 0.2});
      }
      for (int b = 0; b < 6; ++b)
        builder.box({x + builder.between(7, 11), y + builder.between(0, 11), z},
                    {builder.between(0.25, 1), builder.between(0.25, 1), builder.between(0.5, 1.5)});
      builder.box({x, y, z}, {0.25, 12, 2.75});
    }
  }
  return builder;
}

/// Uneven ground of 64 m, six times, with holes.
Builder sheets() {
  constexpr int kSide = 64;
  Builder builder;
  for (int k = 0; k < 6; ++k) {
    std::vector<std::uint32_t> vertices;
    for (int i = 0; i <= kSide; ++i)
      for (int j = 0; j <= kSide; ++j)
        vertices.push_back(
            builder.vertex(i, j, 8 * k + builder.between(0, 0.6) + 3 * std::sin(i / 9.0) * std::cos(j / 7.0)));
    const auto at = [&](int i, int j) { return vertices[static_cast<std::size_t>(i * (kSide + 1) + j)]; };
    for (int i = 0; i < kSide; ++i)
      for (int j = 0; j < kSide; ++j)
        if (builder.between(0, 1) < 0.97) builder.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  }
  return builder;
}

/// 150 roads, six metres wide and 300 m long, that climb and bend at random and cross each other.
Builder roads() {
  Builder builder;
  for (int road = 0; road < 150; ++road) {
    double x = builder.between(0, 200), y = builder.between(0, 200), z = builder.between(0, 30);
    double angle = builder.between(0, 6.25);
    const double bend = 0.3 * builder.between(-0.1, 0.1), climb = builder.between(-0.1, 0.1);
    std::array<std::uint32_t, 2> before{};
    for (int i = 0; i < 150; ++i) {
      const double nx = -3 * std::sin(angle), ny = 3 * std::cos(angle);
      const std::array<std::uint32_t, 2> now{builder.vertex(x + nx, y + ny, z), builder.vertex(x - nx, y - ny, z)};
      if (i > 0) builder.quad(before[0], before[1], now[1], now[0]);
      before = now;
      x += 2 * std::cos(angle);
      y += 2 * std::sin(angle);
      angle += bend;
      z += climb;
    }
  }
  return builder;
}

/// 20 discs of 1,000 triangles around their middles, 3 m apart.
Builder fans() {
  constexpr int kCorners = 1000;
  Builder builder;
  for (int k = 0; k < 20; ++k) {
    const std::uint32_t middle = builder.vertex(0, 0, 3 * k);
    for (int i = 0; i < kCorners; ++i)
      builder.vertex(50 * std::cos(kTurn * i / kCorners), 50 * std::sin(kTurn * i / kCorners), 3 * k);
    for (std::uint32_t i = 0; i < kCorners; ++i)
      builder.triangle(middle, middle + 1 + i, middle + 1 + (i + 1) % kCorners);
  }
  return builder;
}

/// Spirals of 23.5 quads a turn, 20 m apart: ramps of 3 m a turn, or stairs of treads 0.149 m high.
Builder spirals(int count, int quads, bool isStair) {
  constexpr double kQuads = 23.5;
  Builder builder;
  for (int spiral = 0; spiral < count; ++spiral) {
    const auto at = [&](double step, double radius, double z) {
      return builder.vertex(20.0 * spiral + radius * std::cos(kTurn * step / kQuads),
                            radius * std::sin(kTurn * step / kQuads), z);
    };
    std::array<std::uint32_t, 2> before{};
    for (int i = 0; i <= quads; ++i) {
      if (isStair) {
        const double z = 3.5 * i / kQuads;
        const std::array<std::uint32_t, 4> tread{at(i, 5, z), at(i, 8, z), at(i + 1, 8, z), at(i + 1, 5, z)};
        builder.quad(tread[0], tread[1], tread[2], tread[3]);
        if (i > 0) builder.quad(before[0], before[1], tread[1], tread[0]);
        before = {tread[3], tread[2]};
      } else {
        const double z = 3.0 * i / kQuads;
        const std::array<std::uint32_t, 2> now{at(i, 5, z), at(i, 8, z)};
        if (i > 0) builder.quad(before[0], before[1], now[1], now[0]);
        before = now;
      }
    }
  }
  return builder;
}

}  // namespace

std::vector<StackedLevel> makeStackedLevels() {
  Builder turned = decks(16, 20);
  turned.turn(0.3);
  return {{"16 decks", decks(16, 20).take()},
          {"16 decks, turned", turned.take()},
          {"40 decks", decks(40, 12).take()},
          {"tower blocks", towers().take()},
          {"6 uneven sheets", sheets().take()},
          {"roads that cross", roads().take()},
          {"20 discs", fans().take()},
          {"25 spiral ramps of 17 turns", spirals(25, 400, false).take()},
          {"25 spiral stairs of 17 turns", spirals(25, 400, true).take()},
          {"a spiral ramp of 425 turns", spirals(1, 10000, false).take()},
          {"a spiral stair of 425 turns", spirals(1, 10000, true).take()}};
}

}  // namespace footfall::bench
