// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inspect/doorways.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "core/inspect/upright.hpp"

namespace footfall::detail {
namespace {

constexpr double kRight = 1e-6;                  // cosine of what is still a right angle
constexpr double kNarrowest = 0.4, kWidest = 4;  // metres
constexpr double kDeepest = 1, kLowest = 1.4;    // metres
constexpr std::size_t kPollEvery = 4096;

using Corners = std::array<Vec3, 3>;

bool isBefore(const Vec3& a, const Vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

struct LevelEdge {
  Vec3 from, to;  ///< the smaller one first
  LevelEdge(const Vec3& a, const Vec3& b) : from(isBefore(b, a) ? b : a), to(isBefore(b, a) ? a : b) {}
  [[nodiscard]] auto key() const { return std::tie(from.x, from.y, from.z, to.x, to.y, to.z); }
};

/// The top of an upright triangle.
struct Jamb {
  LevelEdge top;
  double height = 0;
};

/// Half of a rectangle that faces down.
struct LintelHalf {
  LevelEdge diagonal, end;  ///< the long side that the whole rectangle does not have, and its short one
  double width = 0;
};

double lengthInPlan(const Vec3& a, const Vec3& b) { return std::hypot(b.x - a.x, b.y - a.y); }

void addJambs(const Corners& p, std::vector<Jamb>& jambs) {
  const double high = std::max({p[0].z, p[1].z, p[2].z}), low = std::min({p[0].z, p[1].z, p[2].z});
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = p[k], &b = p[(k + 1) % 3];
    if (a.z == high && b.z == high) jambs.push_back({{a, b}, high - low});
  }
}

void addLintel(const Corners& p, double metresPerUnit, std::vector<LintelHalf>& lintels) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &corner = p[k], &a = p[(k + 1) % 3], &b = p[(k + 2) % 3];
    const double u = lengthInPlan(corner, a), v = lengthInPlan(corner, b);
    const double cosine = (a.x - corner.x) * (b.x - corner.x) + (a.y - corner.y) * (b.y - corner.y);
    const double width = std::max(u, v), metres = width * metresPerUnit;
    if (std::fabs(cosine) > kRight * u * v || u == v || metres < kNarrowest || metres > kWidest ||
        std::min(u, v) * metresPerUnit > kDeepest)
      continue;
    lintels.push_back({{a, b}, {corner, u < v ? a : b}, width});
  }
}

}  // namespace

std::vector<Doorway> findDoorways(const Environment& environment, const Poll& poll) {
  std::vector<Jamb> jambs;
  std::vector<LintelHalf> lintels;
  for (std::size_t t = 0; t < environment.triangles.size(); ++t) {
    if (t % kPollEvery == 0) poll();
    Corners p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = environment.vertices[environment.triangles[t][k]];
    const double area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
    const bool isLevel = p[0].z == p[1].z && p[1].z == p[2].z;
    const bool stands = isUpright(p);
    if (isLevel && !stands && area < 0)
      addLintel(p, environment.metresPerUnit, lintels);
    else if (stands && !isLevel)
      addJambs(p, jambs);
  }
  poll();
  std::ranges::sort(jambs, [](const Jamb& a, const Jamb& b) { return a.top.key() < b.top.key(); });
  poll();
  std::ranges::sort(lintels,
                    [](const LintelHalf& a, const LintelHalf& b) { return a.diagonal.key() < b.diagonal.key(); });
  const auto heightAt = [&](const LevelEdge& end) {
    double height = 0;
    const auto isBelow = [](const Jamb& jamb, const LevelEdge& edge) { return jamb.top.key() < edge.key(); };
    for (auto at = std::lower_bound(jambs.begin(), jambs.end(), end, isBelow);
         at != jambs.end() && at->top.key() == end.key(); ++at)
      height = std::max(height, at->height);
    return height;
  };
  std::vector<Doorway> doorways;
  for (std::size_t i = 0; i + 1 < lintels.size(); ++i) {
    const LintelHalf &one = lintels[i], &other = lintels[i + 1];
    if (one.diagonal.key() != other.diagonal.key() || one.end.key() == other.end.key()) continue;
    const double height = std::min(heightAt(one.end), heightAt(other.end));
    if (height * environment.metresPerUnit >= kLowest) doorways.push_back({one.width, height});
    ++i;
  }
  return doorways;
}

}  // namespace footfall::detail
