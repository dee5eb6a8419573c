// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/plan_walls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "core/base/box_tree.hpp"
#include "core/base/vector.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kPolled = 1 << 12;
/// Slopes in metres, as in levels of a town, may have this many planes; more would be a picture of lines alone.
constexpr std::size_t kMostLevels = 4096;

struct CutSegment {
  PlanPlace from{}, to{};  ///< ends; the solid side is on the left
  auto operator<=>(const CutSegment&) const = default;
};

struct HeightRange {
  double lower = 0, upper = 0;
};

HeightRange heightsOf(const NavigationMesh& mesh, std::uint32_t triangle) {
  const Triangle& t = mesh.triangles[triangle];
  const auto [lower, upper] = std::minmax({mesh.vertices[t[0]].z, mesh.vertices[t[1]].z, mesh.vertices[t[2]].z});
  return {lower, upper};
}

double planAreaOf(const NavigationMesh& mesh, std::uint32_t triangle) {
  const Triangle& t = mesh.triangles[triangle];
  return normalOf(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]).z / 2;
}

/// Heights of floors, ascending: first the level with the largest area, then the next that is no part of it; at last
/// what slopes need so that each of their heights has a level within the tolerance.
std::vector<double> levelsOf(const NavigationMesh& mesh, std::span<const std::uint32_t> triangles, double tolerance) {
  std::map<double, double> areas;
  for (const std::uint32_t t : triangles) {
    const HeightRange heights = heightsOf(mesh, t);
    if (heights.upper - heights.lower < tolerance) areas[(heights.lower + heights.upper) / 2] += planAreaOf(mesh, t);
  }
  std::vector<std::pair<double, double>> byArea;
  for (const auto& [height, area] : areas) byArea.emplace_back(-area, height);
  std::sort(byArea.begin(), byArea.end());
  std::map<double, bool> levels;
  const auto hasNear = [&levels, tolerance](double height) {
    const auto next = levels.upper_bound(height - tolerance);
    return next != levels.end() && next->first < height + tolerance;
  };
  for (const auto& [area, height] : byArea)
    if (!hasNear(height)) levels[height] = true;
  for (const std::uint32_t t : triangles) {
    const HeightRange heights = heightsOf(mesh, t);
    if (heights.upper - heights.lower < tolerance) continue;
    // Heights are whole multiples, so that neighbours agree.
    double at = std::ceil(heights.lower / tolerance) * tolerance;
    for (; at <= heights.upper && levels.size() < kMostLevels; at += tolerance)
      if (!hasNear(at)) levels[at] = true;
  }
  std::vector<double> heights;
  for (const auto& level : levels) heights.push_back(level.first);
  return heights;
}

/// The crossing of the edge from a to b with a height, the same for both directions.
PlanPlace crossing(const Vec3& a, const Vec3& b, double height) {
  const bool isTurned = std::tie(b.x, b.y, b.z) < std::tie(a.x, a.y, a.z);
  const Vec3 &p = isTurned ? b : a, &q = isTurned ? a : b;
  const double f = (height - p.z) / (q.z - p.z);
  return {p.x + f * (q.x - p.x), p.y + f * (q.y - p.y)};
}

std::optional<CutSegment> cutTriangle(const Environment& environment, const Triangle& t, double height) {
  std::array<PlanPlace, 2> ends{};
  std::size_t count = 0;
  for (int k = 0; k < 3; ++k) {
    const Vec3 &a = environment.vertices[t[k]], &b = environment.vertices[t[next(k)]];
    // A corner at the height itself counts as above, so that there are two crossings or none.
    if ((a.z >= height) != (b.z >= height) && count < 2) ends[count++] = crossing(a, b, height);
  }
  if (count < 2 || ends[0] == ends[1]) return std::nullopt;
  const Vec3 normal = normalOf(environment.vertices[t[0]], environment.vertices[t[1]], environment.vertices[t[2]]);
  const double along = (ends[1][0] - ends[0][0]) * -normal.y + (ends[1][1] - ends[0][1]) * normal.x;
  return along >= 0 ? CutSegment{ends[0], ends[1]} : CutSegment{ends[1], ends[0]};
}

double distanceToSegment(const PlanPlace& p, const PlanPlace& a, const PlanPlace& b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1], square = dx * dx + dy * dy;
  const double f = square > 0 ? std::clamp(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(p[0] - a[0] - f * dx, p[1] - a[1] - f * dy);
}

