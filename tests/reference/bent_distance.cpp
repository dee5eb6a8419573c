// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/bent_distance.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace footfall::reference {
namespace {

constexpr double kBeside = 1e-7;  // distance from a corner to a place beside it

}  // namespace

BentDistance::BentDistance(const NavigationMesh& mesh, const BorderDistance& straight, BorderKind kind, double most)
    : mesh_(mesh), straight_(straight), kind_(kind), most_(most) {
  findCorners();
  for (const bool orDoubtful : {false, true}) findDistances(orDoubtful);
}

void BentDistance::findCorners() {
  // Corners of triangles that are joined at a place: numbers are 3 * triangle + corner.
  std::vector<std::size_t> parents(3 * mesh_.triangles.size());
  std::iota(parents.begin(), parents.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (parents[i] != i) i = parents[i] = parents[parents[i]];
    return i;
  };
  const auto vertex = [&](std::size_t i) -> const Vec3& { return mesh_.vertices[mesh_.triangles[i / 3][i % 3]]; };
  std::vector<char> isBorder(parents.size(), 0);
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t ends[] = {3 * t + k, 3 * t + (k + 1) % 3};
      if (straight_.beyond(t, static_cast<int>(k)).empty()) isBorder[ends[0]] = isBorder[ends[1]] = 1;
      for (const std::uint32_t other : straight_.beyond(t, static_cast<int>(k)))
        for (const std::size_t end : ends)
          for (std::size_t j = 0; j < 3; ++j)
            if (std::hypot(vertex(end).x - vertex(3 * other + j).x, vertex(end).y - vertex(3 * other + j).y) < 1e-9)
              parents[find(end)] = find(3 * other + j);
    }
  std::set<std::size_t> borders;
  for (std::size_t i = 0; i < parents.size(); ++i)
    if (isBorder[i] != 0) borders.insert(find(i));
  std::map<std::size_t, std::size_t> numbers;
  for (std::size_t i = 0; i < parents.size(); ++i) {
    if (borders.count(find(i)) == 0) continue;
    const auto [it, isNew] = numbers.try_emplace(find(i), corners_.size());
    if (isNew) corners_.push_back({vertex(i).x, vertex(i).y, {}, {}, false});
    const Vec3 &p = vertex(i), &q = vertex(3 * (i / 3) + (i + 1) % 3), &r = vertex(3 * (i / 3) + (i + 2) % 3);
    const double dx = (q.x + r.x) / 2 - p.x, dy = (q.y + r.y) / 2 - p.y;
    const double share = std::min(kBeside / std::hypot(dx, dy), 0.1);
    corners_[it->second].beside.push_back({static_cast<std::uint32_t>(i / 3), p.x + share * dx, p.y + share * dy});
  }
  for (std::size_t i = 0; i < corners_.size(); ++i) cells_[cellOf(corners_[i].x, corners_[i].y)].push_back(i);
}

BentDistance::Cell BentDistance::cellOf(double x, double y) const {
  return {static_cast<int>(std::floor(x / most_)), static_cast<int>(std::floor(y / most_))};
}

template <class Visit>
void BentDistance::visitNear(double x, double y, const Visit& visit) const {
  const auto [i, j] = cellOf(x, y);
  for (int di = -1; di <= 1; ++di)
    for (int dj = -1; dj <= 1; ++dj)
      if (const auto found = cells_.find({i + di, j + dj}); found != cells_.end())
        for (const std::size_t corner : found->second)
          if (std::hypot(corners_[corner].x - x, corners_[corner].y - y) <= most_) visit(corner);
}

BentDistance::Sight BentDistance::see(const SurfacePlace& from, const Corner& corner, bool orDoubtful) const {
  Sight sight;
  for (const SurfacePlace& place : corner.beside) {
    const BorderDistance::Walk way = straight_.walk(from, place.x, place.y);
    sight.isDoubtful = sight.isDoubtful || way.isDoubtful;
    if (!way.isStopped && way.end.triangle == place.triangle && (orDoubtful || !way.isDoubtful))
      sight.length = std::hypot(corner.x - from.x, corner.y - from.y);
  }
  return sight;
}

