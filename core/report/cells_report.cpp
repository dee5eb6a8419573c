// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/cells_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <vector>

#include "core/base/counted_text.hpp"
#include "core/partitioning/load_balancing.hpp"
#include "core/report/text_table.hpp"
#include "footfall/up_axis.hpp"

namespace footfall::detail {
namespace {

using Json = nlohmann::ordered_json;

/// A cell's sides along the axes of the file.
struct FileBounds {
  std::array<double, 3> lower, upper;
};

FileBounds fileBounds(const CellBounds& b, UpAxis up) {
  FileBounds bounds{};
  const auto axes = fileAxes(up);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [axis, sign] = axes[i];
    bounds.lower[axis] = sign > 0 ? b.lower[i] : -b.upper[i];
    bounds.upper[axis] = sign > 0 ? b.upper[i] : -b.lower[i];
  }
  return bounds;
}

/// The axes of the plan and the one that is up, as the file numbers them.
std::array<std::size_t, 3> planAndHeight(UpAxis up) {
  const auto axes = fileAxes(up);
  return {std::min(axes[0].axis, axes[1].axis), std::max(axes[0].axis, axes[1].axis), axes[2].axis};
}

constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};

std::string rangeText(double lower, double upper) {
  const bool begins = std::isfinite(lower), ends = std::isfinite(upper);
  if (!begins && !ends) return "all";
  return (begins ? formatted(lower + 0.0, "%.9g") + ' ' : "") + ".." +
         (ends ? ' ' + formatted(upper + 0.0, "%.9g") : "");
}

std::vector<double> costsOf(const Partition& partition) {
  std::vector<double> costs;
  for (const Cell& cell : partition.cells) costs.push_back(cell.cost);
  return costs;
}

double imbalanceOf(const CellsReport& report) {
  return assignLongestFirst(costsOf(report.partition), static_cast<std::size_t>(std::max(report.threads, 1)))
      .imbalance();
}

}  // namespace

std::string formatCells(const CellsReport& report) {
  const auto axes = planAndHeight(report.environment.up);
  const std::vector<double> costs = costsOf(report.partition);
  const double total = std::accumulate(costs.begin(), costs.end(), 0.0);
  std::vector<std::vector<std::string>> rows{
      {"cell", kAxes[axes[0]], kAxes[axes[1]], kAxes[axes[2]], "floors", "obstacles", "cost", ""}};
  for (std::size_t i = 0; i < report.partition.cells.size(); ++i) {
    const Cell& cell = report.partition.cells[i];
    const FileBounds b = fileBounds(cell.bounds, report.environment.up);
    std::vector<std::string> row{std::to_string(i + 1)};
    for (const std::size_t axis : axes) row.push_back(rangeText(b.lower[axis], b.upper[axis]));
    row.insert(row.end(), {std::to_string(cell.floors), std::to_string(cell.obstacles), formatted(cell.cost, "%.6g"),
                           total > 0 ? formatted(100 * cell.cost / total, "%.1f %%") : ""});
    rows.push_back(std::move(row));
  }
  std::string text = formatTable(rows) + '\n';
  text += counted(costs.size(), "cell", "cells") + " by " + report.partition.strategy + "; on " +
          counted(static_cast<std::uint64_t>(std::max(report.threads, 1)), "thread", "threads") +
          ", largest first, the busiest has " + formatted(imbalanceOf(report), "%.3g") + " times the mean cost\n";
  if (!report.partition.reason.empty()) text += "why: " + report.partition.reason.str() + '\n';
  if (const auto& cut = report.cut) {
    text += "cut: " + counted(cut->triangles, "triangle", "triangles") + " from " +
            std::to_string(report.environment.triangles.size()) + ", " + counted(cut->vertices, "vertex", "vertices") +
            ", " + std::to_string(cut->cutVertices) + " of them made by cuts";
    if (cut->closedTriangles > 0)
      text += "; " + counted(cut->closedTriangles, "triangle", "triangles") + " closed by rounding, left out";
    text += '\n';
  }
  return text;
}

std::string formatCellsJson(const CellsReport& report) {
  const Environment& environment = report.environment;
  const auto axes = planAndHeight(environment.up);
  Json json;
  json["environment"] = {{"source", environment.source},
                         {"triangles", environment.triangles.size()},
                         {"up", nameOf(environment.up)},
                         {"metres_per_unit", environment.metresPerUnit}};
  json["strategy"] = report.partition.strategy;
  json["reason"] = report.partition.reason.str();
  json["plan_axes"] = {kAxes[axes[0]], kAxes[axes[1]]};
  json["threads"] = std::max(report.threads, 1);
  json["imbalance"] = imbalanceOf(report);
  json["cells"] = Json::array();
  for (std::size_t i = 0; i < report.partition.cells.size(); ++i) {
    const Cell& cell = report.partition.cells[i];
    const FileBounds b = fileBounds(cell.bounds, environment.up);
    const auto sides = [](const std::array<double, 3>& values) {
      Json array = Json::array();
      for (const double v : values) array.push_back(std::isfinite(v) ? Json(v + 0.0) : Json());
      return array;
    };
    json["cells"].push_back({{"cell", i + 1},
                             {"lower", sides(b.lower)},
                             {"upper", sides(b.upper)},
                             {"floors", cell.floors},
                             {"obstacles", cell.obstacles},
                             {"cost", cell.cost}});
  }
  if (const auto& cut = report.cut)
    json["cut"] = {{"vertices", cut->vertices},
                   {"cut_vertices", cut->cutVertices},
                   {"triangles", cut->triangles},
                   {"closed_triangles", cut->closedTriangles}};
  // File names are bytes; what is no UTF-8 must not lose the report.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace footfall::detail
