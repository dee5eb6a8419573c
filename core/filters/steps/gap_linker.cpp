// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/steps/gap_linker.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "core/base/index_and_box.hpp"
#include "core/exact/plan_places.hpp"
#include "core/mesh/lifted_vertex.hpp"

namespace footfall::detail {
namespace {

constexpr double kUnit = GapConditions::kUnit;
constexpr double kSnap = GapConditions::kSnap;
constexpr double kAcross = GapConditions::kAcross;
/// The length by which a line that cuts a border extends behind it, so that rounding its ends hardly turns it.
constexpr double kArm = 0x1p20;
/// The bound of the coordinates of places.
constexpr double kMostCoordinate = 0x1p36;
/// The limit of rounds. Splits cause further splits on the borders across. Where gaps are wide compared with edges, and
/// many borders face each other at all angles, this does not end; parts that are not matched by then get no link, and
/// are counted.
constexpr int kRounds = 4;
/// A later round makes at most as many cuts as the first one, plus this number for each gap. Time and memory thus stay
/// proportional to the gaps where cuts cause more and more cuts.
constexpr std::size_t kCutsOfGap = 4, kFewCuts = 64;
/// The distance by which an end is drawn in from an obstacle that touches it. It is more than GapConditions leaves to
/// exact comparison.
constexpr double kDrawnIn = 4 * GapConditions::kSlack;
/// Constants of the first comparison of two borders by rounded vertices: the distance that counts as touching, scaled;
/// the factor by which borders must exceed their errors for their directions to be reliable; and a value a little less
/// than the least cosine of two borders.
constexpr double kRough = 1;
constexpr double kLong = 0x1p12;
constexpr double kRoughCosine = 0.12;

Vec3 roundToUnit(const Vec3& p) {
  return {std::nearbyint(p.x / kUnit) * kUnit, std::nearbyint(p.y / kUnit) * kUnit, p.z};
}
bool isNear(const Vec3& a, const Vec3& b) { return std::fabs(a.x - b.x) <= kSnap && std::fabs(a.y - b.y) <= kSnap; }
Vec3 middleOf(const GapBorder& line, const GapPiece& piece) {
  const double begin = piece.frame.along(line.from.x, line.from.y), end = piece.frame.along(line.to.x, line.to.y);
  const double t = std::clamp(((piece.ends[0] + piece.ends[1]) / 2 - begin) / (end - begin), 0.0, 1.0);
  return {line.from.x + t * (line.to.x - line.from.x), line.from.y + t * (line.to.y - line.from.y), 0};
}
double longerOf(const GapBorder& line, const Vec3& place) {
  return std::fabs(line.to.x - line.from.x) >= std::fabs(line.to.y - line.from.y) ? place.x : place.y;
}

}  // namespace

GapLinker::GapLinker(BorderSplits& splits, double gap, RunContext& context)
    : splits_(splits), context_(context), gap_(gap) {}

Vec3 GapLinker::placeOf(const MeshVertex& v) const {
  if (v.error < 2 * kUnit) return {v.x, v.y, v.z};
  const PlanKernel& kernel = *splits_.kernel();
  const int scale = kernel.mesh().grid.scaleExponent();
  const Vec3 place = kernel.roundedPosition(v.point, v.face);
  return {std::ldexp(place.x, scale), std::ldexp(place.y, scale), std::ldexp(place.z, scale)};
}

GapBorder GapLinker::lineOf(const MeshVertex& from, const MeshVertex& to, Index face) const {
  const SourceMesh& source = splits_.kernel()->mesh();
  GapBorder result{placeOf(from), placeOf(to), {}};
  const auto& normal = source.normals[face];
  const auto isZero = [](const ErrorDouble& x) { return x.value == 0 && x.error == 0; };
  if (isZero(normal[0]) && isZero(normal[1])) result.level = source.scaled[source.triangles[face][0]].z;
  return result;
}

GapBorder GapLinker::computeLine(Index number) const {
  const MeshBorder& border = splits_.border(number);
  return lineOf(splits_.vertex(border.from), splits_.vertex(border.to), border.face);
}

const GapBorder& GapLinker::lineOf(Index border) {
  const auto [line, isNew] = lines_.try_emplace(border);
  if (isNew) line->second = computeLine(border);
  return line->second;
}

// A way over a gap lies within the gap's width on the right of the first border's line, and its length along the line
// is no larger.
bool GapLinker::mayFace(const MeshBorder& e, const MeshBorder& f) const {
  const MeshVertex &a = splits_.vertex(e.from), &b = splits_.vertex(e.to);
  const std::array<const MeshVertex*, 2> ends{&splits_.vertex(f.to), &splits_.vertex(f.from)};
  const double error = 8 * std::max({a.error, b.error, ends[0]->error, ends[1]->error}) + kRough;
  const double ex = b.x - a.x, ey = b.y - a.y, length = std::sqrt(ex * ex + ey * ey);
  const double fx = ends[1]->x - ends[0]->x, fy = ends[1]->y - ends[0]->y, other = std::sqrt(fx * fx + fy * fy);
  if (!(length > kLong * error) || !(other > kLong * error)) return true;
  if (ex * fx + ey * fy < kRoughCosine * length * other) return false;
  const double gap = std::ldexp(gap_, splits_.kernel()->mesh().grid.scaleExponent());
  std::array<double, 2> along{}, outwards{};
  double slack = 0;
  for (const int i : {0, 1}) {
    const double x = ends[i]->x - a.x, y = ends[i]->y - a.y;
    along[i] = (x * ex + y * ey) / length;
    outwards[i] = (x * ey - y * ex) / length;
    slack = std::max(slack, error * (1 + (std::fabs(x) + std::fabs(y)) / length));
  }
  const auto [nearest, farthest] = std::minmax({outwards[0], outwards[1]});
  const auto [first, last] = std::minmax({along[0], along[1]});
  return nearest <= gap + slack && farthest >= -slack && first <= length + gap + slack && last >= -gap - slack;
}

std::vector<GapStretch> GapLinker::find(Index first, Index second, GapConditions& conditions, GapLines& lines) const {
  std::vector<GapStretch> found;
  const MeshBorder &e = splits_.border(first), &f = splits_.border(second);
  if (!mayFace(e, f)) return found;
  const auto lineOf = [&](Index number) {
    const auto slot = static_cast<std::size_t>(number % GapLines::kCount);
    if (lines.numbers[slot] != number) {
      lines.lines[slot] = computeLine(number);
      lines.numbers[slot] = number;
    }
    return lines.lines[slot];
  };
  const GapBorder line = lineOf(first), other = lineOf(second);
  const double longest = std::ldexp(GapConditions::kShortInGaps * gap_, splits_.kernel()->mesh().grid.scaleExponent());
  for (GapPiece& free : conditions.find(line, other)) {
    if (!free.corner && free.ends[1] - free.ends[0] <= longest) free.corner = middleOf(line, free);
    found.push_back({first, second, std::move(free), {}, false});
  }
  return found;
}

std::vector<GapStretch> GapLinker::findAgain(Index first, Index second, const std::array<GapBorder, 2>& edges,
                                             GapConditions* conditions) {
  std::vector<GapStretch> found;
  const GapBorder &e = lineOf(first), &f = lineOf(second);
  const std::optional<GapFrame> frame = GapConditions::frameOf(e, f, edges);
  if (!frame) return found;
  GapPiece piece{*frame, {}, {}};
  const auto along = [&](std::size_t border, const Vec3& place) {
    return piece.frameOf(border).along(place.x, place.y);
  };
  const std::array<double, 2> across{along(0, edges[1].to), along(0, edges[1].from)};
  piece.ends = {along(0, edges[0].from), along(0, edges[0].to)};
  if (std::max(std::fabs(across[0] - piece.ends[0]), std::fabs(across[1] - piece.ends[1])) > GapConditions::kMostOff &&
      std::min(across[1] - across[0], piece.ends[1] - piece.ends[0]) > GapConditions::kShort)
    piece.setWays(across);
  piece.ends = {std::max({along(0, e.from), along(1, f.to), piece.ends[0], along(1, edges[1].to)}),
                std::min({along(0, e.to), along(1, f.from), piece.ends[1], along(1, edges[1].from)})};
  if (!(piece.ends[1] - piece.ends[0] > GapConditions::kShort)) return found;
  const GapStretch whole{first, second, std::move(piece), {}, false};
  if (conditions == nullptr) return {whole};
  for (GapPiece& free : conditions->findFree(e, f, whole.piece))
    found.push_back({first, second, std::move(free), {}, false});
  return found;
}

void GapLinker::add(std::vector<GapStretch> stretches) {
  for (const GapStretch& stretch : stretches) known_.push_back({stretch.piece.ends});
  std::move(stretches.begin(), stretches.end(), std::back_inserter(gaps_));
}

GapLinker::Chain GapLinker::chainOf(Index number) {
  static const std::vector<Vec3> kNone;
  const MeshBorder& border = splits_.border(number);
  const std::vector<MeshVertex>& inside = splits_.of(border.edge);
  const GapBorder& line = lineOf(number);
  if (inside.empty()) return {line, kNone};
  std::vector<Vec3>& places = places_[border.edge];
  if (places.size() != inside.size()) {
    places.clear();
    for (const MeshVertex& v : inside) places.push_back(placeOf(v));
  }
  return {line, places, splits_.isForward(border)};
}

GapLinker::ChainPart GapLinker::partOf(const Chain& chain, const GapFrame& frame, double low, double high) {
  const std::size_t count = chain.length();
  const bool isAscending = chain.along(frame, 0) < chain.along(frame, count - 1);
  const auto firstWhere = [&](const auto& holds) {
    std::size_t begin = 0, end = count;
    while (begin < end) {
      const std::size_t middle = begin + (end - begin) / 2;
      if (holds(chain.along(frame, middle)))
        end = middle;
      else
        begin = middle + 1;
    }
    return begin;
  };
  if (isAscending)
    return {firstWhere([&](double along) { return along >= low; }),
            firstWhere([&](double along) { return along > high; })};
  return {firstWhere([&](double along) { return along <= high; }),
          firstWhere([&](double along) { return along < low; })};
}

std::optional<std::size_t> GapLinker::findAt(const Chain& chain, const GapFrame& frame, double along) {
  const ChainPart part = partOf(chain, frame, along - kAcross, along + kAcross);
  std::optional<std::size_t> best;
  double least = 0;
  for (std::size_t i = part.begin; i < part.end; ++i) {
    const double distance = std::fabs(chain.along(frame, i) - along);
    if (best && distance >= least) continue;
    best = i;
    least = distance;
  }
  return best;
}

const MeshVertex* GapLinker::vertexAt(Index number, const GapFrame& frame, double along) {
  const std::optional<std::size_t> found = findAt(chainOf(number), frame, along);
  return found ? &splits_.chainVertex(splits_.border(number), *found) : nullptr;
}

void GapLinker::planCut(GapStretch& stretch, std::size_t own, const Chain& chain, double along, Cuts& cuts) {
  if (findAt(chain, stretch.piece.frameOf(own), along)) return;
  const Index number = own == 0 ? stretch.first : stretch.second;
  const GapFrame& frame = stretch.piece.frame;
  const GapBorder& line = chain.line;
  const double begin = frame.along(line.from.x, line.from.y), end = frame.along(line.to.x, line.to.y);
  if (own == 1) along = stretch.piece.placeAcross(along);
  const double t = (along - begin) / (end - begin);
  const double across = frame.across(line.from.x, line.from.y) * (1 - t) + frame.across(line.to.x, line.to.y) * t;
  const Vec3 place = frame.place(along, across);
  auto& planned = cuts.places[splits_.border(number).edge];
  const double key = longerOf(line, place);
  for (auto it = planned.lower_bound(key - kSnap); it != planned.end() && it->first <= key + kSnap; ++it)
    if (isNear(place, it->second)) return;
  const Cut cut{number,
                {roundToUnit(frame.place(along, across - kArm)), roundToUnit(frame.place(along, across + kArm))}};
  for (const Vec3& p : cut.line)
    if (!(std::max(std::fabs(p.x), std::fabs(p.y)) < kMostCoordinate)) stretch.isDropped = true;
  if (stretch.isDropped) {
    ++undecided_;
    return;
  }
  planned.emplace(key, place);
  cuts.list.push_back(cut);
}

// The ends of the gaps, and what lies across from each vertex within one.
bool GapLinker::planCuts(const Group& group, Cuts& cuts) {
  for (const std::size_t gap : group.gaps) {
    GapStretch& stretch = gaps_[gap];
    context_.checkCancelled();
    if (cuts.list.size() > cuts.most) return false;
    if (stretch.isDropped || isSettled(gap)) continue;
    const auto [low, high] = stretch.piece.ends;
    const std::array chains{chainOf(stretch.first), chainOf(stretch.second)};
    for (const double end : {low, high})
      for (const std::size_t k : {0, 1})
        if (!stretch.isDropped) planCut(stretch, k, chains[k], end, cuts);
    for (const std::size_t k : {0, 1}) {
      const Chain& own = chains[k];
      const GapFrame& frame = stretch.piece.frameOf(k);
      const ChainPart part = partOf(own, frame, low + kAcross, high - kAcross);
      const std::size_t last = std::min(part.end, own.length() - 1);
      for (std::size_t i = std::max<std::size_t>(part.begin, 1); i < last && !stretch.isDropped; ++i)
        planCut(stretch, 1 - k, chains[1 - k], own.along(frame, i), cuts);
    }
  }
  return true;
}

void GapLinker::makeCuts(const std::vector<Cut>& cuts, const Spread& spread) {
  if (cuts.empty()) return;
  const PlanKernel& before = *splits_.kernel();
  std::vector<Vec3> places;
  const double anywhere = before.mesh().scaled.front().z;
  for (const Cut& cut : cuts)
    for (const Vec3& p : cut.line) places.push_back({p.x, p.y, anywhere});
  auto mesh = std::make_shared<SourceMesh>(before.mesh());
  if (!mesh->withoutPlaces) mesh->withoutPlaces = before.sharedMesh();
  const std::vector<Index> ids = addPlanPlaces(*mesh, places, context_);
  splits_.replaceKernel(std::make_shared<PlanKernel>(std::move(mesh), before.heights(), before.borders()));
  std::vector<Index> changed;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    context_.checkCancelled();
    const MeshBorder& border = splits_.border(cuts[i].border);
    const Index a = ids[2 * i], b = ids[2 * i + 1];
    const std::vector<KnownLine> lines = splits_.linesOf(border, splits_.geometry());
    if (a == b || lines.empty()) continue;
    const auto& [line, face] = lines.front();
    const PlanLine across{PlanLine::Edge, std::min(a, b), std::max(a, b)};
    const PlanPoint point = PlanPoint::crossing(line, across, line.kind == PlanLine::Trace ? face : -1);
    if (splits_.insert(border.edge, liftedVertex(*splits_.kernel(), border.face, point)))
      changed.push_back(border.edge);
  }
  spread(changed);
}

