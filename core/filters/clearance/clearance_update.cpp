// The part of ClearanceClipper that cuts a face anew only near changes.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cuts are a sum: windings of all obstacles' outlines, and walls. What ends beside the boxes around all that came and
// went stays; what has an end in one of them is cut anew, by all obstacles that reach there. What is known of a point,
// each obstacle that has it finds by itself. So the cuts are those that all obstacles together make, in the same order.
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/base/index_and_box.hpp"
#include "core/base/sorted_list.hpp"
#include "core/exact/insertion_order.hpp"
#include "core/filters/clearance/clearance_clipper.hpp"
#include "core/filters/clearance/crowding.hpp"

namespace footfall::detail {
namespace {

// A point's error, or the rounding of a box's place, may be this part of the margin round the boxes.
constexpr double kPartOfMargin = 1.0 / 8;

bool isIn(const std::vector<Index>& ascending, Index wanted) {
  return std::binary_search(ascending.begin(), ascending.end(), wanted);
}

bool isEmpty(const Box& box) { return box.lower[0] > box.upper[0]; }

/// Boxes in the plan around what changed, with a margin for whatever is rounded.
class ChangedPlaces {
 public:
  ChangedPlaces(const SourceMesh& mesh, Index face, const std::array<Box, 2>& changed) {
    const Box box = boxOf(mesh, face);
    const Vec3& base = mesh.vertices[mesh.triangles[face][0]];
    const double width = std::max(box.upper[0] - box.lower[0], box.upper[1] - box.lower[1]);
    const double margin = width * 0x1p-12;
    const PowerOfTwo toScaled(mesh.grid.scaleExponent());
    largestError_ = toScaled(margin) * kPartOfMargin;
    double largest = 0;
    for (std::size_t i = 0; i < changed.size(); ++i) {
      units_[i] = scaled_[i] = changed[i];
      if (isEmpty(changed[i])) continue;
      for (const std::size_t axis : {0, 1}) {
        const double origin = axis == 0 ? base.x : base.y;
        largest = std::max(
            {largest, std::fabs(changed[i].lower[axis]), std::fabs(changed[i].upper[axis]), std::fabs(origin)});
        units_[i].lower[axis] -= margin;
        units_[i].upper[axis] += margin;
        scaled_[i].lower[axis] = toScaled(changed[i].lower[axis] - origin - margin / 2);
        scaled_[i].upper[axis] = toScaled(changed[i].upper[axis] - origin + margin / 2);
      }
    }
    isSafe_ = largest * 0x1p-48 < margin * kPartOfMargin && largestError_ > std::numeric_limits<double>::min();
  }

  /// True when margins are wider than all roundings, but for those of points.
  [[nodiscard]] bool isSafe() const { return isSafe_; }
  [[nodiscard]] bool isSafe(const ApproximatePoint& point) const { return point.error <= largestError_; }
  /// False: the point, with a small enough error, lies beside the boxes.
  [[nodiscard]] bool mayHold(const ApproximatePoint& p) const {
    return std::any_of(scaled_.begin(), scaled_.end(), [&](const Box& b) {
      return b.lower[0] <= p.x && p.x <= b.upper[0] && b.lower[1] <= p.y && p.y <= b.upper[1];
    });
  }
  /// Boxes that each triangle overlaps in the plan which has a point that may be held.
  [[nodiscard]] const std::array<Box, 2>& around() const { return units_; }

