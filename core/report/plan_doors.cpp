// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/plan_doors.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>

#include "core/base/disjoint_sets.hpp"
#include "footfall/edit.hpp"

namespace footfall::detail {
namespace {

constexpr double kNear = 0.1;       // metres between a leaf, its frame and its handle
constexpr double kLowest = 1;       // metres: what is lower is a hatch
constexpr double kShortest = 0.05;  // metres: shorter edges say little of a direction

struct Box {
  std::array<double, 3> low, high;

  [[nodiscard]] bool isNear(const Box& other, double distance) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (low[k] - distance > other.high[k] || other.low[k] - distance > high[k]) return false;
    return true;
  }
  void add(const Box& other) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], other.low[k]);
      high[k] = std::max(high[k], other.high[k]);
    }
  }
};

Box boxOf(const Environment& environment, std::uint32_t triangle) {
  const Triangle& corners = environment.triangles[triangle];
  const Vec3& first = environment.vertices[corners[0]];
  Box box{{first.x, first.y, first.z}, {first.x, first.y, first.z}};
  for (const std::uint32_t v : corners) {
    const Vec3& p = environment.vertices[v];
    box.add({{p.x, p.y, p.z}, {p.x, p.y, p.z}});
  }
  return box;
}

bool isDoorClass(const std::string& name) { return name == "IfcDoor" || name == "IfcDoorStandardCase"; }

/// Triangles whose boxes come near each other, one list for each group; the largest boxes first, so that a door's leaf
/// gathers what belongs to it.
std::vector<std::vector<std::uint32_t>> groupsOf(const Environment& environment,
                                                 const std::vector<std::uint32_t>& triangles, double distance,
                                                 const Poll& poll) {
  std::vector<Box> boxes;
  for (const std::uint32_t t : triangles) boxes.push_back(boxOf(environment, t));
  std::vector<std::uint32_t> order(triangles.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return boxes[a].low[0] < boxes[b].low[0]; });
  DisjointSets sets(triangles.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i % 256 == 0) poll();
    const Box& box = boxes[order[i]];
    for (std::size_t j = i + 1; j < order.size() && boxes[order[j]].low[0] <= box.high[0] + distance; ++j)
      if (box.isNear(boxes[order[j]], distance)) sets.unite(order[i], order[j]);
  }
  std::map<std::uint32_t, std::vector<std::uint32_t>> groups;
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    groups[static_cast<std::uint32_t>(sets.find(i))].push_back(triangles[i]);
  std::vector<std::vector<std::uint32_t>> lists;
  for (auto& [root, list] : groups) lists.push_back(std::move(list));
  return lists;
}

PlanDoor doorOf(const Environment& environment, const std::vector<std::uint32_t>& all, double shortest) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  PlanDoor door;
  door.lower = kFar;
  door.upper = -kFar;
  for (const std::uint32_t t : all) {
    const Box box = boxOf(environment, t);
    door.lower = std::min(door.lower, box.low[2]);
    door.upper = std::max(door.upper, box.high[2]);
  }
  // The leaf and its frame are as high as the door; handles and hinges, which stand out, are not.
  std::vector<std::uint32_t> triangles;
  for (const std::uint32_t t : all) {
    const Box box = boxOf(environment, t);
    if (box.high[2] - box.low[2] >= (door.upper - door.lower) / 2) triangles.push_back(t);
  }
  if (triangles.empty()) triangles = all;
  // Directions to within a degree: panels have many edges.
  std::map<int, PlanPlace> directions;
  for (const std::uint32_t t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &a = environment.vertices[environment.triangles[t][k]],
                 &b = environment.vertices[environment.triangles[t][(k + 1) % 3]];
      const double x = b.x - a.x, y = b.y - a.y, length = std::hypot(x, y);
      if (length < shortest) continue;
      const double quarter = std::acos(0.0);
      const double angle = std::fmod(std::atan2(y, x) + 4 * quarter, quarter);
      directions.try_emplace(static_cast<int>(angle / quarter * 90), PlanPlace{x / length, y / length});
    }
  if (directions.empty()) directions[0] = {1, 0};
  double least = kFar;
  for (const auto& [degrees, axis] : directions) {
    const auto along = axis;  // a variable of its own, because Clang 14 captures no bindings
    double low = kFar, high = -kFar, left = kFar, right = -kFar;
    for (const std::uint32_t t : triangles)
      for (const std::uint32_t v : environment.triangles[t]) {
        const Vec3& p = environment.vertices[v];
        const double u = p.x * along[0] + p.y * along[1], w = p.y * along[0] - p.x * along[1];
        low = std::min(low, u);
        high = std::max(high, u);
        left = std::min(left, w);
        right = std::max(right, w);
      }
    if (!((high - low) * (right - left) < least)) continue;
    least = (high - low) * (right - left);
    const auto corner = [&](double u, double w) {
      return PlanPlace{u * along[0] - w * along[1], u * along[1] + w * along[0]};
    };
    door.corners = high - low >= right - left
                       ? std::array{corner(low, left), corner(high, left), corner(high, right), corner(low, right)}
                       : std::array{corner(low, right), corner(low, left), corner(high, left), corner(high, right)};
  }
  return door;
}

}  // namespace

std::vector<PlanDoor> findDoors(const Environment& environment, Poll poll) {
  const Environment* file = &environment;
  std::shared_ptr<const Environment> held;
  while (file->edit) {
    std::shared_ptr<const Environment> base = file->edit->base.lock();
    if (!base) break;
    held = std::move(base);
    file = held.get();
  }
  if (file->partOf.empty()) return {};
  std::map<std::uint32_t, std::vector<std::uint32_t>> doors;
  for (std::uint32_t t = 0; t < file->triangles.size(); ++t)
    if (isDoorClass(file->parts[file->partOf[t]].mesh)) doors[file->partOf[t]].push_back(t);
  const double metres = file->metresPerUnit;
  std::vector<PlanDoor> found;
  for (const auto& [part, triangles] : doors)
    for (const std::vector<std::uint32_t>& group : groupsOf(*file, triangles, kNear / metres, poll)) {
      const PlanDoor door = doorOf(*file, group, kShortest / metres);
      if ((door.upper - door.lower) * metres >= kLowest) found.push_back(door);
    }
  return found;
}

}  // namespace footfall::detail
