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
  static std::optional<NewNumbers> of(const std::vector<Index>& before, const std::vector<Index>& now) {
    NewNumbers numbers;
    for (std::size_t i = 0; i < before.size(); ++i) numbers.pairs_.emplace_back(before[i], now[i]);
    auto& pairs = numbers.pairs_;
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    for (std::size_t i = 1; i < pairs.size(); ++i)
      if (pairs[i - 1].first == pairs[i].first || pairs[i - 1].second >= pairs[i].second) return std::nullopt;
    return numbers;
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

  std::vector<std::pair<Index, Index>> pairs_;
};

}  // namespace

std::size_t CutFaceHash::operator()(const std::array<Vec3, 3>& corners) const {
  std::uint64_t mixed = 0;
  for (const Vec3& p : corners)
    for (const double x : {p.x, p.y, p.z})
      mixed = (std::rotl(mixed, 7) ^ std::bit_cast<std::uint64_t>(x)) * 0x9E3779B97F4A7C15U;
  return static_cast<std::size_t>(mixed ^ mixed >> 32);
}

void CutFaces::add(const PlanKernel& kernel, Index face, PlanPolygons polygons, std::shared_ptr<const FaceCuts> cuts,
                   std::shared_ptr<const FaceMesh> mesh) {
  const SourceMesh& source = kernel.mesh();
  CutFace cut{cornersOf(source, face), obstacleEdgesOf(source, face), {}, {}, {}, std::move(cuts), std::move(mesh)};
  for (const Index v : source.triangles[face]) cut.ids.push_back(source.planIds[v]);
  for (const std::span<const Index> polygon : polygons) {
    cut.sizes.push_back(static_cast<Index>(polygon.size()));
    for (const Index id : polygon) {
      cut.ids.push_back(id);
      cut.places.push_back(source.scaled[id]);
    }
  }
  faces_.insert_or_assign(cut.corners, std::move(cut));
}

std::optional<CutFaces::Found> CutFaces::find(const PlanKernel& kernel, Index face, PlanPolygons polygons) const {
  const SourceMesh& source = kernel.mesh();
  if (source.grid.scaleExponent() != scaleExponent_ || kernel.sign().slack != slack_) return std::nullopt;
  const auto known = faces_.find(cornersOf(source, face));
  if (known == faces_.end()) return std::nullopt;
  const CutFace& cut = known->second;
  if (cut.obstacleEdges != obstacleEdgesOf(source, face) || cut.sizes.size() != polygons.size()) return std::nullopt;
  std::vector<Index> ids;
  for (const Index v : source.triangles[face]) ids.push_back(source.planIds[v]);
  std::size_t at = 0;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    if (cut.sizes[i] != static_cast<Index>(polygons[i].size())) return std::nullopt;
    for (const Index id : polygons[i]) {
      const Vec3 &then = cut.places[at++], &now = source.scaled[id];
      if (then.x != now.x || then.y != now.y) return std::nullopt;
      ids.push_back(id);
    }
  }
  const std::optional<NewNumbers> numbers = NewNumbers::of(cut.ids, ids);
  if (!numbers) return std::nullopt;
  const auto cuts = std::make_shared<FaceCuts>(*cut.cuts);
  if (!numbers->renumberAll(*cuts)) return std::nullopt;
  if (!cut.mesh) return Found{cuts, nullptr};
  const auto mesh = std::make_shared<FaceMesh>(*cut.mesh);
  if (!numbers->renumberAll(*mesh)) return std::nullopt;
  return Found{cuts, mesh};
}

std::size_t CutFaces::bytes() const {
  std::size_t bytes = 0;
  for (const auto& [corners, cut] : faces_) {
    bytes += sizeof(corners) + sizeof(cut) + cut.sizes.capacity() * sizeof(Index) +
             cut.places.capacity() * sizeof(Vec3) + cut.ids.capacity() * sizeof(Index);
    if (cut.cuts) bytes += cut.cuts->points.size() * (sizeof(PlanPoint) + sizeof(PlanLine) + sizeof(CutSegment));
    if (cut.mesh)
      bytes += cut.mesh->points.size() * (sizeof(PlanPoint) + sizeof(ApproximatePoint)) +
               cut.mesh->lines.size() * sizeof(PlanLine) + cut.mesh->facets.size() * sizeof(FaceMesh::Facet);
  }
  return bytes;
}

std::size_t bytesOf(const RadiusMemory& memory) {
  std::size_t bytes = memory.cutFaces.bytes() + memory.covered.capacity() * sizeof(memory.covered.front());
  for (const auto& part : memory.covered)
    if (part)
      bytes += part->places.capacity() * sizeof(Vec3) + part->triangles.capacity() * sizeof(std::array<Index, 3>);
  return bytes;
}

}  // namespace footfall::detail
