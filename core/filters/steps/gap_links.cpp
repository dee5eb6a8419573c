// The part of StepLinker that links across gaps.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/filters/steps/step_linker.hpp"
#include "core/mesh/lifted_vertex.hpp"

namespace footfall::detail {
namespace {

constexpr double kUnit = GapConditions::kUnit;
constexpr double kSnap = GapConditions::kSnap;
/// Places of two borders that are nearer along a gap are across from each other.
constexpr double kAcross = 4 * kSnap;
/// Each line that cuts a border goes on so far behind it, so that rounding its ends hardly turns it.
constexpr double kArm = 0x1p20;
/// Coordinates of places are below that.
constexpr double kMostCoordinate = 0x1p36;
/// Splits bring forth others on the borders across. Where gaps are wide beside edges, and many borders face each other
/// at all angles, there is no end to that; what is not matched then is not linked, and counted.
constexpr int kRounds = 4;
/// So far an end is drawn in from where an obstacle touches it: by more than GapConditions left to be compared exactly.
constexpr double kDrawnIn = 4 * GapConditions::kSlack;

Vec3 roundToUnit(const Vec3& p) {
  return {std::nearbyint(p.x / kUnit) * kUnit, std::nearbyint(p.y / kUnit) * kUnit, p.z};
}
bool isNear(double x, double y, const Vec3& place) {
  return std::fabs(x - place.x) <= kSnap && std::fabs(y - place.y) <= kSnap;
}

}  // namespace

GapBorder StepLinker::gapBorderOf(const Border& border) const {
  const SourceMesh& source = kernel_->mesh();
  const int scale = source.grid.scaleExponent();
  const auto placeOf = [&](const MeshVertex& v) {
    if (v.error < 2 * kUnit) return Vec3{v.x, v.y, v.z};
    const Vec3 place = kernel_->roundedPosition(v.point, v.face);
    return Vec3{std::ldexp(place.x, scale), std::ldexp(place.y, scale), std::ldexp(place.z, scale)};
  };
  GapBorder result{placeOf(mesh_.vertices[border.from]), placeOf(mesh_.vertices[border.to]), {}};
  const auto& normal = source.normals[border.face];
  const auto isZero = [](const ErrorDouble& x) { return x.value == 0 && x.error == 0; };
  if (isZero(normal[0]) && isZero(normal[1])) result.level = source.scaled[source.triangles[border.face][0]].z;
  return result;
}

// Each border is tried with many others.
void StepLinker::findGapBorders() {
  constexpr std::size_t kBordersPerTask = 256;
  gapBorders_.resize(borders_.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, borders_.size(), kBordersPerTask), [&](const auto& range) {
    context_.checkCancelled();
    for (std::size_t i = range.begin(); i != range.end(); ++i) gapBorders_[i] = gapBorderOf(borders_[i]);
  });
}

void StepLinker::tryGap(Index first, Index second, Worker& worker) const {
  const Border &e = borders_[first], &f = borders_[second];
  if (e.edge == f.edge) return;
  const GapBorder &near = gapBorders_[first], &far = gapBorders_[second];
  std::optional<GapPiece> piece = worker.gaps.findNear(near, far);
  if (!piece) return;
  // Where they coincide, there is no gap.
  MeshGeometry& geometry = worker.geometry;
  const int from = geometry.orientation(e.from, e.to, f.from), to = geometry.orientation(e.from, e.to, f.to);
  if (from == 0 && to == 0) return;
  for (GapPiece& free : worker.gaps.findFree(near, far, *piece))
    worker.found.gaps.push_back({first, second, std::move(free), {}, false});
}

const MeshVertex* StepLinker::vertexAt(const Border& border, const GapFrame& frame, double along) const {
  const MeshVertex* best = nullptr;
  double least = kAcross;
  const auto look = [&](const MeshVertex& v) {
    const double distance = std::fabs(frame.along(v.x, v.y) - along);
    if (distance > least || (best != nullptr && distance == least)) return;
    best = &v;
    least = distance;
  };
  look(mesh_.vertices[border.from]);
  look(mesh_.vertices[border.to]);
  if (const auto found = splits_.find(border.edge); found != splits_.end())
    for (const MeshVertex& split : found->second) look(split);
  return best;
}

