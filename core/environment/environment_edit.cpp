// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/environment/coordinate_grid.hpp"
#include "core/environment/environment_head.hpp"
#include "footfall/edit.hpp"
#include "footfall/errors.hpp"

namespace footfall {
namespace {

void checkSoup(const TriangleSoup& soup) {
  for (const Vec3& v : soup.vertices)
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
      throw InputError(FOOTFALL_TEXT("an obstacle has a coordinate that is not finite; nothing was changed"));
  for (const Triangle& t : soup.triangles)
    for (const std::uint32_t v : t)
      if (v >= soup.vertices.size())
        throw InputError(FOOTFALL_TEXT("an obstacle's triangle names vertex %1 of %2; nothing was changed"), v,
                         soup.vertices.size());
}

constexpr std::uint32_t kGone = 0xFFFFFFFF;

/// Copies the attributes of each triangle besides its corners; `result` has its edit already.
void carryAttributes(const Environment& base, Environment& result, std::size_t added) {
  const std::vector<std::uint32_t>& kept = result.edit->keptTriangles;
  if (!base.partOf.empty()) {
    result.partOf.reserve(kept.size() + added);
    for (const std::uint32_t t : kept) result.partOf.push_back(base.partOf[t]);
    if (added > 0) {
      const auto unnamed = std::find(result.parts.begin(), result.parts.end(), EnvironmentPart{});
      const auto part = static_cast<std::uint32_t>(unnamed - result.parts.begin());
      if (unnamed == result.parts.end()) result.parts.emplace_back();
      if (!result.usualRoles.empty()) result.usualRoles.resize(result.parts.size(), PartRole::Floor);
      result.partOf.resize(kept.size() + added, part);
    }
  }
  if (base.obstacleOnly.empty()) return;
  result.obstacleOnly.reserve(kept.size() + added);
  for (const std::uint32_t t : kept) result.obstacleOnly.push_back(base.obstacleOnly[t]);
  result.obstacleOnly.resize(kept.size() + added, 0);
}

}  // namespace

std::shared_ptr<const Environment> editEnvironment(const std::shared_ptr<const Environment>& base,
                                                   const std::vector<std::uint32_t>& removed,
                                                   const TriangleSoup& added) {
  checkSoup(added);
  const std::size_t count = base->triangles.size();
  for (const std::uint32_t t : removed)
    if (t >= count)
      throw InputError(FOOTFALL_TEXT("there is no triangle %1 to remove; the environment has %2"), t, count);
  return editedCopy(base, removed, added);
}

std::shared_ptr<Environment> editedCopy(const std::shared_ptr<const Environment>& base,
                                        const std::vector<std::uint32_t>& removed, const TriangleSoup& added) {
  const std::size_t count = base->triangles.size();
  std::vector<char> gone(count, 0);
  for (const std::uint32_t t : removed) gone[t] = 1;
  // A vertex goes when removed triangles alone used it.
  std::vector<char> lost(base->vertices.size(), 0);
  for (const std::uint32_t t : removed)
    for (const std::uint32_t v : base->triangles[t]) lost[v] = 1;
  for (std::size_t t = 0; t < count; ++t)
    if (gone[t] == 0)
      for (const std::uint32_t v : base->triangles[t]) lost[v] = 0;

  auto result = std::make_shared<Environment>();
  detail::copyHead(*base, *result);
  auto edit = std::make_shared<EnvironmentEdit>();
  edit->base = base;
  result->vertices.reserve(base->vertices.size() + added.vertices.size());
  result->triangles.reserve(count + added.triangles.size());
  std::vector<std::uint32_t> renumbered(base->vertices.size(), kGone);
  for (std::size_t v = 0; v < base->vertices.size(); ++v) {
    if (lost[v] != 0) continue;
    renumbered[v] = static_cast<std::uint32_t>(result->vertices.size());
    result->vertices.push_back(base->vertices[v]);
    edit->keptVertices.push_back(static_cast<std::uint32_t>(v));
  }
  for (std::size_t t = 0; t < count; ++t) {
    if (gone[t] != 0) continue;
    const Triangle& f = base->triangles[t];
    result->triangles.push_back({renumbered[f[0]], renumbered[f[1]], renumbered[f[2]]});
    edit->keptTriangles.push_back(static_cast<std::uint32_t>(t));
  }
  const auto first = static_cast<std::uint32_t>(result->vertices.size());
  const TriangleSoup rounded = detail::onGridOf(*base, added);
  result->vertices.insert(result->vertices.end(), rounded.vertices.begin(), rounded.vertices.end());
  for (const Triangle& t : added.triangles) result->triangles.push_back({first + t[0], first + t[1], first + t[2]});
  result->edit = std::move(edit);
  carryAttributes(*base, *result, added.triangles.size());
  return result;
}

void EditableEnvironment::edit(const std::vector<std::uint32_t>& removed, const TriangleSoup& added) {
  current_ = editEnvironment(current_, removed, added);
  const auto& kept = current_->edit->keptTriangles;
  for (auto& [id, triangles] : triangles_)
    for (std::uint32_t& t : triangles)
      t = static_cast<std::uint32_t>(std::lower_bound(kept.begin(), kept.end(), t) - kept.begin());
}

ObstacleId EditableEnvironment::add(const TriangleSoup& obstacle) {
  edit({}, obstacle);
  std::vector<std::uint32_t>& mine = triangles_[next_];
  for (std::size_t i = obstacle.triangles.size(); i > 0; --i)
    mine.push_back(static_cast<std::uint32_t>(current_->triangles.size() - i));
  return next_++;
}

void EditableEnvironment::replace(ObstacleId id, const TriangleSoup& obstacle) {
  const auto found = triangles_.find(id);
  if (found == triangles_.end()) throw InputError(FOOTFALL_TEXT("there is no obstacle %1"), id);
  checkSoup(obstacle);
  const std::vector<std::uint32_t> removed = std::move(found->second);
  triangles_.erase(found);
  edit(removed, obstacle);
  std::vector<std::uint32_t>& mine = triangles_[id];
  for (std::size_t i = obstacle.triangles.size(); i > 0; --i)
    mine.push_back(static_cast<std::uint32_t>(current_->triangles.size() - i));
}

void EditableEnvironment::remove(ObstacleId id) {
  replace(id, {});
  triangles_.erase(id);
}

}  // namespace footfall
