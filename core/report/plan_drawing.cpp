// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/plan_drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/base/counted_text.hpp"
#include "core/base/vector.hpp"
#include "core/report/plan_label.hpp"

namespace footfall::detail {
namespace {

// Millimetres on the paper.
constexpr double kWallLine = 0.5, kWallOutline = 0.25, kBorder = 0.15, kObstacle = 0.5, kThin = 0.13, kMedium = 0.25;
constexpr double kArrowHead = 1.6, kTick = 1.0, kTickDistance = 1.5;
constexpr double kLetters = 2.6, kSmallLetters = 1.9;
constexpr double kShortestMark = 2.5;  // arrows over single steps, and words at passages
constexpr double kLetterWidth = 0.55;  // average share of the letter size

SheetPoint between(const SheetPoint& a, const SheetPoint& b, double f) {
  return {a.x + f * (b.x - a.x), a.y + f * (b.y - a.y)};
}

double distance(const SheetPoint& a, const SheetPoint& b) { return std::hypot(b.x - a.x, b.y - a.y); }

class PageDrawer {
 public:
  PageDrawer(const PlanSubject& subject, std::size_t page, const PlanLayout& layout, const PlanStyle& style,
             std::vector<SheetShape>& drawing, Poll poll)
      : subject_(subject),
        mesh_(subject.mesh),
        page_(subject.pages[page]),
        layout_(layout),
        style_(style),
        drawing_(drawing),
        poll_(poll),
        isHere_(mesh_.triangles.size(), 0) {
    for (const std::uint32_t t : page_.triangles) isHere_[t] = 1;
  }

  PlanContents draw() {
    drawWalls();
    outline_ = outlineInPlan(mesh_, page_.triangles, EdgeRule::Joined, poll_);
    hideInsideOfWalls();
    drawWalkable();
    drawDoors();
    drawGaps();
    drawSteps();
    drawObstacleEdges();
    drawDrops();
    drawPassages();
    drawFlights();
    if (subject_.corridors != nullptr) {
      const auto drawn = drawCorridors(*subject_.corridors, mesh_, isHere_, subject_.environment.metresPerUnit, layout_,
                                       style_.corridor, style_.bottleneck, drawing_, words_);
      contents_.corridors = drawn.lines;
      contents_.bottlenecks = drawn.bottlenecks;
    }
    drawAreas();
    return contents_;
  }

 private:
  [[nodiscard]] SheetPoint at(const Vec3& p) const { return layout_.at(p.x, p.y); }
  [[nodiscard]] SheetPoint at(std::uint32_t vertex) const { return at(mesh_.vertices[vertex]); }
  [[nodiscard]] std::vector<SheetPoint> lineOf(const PlanLineString& line) const {
    std::vector<SheetPoint> points;
    for (const PlanPlace& p : line) points.push_back(layout_.at(p));
    return points;
  }
  [[nodiscard]] std::vector<SheetPoint> lineOf(const PlanRing& ring) const {
    std::vector<SheetPoint> points;
    for (const std::uint32_t v : ring) points.push_back(at(v));
    return points;
  }
  [[nodiscard]] std::vector<std::vector<SheetPoint>> ringsOf(const PlanPart& part) const {
    std::vector<std::vector<SheetPoint>> rings{lineOf(part.outer)};
    for (const PlanRing& hole : part.holes) rings.push_back(lineOf(hole));
    return rings;
  }
  void addPath(SheetPath path) {
    if (!path.lines.empty()) drawing_.emplace_back(std::move(path));
  }

  // Draws walls below the walkable area, so that the outer half of walls at its border is visible, and nothing cut
  // elsewhere, such as a flight of stairs, covers floors above it.
  void drawWalls() {
    PlanWalls walls = cutWalls(subject_.environment, mesh_, page_.triangles, subject_.cut, poll_);
    contents_.walls = !walls.solids.empty() || !walls.closedLines.empty() || !walls.openLines.empty();
    for (const PlanSolid& solid : walls.solids) {
      SheetPath path{{}, true, style_.wall, SheetStroke{style_.wallLine, kWallOutline}};
      for (const PlanLineString& line : solid.lines) path.lines.push_back(lineOf(line));
      addPath(std::move(path));
    }
    SheetPath closed{{}, true, {}, SheetStroke{style_.wallLine, kWallLine}}, open{{}, false, {}, closed.stroke};
    for (const PlanLineString& line : walls.closedLines) closed.lines.push_back(lineOf(line));
    for (const PlanLineString& line : walls.openLines) open.lines.push_back(lineOf(line));
    addPath(std::move(closed));
    addPath(std::move(open));
    solids_ = std::move(walls.solids);
  }

