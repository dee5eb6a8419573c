// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/slow_soups.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace footfall::fuzz {
namespace {

constexpr double kExtent = 100;

void addQuad(Triangles& soup, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  soup.push_back({a, b, c});
  soup.push_back({a, c, d});
}

void addFloor(Triangles& soup, double x0, double y0, double x1, double y1, double z) {
  addQuad(soup, {x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z});
}

/// The five upper sides of a box that is turned about its corner: nothing is meant to be seen from below.
void addCrate(Triangles& soup, const Vec3& corner, const std::array<double, 3>& size, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const auto at = [&](double x, double y, double z) {
    return Vec3{corner.x + c * x - s * y, corner.y + s * x + c * y, corner.z + z};
  };
  const auto [w, d, h] = size;
  addQuad(soup, at(0, 0, h), at(w, 0, h), at(w, d, h), at(0, d, h));
  addQuad(soup, at(0, 0, 0), at(w, 0, 0), at(w, 0, h), at(0, 0, h));
  addQuad(soup, at(w, 0, 0), at(w, d, 0), at(w, d, h), at(w, 0, h));
  addQuad(soup, at(w, d, 0), at(0, d, 0), at(0, d, h), at(w, d, h));
  addQuad(soup, at(0, d, 0), at(0, 0, 0), at(0, 0, h), at(0, d, h));
}

}  // namespace

double SlowSoups::number(double low, double high) {
  return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
}

Triangles SlowSoups::make() {
  Triangles soup;
  const std::size_t kind = below(9);
  const double height = number(0, 1) < 0.5 ? 0 : number(0, 1.9);
  if (kind != 0) addFloor(soup, 0, 0, kExtent, kExtent, 0);
  const double size = number(1, kExtent);
  constexpr std::size_t kCrate = 10;
  while (soup.size() + (kind < 7 ? 2 : kCrate) <= most_) {
    const double x = number(0, kExtent), y = number(0, kExtent), angle = number(0, 6.3);
    const double z = 0.05 + number(0, height), dx = size * std::cos(angle), dy = size * std::sin(angle);
    switch (kind) {
      case 0:  // floors above each other
        addFloor(soup, x / 10, y / 10, kExtent + x / 10, kExtent + y / 10, 3.0 * static_cast<double>(soup.size()));
        break;
      case 1:  // slabs
        addFloor(soup, x, y, x + size, y + size, z);
        break;
      case 2:  // long, thin blades
        soup.push_back({{{x, y, z}, {x + dx, y + dy, z}, {x + dx - dy / 500, y + dy + dx / 500, z + height}}});
        break;
      case 3:  // needles out of one point
        soup.push_back({{{0, 0, z}, {kExtent, x, z}, {kExtent, x + 0.1, z + height}}});
        break;
      case 4:  // walls
        addQuad(soup, {x, y, 0}, {x + dx, y + dy, 0}, {x + dx, y + dy, 1}, {x, y, 1});
        break;
      case 5:  // ramps that pierce the floor
        soup.push_back({{{x, y, -z}, {x + dx, y + dy, z}, {x - dy, y + dx, -z}}});
        break;
      case 7:  // crates at all angles
        addCrate(soup, {x, y, 0}, {number(0.2, 3), number(0.2, 3), number(0.1, 3)}, angle);
        break;
      case 8:  // furniture and what lies on it: many floors hardly larger than a gap, near each other
        addCrate(soup, {x / 200, y / 200, z / 8}, {number(0.005, 0.08), number(0.005, 0.08), number(0.005, 0.1)},
                 height == 0 ? 0 : angle);
        break;
      default:  // anything on a coarse grid
        soup.push_back({});
        for (Vec3& p : soup.back())
          p = {std::floor(number(0, 20)), std::floor(number(0, 20)), std::floor(number(0, 4))};
    }
  }
  if (noisy_ && below(2) == 0) addNoise(soup, 0, soup.size());
  return soup;
}

// The coordinates of a file of floats whose meshes are placed by matrices of floats: also where they cancel, errors are
// those of numbers of a metre.
void SlowSoups::addNoise(Triangles& soup, std::size_t first, std::size_t last) {
  const auto noisy = [&](double value) {
    const auto rounded = static_cast<float>(value);
    const auto unit = static_cast<float>(std::ldexp(1.0, std::ilogb(std::fabs(rounded) + 1.0F) - 23));
    return static_cast<double>(rounded + unit * static_cast<float>(static_cast<int>(below(5)) - 2));
  };
  for (std::size_t t = first; t < last; ++t)
    for (Vec3& p : soup[t]) p = {noisy(p.x), noisy(p.y), noisy(p.z)};
}

void SlowSoups::change(Triangles& soup, std::size_t first, std::size_t last) {
  const Vec3 centre = soup[first][0];
  const double x = number(-1, 1), y = number(-1, 1), size = std::pow(10, number(-9, 1.5)), angle = number(0, 6.3);
  const double c = std::cos(angle), s = std::sin(angle), factor = std::pow(10, number(-2, 2));
  const std::array<std::function<Vec3(const Vec3&)>, 7> changes{
      [&](const Vec3& p) {
        return Vec3{p.x + x * size, p.y + y * size, p.z};
      },
      [&](const Vec3& p) {
        return Vec3{p.x, p.y, p.z + x * size};
      },
      [&](const Vec3& p) {
        return Vec3{p.x + number(-size, size), p.y + number(-size, size), p.z};
      },
      [&](const Vec3& p) {
        return Vec3{p.x, p.y, p.z + number(-size, size)};
      },
      [&](const Vec3& p) {
        const double u = p.x - centre.x, v = p.y - centre.y;
        return Vec3{centre.x + c * u - s * v, centre.y + s * u + c * v, p.z};
      },
      [&](const Vec3& p) {
        return Vec3{centre.x + (p.x - centre.x) * factor, centre.y + (p.y - centre.y) * (x < 0 ? factor : 1), p.z};
      },
      [&](const Vec3& p) {
        return Vec3{std::round(p.x), std::round(p.y), std::round(p.z * 4) / 4};
      }};
  const auto& changed = changes[below(changes.size())];
  for (std::size_t t = first; t < last; ++t)
    for (Vec3& p : soup[t]) p = changed(p);
}

Triangles SlowSoups::mutate(const Triangles& soup, const Triangles& other) {
  Triangles result = soup;
  if (noisy_ && below(8) == 0) addNoise(result, 0, result.size());
  for (std::size_t rounds = 1 + below(4); rounds > 0; --rounds) {
    const std::size_t length = 1 + below(std::max<std::size_t>(result.size() / (1 + below(20)), 1));
    const std::size_t to = below(result.size() - length + 1);
    const Triangles& source = below(3) == 0 ? other : result;
    if (below(2) == 0 && source.size() >= length) {  // a run in place of another
      const std::size_t from = below(source.size() - length + 1);
      const Triangles run(source.begin() + static_cast<std::ptrdiff_t>(from),
                          source.begin() + static_cast<std::ptrdiff_t>(from + length));
      std::copy(run.begin(), run.end(), result.begin() + static_cast<std::ptrdiff_t>(to));
    }
    change(result, to, to + length);
  }
  return result;
}

}  // namespace footfall::fuzz
