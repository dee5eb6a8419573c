// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/navigation/drop_route.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>

namespace footfall::detail {
namespace {

constexpr std::uint32_t kNone = SurfaceTopology::kNone;

double planDistance(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y); }

Vec3 between(const std::array<Vec3, 2>& ends, double t) {
  const auto& [a, b] = ends;
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

DropStop nearestStop(const NavigationMesh& mesh, std::uint32_t number, const Vec3& p) {
  const DropLink& drop = mesh.drops[number];
  const Vec3 &a = drop.start[0], &b = drop.start[1];
  const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
  const double t = squared > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squared, 0.0, 1.0) : 0;
  return {number, between(drop.start, t), between(drop.landing, t)};
}

/// How a part is entered.
struct Entry {
  double length = std::numeric_limits<double>::infinity();
  Vec3 place;
  DropStop by;
  std::uint32_t before = kNone;  ///< the part that the drop starts from
};

}  // namespace

std::optional<std::vector<DropStop>> findDropRoute(const NavigationMesh& mesh, const SurfaceTopology& topology,
                                                   const Vec3& from, std::uint32_t fromTriangle, const Vec3& to,
                                                   std::uint32_t toTriangle) {
  const std::uint32_t first = topology.components[fromTriangle], last = topology.components[toTriangle];
  if (mesh.drops.empty() || first == kNone || last == kNone) return std::nullopt;
  std::vector<std::vector<std::uint32_t>> dropsFrom(topology.componentCount);
  for (std::uint32_t i = 0; i < mesh.drops.size(); ++i)
    if (const std::uint32_t c = topology.components[mesh.drops[i].fromTriangle]; c != kNone) dropsFrom[c].push_back(i);
  std::vector<Entry> entries(topology.componentCount);
  entries[first] = {0, from, {}, kNone};
  // The shortest first; the last part with the way to the goal behind it.
  using Open = std::tuple<double, std::uint32_t>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  open.emplace(0, first);
  std::vector<char> done(topology.componentCount, 0);
  while (!open.empty()) {
    const std::uint32_t part = std::get<1>(open.top());
    open.pop();
    if (done[part] != 0) continue;
    done[part] = 1;
    if (part == last) break;
    const Entry entry = entries[part];
    for (const std::uint32_t number : dropsFrom[part]) {
      const std::uint32_t next = topology.components[mesh.drops[number].toTriangle];
      if (next == kNone || done[next] != 0) continue;
      const DropStop stop = nearestStop(mesh, number, entry.place);
      double length = entry.length + planDistance(entry.place, stop.start) + planDistance(stop.start, stop.landing);
      if (next == last) length += planDistance(stop.landing, to);
      if (!(length < entries[next].length)) continue;
      entries[next] = {length, stop.landing, stop, part};
      open.emplace(length, next);
    }
  }
  if (done[last] == 0 || first == last) return std::nullopt;
  std::vector<DropStop> stops;
  for (std::uint32_t part = last; part != first; part = entries[part].before) stops.push_back(entries[part].by);
  std::reverse(stops.begin(), stops.end());
  return stops;
}

}  // namespace footfall::detail
