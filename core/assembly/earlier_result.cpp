// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assembly/earlier_result.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>

#include "core/assembly/assembly_memory.hpp"
#include "core/exact/plan_places.hpp"

namespace footfall::detail {
namespace {

// A tree pays off from this number of boxes on.
constexpr std::size_t kManyBoxes = 32;

// True when a point depends on a height above a floor.
bool usesLevel(const PlanPoint& point) {
  const auto isRaised = [](const PlanLine& line) { return line.kind == PlanLine::Trace && line.b != 0; };
  if (point.kind() == PlanPoint::EdgePlane) return point.level() != 0;
  return point.kind() == PlanPoint::Crossing && (isRaised(point.firstLine()) || isRaised(point.secondLine()));
}

const std::shared_ptr<const SourceMesh>& withoutPlaces(const PlanKernel& kernel) {
  const auto& mesh = kernel.sharedMesh();
  return mesh->withoutPlaces ? mesh->withoutPlaces : mesh;
}

Box boxAround(const std::vector<Box>& boxes) {
  Box all;
  all.lower.fill(std::numeric_limits<double>::infinity());
  all.upper.fill(-std::numeric_limits<double>::infinity());
  for (const Box& b : boxes)
    for (int k = 0; k < 3; ++k) {
      all.lower[k] = std::min(all.lower[k], b.lower[k]);
      all.upper[k] = std::max(all.upper[k], b.upper[k]);
    }
  return all;
}

}  // namespace

std::optional<EarlierResult> EarlierResult::relate(const StatePtr& before, const PlanKernel& now) {
  if (!before) return std::nullopt;
  const auto& mesh = withoutPlaces(now);
  const auto& meshBefore = withoutPlaces(*before->kernel);
  const bool sameHeights = before->kernel->heights() == now.heights();
  if (meshBefore == mesh) return EarlierResult(before, nullptr, now, sameHeights);
  if (mesh->edit && mesh->edit->base.lock() == meshBefore) return EarlierResult(before, mesh->edit, now, sameHeights);
  return std::nullopt;
}

EarlierResult::EarlierResult(StatePtr before, std::shared_ptr<const SourceEdit> edit, const PlanKernel& now,
                             bool sameHeights)
    : before_(std::move(before)), edit_(std::move(edit)), sameHeights_(sameHeights) {
  const SourceMesh& mesh = before_->kernel->mesh();
  sourcesBefore_ = static_cast<Index>(mesh.vertices.size() - mesh.planPlaces);
  hasSameNumbers_ = !edit_ && (mesh.planPlaces == 0 || &mesh == &now.mesh());
  if (!hasSameNumbers_) placeNow_ = relatePlanPlaces(mesh, now.mesh());
  if (!edit_) return;
  removed_ = boxAround(edit_->removed);
  added_ = boxAround(edit_->added);
  if (edit_->removed.size() + edit_->added.size() < kManyBoxes) return;
  std::vector<Box> boxes = edit_->removed;
  boxes.insert(boxes.end(), edit_->added.begin(), edit_->added.end());
  std::vector<std::int32_t> ids(boxes.size());
  std::iota(ids.begin(), ids.end(), 0);
  auto tree = std::make_shared<TriangleTree>();
  tree->build(boxes, ids);
  tree_ = std::move(tree);
}

bool EarlierResult::isSame(const MeshVertex& before, const MeshVertex& now) const {
  if (before.x != now.x || before.y != now.y || before.z != now.z || before.error != now.error) return false;
  if (!sameHeights_ && usesLevel(now.point)) return false;
  if (hasSameNumbers_) return before.point == now.point && before.face == now.face && before.source == now.source;
  return faceNow(before.face) == now.face &&
         (before.source < 0 ? now.source < 0 : vertexNow(before.source) == now.source) &&
         renumbered(before.point) == now.point;
}

MeshVertex EarlierResult::vertexNow(const MeshVertex& before) const {
  MeshVertex now = before;
  if (hasSameNumbers_) return now;
  now.point = renumbered(before.point);
  now.face = faceNow(before.face);
  if (before.source >= 0) now.source = vertexNow(before.source);
  return now;
}

bool EarlierResult::hasPlaces(const PlanPoint& before) const {
  if (hasSameNumbers_) return true;
  const auto isThere = [this](const PlanLine& line) {
    return line.kind != PlanLine::Edge || (planNow(line.a) >= 0 && planNow(line.b) >= 0);
  };
  if (before.kind() == PlanPoint::Source) return planNow(before.planId()) >= 0;
  return before.kind() != PlanPoint::Crossing || (isThere(before.firstLine()) && isThere(before.secondLine()));
}

bool EarlierResult::hasSameLines(Index face, const CutTable& now) const {
  const Index before = faceBefore(face);
  if (before < 0) return false;
  const auto &then = (*before_->cuts)[before].lines, &lines = now[face].lines;
  return std::equal(then.begin(), then.end(), lines.begin(), lines.end(),
                    [&](const PlanLine& a, const PlanLine& b) { return renumbered(a) == b; });
}

bool EarlierResult::hasSameCuts(Index face, const CutTable& now) const {
  if (!hasSameLines(face, now)) return false;
  const FaceCuts &then = (*before_->cuts)[faceBefore(face)], &cuts = now[face];
  const auto isSamePoint = [&](const PlanPoint& a, const PlanPoint& b) {
    return (sameHeights_ || !usesLevel(a)) && renumbered(a) == b;
  };
  const auto isSameSegment = [](const CutSegment& a, const CutSegment& b) {
    return a.from == b.from && a.to == b.to && a.line == b.line && a.direction == b.direction &&
           a.winding == b.winding && a.wall == b.wall;
  };
  const auto isRaised = [](const PlanLine& line) { return line.kind == PlanLine::Trace && line.b != 0; };
  return then.removed == cuts.removed && then.edgeWalls == cuts.edgeWalls && then.startWinding == cuts.startWinding &&
         (sameHeights_ || std::none_of(then.lines.begin(), then.lines.end(), isRaised)) &&
         std::equal(then.points.begin(), then.points.end(), cuts.points.begin(), cuts.points.end(), isSamePoint) &&
         std::equal(then.borders.begin(), then.borders.end(), cuts.borders.begin(), cuts.borders.end()) &&
         std::equal(then.segments.begin(), then.segments.end(), cuts.segments.begin(), cuts.segments.end(),
                    isSameSegment);
}

bool EarlierResult::isTouched(const Box& box) const {
  if (!edit_) return false;
  if (tree_) {
    if (!overlap(removed_, box) && !overlap(added_, box)) return false;
    std::vector<std::int32_t> stack;
    bool isFound = false;
    tree_->visitOverlapping(box, stack, [&](std::int32_t id) {
      const auto i = static_cast<std::size_t>(id), removed = edit_->removed.size();
      isFound = overlap(i < removed ? edit_->removed[i] : edit_->added[i - removed], box);
      return !isFound;
    });
    return isFound;
  }
  const auto any = [&](const Box& all, const std::vector<Box>& boxes) {
    return overlap(all, box) && std::any_of(boxes.begin(), boxes.end(), [&](const Box& b) { return overlap(b, box); });
  };
  return any(removed_, edit_->removed) || any(added_, edit_->added);
}

PlanLine EarlierResult::renumbered(PlanLine line) const {
  if (hasSameNumbers_) return line;
  if (line.kind == PlanLine::Edge) {
    line.a = planNow(line.a);
    line.b = planNow(line.b);
  } else if (line.kind == PlanLine::Trace) {
    line.a = faceNow(line.a);
  }
  return line;
}

PlanPoint EarlierResult::renumbered(const PlanPoint& point) const {
  if (hasSameNumbers_) return point;
  switch (point.kind()) {
    case PlanPoint::Source:
      return PlanPoint::source(planNow(point.planId()));
    case PlanPoint::EdgePlane:
      return PlanPoint::edgePlane(vertexNow(point.edgeBegin()), vertexNow(point.edgeEnd()), faceNow(point.triangle()),
                                  point.level());
    default:
      return PlanPoint::crossing(renumbered(point.firstLine()), renumbered(point.secondLine()),
                                 point.face() >= 0 ? faceNow(point.face()) : -1);
  }
}

std::shared_ptr<const FaceCuts> EarlierResult::cuts(Index faceBefore, const CopyMemory& memory) const {
  const auto& shared = before_->cuts->shared(faceBefore);
  if (hasSameNumbers_ || !shared) return shared;
  FaceCuts* const result = copyInto(memory, *shared);
  for (PlanPoint& p : result->points) p = renumbered(p);
  for (PlanLine& l : result->lines) l = renumbered(l);
  return {memory, result};
}

std::shared_ptr<const FaceMesh> EarlierResult::mesh(Index faceBefore, const CopyMemory& memory) const {
  const auto& shared = before_->memory->meshes[faceBefore];
  if (hasSameNumbers_ || !shared) return shared;
  FaceMesh* const result = copyInto(memory, *shared);
  for (PlanPoint& p : result->points) p = renumbered(p);
  for (PlanLine& l : result->lines) l = renumbered(l);
  return {memory, result};
}

std::shared_ptr<const std::pmr::vector<Index>> EarlierResult::candidates(Index faceBefore,
                                                                         const CopyMemory& memory) const {
  const auto& shared = before_->memory->candidates[faceBefore];
  if (!edit_ || !shared) return shared;
  std::pmr::vector<Index>* const result = copyInto(memory, *shared);
  for (Index& t : *result) t = edit_->triangleOf[t];
  std::erase(*result, -1);
  return {memory, result};
}

std::vector<Index> EarlierResult::gone(Index faceBefore) const {
  std::vector<Index> result;
  const auto& shared = before_->memory->candidates[faceBefore];
  if (!edit_ || !shared) return result;
  std::copy_if(shared->begin(), shared->end(), std::back_inserter(result),
               [&](Index t) { return edit_->triangleOf[t] < 0; });
  return result;
}

std::array<Box, 2> EarlierResult::changedIn(const Box& box) const {
  const auto around = [&](const std::vector<Box>& boxes) {
    std::vector<Box> near;
    std::copy_if(boxes.begin(), boxes.end(), std::back_inserter(near), [&](const Box& b) { return overlap(b, box); });
    return boxAround(near);
  };
  return edit_ ? std::array{around(edit_->removed), around(edit_->added)} : std::array{boxAround({}), boxAround({})};
}

const std::vector<Index>& EarlierResult::added() const {
  static const std::vector<Index> kNone;
  return edit_ ? edit_->addedTriangles : kNone;
}

}  // namespace footfall::detail
