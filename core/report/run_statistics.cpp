// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/base/counted_text.hpp"
#include "core/base/process_usage.hpp"
#include "core/base/vector.hpp"
#include "core/environment/skipped_polygons.hpp"
#include "core/filters/descriptor_text.hpp"
#include "core/mesh/storey_names.hpp"
#include "core/report/layers_text.hpp"
#include "core/report/text_table.hpp"
#include "footfall/filter.hpp"
#include "footfall/inspect.hpp"
#include "footfall/report.hpp"
#include "footfall/up_axis.hpp"
#include "footfall/version.hpp"

namespace footfall {
using namespace detail;
namespace {

using Json = nlohmann::ordered_json;

Json valueJson(const ParameterDescriptor& parameter, double value) {
  switch (parameter.type) {
    case ParameterType::Boolean:
      return value != 0;
    case ParameterType::Integer:
      return static_cast<std::int64_t>(value);
    case ParameterType::Real:
      break;
  }
  return value;
}

Json parametersJson(const StepStatistics& step) {
  Json parameters = Json::object();
  const FilterDescriptor* filter = findFilter(step.name);
  if (filter == nullptr || !filter->takes(step.parameters.size())) return parameters;
  const std::size_t once = filter->parameters.size() - filter->repeats;
  for (std::size_t i = 0; i < once; ++i)
    parameters[std::string(filter->parameters[i].name)] = valueJson(filter->parameters[i], step.parameters[i]);
  if (filter->repeats == 0) return parameters;
  Json& groups = parameters[std::string(filter->groups)] = Json::array();
  for (std::size_t i = once; i < step.parameters.size(); ++i) {
    if ((i - once) % filter->repeats == 0) groups.push_back(Json::array());
    groups.back().push_back(valueJson(filter->parameterOf(i), step.parameters[i]));
  }
  return parameters;
}

Json boundJson(const std::array<double, 3>& bound) {
  Json json = Json::array();
  for (const double c : bound) json.push_back(std::isfinite(c) ? Json(c) : Json(nullptr));
  return json;
}

Json spanJson(const CellSpan& span) {
  return {{"filter", span.filter}, {"thread", span.thread}, {"start_ms", span.startMs}, {"end_ms", span.endMs}};
}

Json cellJson(const CellReport& cell) {
  Json filters = Json::object(), spans = Json::array();
  for (const CellSpan& span : cell.spans) {
    Json& sum = filters[span.filter];
    sum = (sum.is_null() ? 0 : sum.get<double>()) + span.endMs - span.startMs;
    spans.push_back(spanJson(span));
  }
  return {{"lower", boundJson(cell.bounds.lower)},
          {"upper", boundJson(cell.bounds.upper)},
          {"cost", cell.cost},
          {"triangles_in", cell.trianglesIn},
          {"triangles_out", cell.trianglesOut},
          {"thread", cell.thread},
          {"start_ms", cell.startMs},
          {"end_ms", cell.endMs},
          {"work_ms", cell.workMs()},
          {"filters", filters},
          {"spans", spans}};
}

Json blockJson(const BlockReport& block, int threads) {
  Json cells = Json::array(), shared = Json::array();
  for (const CellReport& cell : block.cells) cells.push_back(cellJson(cell));
  for (const CellSpan& span : block.shared) shared.push_back(spanJson(span));
  return {{"first_step", block.firstStep},
          {"last_step", block.lastStep},
          {"strategy", block.strategy},
          {"reason", block.reason.str()},
          {"start_ms", block.startMs},
          {"partitioning_ms", block.partitioningMs},
          {"parallel_ms", block.parallelMs},
          {"merging_ms", block.mergingMs},
          {"imbalance", block.imbalance(threads)},
          {"busy_ms", block.busyMs(threads)},
          {"shared", shared},
          {"cells", cells}};
}

Json timesJson(const RunTimes& times) {
  return {{"preprocessing_ms", times.preprocessing},
          {"partitioning_ms", times.partitioning},
          {"parallel_ms", times.parallel},
          {"merging_ms", times.merging},
          {"postprocessing_ms", times.postprocessing},
          {"overhead_ms", times.overhead},
          {"total_ms", times.total}};
}

Json speedUpJson(const std::optional<SpeedUp>& speedUp, int threads) {
  if (!speedUp) return nullptr;
  return {{"one_thread_ms", speedUp->oneThreadMs},
          {"parallel_ms", speedUp->parallelMs},
          {"speed_up", speedUp->speedUp()},
          {"efficiency", speedUp->efficiency(threads)}};
}

ExactFallbacks sumFallbacks(const RunResult& result) {
  ExactFallbacks sum;
  for (const StepStatistics& step : result.steps) {
    sum += step.fallbacks;
  }
  return sum;
}

std::string number(double value, const char* format = "%.1f") { return formatted(value, format); }

std::string stepText(const StepStatistics& step) {
  const FilterDescriptor* filter = findFilter(step.name);
  return filter == nullptr ? step.name : formatStep({filter, step.parameters, true, 0});
}

/// The elements that import left out, in a few lines; empty when none has an area.
std::string skippedLines(const Environment& environment) {
  constexpr std::size_t kShown = 3;
  const std::uint64_t polygons = environment.skipped.polygons;
  if (polygons == 0) return {};
  return "skipped " + counted(polygons, "polygon", "polygons") + " of the file:\n" +
         formatSkipped(environment.skipped, environment.up, kShown);
}

Json skippedJson(const SkippedElements& skipped) {
  Json listed = Json::array();
  for (const SkippedPolygon& polygon : skipped.listed) {
    Json entry = Json::object();
    entry["line"] = polygon.line > 0 ? Json(polygon.line) : Json(nullptr);
    entry["face"] = polygon.line > 0 ? Json(nullptr) : Json(polygon.face);
    entry["mesh"] = polygon.mesh;
    entry["reason"] = skippedReason(polygon).str();
    listed.push_back(std::move(entry));
  }
  return {{"points", skipped.points}, {"lines", skipped.lines}, {"polygons", skipped.polygons}, {"listed", listed}};
}

/// The figures of a mesh's steps, or gaps.
struct LinkFigures {
  std::size_t count = 0;
  double planLength = 0, highest = 0, widest = 0;
  [[nodiscard]] Json json() const {
    return {{"count", count},
            {"length", planLength},
            {"highest", count > 0 ? Json(highest) : Json()},
            {"widest", count > 0 ? Json(widest) : Json()}};
  }
};

LinkFigures measureLinks(const NavigationMesh& mesh, StepKind kind) {
  LinkFigures figures;
  for (const StepLink& link : mesh.links) {
    if (link.kind != kind) continue;
    const Vec3 &a = mesh.vertices[link.from[0]], &b = mesh.vertices[link.from[1]];
    ++figures.count;
    figures.planLength += std::hypot(b.x - a.x, b.y - a.y);
    figures.highest = std::max(figures.highest, link.height);
    figures.widest = std::max(figures.widest, link.width);
  }
  return figures;
}

/// The figures of a mesh's drops.
struct DropFigures {
  double planLength = 0, deepest = 0;
  /// Components to which drops lead from the largest one and from which nothing leads back, and those from which drops
  /// lead to it likewise.
  std::size_t below = 0, above = 0;
};

/// The components to which drops lead from the first one, over others too; or from which they lead to it.
std::vector<char> reachedByDrops(const NavigationMesh& mesh, const Components& components, bool isBackwards) {
  std::vector<std::vector<std::uint32_t>> next(components.list.size());
  for (const DropLink& drop : mesh.drops) {
    std::uint32_t from = components.ofTriangle[drop.fromTriangle], to = components.ofTriangle[drop.toTriangle];
    if (isBackwards) std::swap(from, to);
    next[from].push_back(to);
  }
  std::vector<char> isReached(components.list.size(), 0);
  std::vector<std::uint32_t> open{0};
  isReached[0] = 1;
  while (!open.empty()) {
    const std::uint32_t c = open.back();
    open.pop_back();
    for (const std::uint32_t other : next[c]) {
      if (isReached[other] != 0) continue;
      isReached[other] = 1;
      open.push_back(other);
    }
  }
  return isReached;
}

DropFigures measureDrops(const NavigationMesh& mesh, const Components& components) {
  DropFigures figures;
  if (mesh.drops.empty()) return figures;
  for (const DropLink& drop : mesh.drops) {
    figures.planLength += drop.width;
    figures.deepest = std::max(figures.deepest, drop.depth);
  }
  const std::vector<char> down = reachedByDrops(mesh, components, false), up = reachedByDrops(mesh, components, true);
  for (std::size_t c = 1; c < down.size(); ++c) {
    figures.below += static_cast<std::size_t>(down[c] != 0 && up[c] == 0);
    figures.above += static_cast<std::size_t>(up[c] != 0 && down[c] == 0);
  }
  return figures;
}

/// The share of `total`, the area of all components; areas beyond all doubles count alike, as in
/// Components::connectedShare().
double shareOf(double area, double total, const Components& components) {
  if (!(total > 0)) return 0;
  if (std::isfinite(total)) return area / total;
  return std::isinf(area) ? components.connectedShare() : 0;
}

Json componentsJson(const Components& components) {
  Json list = Json::array();
  const double total = components.totalArea();
  for (const Component& component : components.list) {
    list.push_back({{"area", component.area},
                    {"share", shareOf(component.area, total, components)},
                    {"triangles", component.triangles},
                    {"layers", component.layers}});
  }
  return list;
}

Json layersJson(const NavigationMesh& mesh) {
  std::vector<std::size_t> triangles(mesh.layerCount);
  std::vector<double> areas(mesh.layerCount);
  for (std::size_t t = 0; t < mesh.layers.size(); ++t) {
    const Triangle& corners = mesh.triangles[t];
    ++triangles.at(mesh.layers[t]);
    areas[mesh.layers[t]] += areaOf(mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]);
  }
  Json list = Json::array();
  const std::vector<std::string> storeys = storeyNames(mesh);
  for (std::size_t i = 0; i < areas.size(); ++i)
    list.push_back(
        {{"area", areas[i]}, {"triangles", triangles[i]}, {"storeys", storeys.empty() ? std::string() : storeys[i]}});
  return list;
}

/// The largest parts, and what the others amount to; empty where there are none.
std::string componentLines(const Components& components) {
  constexpr std::size_t kShown = 5;
  const std::vector<Component>& list = components.list;
  if (list.empty()) return {};
  const double total = components.totalArea();
  const auto share = [&](double area) { return number(100 * shareOf(area, total, components), "%.3g") + " %"; };
  std::vector<std::vector<std::string>> rows = {{"component", "area", "share", "triangles", "layers"}};
  const std::size_t shown = std::min(kShown, list.size());
  for (std::size_t i = 0; i < shown; ++i) {
    std::string layers;
    for (const std::uint32_t layer : list[i].layers) {
      if (!layers.empty()) layers += ' ';
      layers += std::to_string(layer);
    }
    rows.push_back({std::to_string(i + 1), number(list[i].area, "%.6g"), share(list[i].area),
                    std::to_string(list[i].triangles), layers});
  }
  if (shown < list.size()) {
    double area = 0;
    std::size_t triangles = 0;
    for (std::size_t i = shown; i < list.size(); ++i) {
      area += list[i].area;
      triangles += list[i].triangles;
    }
    rows.push_back({formatted(static_cast<double>(list.size() - shown), "(%.0f more)"), number(area, "%.6g"),
                    share(area), std::to_string(triangles), ""});
  }
  return '\n' + counted(list.size(), "component", "components") +
         "; two random places are connected with a probability of " + number(components.connectedShare(), "%.3g") +
         '\n' + formatTable(rows) + '\n';
}

std::string linkLine(const NavigationMesh& mesh) {
  const LinkFigures steps = measureLinks(mesh, StepKind::Step), gaps = measureLinks(mesh, StepKind::Gap);
  std::string text;
  if (steps.count > 0)
    text += counted(steps.count, "step", "steps") + " between borders, " + number(steps.planLength, "%.6g") +
            " long in the plan, the highest " + number(steps.highest, "%.6g") + '\n';
  if (gaps.count > 0)
    text += counted(gaps.count, "gap", "gaps") + " between borders, " + number(gaps.planLength, "%.6g") +
            " long in the plan, the widest " + number(gaps.widest, "%.6g") + ", the highest " +
            number(gaps.highest, "%.6g") + '\n';
  return text;
}

std::string dropLine(const NavigationMesh& mesh, const Components& components) {
  if (mesh.drops.empty()) return {};
  const DropFigures figures = measureDrops(mesh, components);
  return counted(mesh.drops.size(), "drop", "drops") + " one way down, " + number(figures.planLength, "%.6g") +
         " long in the plan, the deepest " + number(figures.deepest, "%.6g") + "; one way only: from the largest " +
         "component to " + std::to_string(figures.below) + ", and to it from " + std::to_string(figures.above) + '\n';
}

void addMesh(Json& json, const NavigationMesh& mesh, const Components& components, double area) {
  json["vertices"] = mesh.vertices.size();
  json["triangles"] = mesh.triangles.size();
  json["area"] = area;
  json["layers"] = mesh.layerCount;
  json["layers_at_least"] = leastLayers(mesh);
  json["layer_list"] = layersJson(mesh);
  json["connections"] = mesh.connections.size();
  json["connections_at_least"] = leastConnections(mesh);
  const LinkFigures steps = measureLinks(mesh, StepKind::Step), gaps = measureLinks(mesh, StepKind::Gap);
  json["links"] = mesh.links.size();
  json["link_length"] = steps.planLength + gaps.planLength;
  json["highest_link"] = mesh.links.empty() ? Json() : Json(std::max(steps.highest, gaps.highest));
  json["links_by_kind"] = {{"step", steps.json()}, {"gap", gaps.json()}};
  json["obstacle_edges"] = mesh.obstacleEdges.size();
  const DropFigures drops = measureDrops(mesh, components);
  json["drops"] = mesh.drops.size();
  json["drop_length"] = drops.planLength;
  json["deepest_drop"] = mesh.drops.empty() ? Json() : Json(drops.deepest);
  json["components_below_largest"] = drops.below;
  json["components_above_largest"] = drops.above;
  json["components"] = componentsJson(components);
  json["connected_share"] = components.connectedShare();
}

std::string meshLines(const NavigationMesh& mesh) {
  const Components components = findComponents(mesh);
  return layersText(mesh) + ", " + connectionsText(mesh) + ", " +
         counted(mesh.obstacleEdges.size(), "obstacle edge", "obstacle edges") + '\n' + linkLine(mesh) +
         dropLine(mesh, components) + componentLines(components);
}

Json gridJson(const CoordinateGrid& grid) {
  if (grid.step == 0) return nullptr;
  return {{"step", grid.step},
          {"bits", grid.bits},
          {"largest_movement", grid.largestMovement},
          {"welded_vertices", grid.weldedVertices},
          {"degenerate_triangles", grid.degenerateTriangles},
          {"split_triangles", grid.splitTriangles}};
}

std::string gridLine(const Environment& environment) {
  const CoordinateGrid& grid = environment.grid;
  if (grid.step == 0) return {};
  return "coordinates on a grid of " + number(grid.step, "%.6g") + ", moved by at most " +
         number(grid.largestMovement, "%.2g") + ", " + counted(grid.weldedVertices, "vertex", "vertices") +
         " welded, " + counted(grid.degenerateTriangles, "triangle", "triangles") + " became degenerate, " +
         std::to_string(grid.splitTriangles) + " split\n";
}

}  // namespace

