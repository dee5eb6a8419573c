// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/html_report.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <numeric>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/base/counted_text.hpp"
#include "core/base/process_usage.hpp"
#include "core/base/vector.hpp"
#include "core/environment/skipped_polygons.hpp"
#include "core/filters/descriptor_text.hpp"
#include "core/io/base64.hpp"
#include "core/mesh/gap_bridges.hpp"
#include "core/mesh/surface_topology.hpp"
#include "core/navigation/bottleneck_list.hpp"
#include "core/report/layers_text.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "footfall/report.hpp"
#include "footfall/up_axis.hpp"
#include "footfall/version.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kMostRows = 20, kMostBottlenecks = 50;  // limits of lists that can have thousands

// Blue for bars: Okabe and Ito's, darker or lighter as the background needs it.
constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --text: #1d2226; --quiet: #58636b; --page: #ffffff; --line: #d5dade; --bar: #0072b2; }
@media (prefers-color-scheme: dark) {
  :root { --text: #e6e9eb; --quiet: #a3adb4; --page: #1b1f22; --line: #3b4349; --bar: #56b4e9; }
}
body { margin: 2rem auto; max-width: 62rem; padding: 0 1rem; background: var(--page); color: var(--text);
       font: 1rem/1.5 system-ui, sans-serif; }
h1 { font-size: 1.6rem; margin: 0 0 .25rem; }
h2 { font-size: 1.2rem; margin: 2rem 0 .5rem; }
p { margin: .25rem 0; }
.quiet { color: var(--quiet); }
.wide { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; }
th, td { padding: .3rem .6rem; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; }
th { font-weight: 600; }
.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.scale { width: 12rem; }
.bar { display: block; height: .8rem; margin-top: .35rem; min-width: 1px; background: var(--bar); }
pre { padding: .75rem; border: 1px solid var(--line); overflow-x: auto; }
figure { margin: 1rem 0; }
figure img { max-width: 100%; height: auto; border: 1px solid var(--line); }
figcaption { color: var(--quiet); }
.legend { display: flex; flex-wrap: wrap; gap: .25rem 1.5rem; list-style: none; margin: .5rem 0; padding: 0; }
.legend img { vertical-align: -.15em; }
@media print { body { max-width: none; margin: 0; } figure, tr { break-inside: avoid; } }
)";

std::string number(double value, const char* format) { return formatted(value, format); }
std::string milliseconds(double ms) { return number(ms, ms < 10 ? "%.2f ms" : "%.0f ms"); }
std::string shortNumber(double x) { return number(x, "%.6g"); }

/// Thousands apart, which is how people read them.
std::string grouped(std::uint64_t n) {
  std::string text = std::to_string(n);
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(text.begin() + static_cast<std::ptrdiff_t>(i - 3), ',');
  return text;
}

std::string counted(std::uint64_t n, const char* one, const char* many) {
  return grouped(n) + ' ' + (n == 1 ? one : many);
}

/// A table with titles; columns from `firstNumber` on are numbers, except where a title is empty: bars.
class Table {
 public:
  explicit Table(const std::vector<std::string>& titles, std::size_t firstNumber)
      : titles_(titles), firstNumber_(firstNumber) {
    html_ = "<div class=\"wide\"><table>\n<thead><tr>";
    for (std::size_t i = 0; i < titles.size(); ++i)
      html_ += "<th scope=\"col\"" + classOf(i) + '>' + escapeHtml(titles[i]) + "</th>";
    html_ += "</tr></thead>\n<tbody>\n";
  }
  /// Cells are text; under an empty title a number from 0 to 100.
  void row(const std::vector<std::string>& cells) {
    html_ += "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i) {
      html_ += "<td" + classOf(i) + '>';
      html_ +=
          titles_[i].empty() ? "<span class=\"bar\" style=\"width: " + cells[i] + "%\"></span>" : escapeHtml(cells[i]);
      html_ += "</td>";
    }
    html_ += "</tr>\n";
  }
  [[nodiscard]] std::string finish() const { return html_ + "</tbody>\n</table></div>\n"; }

 private:
  [[nodiscard]] std::string classOf(std::size_t column) const {
    if (titles_[column].empty()) return " class=\"scale\"";
    return column >= firstNumber_ ? " class=\"number\"" : "";
  }
  std::vector<std::string> titles_;
  std::size_t firstNumber_;
  std::string html_;
};