// Returns whether an obstacle meets the quadrangle p[0] q[0] q[1] p[1] in nothing but points of the side from p[end] to
// q[end]. Then the line of that side separates them, or the line of one of the obstacle's edges, on which neither both
// p nor both q lie.
bool GapLinker::isOutside(Index obstacle, const Corners& p, const Corners& q, int end) {
  const PlanKernel& kernel = *splits_.kernel();
  const SourceMesh& source = kernel.mesh();
  const auto& corners = source.triangles[obstacle];
  const Index origin = source.triangles[p[0]->face][0];
  const auto turn = [&](const PlanPoint& a, const PlanPoint& b, const PlanPoint& c) {
    return kernel.orientation(a, b, c, origin, fallbacks_);
  };
  const auto pointOf = [&](Index v) { return PlanPoint::source(source.planIds[v]); };
  const int outer = end == 0 ? -1 : 1;
  if (std::ranges::all_of(corners,
                          [&](Index v) { return outer * turn(p[end]->point, q[end]->point, pointOf(v)) >= 0; }))
    return true;
  for (int k = 0; k < 3; ++k) {
    const PlanPoint a = pointOf(corners[k]), b = pointOf(corners[next(k)]);
    if (a == b) continue;
    const std::array<int, 2> onP{turn(a, b, p[0]->point), turn(a, b, p[1]->point)};
    const std::array<int, 2> onQ{turn(a, b, q[0]->point), turn(a, b, q[1]->point)};
    if ((onP[0] == 0 && onP[1] == 0) || (onQ[0] == 0 && onQ[1] == 0)) continue;
    for (const int side : {1, -1}) {  // side of the quadrangle
      if (side * source.facing[obstacle] > 0) continue;
      if (side * onP[0] >= 0 && side * onP[1] >= 0 && side * onQ[0] >= 0 && side * onQ[1] >= 0) return true;
    }
  }
  return false;
}

