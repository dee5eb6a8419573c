// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/generated_levels.hpp"

#include <array>
#include <cmath>

#include "core/io/export.hpp"

namespace footfall::bench {
using namespace detail;
namespace {

using Units = std::int64_t;  // units of 1/64 m

constexpr Units kMetre = 64;
constexpr std::uint32_t kTrianglesOfBox = 12;

// SplitMix64 (Steele, Lea, Flood 2014): a well mixed number for each number.
std::uint64_t mix(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15ULL;
  x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27U)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31U);
}

class Random {
 public:
  // A number from `low` to `high`, both included.
  Units between(Units low, Units high) {
    return low + static_cast<Units>(mix(state_++) % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::uint64_t state_ = 0;
};

class Builder {
 public:
  Builder() { environment_.up = UpAxis::Y; }
  std::uint32_t addVertex(Units x, Units y, Units z) {
    const auto metres = [](Units units) { return static_cast<double>(units) / kMetre; };
    environment_.vertices.push_back({metres(x), metres(y), metres(z)});
    return static_cast<std::uint32_t>(environment_.vertices.size()) - 1;
  }
  // Counter-clockwise, from the front.
  void addQuad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    environment_.triangles.push_back({a, b, c});
    environment_.triangles.push_back({a, c, d});
  }
  void addBox(const std::array<Units, 3>& low, const std::array<Units, 3>& size) {
    std::array<std::uint32_t, 8> corner{};
    for (std::size_t k = 0; k < 8; ++k)
      corner[k] = addVertex(low[0] + ((k & 1U) != 0 ? size[0] : 0), low[1] + ((k & 2U) != 0 ? size[1] : 0),
                            low[2] + ((k & 4U) != 0 ? size[2] : 0));
    for (const std::array<std::size_t, 4>& face : std::array<std::array<std::size_t, 4>, 6>{
             {{4, 5, 7, 6}, {0, 2, 3, 1}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}}})
      addQuad(corner[face[0]], corner[face[1]], corner[face[2]], corner[face[3]]);
  }
  Environment take() { return std::move(environment_); }

 private:
  Environment environment_;
};

// Hills: heights on a coarse grid, interpolated between its points, in two sizes, and a little roughness.
Units heightAt(Units column, Units row) {
  const auto hill = [&](Units spacing, Units amplitude, std::uint64_t kind) {
    const Units u = column / spacing, v = row / spacing, fu = column % spacing, fv = row % spacing;
    const auto corner = [&](Units i, Units j) {
      const auto key = static_cast<std::uint64_t>(i) << 32U ^ static_cast<std::uint64_t>(j) << 2U ^ kind;
      return static_cast<Units>(mix(key) % static_cast<std::uint64_t>(amplitude));
    };
    const Units near = corner(u, v) * (spacing - fu) + corner(u + 1, v) * fu;
    const Units far = corner(u, v + 1) * (spacing - fu) + corner(u + 1, v + 1) * fu;
    return (near * (spacing - fv) + far * fv) / (spacing * spacing);
  };
  return hill(16, 8 * kMetre, 0) + hill(5, 4 * kMetre, 1) + hill(1, kMetre / 4, 2);
}

}  // namespace

Environment makeTerrain(std::uint32_t triangles) {
  constexpr std::uint32_t kSquaresOfBox = 24;
  const std::uint32_t boxes = triangles / (2 * kSquaresOfBox + kTrianglesOfBox);
  const auto side = static_cast<Units>(std::llround(std::sqrt(boxes * kSquaresOfBox)));
  Builder builder;
  for (Units row = 0; row <= side; ++row)
    for (Units column = 0; column <= side; ++column)
      builder.addVertex(column * kMetre, row * kMetre, heightAt(column, row));
  const auto vertex = [&](Units column, Units row) { return static_cast<std::uint32_t>(row * (side + 1) + column); };
  for (Units row = 0; row < side; ++row)
    for (Units column = 0; column < side; ++column)
      builder.addQuad(vertex(column, row), vertex(column + 1, row), vertex(column + 1, row + 1),
                      vertex(column, row + 1));
  Random random;
  for (std::uint32_t box = 0; box < boxes; ++box) {
    const Units x = random.between(0, (side - 3) * kMetre), y = random.between(0, (side - 3) * kMetre);
    const Units ground = heightAt(x / kMetre, y / kMetre);
    const Units base = box % 2 == 0 ? ground - kMetre : ground + random.between(kMetre, 7 * kMetre / 4);
    builder.addBox({x, y, base}, {random.between(kMetre / 2, 5 * kMetre / 2),
                                  random.between(kMetre / 2, 5 * kMetre / 2), random.between(kMetre, 3 * kMetre)});
  }
  return builder.take();
}

Environment makeGiantFloor(std::uint32_t obstacleTriangles) {
  constexpr std::uint32_t kSquareMetresOfBox = 12;
  const std::uint32_t boxes = obstacleTriangles / kTrianglesOfBox;
  const Units side = std::llround(std::sqrt(boxes * kSquareMetresOfBox)) * kMetre;
  Builder builder;
  const std::uint32_t a = builder.addVertex(0, 0, 0), b = builder.addVertex(side, 0, 0);
  const std::uint32_t c = builder.addVertex(side, side, 0), d = builder.addVertex(0, side, 0);
  builder.addQuad(a, b, c, d);
  Random random;
  for (std::uint32_t box = 0; box < boxes; ++box) {
    const Units base = box % 2 == 0 ? 0 : random.between(kMetre, 7 * kMetre / 4);
    builder.addBox({random.between(0, side - 3 * kMetre), random.between(0, side - 3 * kMetre), base},
                   {random.between(kMetre / 2, 5 * kMetre / 2), random.between(kMetre / 2, 5 * kMetre / 2),
                    random.between(kMetre, 3 * kMetre)});
  }
  return builder.take();
}

void writeEnvironment(const std::string& path, Environment environment) {
  NavigationMesh mesh;
  mesh.vertices = std::move(environment.vertices);
  mesh.triangles = std::move(environment.triangles);
  mesh.sourceTriangles.resize(mesh.triangles.size());
  mesh.frame = {environment.source, UpAxis::Y, environment.metresPerUnit};
  save(mesh, path);
}

}  // namespace footfall::bench