/// Formats areas for people: in square metres where the file's scale is known, else in the file's own units.
class AreaText {
 public:
  explicit AreaText(const Environment& environment) : isKnown_(!environment.scaleGuessed) {
    if (isKnown_) squareMetres_ = environment.metresPerUnit * environment.metresPerUnit;
  }
  [[nodiscard]] std::string operator()(double area) const {
    return shortNumber(area * squareMetres_) + (isKnown_ ? " m²" : "");
  }
  [[nodiscard]] bool isKnown() const { return isKnown_; }

 private:
  bool isKnown_;
  double squareMetres_ = 1;
};

std::string percent(double part, double whole) {
  return number(whole > 0 ? std::clamp(100 * part / whole, 0.0, 100.0) : 0, "%.1f");
}

double areaOf(const NavigationMesh& mesh, const Triangle& t) {
  return detail::areaOf(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
}

struct Group {
  std::size_t triangles = 0;
  double area = 0;
};

std::vector<Group> sumGroups(const NavigationMesh& mesh, const std::vector<std::uint32_t>& groupOf, std::size_t count) {
  std::vector<Group> groups(count);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (groupOf[i] >= count) continue;
    ++groups[groupOf[i]].triangles;
    groups[groupOf[i]].area += areaOf(mesh, mesh.triangles[i]);
  }
  return groups;
}

/// The elements that import left out: their number, and the first polygons with their places.
std::string skippedSection(const SkippedElements& skipped, UpAxis up) {
  std::string text;
  const auto add = [&](std::uint64_t count, const char* one, const char* many) {
    if (count > 0) text += (text.empty() ? "" : ", ") + counted(count, one, many);
  };
  add(skipped.polygons, "polygon", "polygons");
  add(skipped.lines, "line", "lines");
  add(skipped.points, "point", "points");
  if (text.empty()) return "<p>Nothing was left out on import.</p>\n";
  const std::string listed = formatSkipped(skipped, up, kMostRows);
  return "<p>Left out on import: " + text + ".</p>\n" +
         (listed.empty() ? "" : "<pre>" + escapeHtml(listed) + "</pre>\n");
}

std::string environmentSection(const Environment& environment, const Pipeline& pipeline, const ProgramTimes& times) {
  const ExportHeader header = makeExportHeader(pipeline);
  std::string html =
      "<section>\n<h2>Environment</h2>\n<p>" +
      escapeHtml(
          counted(environment.triangles.size(), "triangle", "triangles") + ", " +
          counted(environment.vertices.size(), "vertex", "vertices") + "; " + shownName(environment.up) + " up" +
          (environment.upGuessed ? " (guessed)" : "") + ", " + shortNumber(environment.metresPerUnit) + " m per unit" +
          (environment.scaleGuessed ? " (guessed)" : "") + (environment.bothSides ? ", both sides count as up" : "") +
          (environment.grid.step > 0 ? ", coordinates on a grid of " + shortNumber(environment.grid.step) : "")) +
      "</p>\n";
  html += skippedSection(environment.skipped, environment.up);
  if (times.loadMs > 0) html += "<p class=\"quiet\">Loaded in " + milliseconds(times.loadMs) + "</p>\n";
  html += "</section>\n<section>\n<h2>Agent and pipeline</h2>\n<p>" + escapeHtml(header.agent) + "</p>\n<pre>" +
          escapeHtml(header.pipeline) + "</pre>\n</section>\n";
  return html;
}

std::string stepName(const StepStatistics& step) {
  const FilterDescriptor* filter = findFilter(step.name);
  return filter == nullptr ? step.name : formatStep({filter, step.parameters, true, 0});
}