bool GapLinker::isWider(const MeshVertex& a, const MeshVertex& b) const {
  const PlanKernel& kernel = *splits_.kernel();
  const auto p = kernel.exactPosition(a.point, a.face), q = kernel.exactPosition(b.point, b.face);
  const mpq_class x = p[0] - q[0], y = p[1] - q[1], gap(gap_);
  return x * x + y * y > gap * gap;
}

// A gap is free when its corners form a convex quadrangle, or a triangle where both borders meet at an end, and all
// obstacles are beyond it.
GapLinker::Proof GapLinker::prove(const GapStretch& stretch) {
  const GapPiece& piece = stretch.piece;
  Corners p{}, q{};  // low and high, on the first border and on the second one
  for (const int i : {0, 1}) {
    p[i] = vertexAt(stretch.first, piece.frameOf(0), piece.ends[i]);
    q[i] = vertexAt(stretch.second, piece.frameOf(1), piece.ends[i]);
    if (p[i] == nullptr || q[i] == nullptr) return {Fault::Unknown, -1};
  }
  const PlanKernel& kernel = *splits_.kernel();
  const Index origin = kernel.mesh().triangles[p[0]->face][0];
  const auto turn = [&](const MeshVertex* a, const MeshVertex* b, const MeshVertex* c) {
    return kernel.orientation(a->point, b->point, c->point, origin, fallbacks_);
  };
  const std::array turns{turn(p[1], p[0], q[0]), turn(p[0], q[0], q[1]), turn(q[0], q[1], p[1]),
                         turn(q[1], p[1], p[0])};
  if (std::ranges::any_of(turns, [](int sign) { return sign < 0; }) || std::ranges::count(turns, 0) > 2) {
    for (const int i : {1, 0}) {  // do they meet only in places that are nearly one?
      const Vec3 a = placeOf(*p[i]), b = placeOf(*q[i]);
      if (!stretch.isDrawnIn[i] && std::max(std::fabs(a.x - b.x), std::fabs(a.y - b.y)) <= 2 * kAcross)
        return {Fault::Meets, i};
    }
    return {Fault::Overlaps, -1};
  }
  if (piece.isAsWide)
    for (const int i : {0, 1})
      if (isWider(*p[i], *q[i])) return {Fault::IsTooWide, i};
  for (const int i : {0, 1})
    for (const Index obstacle : piece.touching[i])
      if (!stretch.isDrawnIn[i] && !isOutside(obstacle, p, q, i)) return {Fault::IsTouched, i};
  return {};
}