  /// Floors go on under walls that are bodies, and there is room for an agent in many. No plan shows that.
  void hideInsideOfWalls() {
    std::erase_if(outline_.parts, [this](const PlanPart& part) {
      poll_();
      const bool isHidden =
          std::all_of(part.triangles.begin(), part.triangles.end(), [this](std::uint32_t t) { return isInWall(t); });
      if (!isHidden) return false;
      for (std::size_t i = 0; i < part.outer.size(); ++i)
        hiddenEdges_.insert(placesOf({part.outer[i], part.outer[(i + 1) % part.outer.size()]}));
      return true;
    });
  }

  [[nodiscard]] bool isInWall(std::uint32_t triangle) const {
    const Triangle& t = mesh_.triangles[triangle];
    const Vec3 middle = (1.0 / 3) * (mesh_.vertices[t[0]] + mesh_.vertices[t[1]] + mesh_.vertices[t[2]]);
    return std::any_of(solids_.begin(), solids_.end(), [&](const PlanSolid& solid) {
      return std::abs(solid.level - middle.z) < subject_.cut.tolerance && contains(solid, {middle.x, middle.y});
    });
  }

  /// The places, which are equal for the two sides of an obstacle edge.
  [[nodiscard]] std::pair<PlanPlace, PlanPlace> placesOf(const std::array<std::uint32_t, 2>& edge) const {
    const Vec3 &a = mesh_.vertices[edge[0]], &b = mesh_.vertices[edge[1]];
    return std::minmax(PlanPlace{a.x, a.y}, PlanPlace{b.x, b.y});
  }

  void drawWalkable() {
    // The higher floor is visible where storeys have floors over each other.
    std::vector<std::pair<double, const PlanPart*>> byHeight;
    for (const PlanPart& part : outline_.parts) byHeight.emplace_back(mesh_.vertices[part.outer[0]].z, &part);
    std::stable_sort(byHeight.begin(), byHeight.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [height, part] : byHeight)
      addPath({ringsOf(*part), true, style_.walkable, SheetStroke{style_.border, kBorder}});
  }

  void drawDoors() {
    for (const PlanDoor& door : subject_.doors) {
      poll_();
      if (!isAtFloor(door)) continue;
      contents_.doors = true;
      addDoor(drawing_,
              {layout_.at(door.corners[0]), layout_.at(door.corners[1]), layout_.at(door.corners[2]),
               layout_.at(door.corners[3])},
              style_.door);
    }
  }

  /// True when a floor of this page lies at the door's sill, in it or beside it.
  [[nodiscard]] bool isAtFloor(const PlanDoor& door) const {
    PlanPlace low = door.corners[0], high = low;
    for (const PlanPlace& p : door.corners)
      for (std::size_t k = 0; k < 2; ++k) {
        low[k] = std::min(low[k], p[k] - subject_.cut.margin);
        high[k] = std::max(high[k], p[k] + subject_.cut.margin);
      }
    return std::any_of(page_.triangles.begin(), page_.triangles.end(), [&](std::uint32_t t) {
      const Triangle& corners = mesh_.triangles[t];
      const Vec3 &a = mesh_.vertices[corners[0]], &b = mesh_.vertices[corners[1]], &c = mesh_.vertices[corners[2]];
      return std::max({a.x, b.x, c.x}) >= low[0] && std::min({a.x, b.x, c.x}) <= high[0] &&
             std::max({a.y, b.y, c.y}) >= low[1] && std::min({a.y, b.y, c.y}) <= high[1] &&
             std::max({a.z, b.z, c.z}) >= door.lower - subject_.cut.tolerance &&
             std::min({a.z, b.z, c.z}) <= door.lower + subject_.cut.tolerance;
    });
  }

  void drawGaps() {
    SheetPath gaps{{}, true, style_.gap, {}};
    for (const StepLink& link : mesh_.links)
      if (link.kind == StepKind::Gap && isHere(link))
        gaps.lines.push_back({at(link.from[0]), at(link.from[1]), at(link.to[0]), at(link.to[1])});
    contents_.gaps = !gaps.lines.empty();
    // The width is at least that of a line, to be visible.
    gaps.stroke = SheetStroke{style_.gap, kMedium};
    addPath(std::move(gaps));
  }

  [[nodiscard]] bool isHere(const StepLink& link) const {
    return isHere_[link.fromTriangle] != 0 || isHere_[link.toTriangle] != 0;
  }

  void drawSteps() {
    SheetPath steps{{}, false, {}, SheetStroke{style_.step, kThin}};
    for (const StepLink& link : mesh_.links)
      if (link.kind == StepKind::Step && isHere(link)) steps.lines.push_back({at(link.from[0]), at(link.from[1])});
    contents_.steps = !steps.lines.empty();
    addPath(std::move(steps));
  }