std::string stepsSection(const RunResult& result, const AreaText& areaText) {
  double longest = std::max(result.startMs, result.finishMs);
  for (const StepStatistics& step : result.steps) longest = std::max(longest, step.wallMs);
  Table table({"Step", "", "Time", "Triangles", "Area", "Note"}, 2);
  const auto row = [&](const std::string& name, double ms, const std::string& triangles, const std::string& area,
                       const std::string& note) {
    table.row({name, percent(ms, longest), milliseconds(ms), triangles, area, note});
  };
  if (!result.steps.empty()) {
    const StateSummary& first = result.steps.front().in;
    row("(start)", result.startMs, grouped(first.triangles), areaText(first.area), "");
  }
  for (const StepStatistics& step : result.steps)
    row(stepName(step), step.wallMs, grouped(step.out.triangles), areaText(step.out.area),
        step.fromCache ? step.note.empty() ? "from the cache" : step.note.str() + "; from the cache" : step.note.str());
  row("(navigation mesh)", result.finishMs, result.mesh ? grouped(result.mesh->triangles.size()) : "", "", "");
  return "<section>\n<h2>Steps</h2>\n" + table.finish() + "<p class=\"quiet\">The run took " +
         milliseconds(result.totalMs) + " on " +
         escapeHtml(counted(static_cast<std::uint64_t>(result.threads), "thread", "threads")) + " (" +
         milliseconds(result.cpuMs) + " of processor time); the most memory held at once was " +
         number(static_cast<double>(peakRssBytes()) / 1048576.0, "%.0f") + " MiB.</p>\n</section>\n";
}

std::string groupsTable(const char* title, const std::string& prefix, const std::vector<Group>& groups, bool byArea,
                        const AreaText& areaText) {
  std::vector<std::size_t> order(groups.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (byArea)
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return groups[a].area > groups[b].area; });
  double largest = 0;
  for (const Group& group : groups) largest = std::max(largest, group.area);
  Table table({title, "", "Area", "Triangles"}, 2);
  const std::size_t shown = std::min(order.size(), kMostRows);
  for (std::size_t i = 0; i < shown; ++i) {
    const Group& group = groups[order[i]];
    table.row({prefix + std::to_string(byArea ? i + 1 : order[i]), percent(group.area, largest), areaText(group.area),
               grouped(group.triangles)});
  }
  std::string html = table.finish();
  if (shown < order.size()) {
    double rest = 0;
    for (std::size_t i = shown; i < order.size(); ++i) rest += groups[order[i]].area;
    html += "<p class=\"quiet\">and " + grouped(order.size() - shown) + " more with an area of " + areaText(rest) +
            " together</p>\n";
  }
  return html;
}

std::string resultSection(const RunResult& result, const AreaText& areaText) {
  if (!result.mesh) return {};
  const NavigationMesh& mesh = *result.mesh;
  const SurfaceTopology topology = makeSurfaceTopology(withBridges(mesh));
  std::string html = "<section>\n<h2>Result</h2>\n<p>" +
                     escapeHtml(counted(mesh.triangles.size(), "walkable triangle", "walkable triangles") + ", " +
                                counted(mesh.vertices.size(), "vertex", "vertices") + ", area " +
                                areaText(result.summary.area) + "; " + layersText(mesh) + ", " + connectionsText(mesh) +
                                ", " + counted(mesh.obstacleEdges.size(), "obstacle edge", "obstacle edges") + "; " +
                                counted(topology.componentCount, "connected part", "connected parts")) +
                     "</p>\n";
  if (mesh.layerCount > 0)
    html += groupsTable("Layer", "layer_", sumGroups(mesh, mesh.layers, mesh.layerCount), false, areaText);
  if (topology.componentCount > 0) {
    html += "<h3>Connected parts, the largest first</h3>\n" +
            groupsTable("Part", "", sumGroups(mesh, topology.components, topology.componentCount), true, areaText);
  }
  return html + "</section>\n";
}