bool GapLinker::drawIn(GapStretch& stretch, const Proof& proof) {
  if (proof.end < 0) return false;
  GapPiece& piece = stretch.piece;
  const int end = proof.end;
  // draws the end in to where GapConditions can distinguish the width from the gap
  if (proof.fault == Fault::IsTooWide) {
    const auto widthAt = [&](int i) {
      const Vec3 p = placeOf(*vertexAt(stretch.first, piece.frameOf(0), piece.ends[i]));
      const Vec3 q = placeOf(*vertexAt(stretch.second, piece.frameOf(1), piece.ends[i]));
      return std::sqrt((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y));
    };
    const double most = std::ldexp(gap_, splits_.kernel()->mesh().grid.scaleExponent()) - GapConditions::kSlack;
    const double own = widthAt(end), other = widthAt(1 - end);
    if (!(other < most) || !(own > most)) return false;
    piece.ends[end] += (piece.ends[1 - end] - piece.ends[end]) * ((own - most) / (own - other));
    piece.isAsWide = false;
  } else {
    stretch.isDrawnIn[end] = true;
    piece.ends[end] += (end == 0 ? 1 : -1) * kDrawnIn;
  }
  return piece.ends[1] - piece.ends[0] > GapConditions::kShort;
}

bool GapLinker::prove(const Group& group) {
  bool isChanged = false;
  for (const std::size_t gap : group.gaps) {
    GapStretch& stretch = gaps_[gap];
    context_.checkCancelled();
    if (stretch.isDropped || isSettled(gap)) continue;
    const Proof proof = prove(stretch);
    if (proof.fault == Fault::None) continue;
    if (drawIn(stretch, proof)) {
      isChanged = true;
      continue;
    }
    stretch.isDropped = true;
    undecided_ += proof.fault == Fault::Overlaps || proof.fault == Fault::Meets ? 0 : 1;
  }
  return isChanged;
}