  void drawObstacleEdges() {
    // One of its two sides is listed, in either direction; the layers of both may differ.
    std::vector<std::array<std::uint32_t, 2>> sides;
    for (const PlanPart& part : outline_.parts) {
      const auto addSides = [&sides](const PlanRing& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const auto [lower, upper] = std::minmax(ring[i], ring[(i + 1) % ring.size()]);
          sides.push_back({lower, upper});
        }
      };
      addSides(part.outer);
      for (const PlanRing& hole : part.holes) addSides(hole);
    }
    std::sort(sides.begin(), sides.end());
    SheetPath edges{{}, false, {}, SheetStroke{style_.obstacleEdge, kObstacle}};
    for (const auto& edge : mesh_.obstacleEdges)
      if (std::binary_search(sides.begin(), sides.end(),
                             std::array{std::min(edge[0], edge[1]), std::max(edge[0], edge[1])}))
        if (!hiddenEdges_.contains(placesOf(edge))) edges.lines.push_back({at(edge[0]), at(edge[1])});
    contents_.obstacleEdges = !edges.lines.empty();
    addPath(std::move(edges));
  }

  /// A line along the ledge and ticks downwards, as maps draw a cliff.
  void drawDrops() {
    SheetPath lines{{}, false, {}, SheetStroke{style_.drop, kMedium}};
    for (const DropLink& drop : mesh_.drops) {
      if (isHere_[drop.fromTriangle] == 0) continue;
      const SheetPoint a = at(drop.start[0]), b = at(drop.start[1]);
      const double length = distance(a, b);
      if (!(length > 0)) continue;
      lines.lines.push_back({a, b});
      // Outwards is to the right.
      const SheetPoint tick{kTick * (b.y - a.y) / length, -kTick * (b.x - a.x) / length};
      const double count = std::max(1.0, std::floor(length / kTickDistance));
      for (double i = 0; i < count; ++i) {
        const SheetPoint p = between(a, b, (i + 0.5) / count);
        lines.lines.push_back({p, {p.x + tick.x, p.y + tick.y}});
      }
    }
    contents_.drops = !lines.lines.empty();
    addPath(std::move(lines));
  }

  void drawPassages() {
    SheetPath lines{{}, false, {}, SheetStroke{style_.passage, kMedium, {1.8, 0.9}}};
    // Words at the longest edge of what goes from here to each page.
    std::map<std::size_t, std::pair<double, SheetPoint>> longest;
    for (const PlanPassage& passage : page_.passages) {
      const SheetPoint a = at(passage.edge[0]), b = at(passage.edge[1]);
      lines.lines.push_back({a, b});
      auto& [length, middle] = longest[passage.page];
      if (distance(a, b) > length) {
        length = distance(a, b);
        middle = between(a, b, 0.5);
      }
    }
    contents_.passages = !lines.lines.empty();
    addPath(std::move(lines));
    for (const auto& [page, place] : longest)
      if (place.first >= kShortestMark)
        words_.push_back({{place.second.x, place.second.y + 0.6},
                          "to " + subject_.pages[page].name,
                          kSmallLetters,
                          SheetAnchor::Middle,
                          style_.passage,
                          false,
                          true});
  }

  void drawFlights() {
    for (const PlanFlight& flight : subject_.flights) {
      std::vector<SheetPoint> way;
      const PlanFlight::Riser *first = nullptr, *last = nullptr;
      for (const PlanFlight::Riser& riser : flight.risers) {
        if (isHere_[riser.lower] == 0 && isHere_[riser.upper] == 0) continue;
        if (first == nullptr) first = &riser;
        last = &riser;
        way.push_back(layout_.at(riser.middle));
      }
      if (way.empty()) continue;
      double length = 0;
      for (std::size_t i = 0; i + 1 < way.size(); ++i) length += distance(way[i], way[i + 1]);
      if (way.size() == 1 && first->length * layout_.unit < 2 * kShortestMark) continue;
      if (way.size() > 1 && length < kShortestMark) continue;
      // The arrow begins before the first riser and ends behind the last one.
      const double ends = way.size() == 1 ? 0.9 * kArrowHead : std::min(kArrowHead, length / 4);
      way.insert(way.begin(), moved(way.front(), first->up, -ends));
      way.push_back(moved(way.back(), last->up, ends));
      addArrow(drawing_, way, kArrowHead, {style_.step, kThin});
    }
  }

  static SheetPoint moved(const SheetPoint& p, const PlanPlace& direction, double by) {
    return {p.x + by * direction[0], p.y + by * direction[1]};
  }