 private:
  std::array<Box, 2> units_, scaled_;  ///< scaled: relative to the face's first vertex
  double largestError_ = 0;
  bool isSafe_ = false;
};

/// A point of earlier cuts, of new ones, or of both.
struct PlacedPoint {
  std::uint64_t place = 0;  ///< along the curve
  const PlanPoint* point = nullptr;
  Index then = -1, now = -1;
};

bool isBefore(const PlacedPoint& a, const PlacedPoint& b) {
  return a.place != b.place ? a.place < b.place : *a.point < *b.point;
}

bool endsBefore(const CutSegment& a, const CutSegment& b) { return std::tie(a.from, a.to) < std::tie(b.from, b.to); }

// Both ascend.
std::vector<PlacedPoint> merged(const std::vector<PlacedPoint>& then, const std::vector<PlacedPoint>& now) {
  std::vector<PlacedPoint> all(then.size() + now.size()), result;
  std::merge(then.begin(), then.end(), now.begin(), now.end(), all.begin(), isBefore);
  result.reserve(all.size());
  for (const PlacedPoint& p : all) {
    if (!result.empty() && result.back().place == p.place && *result.back().point == *p.point)
      result.back().now = std::max(result.back().now, p.now);
    else
      result.push_back(p);
  }
  return result;
}

// Lines as they come: `lineOf` has those that segments name, numbered below `count`.
template <class LineOf>
void numberLines(FaceCuts& cuts, std::size_t count, const LineOf& lineOf) {
  std::vector<Index> numbers(count, -1);
  for (CutSegment& s : cuts.segments) {
    Index& number = numbers[s.line];
    if (number < 0) {
      number = static_cast<Index>(cuts.lines.size());
      cuts.lines.push_back(lineOf(s.line));
    }
    s.line = number;
  }
}

// The points of some segments, along the curve.
std::vector<Index> endsAlongCurve(const FaceGeometry& geometry, const std::vector<CutSegment>& segments) {
  std::vector<Index> order;
  for (const CutSegment& s : segments) order.insert(order.end(), {s.from, s.to});
  sortOnce(order);
  sortAlongCurve(geometry, order);
  return order;
}

// The line itself, for each of the earlier cuts' lines, or the number of the same one among the new lines, which follow
// all of them.
std::vector<Index> sameLines(std::span<const PlanLine> then, const std::vector<std::pair<PlanLine, Index>>& now) {
  const auto keyOf = [](const PlanLine& l) { return std::tie(l.kind, l.a, l.b); };
  std::vector<Index> same(then.size());
  for (std::size_t i = 0; i < then.size(); ++i) {
    const auto at = std::lower_bound(now.begin(), now.end(), then[i], [&](const auto& line, const PlanLine& wanted) {
      return keyOf(line.first) < keyOf(wanted);
    });
    same[i] = static_cast<Index>(at != now.end() && at->first == then[i] ? then.size() + at->second : i);
  }
  return same;
}

}  // namespace

// The obstacles that may stand above the face and overlap the boxes in the plan.
std::vector<Index> ClearanceClipper::standingNear(const EarlierCuts& earlier, const std::array<Box, 2>& around) const {
  std::vector<Index> near;
  std::vector<std::int32_t> stack;
  const Box above = clearanceBox(mesh_, face_, geometry_.kernel().heights()[level_ - 1]);
  for (const Box& box : around) {
    if (isEmpty(box)) continue;
    Box search = box;
    search.lower[2] = above.lower[2];
    search.upper[2] = above.upper[2];
    mesh_.tree.visitOverlapping(search, stack, [&](Index obstacle) {
      if (isIn(earlier.standing, obstacle) || isIn(earlier.added, obstacle)) near.push_back(obstacle);
      return true;
    });
  }
  sortOnce(near);
  return near;
}

// The data of all obstacles above the face now; none when it must be processed as a whole.
std::optional<LargeFace> ClearanceClipper::depthsNow(const EarlierCuts& earlier) const {
  Crowding crowding(mesh_, face_);
  crowding.restart(face_, earlier.memory.depths, earlier.memory.areas);
  if (earlier.gone.size() >= crowding.areas()) return std::nullopt;
  for (const Box& box : earlier.gone) crowding.remove(box);
  if (crowding.depths() == nullptr) return std::nullopt;  // adding to so few begins anew
  for (const ClearanceCandidate& candidate : candidates_.found())
    if (!isIn(earlier.standing, candidate.obstacle)) crowding.add(candidate.obstacle);
  if (crowding.depths() == nullptr) return std::nullopt;
  LargeFace now;
  now.depths = *crowding.depths();
  now.areas = crowding.areas();
  return now;
}

std::shared_ptr<const LargeFace> ClearanceClipper::largeFace(const FaceCuts& cuts) const {
  constexpr std::size_t kFewest = 256;
  if (candidates_.found().size() < kFewest || cuts.removed || cuts.dependsOnFloors || cuts.points.empty()) return {};
  const Crowding& crowding = candidates_.crowding();
  if (crowding.depths() == nullptr) return {};
  auto large = std::make_shared<LargeFace>();
  large->points = placesOfPoints();
  large->depths = *crowding.depths();
  large->areas = crowding.areas();
  return large;
}

std::optional<UpdatedCuts> ClearanceClipper::update(Index face, const EarlierCuts& earlier) {
  const ChangedPlaces places(mesh_, face, earlier.changed);
  const auto& pointsThen = earlier.memory.points;
  const auto isSafe = [&](const ApproximatePoint& p) { return places.isSafe(p); };
  if (!places.isSafe() || !std::all_of(pointsThen.begin(), pointsThen.end(), isSafe)) return std::nullopt;
  begin(face);
  const auto near = candidates_.findAmong(face, standingNear(earlier, places.around()));
  std::optional<LargeFace> memory = depthsNow(earlier);
  if (!memory || candidates_.dependsOnFloors() || candidates_.areKnownToCover()) return std::nullopt;
  startGeometry();
  if (!clipAll(near)) return std::nullopt;

  std::vector<char> isHeld(geometry_.pointCount());
  for (std::size_t p = 0; p < isHeld.size(); ++p) {
    const ApproximatePoint& place = geometry_.approximate(static_cast<Index>(p));
    if (!places.isSafe(place)) return std::nullopt;
    isHeld[p] = static_cast<char>(places.mayHold(place));
  }
  std::erase_if(segments_, [&](const CutSegment& s) { return isHeld[s.from] == 0 && isHeld[s.to] == 0; });
  cancelSegments();

  UpdatedCuts result;
  result.cuts.startWinding = isHeld[0] != 0 ? startWinding_ : earlier.cuts.startWinding;
  result.cuts.edgeWalls = edgeWalls_;
  for (int k = 0; k < 3; ++k)
    if (isHeld[k] == 0 || isHeld[next(k)] == 0) result.cuts.edgeWalls |= earlier.cuts.edgeWalls & (1 << k);
  mergeSegments(
      earlier, [&](Index then) { return places.mayHold(pointsThen[then]); }, result.cuts, memory->points);
  if (result.cuts.segments.empty()) return std::nullopt;  // covered, or free
  result.memory = std::move(*memory);
  result.standing.resize(earlier.standing.size() + near.size());
  const std::vector<Index> found = candidates();
  result.standing.erase(std::set_union(earlier.standing.begin(), earlier.standing.end(), found.begin(), found.end(),
                                       result.standing.begin()),
                        result.standing.end());
  if (result.cuts.startWinding == 0) return result;
  candidates_.findAmong(face, result.standing);
  if (candidates_.areKnownToCover()) return std::nullopt;
  return result;
}

// The earlier segments with no end that is held, and those that were cut now.
void ClearanceClipper::mergeSegments(const EarlierCuts& earlier, const std::function<bool(Index)>& isHeld,
                                     FaceCuts& cuts, std::vector<ApproximatePoint>& points) {
  const FaceCuts& then = earlier.cuts;
  std::vector<char> held(then.points.size()), needed(then.points.size(), 0);
  for (std::size_t p = 0; p < held.size(); ++p) held[p] = static_cast<char>(isHeld(static_cast<Index>(p)));
  std::vector<CutSegment> kept;
  kept.reserve(then.segments.size());
  for (const CutSegment& s : then.segments) {
    if (held[s.from] != 0 || held[s.to] != 0) continue;
    kept.push_back(s);
    needed[s.from] = needed[s.to] = 1;
  }
  const CurvePlaces curve(geometry_);
  std::vector<PlacedPoint> pointsThen, pointsNow;
  for (std::size_t p = 0; p < needed.size(); ++p)
    if (needed[p] != 0)
      pointsThen.push_back({curve.of(earlier.memory.points[p]), &then.points[p], static_cast<Index>(p), -1});
  for (const Index p : endsAlongCurve(geometry_, segments_))
    pointsNow.push_back({curve.of(geometry_.approximate(p)), &geometry_[p], -1, p});

  std::vector<Index> numberThen(then.points.size(), -1), numberNow(geometry_.pointCount(), -1);
  for (const PlacedPoint& p : merged(pointsThen, pointsNow)) {
    const auto number = static_cast<Index>(cuts.points.size());
    if (p.then >= 0) numberThen[p.then] = number;
    if (p.now >= 0) numberNow[p.now] = number;
    cuts.points.push_back(*p.point);
    cuts.borders.push_back(p.now >= 0 ? geometry_.border(p.now) : then.borders[p.then]);
    points.push_back(p.now >= 0 ? geometry_.approximate(p.now) : earlier.memory.points[p.then]);
  }

  const auto lineCount = static_cast<Index>(then.lines.size());
  std::vector<std::pair<PlanLine, Index>> linesNow;
  for (CutSegment& s : segments_) {
    linesNow.emplace_back(geometry_.lineAt(s.line), s.line);
    s.line += lineCount;
    s.from = numberNow[s.from];
    s.to = numberNow[s.to];
    if (s.from < s.to) continue;
    std::swap(s.from, s.to);
    s.direction = static_cast<std::int8_t>(-s.direction);
    s.winding = -s.winding;
  }
  std::sort(linesNow.begin(), linesNow.end(), [](const auto& a, const auto& b) {
    return std::tie(a.first.kind, a.first.a, a.first.b) < std::tie(b.first.kind, b.first.a, b.first.b);
  });
  const std::vector<Index> lineThen = sameLines(then.lines, linesNow);
  for (CutSegment& s : kept) {
    s.from = numberThen[s.from];
    s.to = numberThen[s.to];
    s.line = lineThen[s.line];
  }
  std::sort(segments_.begin(), segments_.end(), endsBefore);
  cuts.segments.resize(kept.size() + segments_.size());
  std::merge(kept.begin(), kept.end(), segments_.begin(), segments_.end(), cuts.segments.begin(), endsBefore);

  cuts.lines.reserve(then.lines.size());
  numberLines(cuts, then.lines.size() + geometry_.lineCount(),
              [&](Index line) { return line < lineCount ? then.lines[line] : geometry_.lineAt(line - lineCount); });
}

}  // namespace footfall::detail