// A group has its settled gaps as well, as they may get vertices.
std::vector<GapLinker::Group> GapLinker::openGroups(DisjointSets& rows) const {
  const auto edgeOf = [this](Index border) { return splits_.border(border).edge; };
  for (const GapStretch& gap : gaps_) rows.unite(edgeOf(gap.first), edgeOf(gap.second));
  std::vector<Group> groups;
  std::unordered_map<Index, std::size_t> numbers;  // by their rows
  for (std::size_t gap = 0; gap < gaps_.size(); ++gap)
    if (!isSettled(gap)) {
      const auto [number, isNew] = numbers.try_emplace(rows.find(edgeOf(gaps_[gap].first)), groups.size());
      if (isNew) groups.emplace_back();
      ++groups[number->second].open;
    }
  for (std::size_t gap = 0; gap < gaps_.size(); ++gap)
    if (const auto number = numbers.find(rows.find(edgeOf(gaps_[gap].first))); number != numbers.end())
      groups[number->second].gaps.push_back(gap);
  return groups;
}

void GapLinker::goOn(Group& group, Cuts& all) {
  Cuts cuts{group.mostCuts, {}, {}};
  if (!planCuts(group, cuts)) {
    group.isOpen = false;
    return;
  }
  if (cuts.list.empty() && !prove(group)) {
    group.isDone = true;
    group.isOpen = false;
  }
  if (group.mostCuts == SIZE_MAX) group.mostCuts = cuts.list.size() + kCutsOfGap * group.open + kFewCuts;
  std::move(cuts.list.begin(), cuts.list.end(), std::back_inserter(all.list));
}

void GapLinker::split(DisjointSets& rows, const Spread& spread) {
  std::vector<Group> groups = openGroups(rows);
  for (int round = 0; round < kRounds; ++round) {
    context_.checkCancelled();
    Cuts cuts;
    for (Group& group : groups)
      if (group.isOpen) goOn(group, cuts);
    makeCuts(cuts.list, spread);
  }
  // An end that is still drawn in has no vertices there: such a gap is dropped.
  for (const Group& group : groups)
    while (!group.isDone && prove(group)) context_.checkCancelled();
  for (std::size_t gap = 0; gap < gaps_.size(); ++gap) known_[gap].chains = chainLengths(gaps_[gap]);
}

std::array<std::size_t, 2> GapLinker::chainLengths(const GapStretch& stretch) const {
  return {splits_.chainLength(splits_.border(stretch.first)), splits_.chainLength(splits_.border(stretch.second))};
}

}  // namespace footfall::detail