double side(const PlanPlace& a, const PlanPlace& b, const PlanPlace& p) {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

/// True when a segment comes nearer than `margin` to a triangle that is counter-clockwise.
bool isNear(const CutSegment& s, const std::array<PlanPlace, 3>& t, double margin) {
  const auto isInside = [&t](const PlanPlace& p) {
    return side(t[0], t[1], p) >= 0 && side(t[1], t[2], p) >= 0 && side(t[2], t[0], p) >= 0;
  };
  if (isInside(s.from) || isInside(s.to)) return true;
  for (int k = 0; k < 3; ++k) {
    const PlanPlace &a = t[k], &b = t[next(k)];
    if ((side(a, b, s.from) < 0) != (side(a, b, s.to) < 0) &&
        (side(s.from, s.to, a) < 0) != (side(s.from, s.to, b) < 0))
      return true;
    if (std::min({distanceToSegment(s.from, a, b), distanceToSegment(s.to, a, b), distanceToSegment(a, s.from, s.to)}) <
        margin)
      return true;
  }
  return false;
}

double doubleAreaOf(const PlanLineString& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const PlanPlace &a = ring[i], &b = ring[(i + 1) % ring.size()], &o = ring[0];
    sum += (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
  }
  return sum;
}

bool contains(const PlanLineString& ring, const PlanPlace& p) {
  bool isInside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const PlanPlace &a = ring[i], &b = ring[(i + 1) % ring.size()];
    if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
      isInside = !isInside;
  }
  return isInside;
}

/// Segments of one plane, joined end to end.
class Chains {
 public:
  explicit Chains(std::vector<CutSegment> segments) : segments_(std::move(segments)), isUsed_() {
    std::sort(segments_.begin(), segments_.end());
    segments_.erase(std::unique(segments_.begin(), segments_.end()), segments_.end());
    isUsed_.assign(segments_.size(), 0);
    std::map<PlanPlace, int> arriving;
    for (const CutSegment& s : segments_) ++arriving[s.to];
    // Open lines first, from where nothing arrives; what is left goes round.
    for (std::size_t i = 0; i < segments_.size(); ++i)
      if (isUsed_[i] == 0 && !arriving.contains(segments_[i].from)) follow(i);
    for (std::size_t i = 0; i < segments_.size(); ++i)
      if (isUsed_[i] == 0) follow(i);
  }

  std::vector<PlanLineString> open, closed;

 private:
  void follow(std::size_t first) {
    PlanLineString line{segments_[first].from};
    for (std::size_t at = first;;) {
      isUsed_[at] = 1;
      const PlanPlace end = segments_[at].to;
      if (end == line.front()) {
        (line.size() > 2 ? closed : open).push_back(line);
        return;
      }
      line.push_back(end);
      auto s = std::lower_bound(segments_.begin(), segments_.end(), CutSegment{end, kLeast});
      while (s != segments_.end() && s->from == end && isUsed_[static_cast<std::size_t>(s - segments_.begin())] != 0)
        ++s;
      if (s == segments_.end() || s->from != end) break;
      at = static_cast<std::size_t>(s - segments_.begin());
    }
    open.push_back(std::move(line));
  }

  static constexpr PlanPlace kLeast{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};
  std::vector<CutSegment> segments_;
  std::vector<char> isUsed_;
};

/// Sorts the closed lines into solids, their hollows, and what surrounds a space.
void sortClosed(std::vector<PlanLineString> closed, double level, PlanWalls& walls) {
  struct Solid {
    double area;
    std::vector<PlanLineString> lines;
  };
  std::vector<Solid> solids;
  std::vector<PlanLineString> hollows;
  for (PlanLineString& line : closed) {
    const double area = doubleAreaOf(line);
    if (area > 0)
      solids.push_back({area, {std::move(line)}});
    else
      hollows.push_back(std::move(line));
  }
  for (PlanLineString& hollow : hollows) {
    Solid* around = nullptr;
    for (Solid& solid : solids)
      if (solid.area > -doubleAreaOf(hollow) && (around == nullptr || solid.area < around->area) &&
          contains(solid.lines[0], hollow[0]))
        around = &solid;
    if (around != nullptr)
      around->lines.push_back(std::move(hollow));
    else
      walls.closedLines.push_back(std::move(hollow));
  }
  for (Solid& solid : solids) walls.solids.push_back({std::move(solid.lines), level});
}

