// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/radius/radius_memory.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

#include "core/base/index_and_box.hpp"

namespace footfall::detail {
namespace {

std::uint8_t obstacleEdgesOf(const SourceMesh& mesh, Index face) {
  const auto& f = mesh.triangles[face];
  std::uint8_t edges = 0;
  for (int k = 0; k < 3; ++k)
    if (mesh.hasObstacleEdge(f[k], f[next(k)])) edges |= static_cast<std::uint8_t>(1 << k);
  return edges;
}

std::array<Vec3, 3> cornersOf(const SourceMesh& mesh, Index face) {
  const auto& f = mesh.triangles[face];
  return {mesh.scaled[f[0]], mesh.scaled[f[1]], mesh.scaled[f[2]]};
}

/// Plan ids of one generation in another one; ascending in both.
class NewNumbers {
 public:
  // Empty where their orders differ, or where one place has two numbers.
  static std::optional<NewNumbers> of(std::span<const Index> before, std::span<const Index> now,
                                      std::vector<std::pair<Index, Index>>& pairs) {
    pairs.clear();
    for (std::size_t i = 0; i < before.size(); ++i) pairs.emplace_back(before[i], now[i]);
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    for (std::size_t i = 1; i < pairs.size(); ++i)
      if (pairs[i - 1].first == pairs[i].first || pairs[i - 1].second >= pairs[i].second) return std::nullopt;
    return NewNumbers(pairs);
  }
  // False where something was made of other things than these.
  bool renumber(PlanLine& line) const { return line.kind == PlanLine::Edge && renumber(line.a) && renumber(line.b); }
  bool renumber(PlanPoint& point) const {
    if (point.kind() == PlanPoint::Source) {
      Index id = point.planId();
      if (!renumber(id)) return false;
      point = PlanPoint::source(id);
      return true;
    }
    if (point.kind() != PlanPoint::Crossing) return false;
    PlanLine first = point.firstLine(), second = point.secondLine();
    if (point.face() >= 0 || !renumber(first) || !renumber(second)) return false;
    point = PlanPoint::crossing(first, second, -1);
    return true;
  }
  template <class Parts>
  [[nodiscard]] bool renumberAll(Parts& parts) const {
    const auto isDone = [&](auto& one) { return renumber(one); };
    return std::all_of(parts.points.begin(), parts.points.end(), isDone) &&
           std::all_of(parts.lines.begin(), parts.lines.end(), isDone);
  }

 private:
  bool renumber(Index& id) const {
    const auto found = std::lower_bound(pairs_.begin(), pairs_.end(), std::pair<Index, Index>{id, -1});
    if (found == pairs_.end() || found->first != id) return false;
    id = found->second;
    return true;
  }

  explicit NewNumbers(std::span<const std::pair<Index, Index>> pairs) : pairs_(pairs) {}