/// Says what is on either side of a bottleneck.
std::string sidesText(const CorridorMap& map, const Bottleneck& b, const AreaText& areaText) {
  if (b.isOnlyWay) return "areas of " + areaText(b.sides[0].area) + " and " + areaText(b.sides[1].area);
  const auto widest = [&](std::size_t side) { return shortNumber(map.vertices[b.sides.at(side).widest].width); };
  return "widths of up to " + widest(0) + " and " + widest(1);
}

/// How many bottlenecks the table leaves out, and why; empty where it leaves out none.
std::string leftOutText(const BottleneckList& list, const BottleneckRule& rule) {
  std::string text;
  const auto add = [&text](std::size_t count, const std::string& why) {
    if (count > 0) text += (text.empty() ? "" : "; ") + grouped(count) + why;
  };
  add(list.listed.size() - std::min(list.listed.size(), kMostBottlenecks), " that are wider");
  add(list.slits, ", at most " + shortNumber(rule.widerThan) + " wide");
  add(list.shallow, ", behind which the way gets wider by less than " + shortNumber(100 * rule.leastProminence) + " %");
  return text.empty() ? text : "<p class=\"quiet\">Left out: " + escapeHtml(text) + ".</p>\n";
}

std::string bottlenecksSection(const CorridorMap& map, const Environment& environment, const Pipeline& pipeline,
                               const AreaText& areaText) {
  const BottleneckRule rule = usualBottlenecks(environment.metresPerUnit);
  const BottleneckList list = listBottlenecks(map, rule);
  std::vector<std::string> titles{"Place", "Between", "The only way", "Width"};
  if (areaText.isKnown()) titles.emplace_back("In metres");
  Table table(titles, 3);
  for (std::size_t i = 0; i < std::min(list.listed.size(), kMostBottlenecks); ++i) {
    const Bottleneck& b = map.bottlenecks[list.listed[i]];
    const Vec3 place = inFileFrame(b.place, map.frame.up);
    std::vector<std::string> cells{shortNumber(place.x) + ' ' + shortNumber(place.y) + ' ' + shortNumber(place.z),
                                   sidesText(map, b, areaText), b.isOnlyWay ? "yes" : "no", shortNumber(b.width)};
    if (areaText.isKnown()) cells.push_back(shortNumber(b.width * environment.metresPerUnit) + " m");
    table.row(cells);
  }
  const bool hasRadius = std::ranges::any_of(
      pipeline.steps, [](const PipelineStep& step) { return step.enabled && step.filter->type == FilterType::Radius; });
  return "<section>\n<h2>Bottlenecks</h2>\n<p>" + counted(list.listed.size(), "bottleneck", "bottlenecks") +
         ", the narrowest first. Widths and places are in the units of the file." +
         (hasRadius ? " A RadiusFilter has made every passage narrower." : "") + "</p>\n" +
         (list.listed.empty() ? std::string() : table.finish()) + leftOutText(list, rule) + "</section>\n";
}

std::string blockSection(const BlockReport& block, int threads) {
  std::string html = "<section>\n<h2>Cells and threads</h2>\n<p>" +
                     escapeHtml(block.strategy + ": " + counted(block.cells.size(), "cell", "cells") +
                                (block.reason.empty() ? "" : "; " + block.reason.str())) +
                     "</p>\n<p class=\"quiet\">Partitioning " + milliseconds(block.partitioningMs) + ", cells " +
                     milliseconds(block.parallelMs) + ", merging " + milliseconds(block.mergingMs) + "; imbalance " +
                     number(block.imbalance(threads), "%.2f") + "</p>\n";
  const std::vector<double> busy = block.busyMs(threads);
  const double most = busy.empty() ? 0 : *std::max_element(busy.begin(), busy.end());
  Table lanes({"Thread", "", "Busy"}, 2);
  for (std::size_t i = 0; i < busy.size(); ++i)
    lanes.row({std::to_string(i), percent(busy[i], most), milliseconds(busy[i])});
  html += lanes.finish();

  std::vector<std::size_t> order(block.cells.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return block.cells[a].workMs() > block.cells[b].workMs(); });
  Table cells({"Cell", "", "Work", "Thread", "Triangles in", "Triangles out"}, 2);
  for (std::size_t i = 0; i < std::min(order.size(), kMostRows); ++i) {
    const CellReport& cell = block.cells[order[i]];
    cells.row({std::to_string(order[i] + 1), percent(cell.workMs(), block.cells[order[0]].workMs()),
               milliseconds(cell.workMs()), std::to_string(cell.thread), grouped(cell.trianglesIn),
               grouped(cell.trianglesOut)});
  }
  html += cells.finish();
  if (order.size() > kMostRows)
    html += "<p class=\"quiet\">and " + grouped(order.size() - kMostRows) +
            (order.size() - kMostRows == 1 ? " cell" : " cells") + " with less work</p>\n";
  return html + "</section>\n";
}