void StepLinker::planCut(GapStretch& stretch, Index number, double along, Cuts& cuts) {
  const Border& border = borders_[number];
  const GapFrame& frame = stretch.piece.frame;
  if (vertexAt(border, frame, along) != nullptr) return;
  const GapBorder line = gapBorderOf(border);
  const double begin = frame.along(line.from.x, line.from.y), end = frame.along(line.to.x, line.to.y);
  const double t = (along - begin) / (end - begin);
  const double across = frame.across(line.from.x, line.from.y) * (1 - t) + frame.across(line.to.x, line.to.y) * t;
  const Vec3 place = frame.place(along, across);
  std::vector<Vec3>& planned = cuts.places[border.edge];
  if (std::ranges::any_of(planned, [&](const Vec3& other) { return isNear(place.x, place.y, other); })) return;
  const Cut cut{number,
                {roundToUnit(frame.place(along, across - kArm)), roundToUnit(frame.place(along, across + kArm))}};
  for (const Vec3& p : cut.line)
    if (!(std::max(std::fabs(p.x), std::fabs(p.y)) < kMostCoordinate)) stretch.isDropped = true;
  if (stretch.isDropped) {
    ++undecided_;
    return;
  }
  planned.push_back(place);
  cuts.list.push_back(cut);
}

// The ends of all gaps, and what lies across from each vertex within one.
void StepLinker::planCuts(Cuts& cuts) {
  for (GapStretch& stretch : gaps_) {
    context_.checkCancelled();
    const auto [low, high] = stretch.piece.ends;
    for (const double end : {low, high})
      for (const Index border : {stretch.first, stretch.second})
        if (!stretch.isDropped) planCut(stretch, border, end, cuts);
    for (const auto& [own, other] :
         {std::array{stretch.first, stretch.second}, std::array{stretch.second, stretch.first}}) {
      const auto found = splits_.find(borders_[own].edge);
      if (found == splits_.end()) continue;
      for (const MeshVertex& split : found->second) {
        const double along = stretch.piece.frame.along(split.x, split.y);
        if (!stretch.isDropped && along > low + kAcross && along < high - kAcross) planCut(stretch, other, along, cuts);
      }
    }
  }
}

void StepLinker::makeCuts(const std::vector<Cut>& cuts) {
  std::vector<Vec3> places;
  const double anywhere = kernel_->mesh().scaled.front().z;
  for (const Cut& cut : cuts)
    for (const Vec3& p : cut.line) places.push_back({p.x, p.y, anywhere});
  if (cuts.empty()) return;
  auto mesh = std::make_shared<SourceMesh>(kernel_->mesh());
  if (!mesh->withoutPlaces) mesh->withoutPlaces = kernel_->sharedMesh();
  const std::vector<Index> ids = addPlanPlaces(*mesh, places);
  fallbacks_ += geometry_->fallbacks;
  geometry_.reset();
  kernel_ = std::make_shared<PlanKernel>(std::move(mesh), kernel_->heights(), kernel_->borders());
  geometry_.emplace(*kernel_, mesh_.vertices);
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    context_.checkCancelled();
    const Border& border = borders_[cuts[i].border];
    const Index a = ids[2 * i], b = ids[2 * i + 1];
    const std::vector<KnownLine> lines = linesOf(border, *geometry_);
    if (a == b || lines.empty()) continue;
    const auto& [line, face] = lines.front();
    const PlanLine across{PlanLine::Edge, std::min(a, b), std::max(a, b)};
    const PlanPoint point = PlanPoint::crossing(line, across, line.kind == PlanLine::Trace ? face : -1);
    if (insertSplit(border.edge, liftedVertex(*kernel_, border.face, point))) spreadSplits(border.edge);
  }
}