std::string formatStatistics(const Environment& environment, const RunResult& result, const ProgramTimes& times) {
  Json json;
  json["program"] = "Footfall " + std::string(version());
  json["environment"] = {{"source", environment.source},
                         {"triangles", environment.triangles.size()},
                         {"vertices", environment.vertices.size()},
                         {"up", nameOf(environment.up)},
                         {"up_guessed", environment.upGuessed},
                         {"metres_per_unit", environment.metresPerUnit},
                         {"scale_guessed", environment.scaleGuessed},
                         {"both_sides", environment.bothSides},
                         {"grid", gridJson(environment.grid)},
                         {"skipped", skippedJson(environment.skipped)}};
  json["steps"] = Json::array();
  for (const StepStatistics& step : result.steps) {
    json["steps"].push_back({{"name", step.name},
                             {"parameters", parametersJson(step)},
                             {"start_ms", step.startMs},
                             {"wall_ms", step.wallMs},
                             {"cpu_ms", step.cpuMs},
                             {"triangles_in", step.in.triangles},
                             {"triangles_out", step.out.triangles},
                             {"area_in", step.in.area},
                             {"area_out", step.out.area},
                             {"from_cache", step.fromCache},
                             {"note", step.note.str()}});
  }
  json["load_ms"] = times.loadMs;
  json["start_ms"] = result.startMs;
  json["finish_ms"] = result.finishMs;
  json["export_ms"] = times.exportMs;
  json["total_ms"] = times.totalMs;
  json["run_ms"] = result.totalMs;
  json["cpu_ms"] = result.cpuMs;
  json["threads"] = result.threads;
  json["peak_rss_bytes"] = peakRssBytes();
  const NavigationMesh& mesh = *result.mesh;
  addMesh(json, mesh, findComponents(mesh), result.summary.area);
  const ExactFallbacks fallbacks = sumFallbacks(result);
  json["exact_fallbacks"] = fallbacks.total();
  json["exact_fallbacks_by_kind"] = {
      {"slope", fallbacks.slope}, {"height", fallbacks.height}, {"orientation", fallbacks.orientation},
      {"side", fallbacks.side},   {"order", fallbacks.order},   {"area", fallbacks.area}};
  json["times"] = timesJson(result.times);
  json["speed_up"] = speedUpJson(times.speedUp, result.threads);
  json["speed_up_estimate"] = result.totalMs > 0 ? result.cpuMs / result.totalMs : 1;
  json["blocks"] = Json::array();
  for (const BlockReport& block : result.blocks) json["blocks"].push_back(blockJson(block, result.threads));
  // File names are bytes; what is no UTF-8 must not lose the statistics.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string formatMeshStatistics(const NavigationMesh& mesh) {
  Json json;
  json["program"] = "Footfall " + std::string(version());
  json["source"] = mesh.frame.source;
  const Components components = findComponents(mesh);
  addMesh(json, mesh, components, components.totalArea());
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string formatMeshSummary(const NavigationMesh& mesh) { return meshLines(mesh); }

std::string formatSummary(const Environment& environment, const RunResult& result, const ProgramTimes& times) {
  std::vector<std::vector<std::string>> rows = {{"step", "wall ms", "cpu ms", "triangles", "area", "note"}};
  if (!result.steps.empty()) {
    const StateSummary& first = result.steps.front().in;
    rows.push_back(
        {"(start)", number(result.startMs), "", std::to_string(first.triangles), number(first.area, "%.6g"), ""});
  }
  for (const StepStatistics& step : result.steps) {
    rows.push_back({stepText(step), number(step.wallMs), number(step.cpuMs), std::to_string(step.out.triangles),
                    number(step.out.area, "%.6g"), step.note.str()});
  }
  const NavigationMesh& mesh = *result.mesh;
  rows.push_back({"(navigation mesh)", number(result.finishMs), "", std::to_string(mesh.triangles.size()), "", ""});
  std::string text = environment.source + ": " + counted(environment.triangles.size(), "triangle", "triangles") + ", " +
                     shownName(environment.up) + " up" + (environment.upGuessed ? " (guessed)" : "") + ", " +
                     number(environment.metresPerUnit, "%.6g") + " m per unit" +
                     (environment.scaleGuessed ? " (guessed)" : "") + '\n' + gridLine(environment) +
                     skippedLines(environment) + '\n' + formatTable(rows) + '\n';
  text += meshLines(mesh);
  for (const BlockReport& block : result.blocks) {
    text += "block of " + counted(block.cells.size(), "cell", "cells") + ": partitioning " +
            number(block.partitioningMs) + " ms, parallel " + number(block.parallelMs) + " ms, merging " +
            number(block.mergingMs) + " ms; the busiest thread did " + number(block.imbalance(result.threads), "%.2f") +
            " times the mean\n";
  }
  if (times.speedUp) {
    text += "speed-up " + number(times.speedUp->speedUp(), "%.2f") + ", efficiency " +
            number(times.speedUp->efficiency(result.threads), "%.2f") + ": " + number(times.speedUp->oneThreadMs) +
            " ms on one thread without blocks, " + number(times.speedUp->parallelMs) + " ms as given (medians)\n";
  }
  text += "load " + number(times.loadMs) + " ms, run " + number(result.totalMs) + " ms on " +
          counted(static_cast<std::uint64_t>(result.threads), "thread", "threads") + ", export " +
          number(times.exportMs) + " ms\n";
  return text;
}

}  // namespace footfall