class WallCutter {
 public:
  WallCutter(const NavigationMesh& mesh, std::span<const std::uint32_t> triangles, const WallCut& cut, Poll poll)
      : mesh_(mesh), triangles_(triangles), cut_(cut), poll_(poll) {
    levels_ = levelsOf(mesh, triangles, cut.tolerance);
    std::vector<Index> ids;
    for (std::size_t i = 0; i < triangles.size(); ++i) ids.push_back(static_cast<Index>(i));
    tree_.build(
        ids,
        [this](Index i) {
          BoxTree<2>::Bounds bounds;
          const std::array<PlanPlace, 3> t = placesOf(i);
          for (int k = 0; k < 2; ++k) {
            const auto [lower, upper] = std::minmax({t[0][k], t[1][k], t[2][k]});
            bounds.lower[k] = lower - cut_.margin;
            bounds.upper[k] = upper + cut_.margin;
          }
          return bounds;
        },
        poll);
  }

  PlanWalls cut(const Environment& environment) {
    std::vector<std::vector<CutSegment>> planes(levels_.size());
    for (std::size_t i = 0; i < environment.triangles.size(); ++i) {
      if (i % kPolled == 0) poll_();
      const Triangle& t = environment.triangles[i];
      const auto [lower, upper] =
          std::minmax({environment.vertices[t[0]].z, environment.vertices[t[1]].z, environment.vertices[t[2]].z});
      for (auto level = std::lower_bound(levels_.begin(), levels_.end(), lower - cut_.cutHeight);
           level != levels_.end() && *level + cut_.cutHeight <= upper; ++level)
        if (const auto segment = cutTriangle(environment, t, *level + cut_.cutHeight))
          planes[static_cast<std::size_t>(level - levels_.begin())].push_back(*segment);
    }
    PlanWalls walls;
    for (std::size_t i = 0; i < planes.size(); ++i) join(std::move(planes[i]), levels_[i], walls);
    return walls;
  }

 private:
  [[nodiscard]] std::array<PlanPlace, 3> placesOf(Index i) const {
    const Triangle& t = mesh_.triangles[triangles_[static_cast<std::size_t>(i)]];
    std::array<PlanPlace, 3> places;
    for (int k = 0; k < 3; ++k) places[k] = {mesh_.vertices[t[k]].x, mesh_.vertices[t[k]].y};
    return places;
  }

  void join(std::vector<CutSegment> segments, double level, PlanWalls& walls) const {
    Chains chains(std::move(segments));
    poll_();
    for (PlanLineString& line : chains.open)
      if (comesNear(line, false, level)) walls.openLines.push_back(std::move(line));
    std::vector<PlanLineString> closed;
    for (PlanLineString& line : chains.closed)
      if (comesNear(line, true, level)) closed.push_back(std::move(line));
    sortClosed(std::move(closed), level, walls);
  }

  [[nodiscard]] bool comesNear(const PlanLineString& line, bool isClosed, double level) const {
    for (std::size_t i = 0; i + (isClosed ? 0 : 1) < line.size(); ++i)
      if (comesNear(CutSegment{line[i], line[(i + 1) % line.size()]}, level)) return true;
    return false;
  }

  [[nodiscard]] bool comesNear(const CutSegment& segment, double level) const {
    BoxTree<2>::Bounds query;
    for (int k = 0; k < 2; ++k) {
      query.lower[k] = std::min(segment.from[k], segment.to[k]);
      query.upper[k] = std::max(segment.from[k], segment.to[k]);
    }
    bool isFound = false;
    tree_.visitOverlapping(query, [&](Index i) {
      if (isFound) return;
      const HeightRange heights = heightsOf(mesh_, triangles_[static_cast<std::size_t>(i)]);
      isFound = heights.lower < level + cut_.tolerance && heights.upper > level - cut_.tolerance &&
                isNear(segment, placesOf(i), cut_.margin);
    });
    return isFound;
  }

  const NavigationMesh& mesh_;
  std::span<const std::uint32_t> triangles_;
  const WallCut& cut_;
  Poll poll_;
  std::vector<double> levels_;
  BoxTree<2> tree_;
};

}  // namespace

bool contains(const PlanSolid& solid, const PlanPlace& place) {
  bool isInside = false;
  for (const PlanLineString& line : solid.lines) isInside = isInside != contains(line, place);
  return isInside;
}

PlanWalls cutWalls(const Environment& environment, const NavigationMesh& mesh, std::span<const std::uint32_t> triangles,
                   const WallCut& cut, Poll poll) {
  if (triangles.empty()) return {};
  return WallCutter(mesh, triangles, cut, poll).cut(environment);
}

}  // namespace footfall::detail