  /// Writes the area of each connected part on this page, in its largest piece.
  void drawAreas() {
    struct Sum {
      double area = 0, largest = 0;
      const PlanPart* piece = nullptr;
    };
    std::map<std::uint32_t, Sum> sums;
    for (const PlanPart& part : outline_.parts) {
      double area = 0;
      for (const std::uint32_t t : part.triangles) {
        const Triangle& corners = mesh_.triangles[t];
        area += areaOf(mesh_.vertices[corners[0]], mesh_.vertices[corners[1]], mesh_.vertices[corners[2]]);
      }
      Sum& sum = sums[subject_.parts.ofTriangle[part.triangles.front()]];
      sum.area += area;
      contents_.area += area;
      if (area > sum.largest) {
        sum.largest = area;
        sum.piece = &part;
      }
    }
    const double metres = subject_.environment.metresPerUnit;
    for (const auto& [number, sum] : sums)
      if (sum.piece != nullptr) writeArea(*sum.piece, sum.area * metres * metres, number);
    for (SheetText& text : words_) drawing_.emplace_back(std::move(text));
  }

  void writeArea(const PlanPart& piece, double area, std::uint32_t number) {
    const RoomiestPlace place = findRoomiestPlace(ringsOf(piece), kSmallLetters / 4, poll_);
    const std::string words = areaText(area);
    const bool isNumbered = subject_.parts.areas.size() > 1;
    const auto needs = [&words](double letters) {
      return letters * kLetterWidth * static_cast<double>(words.size()) / 2;
    };
    const double letters = place.radius > needs(kLetters) ? kLetters : kSmallLetters;
    if (place.radius < 0.7 * needs(letters)) return;
    const double lift = isNumbered ? 0 : -letters / 3;
    words_.push_back({{place.at.x, place.at.y + lift}, words, letters, SheetAnchor::Middle, style_.text, true, true});
    if (isNumbered)
      words_.push_back({{place.at.x, place.at.y - kSmallLetters * 1.1},
                        "part " + std::to_string(number + 1),
                        kSmallLetters,
                        SheetAnchor::Middle,
                        style_.text,
                        false,
                        true});
  }

  std::vector<SheetText> words_;  // drawn over everything else
  const PlanSubject& subject_;
  const NavigationMesh& mesh_;
  const PlanPage& page_;
  const PlanLayout& layout_;
  const PlanStyle& style_;
  std::vector<SheetShape>& drawing_;
  Poll poll_;
  std::vector<char> isHere_;
  PlanOutline outline_;
  std::vector<PlanSolid> solids_;
  std::set<std::pair<PlanPlace, PlanPlace>> hiddenEdges_;
  PlanContents contents_;
};

}  // namespace

PlanStyle planStyle(PlanColours colours) {
  constexpr Rgb kBlack{0, 0, 0}, kDark{60, 60, 60};
  if (colours == PlanColours::BlackAndWhite)
    return {{232, 232, 232}, kBlack, kDark,  kBlack, kBlack, kBlack, {150, 150, 150},
            kBlack,          kBlack, kBlack, kBlack, kDark,  kBlack};
  // The editor's colours; words and lines of gaps and steps on a light tint of the first layer's.
  constexpr Rgb kTint{214, 240, 230};
  return {kTint,          kDark, kDark,  kBlack, kVermilion, kBlue,     kOrange,
          kReddishPurple, kDark, kBlack, kDark,  kSkyBlue,   kVermilion};
}

PlanContents drawPlanPage(const PlanSubject& subject, std::size_t page, const PlanLayout& layout,
                          const PlanStyle& style, std::vector<SheetShape>& drawing, Poll poll) {
  return PageDrawer(subject, page, layout, style, drawing, poll).draw();
}

void addDoor(std::vector<SheetShape>& drawing, const std::array<SheetPoint, 4>& corners, const Rgb& colour) {
  const SheetStroke line{colour, kThin};
  drawing.emplace_back(SheetPath{{{corners[0], corners[3]}, {corners[1], corners[2]}}, false, {}, line});
  drawing.emplace_back(SheetPath{{{between(corners[0], corners[3], 0.5), between(corners[1], corners[2], 0.5)}},
                                 false,
                                 {},
                                 SheetStroke{colour, kMedium}});
}

void addArrow(std::vector<SheetShape>& drawing, const std::vector<SheetPoint>& way, double size,
              const SheetStroke& stroke) {
  drawing.emplace_back(SheetPath{{way}, false, {}, stroke});
  const SheetPoint &tip = way.back(), &before = way[way.size() - 2];
  const double length = distance(before, tip);
  if (!(length > 0)) return;
  const double x = size * (tip.x - before.x) / length, y = size * (tip.y - before.y) / length;
  drawing.emplace_back(
      SheetPath{{{tip, {tip.x - x - y / 3, tip.y - y + x / 3}, {tip.x - x + y / 3, tip.y - y - x / 3}}},
                true,
                stroke.colour,
                {}});
}

std::string areaText(double squareMetres) {
  return formatted(squareMetres, squareMetres < 1000 ? "%.1f" : "%.0f") + " m\u00b2";
}

}  // namespace footfall::detail
