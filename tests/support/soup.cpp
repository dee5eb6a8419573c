// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/soup.hpp"

#include "core/base/number_text.hpp"

namespace footfall::test {
using namespace detail;

Soup& Soup::triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  triangles_.push_back({a, b, c});
  return *this;
}

Soup& Soup::quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return triangle(a, b, c).triangle(a, c, d);
}

Soup& Soup::floor(double x0, double y0, double x1, double y1, double z) {
  return quad({x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z});
}

Soup& Soup::ceiling(double x0, double y0, double x1, double y1, double z) {
  return quad({x0, y0, z}, {x0, y1, z}, {x1, y1, z}, {x1, y0, z});
}

Soup& Soup::wall(double x0, double y0, double x1, double y1, double z0, double z1) {
  return quad({x0, y0, z0}, {x1, y1, z0}, {x1, y1, z1}, {x0, y0, z1});
}

Soup& Soup::ramp(double x0, double y0, double x1, double y1, double z0, double z1) {
  return quad({x0, y0, z0}, {x1, y0, z1}, {x1, y1, z1}, {x0, y1, z0});
}

Soup& Soup::box(const Vec3& lower, const Vec3& upper) {
  ceiling(lower.x, lower.y, upper.x, upper.y, lower.z);
  floor(lower.x, lower.y, upper.x, upper.y, upper.z);
  wall(lower.x, lower.y, upper.x, lower.y, lower.z, upper.z);
  wall(upper.x, lower.y, upper.x, upper.y, lower.z, upper.z);
  wall(upper.x, upper.y, lower.x, upper.y, lower.z, upper.z);
  return wall(lower.x, upper.y, lower.x, lower.y, lower.z, upper.z);
}

Soup& Soup::add(const Soup& other) {
  triangles_.insert(triangles_.end(), other.triangles_.begin(), other.triangles_.end());
  return *this;
}

Soup Soup::mapped(const std::function<Vec3(const Vec3&)>& map) const {
  Soup result;
  for (const auto& t : triangles_) result.triangle(map(t[0]), map(t[1]), map(t[2]));
  return result;
}

std::shared_ptr<Environment> Soup::environment(bool bothSides) const {
  auto environment = std::make_shared<Environment>();
  environment->source = "soup";
  environment->bothSides = bothSides;
  for (const auto& t : triangles_) {
    const auto first = static_cast<std::uint32_t>(environment->vertices.size());
    environment->vertices.insert(environment->vertices.end(), t.begin(), t.end());
    environment->triangles.push_back({first, first + 1, first + 2});
  }
  return environment;
}

std::shared_ptr<Environment> shuffled(const Environment& environment, const std::vector<std::uint32_t>& order,
                                      std::uint32_t turn) {
  auto result = std::make_shared<Environment>(environment);
  result->vertices.clear();
  result->triangles.clear();
  for (const std::uint32_t old : order) {
    const Triangle& t = environment.triangles[old];
    const auto first = static_cast<std::uint32_t>(result->vertices.size());
    for (std::uint32_t k = 0; k < 3; ++k) result->vertices.push_back(environment.vertices[t[(k + turn) % 3]]);
    result->triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

std::string toText(const Environment& environment) {
  std::string text;
  for (const Triangle& t : environment.triangles) {
    text += ".triangle(";
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& v = environment.vertices[t[k]];
      text += k == 0 ? "{" : ", {";
      appendNumber(text, v.x);
      text += ", ";
      appendNumber(text, v.y);
      text += ", ";
      appendNumber(text, v.z);
      text += "}";
    }
    text += ")\n";
  }
  return text;
}

}  // namespace footfall::test