std::string embedded(const ReportPicture& picture, const std::string& alt) {
  return "<img alt=\"" + alt + "\" src=\"data:image/png;base64," + toBase64(picture.png) + "\"/>";
}

std::string picturesSection(const ReportDetails& details) {
  if (details.pictures.empty()) return {};
  std::string html = "<section>\n<h2>Pictures</h2>\n";
  if (!details.legend.empty()) {
    html += "<ul class=\"legend\">\n";
    // The words stand beside the colour: its picture needs none of its own.
    for (const ReportPicture& colour : details.legend)
      html += "<li>" + embedded(colour, "") + ' ' + escapeHtml(colour.caption) + "</li>\n";
    html += "</ul>\n";
  }
  for (const ReportPicture& picture : details.pictures) {
    const std::string caption = escapeHtml(picture.caption);
    html += "<figure>" + embedded(picture, caption) + "<figcaption>" + caption + "</figcaption></figure>\n";
  }
  return html + "</section>\n";
}

}  // namespace

std::string reportDate() {
  std::time_t now = std::time(nullptr);
  if (const char* given = std::getenv("SOURCE_DATE_EPOCH")) {
    const std::string_view text(given);
    std::int64_t seconds = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seconds);
    if (error == std::errc() && end == text.data() + text.size()) now = static_cast<std::time_t>(seconds);
  }
  std::tm time{};
  std::array<char, 40> buffer{};
  if (::gmtime_r(&now, &time) == nullptr ||
      std::strftime(buffer.data(), buffer.size(), "%Y-%m-%d %H:%M UTC", &time) == 0)
    return {};
  return buffer.data();
}

std::string formatHtmlReport(const Environment& environment, const Pipeline& pipeline, const RunResult& result,
                             const ProgramTimes& times, const ReportDetails& details) {
  const std::string name = escapeHtml(std::filesystem::path(environment.frame().source).filename().string());
  const AreaText areaText(environment);
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<meta name=\"generator\" content=\"Footfall " FOOTFALL_VERSION "\"/>\n<title>" +
      name + ": walkable area</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n<main>\n<h1>" + name +
      "</h1>\n<p class=\"quiet\">Walkable area, computed by Footfall " FOOTFALL_VERSION +
      (details.date.empty() ? std::string() : " on " + escapeHtml(details.date)) +
      (areaText.isKnown() ? ". Areas are in square metres; the pipeline's lengths are in the units of the file, " +
                                shortNumber(environment.metresPerUnit) + " m each.</p>\n"
                          : ". Lengths and areas are in the units of the file, whose scale is a guess.</p>\n");
  html += environmentSection(environment, pipeline, times);
  html += resultSection(result, areaText);
  if (details.corridors != nullptr) html += bottlenecksSection(*details.corridors, environment, pipeline, areaText);
  html += stepsSection(result, areaText);
  for (const BlockReport& block : result.blocks) html += blockSection(block, result.threads);
  html += picturesSection(details);
  return html + "</main>\n</body>\n</html>\n";
}

}  // namespace footfall::detail