// Along steps, from an edge that got a vertex to all that must have it, too.
void StepLinker::spreadSplits(Index edge) {
  if (stretchesAt_.empty())
    for (std::size_t i = 0; i < stretches_.size(); ++i)
      for (const Index border : {stretches_[i].first, stretches_[i].second})
        stretchesAt_[borders_[border].edge].push_back(i);
  std::vector<Index> changed{edge};
  while (!changed.empty()) {
    const Index own = changed.back();
    changed.pop_back();
    const auto found = stretchesAt_.find(own);
    if (found == stretchesAt_.end()) continue;
    for (const std::size_t i : found->second) {
      const Stretch& s = stretches_[i];
      const Index first = borders_[s.first].edge, other = own == first ? borders_[s.second].edge : first;
      bool isChanged = false;
      for (const MeshVertex& split : splitsBetween(own, s.begin, s.end))
        isChanged = insertSplit(other, split) || isChanged;
      if (isChanged) changed.push_back(other);
    }
  }
}

// Whether an obstacle meets the quadrangle p[0] q[0] q[1] p[1] at nothing but points of the side from p[end] to q[end]:
// the line of that side parts them, or the line of one of the obstacle's edges, on which neither both p nor both q lie.
bool StepLinker::isOutside(Index obstacle, const Corners& p, const Corners& q, int end) {
  const SourceMesh& source = kernel_->mesh();
  const auto& corners = source.triangles[obstacle];
  const Index origin = source.triangles[p[0]->face][0];
  const auto turn = [&](const PlanPoint& a, const PlanPoint& b, const PlanPoint& c) {
    return kernel_->orientation(a, b, c, origin, geometry_->fallbacks);
  };
  const auto placeOf = [&](Index v) { return PlanPoint::source(source.planIds[v]); };
  const int outer = end == 0 ? -1 : 1;
  if (std::ranges::all_of(corners,
                          [&](Index v) { return outer * turn(p[end]->point, q[end]->point, placeOf(v)) >= 0; }))
    return true;
  for (int k = 0; k < 3; ++k) {
    const PlanPoint a = placeOf(corners[k]), b = placeOf(corners[next(k)]);
    if (a == b) continue;
    const std::array<int, 2> onP{turn(a, b, p[0]->point), turn(a, b, p[1]->point)};
    const std::array<int, 2> onQ{turn(a, b, q[0]->point), turn(a, b, q[1]->point)};
    if ((onP[0] == 0 && onP[1] == 0) || (onQ[0] == 0 && onQ[1] == 0)) continue;
    for (const int side : {1, -1}) {  // that of the quadrangle
      if (side * source.facing[obstacle] > 0) continue;
      if (side * onP[0] >= 0 && side * onP[1] >= 0 && side * onQ[0] >= 0 && side * onQ[1] >= 0) return true;
    }
  }
  return false;
}

bool StepLinker::isWider(const MeshVertex& a, const MeshVertex& b) const {
  const auto p = kernel_->exactPosition(a.point, a.face), q = kernel_->exactPosition(b.point, b.face);
  const mpq_class x = p[0] - q[0], y = p[1] - q[1], gap(gap_);
  return x * x + y * y > gap * gap;
}

