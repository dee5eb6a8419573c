// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/info.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "core/base/counted_text.hpp"
#include "core/base/number_text.hpp"
#include "core/environment/part_names.hpp"
#include "core/environment/part_rules.hpp"
#include "core/environment/skipped_polygons.hpp"
#include "core/exact/grid.hpp"
#include "core/exact/source_predicates.hpp"
#include "core/mesh/adjacency.hpp"
#include "footfall/up_axis.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kSkippedShown = 20;

/// A number for each vertex that it shares with exactly the vertices at the same position.
std::vector<std::uint32_t> numberPositions(const std::vector<Vec3>& vertices) {
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Vec3 &p = vertices[a], &q = vertices[b];
    return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
  });
  std::vector<std::uint32_t> position(vertices.size());
  std::uint32_t current = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && vertices[order[i]] != vertices[order[i - 1]]) ++current;
    position[order[i]] = current;
  }
  return position;
}

void countEdges(std::vector<Triangle> byPosition, std::size_t positionCount, EnvironmentInfo& info) {
  // Triangles folded onto themselves bound nothing.
  std::erase_if(byPosition, [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  const Adjacency adjacency = findEdges(byPosition, positionCount);
  for (Index e = 0; e < adjacency.edgeCount(); ++e) {
    const std::size_t triangles = adjacency.sidesOf(e).size();
    if (triangles == 1) ++info.openEdges;
    if (triangles > 2) ++info.nonManifoldEdges;
  }
}

void appendLine(std::string& text, const char* label, const std::string& value) {
  constexpr std::size_t kLabelWidth = 24;
  std::string padded(label);
  padded.resize(kLabelWidth, ' ');
  text += padded + value + "\n";
}

/// The role that the file gives a part, unless it is the usual one.
std::string roleNote(const Environment& environment, std::size_t part) {
  switch (usualRole(environment, static_cast<std::uint32_t>(part))) {
    case PartRole::ObstacleOnly:
      return " (usually an obstacle only)";
    case PartRole::Ignored:
      return " (usually ignored)";
    case PartRole::Floor:
      break;
  }
  return {};
}

std::string number(auto value) {
  std::string text;
  appendNumber(text, value);
  return text;
}

}  // namespace

std::string gridText(const Environment& environment, int bits) {
  // Doubles decide nearly everything on coordinates of fewer bits, and rarely on those of more.
  constexpr int kManyBits = 40;
  const CoordinateGrid& grid = environment.grid;
  if (grid.step == 0)
    return "none; coordinates have " + number(bits) + " bits" +
           (bits > kManyBits ? ", and --grid on may make runs several times faster" : "");
  return "step " + number(grid.step) + ", " + number(grid.bits) + " bits; moved by at most " +
         number(grid.largestMovement) + "; " + counted(grid.weldedVertices, "vertex", "vertices") + " welded, " +
         counted(grid.degenerateTriangles, "triangle", "triangles") + " became degenerate, " +
         number(grid.splitTriangles) + " split";
}

EnvironmentInfo inspectEnvironment(const Environment& environment) {
  EnvironmentInfo info;
  Grid digits;
  for (const Vec3& p : environment.vertices)
    for (const double x : {p.x, p.y, p.z}) digits.include(x);
  info.bits = digits.width();
  info.triangles = environment.triangles.size();
  info.vertices = environment.vertices.size();
  if (!environment.vertices.empty()) info.lower = info.upper = environment.vertices.front();
  for (const Vec3& p : environment.vertices) {
    info.lower = {std::min(info.lower.x, p.x), std::min(info.lower.y, p.y), std::min(info.lower.z, p.z)};
    info.upper = {std::max(info.upper.x, p.x), std::max(info.upper.y, p.y), std::max(info.upper.z, p.z)};
  }

  constexpr double kSlope = 45;
  for (std::size_t i = 0; i < environment.triangles.size(); ++i) {
    const Triangle& t = environment.triangles[i];
    const bool isNoFloor = !environment.obstacleOnly.empty() && environment.obstacleOnly[i] != 0;
    const Vec3 &a = environment.vertices[t[0]], &b = environment.vertices[t[1]], &c = environment.vertices[t[2]];
    if (isDegenerate(a, b, c)) {
      ++info.degenerate;
    } else if (!isNoFloor &&
               (isWithinSlope(a, b, c, kSlope) || (environment.bothSides && isWithinSlope(a, c, b, kSlope)))) {
      ++info.walkable45;
    }
  }

  info.partTriangles = countPartTriangles(environment);
  const std::vector<std::uint32_t> position = numberPositions(environment.vertices);
  std::vector<Triangle> byPosition = environment.triangles;
  for (Triangle& t : byPosition) {
    for (std::uint32_t& corner : t) corner = position[corner];
    std::sort(t.begin(), t.end());
  }
  countEdges(byPosition, environment.vertices.size(), info);
  std::sort(byPosition.begin(), byPosition.end());
  info.duplicate = static_cast<std::size_t>(byPosition.end() - std::unique(byPosition.begin(), byPosition.end()));
  return info;
}

std::string formatInfo(const Environment& environment, const EnvironmentInfo& info) {
  std::string text;
  const auto range = [&](double low, double high) { return number(low) + " to " + number(high); };
  appendLine(text, "environment", environment.source);
  if (!environment.origin.empty()) appendLine(text, "packed from", environment.origin);
  appendLine(text, "triangles", number(info.triangles));
  appendLine(text, "vertices", number(info.vertices));
  appendLine(text, "bounds (Z up)",
             "x " + range(info.lower.x, info.upper.x) + ", y " + range(info.lower.y, info.upper.y) + ", z " +
                 range(info.lower.z, info.upper.z));
  appendLine(text, "up axis of the file",
             shownName(environment.up) + (environment.upGuessed ? " (guessed)" : " (given)"));
  appendLine(text, "metres per unit",
             number(environment.metresPerUnit) + (environment.scaleGuessed ? " (guessed)" : " (given)"));
  appendLine(text, "grid of coordinates", gridText(environment, info.bits));
  appendLine(text, "upper sides", environment.bothSides ? "both (given)" : "front");
  appendLine(text, "degenerate", number(info.degenerate));
  appendLine(text, "duplicate", number(info.duplicate));
  appendLine(text, "walkable at 45 degrees", number(info.walkable45));
  appendLine(text, "open edges", number(info.openEdges));
  appendLine(text, "non-manifold edges", number(info.nonManifoldEdges));
  appendLine(text, "skipped",
             counted(environment.skipped.points, "point", "points") + ", " +
                 counted(environment.skipped.lines, "line", "lines") + ", " +
                 counted(environment.skipped.polygons, "polygon", "polygons"));
  text += formatSkipped(environment.skipped, environment.up, kSkippedShown);
  for (const Storey& storey : environment.storeys)
    appendLine(text, "storey", storey.name + " at " + number(storey.height));
  if (environment.parts.empty()) return text;
  appendLine(text, "parts (MESH/MATERIAL)", number(environment.parts.size()));
  for (std::size_t p = 0; p < environment.parts.size(); ++p)
    text += "  " + partLabel(environment.parts[p]).str() + ": " +
            counted(info.partTriangles[p], "triangle", "triangles") + roleNote(environment, p) + '\n';
  return text;
}

}  // namespace footfall::detail
