// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/comparison_report.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/base/counted_text.hpp"
#include "core/base/process_usage.hpp"
#include "core/compare/comparison_cover.hpp"
#include "footfall/up_axis.hpp"

namespace footfall::detail {
namespace {

using Json = nlohmann::ordered_json;

Json placeJson(const Vec3& p, UpAxis up) {
  const Vec3 place = inFileFrame(p, up);
  return {place.x, place.y, place.z};
}

Json areasJson(const SurfaceArea& areas) { return {{"area", areas.surface}, {"plan_area", areas.plan}}; }

Json partJson(const MeshPart& part) {
  Json json;
  if (!part.name.empty()) json["name"] = part.name;
  json["triangles"] = part.triangles;
  json["degenerate_triangles"] = part.degenerate;
  json["components"] = part.components;
  json["area"] = part.areas.surface;
  json["plan_area"] = part.areas.plan;
  json["uncovered"] = areasJson(part.uncovered);
  return json;
}

Json meshJson(const NavigationMeshFile& file, const MeshDescription& mesh) {
  Json json = {{"file", file.path},
               {"footfall_export", file.isExport},
               {"up", nameOf(file.up)},
               {"up_stated", file.statedUp.has_value()},
               {"metres_per_unit", file.metresPerUnit ? Json(*file.metresPerUnit) : Json()},
               {"vertices", mesh.vertices},
               {"positions", mesh.positions}};
  json.update(partJson(mesh.whole));
  json["layers"] = mesh.layers.size();
  json["connections"] = mesh.connections;
  json["connection_length"] = mesh.connectionLength;
  json["obstacle_edges"] = mesh.obstacleEdges;
  json["obstacle_edge_length"] = mesh.obstacleEdgeLength;
  json["links"] = mesh.links;
  json["link_length"] = mesh.linkLength;
  json["highest_link"] = mesh.links > 0 ? Json(mesh.highestLink) : Json();
  json["gaps"] = mesh.gaps;
  json["widest_gap"] = mesh.gaps > 0 ? Json(mesh.widestGap) : Json();
  json["drops"] = mesh.drops;
  json["drop_length"] = mesh.dropLength;
  json["deepest_drop"] = mesh.drops > 0 ? Json(mesh.deepestDrop) : Json();
  json["by_layer"] = Json::array();
  for (const MeshPart& part : mesh.layers) json["by_layer"].push_back(partJson(part));
  return json;
}

Json setJson(const SetDifference& sets, comparison::CoverPart part) {
  Json json = {{"empty", !sets.hasArea[part]}};
  json.update(areasJson(sets.areas[part]));
  return json;
}

Json distancesJson(const SurfaceDistances& d, UpAxis up) {
  return {{"samples", d.samples},
          {"d_min", d.min},
          {"d_max", d.max},
          {"d_mean", d.mean},
          {"d_rms", d.rms},
          {"d_max_at", placeJson(d.farthest, up)},
          {"hausdorff_lower", d.lower},
          {"hausdorff_upper", d.upper},
          {"error_reached", d.boundReached}};
}

std::string number(double value, const char* format = "%.10g") { return formatted(value, format); }

/// Rows of a label and texts, as wide as the widest.
class Table {
 public:
  void row(std::vector<std::string> texts) { rows_.push_back(std::move(texts)); }
  void gap() { rows_.emplace_back(); }
  [[nodiscard]] std::string text() const {
    std::vector<std::size_t> widths;
    for (const auto& row : rows_) {
      widths.resize(std::max(widths.size(), row.size()), 0);
      for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    std::string all;
    for (const auto& row : rows_) {
      for (std::size_t i = 0; i < row.size(); ++i) {
        const std::string padding(widths[i] - row[i].size(), ' ');
        all += i == 0 ? row[i] + padding : "  " + padding + row[i];
      }
      all += '\n';
    }
    return all;
  }

 private:
  std::vector<std::vector<std::string>> rows_;
};

void addMeshes(const MeshComparison& comparison, Table& table) {
  const auto& [a, b] = comparison.meshes;
  const auto counts = [&](const char* label, std::size_t inA, std::size_t inB) {
    table.row({label, std::to_string(inA), std::to_string(inB)});
  };
  table.row({"", "A", "B"});
  counts("vertices", a.vertices, b.vertices);
  counts("triangles", a.whole.triangles, b.whole.triangles);
  if (a.whole.degenerate + b.whole.degenerate > 0)
    counts("  of them without area", a.whole.degenerate, b.whole.degenerate);
  counts("components", a.whole.components, b.whole.components);
  counts("layers", a.layers.size(), b.layers.size());
  counts("connections", a.connections, b.connections);
  table.row({"  their length", number(a.connectionLength), number(b.connectionLength)});
  counts("obstacle edges", a.obstacleEdges, b.obstacleEdges);
  table.row({"  their length", number(a.obstacleEdgeLength), number(b.obstacleEdgeLength)});
  if (a.links + b.links > 0) {
    counts("steps", a.links, b.links);
    table.row({"  their length in the plan", number(a.linkLength), number(b.linkLength)});
    table.row({"  the highest", number(a.highestLink), number(b.highestLink)});
    if (a.gaps + b.gaps > 0) {
      counts("  of them gaps", a.gaps, b.gaps);
      table.row({"  the widest", number(a.widestGap), number(b.widestGap)});
    }
  }
  if (a.drops + b.drops > 0) {
    counts("drops", a.drops, b.drops);
    table.row({"  their length in the plan", number(a.dropLength), number(b.dropLength)});
    table.row({"  the deepest", number(a.deepestDrop), number(b.deepestDrop)});
  }
  table.row({"area", number(a.whole.areas.surface), number(b.whole.areas.surface)});
  table.row({"  in the plan", number(a.whole.areas.plan), number(b.whole.areas.plan)});
}

void addDifferences(const MeshComparison& comparison, Table& table) {
  const auto& sets = comparison.sets;
  const auto& [a, b] = comparison.meshes;
  table.gap();
  table.row({"", "A without B", "B without A"});
  table.row({"exact area", number(sets.areas[0].surface), number(sets.areas[1].surface)});
  table.row({"  in the plan", number(sets.areas[0].plan), number(sets.areas[1].plan)});
  table.row({"heights within " + number(comparison.height, "%.4g"), number(a.whole.uncovered.surface),
             number(b.whole.uncovered.surface)});
  table.row({"  in the plan", number(a.whole.uncovered.plan), number(b.whole.uncovered.plan)});
  const std::size_t layers = std::max(a.layers.size(), b.layers.size());
  for (std::size_t i = 0; i < layers; ++i) {
    const auto textOf = [i](const MeshDescription& mesh) {
      return i < mesh.layers.size() ? number(mesh.layers[i].uncovered.plan) : std::string("-");
    };
    table.row({"    layer_" + std::to_string(i), textOf(a), textOf(b)});
  }
  if (a.links + b.links > 0)
    table.row({"steps, length in the plan", number(comparison.links.lengths[0]), number(comparison.links.lengths[1])});
}

void addDistances(const std::array<SurfaceDistances, 2>& distances, Table& table) {
  table.gap();
  table.row({"distances", "A to B", "B to A"});
  const auto values = [&](const char* label, double SurfaceDistances::*member) {
    table.row({label, number(distances[0].*member), number(distances[1].*member)});
  };
  table.row({"samples", std::to_string(distances[0].samples), std::to_string(distances[1].samples)});
  values("d_min", &SurfaceDistances::min);
  values("d_max", &SurfaceDistances::max);
  values("d_mean", &SurfaceDistances::mean);
  values("d_rms", &SurfaceDistances::rms);
  values("Hausdorff, at least", &SurfaceDistances::lower);
  values("Hausdorff, at most", &SurfaceDistances::upper);
}

std::string verdict(const MeshComparison& comparison) {
  if (comparison.equal()) return "Equal: both are the same set of points.\n";
  const auto& sets = comparison.sets;
  if (!sets.hasArea[0]) return "Different: B holds all of A, and more.\n";
  if (!sets.hasArea[1]) return "Different: A holds all of B, and more.\n";
  return "Different as exact sets; " + howDifferent(comparison) + ".\n";
}

/// The sentence on steps, which follows the verdict on the sets; empty when neither mesh has any.
std::string linkVerdict(const MeshComparison& comparison) {
  if (comparison.meshes[0].links + comparison.meshes[1].links == 0) return {};
  if (comparison.hasEqualLinks()) return "Both have the same steps.\n";
  if (comparison.meshes[1].links == 0) return "Only A has steps.\n";
  if (comparison.meshes[0].links == 0) return "Only B has steps.\n";
  return "Their steps differ.\n";
}

/// The same for drops.
std::string dropVerdict(const MeshComparison& comparison) {
  if (comparison.meshes[0].drops + comparison.meshes[1].drops == 0) return {};
  if (comparison.equalDrops) return "Both have the same drops.\n";
  if (comparison.meshes[1].drops == 0) return "Only A has drops.\n";
  if (comparison.meshes[0].drops == 0) return "Only B has drops.\n";
  return "Their drops differ.\n";
}

}  // namespace

std::string howDifferent(const MeshComparison& comparison) {
  const double most = std::max(comparison.meshes[0].whole.uncovered.plan, comparison.meshes[1].whole.uncovered.plan);
  std::string text = "heights within " + number(comparison.height, "%.4g") + ", ";
  text += most > 0 ? "an area of at most " + number(most, "%.4g") + " in the plan is in one of them only"
                   : "each covers all of the other";
  if (comparison.distances) {
    const auto& [ab, ba] = *comparison.distances;
    text +=
        ", and no point of either is farther than " + number(std::max(ab.upper, ba.upper), "%.4g") + " from the other";
  }
  return text;
}

std::string formatComparison(const std::array<NavigationMeshFile, 2>& files, const MeshComparison& comparison,
                             const ComparisonTimes& times) {
  std::string text;
  for (const std::size_t i : {0, 1}) {
    text += (i == 0 ? "A: " : "B: ") + files[i].path + ", " + shownName(files[i].up) + " up" +
            (files[i].statedUp ? "" : " (not stated)") + '\n';
  }
  if (files[0].metresPerUnit && files[1].metresPerUnit && *files[0].metresPerUnit != *files[1].metresPerUnit)
    text += "Note: the files state different metres per unit; their numbers are compared as they are.\n";
  text += '\n' + verdict(comparison) + linkVerdict(comparison) + dropVerdict(comparison) + '\n';
  Table table;
  addMeshes(comparison, table);
  addDifferences(comparison, table);
  if (comparison.distances) addDistances(*comparison.distances, table);
  text += table.text() + '\n';
  text += "walkable space covered: " + number(comparison.covered(), "%.15g") +
          " of A within the height; area of B / area of A (thesis 5.5): " +
          (comparison.areaRatio() ? number(*comparison.areaRatio(), "%.15g") : "-") + '\n';
  if (comparison.distances && !(comparison.distances->at(0).boundReached && comparison.distances->at(1).boundReached))
    text += "The Hausdorff bounds hold, but are wider than " + number(comparison.error, "%.4g") +
            ": it would have taken too many steps; allow a larger error.\n";
  text += "load " + number(times.loadMs, "%.1f") + " ms, compare " + number(times.compareMs, "%.1f") + " ms\n";
  return text;
}

std::string formatComparisonJson(const std::array<NavigationMeshFile, 2>& files, const MeshComparison& comparison,
                                 const ComparisonTimes& times) {
  const auto& sets = comparison.sets;
  Json json;
  json["equal"] = comparison.equal();
  json["a"] = meshJson(files[0], comparison.meshes[0]);
  json["b"] = meshJson(files[1], comparison.meshes[1]);
  json["exact"] = {{"a_without_b", setJson(sets, comparison::kOnlyFirst)},
                   {"b_without_a", setJson(sets, comparison::kOnlySecond)},
                   {"common", setJson(sets, comparison::kBoth)}};
  const LinkDifference& links = comparison.links;
  const auto lengthJson = [&links](std::size_t part) {
    return Json{{"empty", !links.hasLength[part]}, {"length", links.lengths[part]}};
  };
  json["links"] = {{"a_without_b", lengthJson(0)}, {"b_without_a", lengthJson(1)}, {"common", lengthJson(2)}};
  json["equal_drops"] = comparison.equalDrops;
  json["within_height"] = {{"height", comparison.height},
                           {"a_without_b", areasJson(comparison.meshes[0].whole.uncovered)},
                           {"b_without_a", areasJson(comparison.meshes[1].whole.uncovered)}};
  json["walkable_space_covered"] = comparison.covered();
  json["area_ratio"] = comparison.areaRatio() ? Json(*comparison.areaRatio()) : Json();
  if (comparison.distances) {
    const auto& [ab, ba] = *comparison.distances;
    json["distances"] = {{"error", comparison.error},
                         {"a_to_b", distancesJson(ab, files[0].up)},
                         {"b_to_a", distancesJson(ba, files[1].up)},
                         {"hausdorff_lower", std::max(ab.lower, ba.lower)},
                         {"hausdorff_upper", std::max(ab.upper, ba.upper)}};
  } else {
    json["distances"] = nullptr;
  }
  json["load_ms"] = times.loadMs;
  json["compare_ms"] = times.compareMs;
  json["peak_rss_bytes"] = peakRssBytes();
  // File names are bytes; what is no UTF-8 must not lose the report.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace footfall::detail