  std::span<const std::pair<Index, Index>> pairs_;
};

}  // namespace

std::size_t CutFaces::slotOf(const std::array<Vec3, 3>& corners) const {
  std::uint64_t mixed = 0;
  for (const Vec3& p : corners)
    for (const double x : {p.x, p.y, p.z})
      mixed = (std::rotl(mixed, 7) ^ std::bit_cast<std::uint64_t>(x)) * 0x9E3779B97F4A7C15U;
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = static_cast<std::size_t>(mixed ^ mixed >> 32) & mask;
  while (slots_[slot] >= 0 && faces_[slots_[slot]].corners != corners) slot = (slot + 1) & mask;
  return slot;
}

void CutFaces::growTable() {
  slots_.assign(std::max<std::size_t>(64, 2 * slots_.size()), -1);
  for (std::size_t i = 0; i < faces_.size(); ++i) slots_[slotOf(faces_[i].corners)] = static_cast<Index>(i);
}

void CutFaces::add(const PlanKernel& kernel, Index face, PlanPolygons polygons, std::shared_ptr<const FaceCuts> cuts,
                   std::shared_ptr<const FaceMesh> mesh) {
  const SourceMesh& source = kernel.mesh();
  if (cuts) ofParts_ += cuts->points.size() * (sizeof(PlanPoint) + sizeof(PlanLine) + sizeof(CutSegment));
  if (mesh)
    ofParts_ += mesh->points.size() * (sizeof(PlanPoint) + sizeof(ApproximatePoint)) +
                mesh->lines.size() * sizeof(PlanLine) + mesh->facets.size() * sizeof(FaceMesh::Facet);
  if (2 * (faces_.size() + 1) > slots_.size()) growTable();
  const std::array<Vec3, 3> corners = cornersOf(source, face);
  slots_[slotOf(corners)] = static_cast<Index>(faces_.size());
  faces_.push_back({corners, obstacleEdgesOf(source, face), std::move(cuts), std::move(mesh), sizes_.size(),
                    places_.size(), ids_.size()});
  for (const Index v : source.triangles[face]) ids_.push_back(source.planIds[v]);
  for (const std::span<const Index> polygon : polygons) {
    sizes_.push_back(static_cast<Index>(polygon.size()));
    ids_.insert(ids_.end(), polygon.begin(), polygon.end());
    for (const Index id : polygon) places_.push_back(source.scaled[id]);
  }
}

bool CutFaces::hasPolygons(std::size_t number, const SourceMesh& source, Index face, PlanPolygons polygons,
                           std::vector<Index>& ids) const {
  const CutFace& cut = faces_[number];
  const std::size_t end = number + 1 < faces_.size() ? faces_[number + 1].firstSize : sizes_.size();
  if (cut.obstacleEdges != obstacleEdgesOf(source, face) || end - cut.firstSize != polygons.size()) return false;
  ids.clear();
  for (const Index v : source.triangles[face]) ids.push_back(source.planIds[v]);
  std::size_t at = cut.firstPlace;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    if (sizes_[cut.firstSize + i] != static_cast<Index>(polygons[i].size())) return false;
    for (const Index id : polygons[i]) {
      const Vec3 &then = places_[at++], &now = source.scaled[id];
      if (then.x != now.x || then.y != now.y) return false;
      ids.push_back(id);
    }
  }
  return true;
}

std::optional<CutFaces::Found> CutFaces::find(const PlanKernel& kernel, Index face, PlanPolygons polygons,
                                              CutCopies& copies) const {
  const SourceMesh& source = kernel.mesh();
  if (source.grid.scaleExponent() != scaleExponent_ || kernel.sign().slack != slack_ || slots_.empty())
    return std::nullopt;
  const Index number = slots_[slotOf(cornersOf(source, face))];
  if (number < 0 || !hasPolygons(static_cast<std::size_t>(number), source, face, polygons, copies.ids))
    return std::nullopt;
  const CutFace& cut = faces_[number];
  const std::span<const Index> before(ids_.data() + cut.firstId, copies.ids.size());
  if (std::equal(before.begin(), before.end(), copies.ids.begin())) return Found{cut.cuts, cut.mesh};
  const std::optional<NewNumbers> numbers = NewNumbers::of(before, copies.ids, copies.numbers);
  if (!numbers) return std::nullopt;
  FaceCuts* const cuts = copyInto(copies.memory, *cut.cuts);
  if (!numbers->renumberAll(*cuts)) return std::nullopt;
  if (!cut.mesh) return Found{{copies.memory, cuts}, nullptr};
  FaceMesh* const mesh = copyInto(copies.memory, *cut.mesh);
  if (!numbers->renumberAll(*mesh)) return std::nullopt;
  return Found{{copies.memory, cuts}, {copies.memory, mesh}};
}

std::size_t CutFaces::bytes() const {
  return ofParts_ + faces_.capacity() * sizeof(CutFace) + places_.capacity() * sizeof(Vec3) +
         (sizes_.capacity() + ids_.capacity() + slots_.capacity()) * sizeof(Index);
}

std::size_t bytesOf(const RadiusMemory& memory) {
  std::size_t bytes = memory.cutFaces.bytes() + memory.covered.capacity() * sizeof(memory.covered.front());
  for (const auto& part : memory.covered)
    if (part)
      bytes += part->places.capacity() * sizeof(Vec3) + part->triangles.capacity() * sizeof(std::array<Index, 3>);
  return bytes;
}

}  // namespace footfall::detail