// Its corners are those of a convex quadrangle, or of a triangle where both borders meet at an end; all obstacles are
// beyond it. `end` is set to an end that an obstacle reaches, or at which both meet, else to -1; `isOverlap` says that
// there is no gap.
bool StepLinker::isProven(const GapStretch& stretch, int& end, bool& isOverlap) {
  end = -1;
  isOverlap = false;
  const GapPiece& piece = stretch.piece;
  Corners p{}, q{};  // low and high, on the first border and on the second one
  for (const int i : {0, 1}) {
    p[i] = vertexAt(borders_[stretch.first], piece.frame, piece.ends[i]);
    q[i] = vertexAt(borders_[stretch.second], piece.frame, piece.ends[i]);
    if (p[i] == nullptr || q[i] == nullptr) return false;
  }
  const Index origin = kernel_->mesh().triangles[p[0]->face][0];
  const auto turn = [&](const MeshVertex* a, const MeshVertex* b, const MeshVertex* c) {
    return kernel_->orientation(a->point, b->point, c->point, origin, geometry_->fallbacks);
  };
  const std::array turns{turn(p[1], p[0], q[0]), turn(p[0], q[0], q[1]), turn(q[0], q[1], p[1]),
                         turn(q[1], p[1], p[0])};
  isOverlap = std::ranges::any_of(turns, [](int sign) { return sign < 0; }) || std::ranges::count(turns, 0) > 2;
  if (isOverlap) {  // only where they meet, in places that are nearly one?
    for (const int i : {0, 1})
      if (!stretch.isDrawnIn[i] && std::max(std::fabs(p[i]->x - q[i]->x), std::fabs(p[i]->y - q[i]->y)) <= kAcross)
        end = i;
    return false;
  }
  if (piece.isAsWide && (isWider(*p[0], *q[0]) || isWider(*p[1], *q[1]))) return false;
  for (const int i : {0, 1})
    for (const Index obstacle : piece.touching[i])
      if (!stretch.isDrawnIn[i] && !isOutside(obstacle, p, q, i)) {
        end = i;
        return false;
      }
  return true;
}

bool StepLinker::proveGaps() {
  bool isChanged = false;
  for (GapStretch& stretch : gaps_) {
    context_.checkCancelled();
    if (stretch.isDropped) continue;
    int end = -1;
    bool isOverlap = false;
    if (isProven(stretch, end, isOverlap)) continue;
    if (end >= 0 && !stretch.isDrawnIn[end]) {
      stretch.isDrawnIn[end] = true;
      stretch.piece.ends[end] += (end == 0 ? 1 : -1) * kDrawnIn;
      if (stretch.piece.ends[1] - stretch.piece.ends[0] > GapConditions::kShort) {
        isChanged = true;
        continue;
      }
    }
    stretch.isDropped = true;
    undecided_ += isOverlap ? 0 : 1;
  }
  return isChanged;
}

void StepLinker::splitAtGaps() {
  for (int round = 0; round < kRounds; ++round) {
    context_.checkCancelled();
    Cuts cuts;
    planCuts(cuts);
    if (cuts.list.empty() && !proveGaps()) return;
    makeCuts(cuts.list);
  }
  while (proveGaps()) context_.checkCancelled();  // what is still drawn in then has no vertices there, and goes
}

// Both in their own directions. Of the vertices within the gap, those that lie across from each other are paired;
// between two such pairs without another vertex there is a link.
void StepLinker::addGapLinks(WalkableMesh& result, const GapStretch& stretch, const std::vector<Index>& from,
                             const std::vector<Index>& to) {
  struct Place {
    Index vertex = -1;
    double along = 0;
  };
  const auto placesOf = [&](const std::vector<Index>& chain) {
    std::vector<Place> places;
    for (const Index v : chain) {
      const double along = stretch.piece.frame.along(result.vertices[v].x, result.vertices[v].y);
      if (along > stretch.piece.ends[0] - kAcross && along < stretch.piece.ends[1] + kAcross)
        places.push_back({v, along});
    }
    return places;
  };
  const std::vector<Place> first = placesOf(from);
  std::vector<Place> second = placesOf(to);
  std::reverse(second.begin(), second.end());
  std::size_t i = 0, j = 0;
  std::optional<std::array<std::size_t, 2>> last;
  while (i < first.size() && j < second.size()) {
    const double distance = first[i].along - second[j].along;
    if (std::fabs(distance) > kAcross) {
      ++(distance < 0 ? i : j);
      continue;
    }
    if (last && (*last)[0] + 1 == i && (*last)[1] + 1 == j) {
      MeshLink link{{first[i - 1].vertex, first[i].vertex}, {second[j].vertex, second[j - 1].vertex}, true};
      if (link.to < link.from) std::swap(link.from, link.to);
      result.links.push_back(link);
    } else if (last) {
      ++undecided_;
    }
    last = {i++, j++};
  }
}

}  // namespace footfall::detail
