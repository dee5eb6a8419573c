// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/formats/engine_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/base/vector.hpp"
#include "core/io/export.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

double rounded(double x) {
  // The number is volatile, because GCC 12 omits the conversion to float and back where it vectorizes two numbers.
  const volatile auto number = static_cast<float>(x + 0.0);  // avoids -0
  const float value = number;
  if (!std::isfinite(value))
    throw InputError(
        FOOTFALL_TEXT("a coordinate is larger than a float can be; export as OBJ, or with a smaller scale"));
  return value;
}

Vec3 rounded(const Vec3& p) { return {rounded(p.x), rounded(p.y), rounded(p.z)}; }

Vec3 between(const Vec3& a, const Vec3& b, double t) { return a + t * (b - a); }

/// Triangles, links and jumps of a mesh after one cut.
class Cut {
 public:
  Cut(EngineMesh& mesh, int axis, double place) : mesh_(mesh), axis_(axis), place_(place) {}

  void make() {
    const std::vector<Triangle> before = std::move(mesh_.triangles);
    const std::vector<std::uint32_t> layers = std::move(mesh_.layers);
    mesh_.triangles.clear();
    mesh_.layers.clear();
    for (std::size_t t = 0; t < before.size(); ++t) {
      cutTriangle(before[t]);
      if (!layers.empty()) mesh_.layers.resize(mesh_.triangles.size(), layers[t]);
    }
    const std::vector<EngineLink> links = std::move(mesh_.links);
    mesh_.links.clear();
    for (const EngineLink& link : links) cutLink(link);
  }

 private:
  [[nodiscard]] double coordinate(const Vec3& p) const { return axis_ == 0 ? p.x : p.y; }
  [[nodiscard]] bool isBeyond(std::uint32_t v) const { return coordinate(mesh_.vertices[v]) > place_; }

  /// The vertex where the edge is cut. The lower end counts first, so that borders above each other in the plan are cut
  /// at the same place.
  std::uint32_t crossing(std::uint32_t a, std::uint32_t b) {
    const std::uint64_t key = static_cast<std::uint64_t>(std::min(a, b)) << 32 | std::max(a, b);
    const auto [found, isNew] = crossings_.try_emplace(key, static_cast<std::uint32_t>(mesh_.vertices.size()));
    if (isNew) {
      const bool swap = isBeyond(a);
      const Vec3 low = mesh_.vertices[swap ? b : a], high = mesh_.vertices[swap ? a : b];
      Vec3 p = rounded(between(low, high, (place_ - coordinate(low)) / (coordinate(high) - coordinate(low))));
      (axis_ == 0 ? p.x : p.y) = place_;
      mesh_.vertices.push_back(p);
    }
    return found->second;
  }

  void cutTriangle(const Triangle& triangle) {
    int beyond = 0;
    for (const std::uint32_t v : triangle) beyond += isBeyond(v) ? 1 : 0;
    if (beyond == 0 || beyond == 3) {
      mesh_.triangles.push_back(triangle);
      return;
    }
    std::size_t alone = 0;  // the corner that is alone on its side
    while (isBeyond(triangle[alone]) != (beyond == 1)) ++alone;
    const std::uint32_t a = triangle[alone], b = triangle[(alone + 1) % 3], c = triangle[(alone + 2) % 3];
    const std::uint32_t ab = crossing(a, b), ca = crossing(c, a);
    mesh_.triangles.push_back({a, ab, ca});
    mesh_.triangles.push_back({ab, b, c});
    mesh_.triangles.push_back({ab, c, ca});
  }

  void cutLink(const EngineLink& link) {
    const auto [a, b] = link.from;
    const auto [c, d] = link.to;
    const bool fromCut = isBeyond(a) != isBeyond(b), toCut = isBeyond(c) != isBeyond(d);
    if (fromCut && toCut && isBeyond(a) == isBeyond(d)) {
      const std::uint32_t m = crossing(a, b), n = crossing(c, d);
      mesh_.links.push_back({{a, m}, {n, d}});
      mesh_.links.push_back({{m, b}, {c, n}});
    } else if (fromCut) {  // a gap: the part on the side of the other edge goes on
      const std::uint32_t m = crossing(a, b);
      mesh_.links.push_back({isBeyond(a) == isBeyond(d) ? std::array{a, m} : std::array{m, b}, link.to});
    } else if (toCut) {
      const std::uint32_t n = crossing(c, d);
      mesh_.links.push_back({link.from, isBeyond(d) == isBeyond(a) ? std::array{n, d} : std::array{c, n}});
    } else {
      mesh_.links.push_back(link);
    }
  }

  EngineMesh& mesh_;
  int axis_;
  double place_;
  std::unordered_map<std::uint64_t, std::uint32_t> crossings_;
};

}  // namespace

Vec3 insetPlace(const EngineMesh& mesh, const Triangle& triangle, const Vec3& place) {
  const Vec3 &a = mesh.vertices[triangle[0]], &b = mesh.vertices[triangle[1]], &c = mesh.vertices[triangle[2]];
  const Vec3 centre = between(between(a, b, 0.5), c, 1.0 / 3), way = centre - place;
  const double distance = std::hypot(way.x, way.y);
  return rounded(distance > 0 ? between(place, centre, std::min(0.5, kInset / distance)) : place);
}

EngineMesh engineMesh(const NavigationMesh& mesh, const ExportOptions& options) {
  checkScale(options, mesh);
  const double scale = mesh.frame.metresPerUnit * options.scale;
  EngineMesh result;
  result.vertices.reserve(mesh.vertices.size());
  for (const Vec3& p : mesh.vertices) {
    const Vec3 place = scale * p, near = rounded(place), error = near - place;
    for (const double e : {error.x, error.y, error.z})
      result.largestError = std::max(result.largestError, std::fabs(e));
    result.vertices.push_back(near);
  }
  result.triangles = mesh.triangles;
  if (options.layers) result.layers = mesh.layers;
  if (options.steps)
    for (const StepLink& link : mesh.links) result.links.push_back({link.from, link.to});
  if (!options.drops) return result;
  for (const DropLink& drop : mesh.drops) {
    const double count = std::clamp(std::ceil(drop.width * scale), 1.0, 1000.0);
    for (double i = 0; i < count; ++i) {
      const double t = (i + 0.5) / count;
      const auto place = [&](const std::array<Vec3, 2>& ends, std::uint32_t triangle) {
        return insetPlace(result, result.triangles[triangle], scale * between(ends[0], ends[1], t));
      };
      result.jumps.push_back({place(drop.start, drop.fromTriangle), place(drop.landing, drop.toTriangle), true});
    }
  }
  return result;
}

void cutAlong(EngineMesh& mesh, int axis, double place) { Cut(mesh, axis, place).make(); }

}  // namespace footfall::detail