// Dijkstra's algorithm over all that see each other.
void BentDistance::findDistances(bool orDoubtful) {
  std::set<std::pair<double, std::size_t>> queue;
  const auto offer = [&](std::size_t corner, double length) {
    std::optional<double>& least = corners_[corner].least[orDoubtful ? 1 : 0];
    if (length > most_ || (least && *least <= length)) return;
    if (least) queue.erase({*least, corner});
    least = length;
    queue.insert({length, corner});
  };
  for (std::size_t i = 0; i < corners_.size(); ++i)
    for (const SurfacePlace& place : corners_[i].beside) {
      const auto [least, isDoubtful] = straight_.at(place, most_, kind_, orDoubtful);
      corners_[i].isDoubtful = corners_[i].isDoubtful || isDoubtful;
      if (least) offer(i, *least);
    }
  // The walk runs along an edge of the border, which doubles may take for a walk into it.
  for (const BorderDistance::Border& border : straight_.borders()) {
    const auto& [begin, end, kind] = border.stretch;
    if (kind != kind_ && !(orDoubtful && kind == BorderKind::Doubtful)) continue;
    const Triangle& t = mesh_.triangles[border.triangle];
    const Vec3 &a = mesh_.vertices[t[border.side]], &b = mesh_.vertices[t[(border.side + 1) % 3]];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const bool isDoubtful = straight_.isNeedle(border.triangle);
    for (const auto& [place, share] : {std::pair{a, begin}, std::pair{b, 1 - end}})
      for (const std::size_t i : cells_[cellOf(place.x, place.y)]) {
        if (std::hypot(corners_[i].x - place.x, corners_[i].y - place.y) >= 1e-9 ||
            std::none_of(corners_[i].beside.begin(), corners_[i].beside.end(),
                         [&](const SurfacePlace& p) { return p.triangle == border.triangle; }))
          continue;
        corners_[i].isDoubtful = corners_[i].isDoubtful || isDoubtful;
        if (!isDoubtful || orDoubtful) offer(i, share * length);
      }
  }
  while (!queue.empty()) {
    const auto [passed, corner] = *queue.begin();
    queue.erase(queue.begin());
    const Corner& own = corners_[corner];
    visitNear(own.x, own.y, [&, passed = passed, corner = corner](std::size_t other) {
      const double direct = std::hypot(own.x - corners_[other].x, own.y - corners_[other].y);
      if (other == corner || passed + direct > most_) return;
      for (const SurfacePlace& place : own.beside) {
        const Sight sight = see(place, corners_[other], orDoubtful);
        corners_[other].isDoubtful = corners_[other].isDoubtful || sight.isDoubtful || own.isDoubtful;
        if (sight.length) offer(other, passed + *sight.length);
      }
    });
  }
}

BorderDistance::Distance BentDistance::at(const SurfacePlace& from, bool orDoubtful) const {
  BorderDistance::Distance distance = straight_.at(from, most_, kind_, orDoubtful);
  visitNear(from.x, from.y, [&](std::size_t corner) {
    const Corner& own = corners_[corner];
    const std::optional<double>& passed = own.least[orDoubtful ? 1 : 0];
    if (!passed) {
      distance.isDoubtful = distance.isDoubtful || own.isDoubtful;
      return;
    }
    const double bent = *passed + std::hypot(own.x - from.x, own.y - from.y);
    if (bent > most_ || (distance.least && *distance.least <= bent)) return;
    const Sight sight = see(from, own, orDoubtful);
    distance.isDoubtful = distance.isDoubtful || sight.isDoubtful || own.isDoubtful;
    if (sight.length) distance.least = bent;
  });
  return distance;
}

}  // namespace footfall::reference
