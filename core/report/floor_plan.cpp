// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/floor_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>

#include "core/base/counted_text.hpp"
#include "core/io/formats/save.hpp"
#include "core/mesh/storey_names.hpp"
#include "core/navigation/bottleneck_list.hpp"
#include "core/navigation/corridor_graph.hpp"
#include "core/report/plan_drawing.hpp"
#include "footfall/errors.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "footfall/path.hpp"
#include "footfall/report.hpp"
#include "footfall/up_axis.hpp"

namespace footfall::detail {
namespace {

// The distance round the walkable area within which walls are drawn, and the longest tread of a flight; in metres,
// whatever the agent.
constexpr double kWallMargin = 0.5, kLongestTread = 1.2;
// Shares of the agent's height.
constexpr double kCutHeight = 0.55, kLevelTolerance = 0.25;

// Millimetres.
constexpr double kTitleLetters = 4.2, kLetters = 2.6, kSmallLetters = 2.1, kLongestBar = 60;
constexpr SheetStroke kFrameLine{{0, 0, 0}, 0.25};

double largestRadius(const Pipeline& pipeline) {
  double radius = 0;
  for (const PipelineStep& step : pipeline.steps)
    if (step.enabled && step.filter->type == FilterType::Radius) radius = std::max(radius, step.values[0]);
  return radius;
}

PlanWindow boxOf(const NavigationMesh& mesh, double margin) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  PlanWindow box{{kFar, kFar}, {-kFar, -kFar}};
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) {
      const Vec3& p = mesh.vertices[v];
      box.lower = {std::min(box.lower[0], p.x - margin), std::min(box.lower[1], p.y - margin)};
      box.upper = {std::max(box.upper[0], p.x + margin), std::max(box.upper[1], p.y + margin)};
    }
  }
  return box;
}

std::string metresText(double metres, const char* format = "%.2f") {
  std::string text = formatted(metres, format);
  if (text.find('.') != std::string::npos) {
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
  }
  return text + " m";
}

std::string inCapitals(std::string name) {
  if (!name.empty()) name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

std::string agentInMetres(const AgentNumbers& agent, double metres) {
  std::string text = "slope " + (agent.maxSlope ? number(*agent.maxSlope) + " degrees" : std::string("any"));
  text += ", height " + (agent.height ? number(*agent.height * metres) + " m" : std::string("any"));
  for (const auto& [name, value] : {std::pair{"step", agent.step}, {"gap", agent.gap}, {"radius", agent.radius}})
    if (value > 0) text += std::string(", ") + name + ' ' + number(value * metres) + " m";
  return text;
}

/// The lines around a drawing: a frame, and below it title, legend, scale bar and axes.
class TitleBlock {
 public:
  TitleBlock(const PlanLayout& layout, const PlanStyle& style, Sheet& sheet)
      : layout_(layout),
        style_(style),
        sheet_(sheet),
        left_(layout.window.lower.x),
        right_(layout.window.upper.x),
        bottom_(layout.window.lower.y - kHeight) {}

  void draw(const std::vector<std::string>& lines, const PlanContents& contents, double metresPerUnit, UpAxis up) {
    rectangle({left_, bottom_}, {right_, layout_.window.upper.y}, {}, kFrameLine);
    line({left_, layout_.window.lower.y}, {right_, layout_.window.lower.y}, kFrameLine);
    double y = layout_.window.lower.y - 1.5 * kTitleLetters;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      write({left_ + kInside, y}, lines[i], i == 0 ? kTitleLetters : kLetters, SheetAnchor::Left, i == 0);
      y -= 1.6 * kLetters;
    }
    drawLegend(contents);
    drawScaleBar(metresPerUnit);
    drawAxes(up);
  }

 private:
  static constexpr double kHeight = 30, kInside = 3;

  void rectangle(SheetPoint lower, SheetPoint upper, std::optional<Rgb> fill, std::optional<SheetStroke> stroke) {
    sheet_.frame.emplace_back(
        SheetPath{{{lower, {upper.x, lower.y}, upper, {lower.x, upper.y}}}, true, fill, std::move(stroke)});
  }
  void line(SheetPoint a, SheetPoint b, const SheetStroke& stroke) {
    sheet_.frame.emplace_back(SheetPath{{{a, b}}, false, {}, stroke});
  }
  void write(SheetPoint at, const std::string& text, double size, SheetAnchor anchor = SheetAnchor::Left,
             bool isBold = false) {
    sheet_.frame.emplace_back(SheetText{at, text, size, anchor, {0, 0, 0}, isBold, false});
  }

  void drawLegend(const PlanContents& contents) {
    double x = left_ + kInside;
    const double y = bottom_ + 3, middle = y + kSmallLetters / 3;
    constexpr double kSample = 6;
    const auto entry = [&](bool isThere, const std::string& name, double room, const auto& sample) {
      if (!isThere) return;
      sample();
      write({x + kSample + 1.2, y}, name, kSmallLetters);
      x += kSample + room;
    };
    const auto box = [&](const Rgb& fill, const Rgb& border) {
      return [&, fill, border] {
        rectangle({x, middle - 1.3}, {x + kSample, middle + 1.3}, fill, SheetStroke{border, 0.15});
      };
    };
    const auto stroke = [&](SheetStroke sample) {
      return [&, sample] { line({x, middle}, {x + kSample, middle}, sample); };
    };
    entry(true, "walkable", 14, box(style_.walkable, style_.border));
    entry(contents.walls, "walls, cut", 15, box(style_.wall, style_.wallLine));
    entry(contents.doors, "door", 9, [&] {
      addDoor(sheet_.frame,
              {SheetPoint{x, middle - 1}, {x + kSample, middle - 1}, {x + kSample, middle + 1}, {x, middle + 1}},
              style_.door);
    });
    entry(contents.obstacleEdges, "thin wall", 14, stroke({style_.obstacleEdge, 0.5}));
    entry(contents.steps, "step; arrow: up", 21, [&] {
      line({x, middle - 1.3}, {x, middle + 1.3}, {style_.step, 0.13});
      line({x + 2, middle - 1.3}, {x + 2, middle + 1.3}, {style_.step, 0.13});
      addArrow(sheet_.frame, {{x - 0.5, middle}, {x + kSample - 0.5, middle}}, 1.6, {style_.step, 0.13});
    });
    entry(contents.gaps, "gap", 8, box(style_.gap, style_.gap));
    entry(contents.drops, "drop", 9, [&] {
      line({x, middle + 0.5}, {x + kSample, middle + 0.5}, {style_.drop, 0.25});
      for (const double tick : {1.0, 3.0, 5.0})
        line({x + tick, middle + 0.5}, {x + tick, middle - 0.5}, {style_.drop, 0.25});
    });
    entry(contents.passages, "to another page", 22, stroke({style_.passage, 0.25, {1.8, 0.9}}));
    entry(contents.corridors, "middle of passages", 24, stroke({style_.corridor, 0.13}));
    entry(contents.bottlenecks, "narrow passage", 19, [&] {
      addDimension(sheet_.frame, {x + 0.5, middle}, {x + kSample - 0.5, middle}, style_.bottleneck);
    });
  }

  void drawScaleBar(double metresPerUnit) {
    const double metre = layout_.unit / metresPerUnit;
    double bar = std::pow(10, std::floor(std::log10(kLongestBar / metre)));
    for (const double times : {5.0, 2.0})
      if (bar * times * metre <= kLongestBar) {
        bar *= times;
        break;
      }
    constexpr int kParts = 4;
    const double x0 = right_ - 22 - kLongestBar, y = bottom_ + 14, width = bar * metre;
    for (int i = 0; i < kParts; ++i)
      rectangle({x0 + i * width / kParts, y}, {x0 + (i + 1) * width / kParts, y + 1.4},
                i % 2 == 0 ? Rgb{0, 0, 0} : Rgb{255, 255, 255}, SheetStroke{{0, 0, 0}, 0.15});
    write({x0, y + 2.4}, "0", kSmallLetters, SheetAnchor::Middle);
    write({x0 + width / 2, y + 2.4}, metresText(bar / 2, "%.3f"), kSmallLetters, SheetAnchor::Middle);
    write({x0 + width, y + 2.4}, metresText(bar, "%.3f"), kSmallLetters, SheetAnchor::Middle);
    write({x0, y + 7}, scaleText(layout_.scale), kTitleLetters, SheetAnchor::Left, true);
  }

  void drawAxes(UpAxis up) {
    const SheetPoint origin{right_ - 15, bottom_ + 11};
    const SheetStroke stroke{{0, 0, 0}, 0.2};
    const auto axes = fileAxes(up);
    const auto name = [&axes](int k) { return std::string(axes[k].sign < 0 ? "-" : "") + "xyz"[axes[k].axis]; };
    addArrow(sheet_.frame, {origin, {origin.x + 8, origin.y}}, 1.8, stroke);
    addArrow(sheet_.frame, {origin, {origin.x, origin.y + 8}}, 1.8, stroke);
    write({origin.x + 8.8, origin.y - 0.7}, name(0), kSmallLetters);
    write({origin.x, origin.y + 9}, name(1), kSmallLetters, SheetAnchor::Middle);
  }

  const PlanLayout& layout_;
  const PlanStyle& style_;
  Sheet& sheet_;
  double left_, right_, bottom_;
};

std::optional<PlanCorridors> corridorsOf(const NavigationMesh& mesh, const PlanOptions& options, double metresPerUnit,
                                         Poll poll) {
  if (!options.narrowerThan && !options.hasCorridors) return std::nullopt;
  PlanCorridors corridors{makePolledCorridorMap(mesh, false, poll), options.hasCorridors, {}};
  if (options.narrowerThan) {
    BottleneckRule rule = usualBottlenecks(metresPerUnit);
    rule.widerThan = options.widerThan.value_or(rule.widerThan);
    rule.narrowerThan = *options.narrowerThan;
    corridors.narrow = listBottlenecks(corridors.map, rule).listed;
  }
  return corridors;
}

/// "heights 0 m to 3.2 m, walkable 412 m²"
std::string figuresOf(const NavigationMesh& mesh, const PlanPage& page, double area, double metresPerUnit) {
  double lower = std::numeric_limits<double>::infinity(), upper = -lower;
  for (const std::uint32_t t : page.triangles) {
    const Triangle& corners = mesh.triangles[t];
    for (const std::uint32_t v : corners) {
      lower = std::min(lower, mesh.vertices[v].z);
      upper = std::max(upper, mesh.vertices[v].z);
    }
  }
  const std::string from = metresText(lower * metresPerUnit), to = metresText(upper * metresPerUnit);
  return (from == to ? "height " + from : "heights " + from + " to " + to) + "; walkable " +
         areaText(area * metresPerUnit * metresPerUnit);
}

}  // namespace

std::vector<Sheet> drawFloorPlan(const Environment& environment, const Pipeline& pipeline, const NavigationMesh& mesh,
                                 const PlanOptions& options, Poll poll) {
  if (mesh.triangles.empty())
    throw InputError(FOOTFALL_TEXT(
        "nothing is walkable, so there is no plan; change the filters, or look up the reason for a place with Why"));
  const double metres = environment.metresPerUnit;
  const double height = agentHeight(pipeline, metres), step = agentStep(pipeline);
  const double margin = kWallMargin / metres + largestRadius(pipeline);
  const std::vector<PlanPage> pages = makePlanPages(mesh, options.pages, height, step, poll);
  const PlanLayout layout = layOutPlan(boxOf(mesh, margin), metres, options);
  const PlanStyle style = planStyle(options.colours);
  const NumberedParts parts = numberParts(mesh, poll);
  const std::vector<PlanFlight> flights = findFlights(mesh, kLongestTread / metres, poll);
  const std::vector<PlanDoor> doors = findDoors(environment, poll);
  const std::optional<PlanCorridors> corridors = corridorsOf(mesh, options, metres, poll);
  poll();
  const PlanSubject subject{environment,
                            mesh,
                            parts,
                            flights,
                            pages,
                            doors,
                            corridors ? &*corridors : nullptr,
                            {kCutHeight * height, kLevelTolerance * height, margin}};
  const std::string name = environment.source.empty()
                               ? std::string("Floor plan")
                               : std::filesystem::path(environment.frame().source).filename().string();
  std::vector<Sheet> sheets;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    Sheet sheet;
    sheet.width = layout.width;
    sheet.height = layout.height;
    sheet.window = layout.window;
    const std::string storeys = storeysOf(mesh, pages[i].triangles);
    const std::string page = inCapitals(pages[i].name) + (storeys.empty() ? "" : ", " + storeys);
    sheet.title = name + ": " + page;
    const PlanContents contents = drawPlanPage(subject, i, layout, style, sheet.drawing, poll);
    std::string count =
        pages.size() == 1 ? std::string() : " (" + std::to_string(i + 1) + " of " + std::to_string(pages.size()) + ")";
    TitleBlock(layout, style, sheet)
        .draw({name, page + count + "; " + figuresOf(mesh, pages[i], contents.area, metres),
               "For an agent: " + agentInMetres(agentNumbers(pipeline), metres)},
              contents, metres, environment.up);
    sheets.push_back(std::move(sheet));
  }
  return sheets;
}

PlanFormat planFormatOf(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (ending == ".svg") return PlanFormat::Svg;
  if (ending == ".pdf") return PlanFormat::Pdf;
  if (ending == ".wkt") return PlanFormat::Wkt;
  if (ending == ".geojson") return PlanFormat::GeoJson;
  throw InputError(
      FOOTFALL_TEXT("%1: not the name of a floor plan; give one that ends in .svg, .pdf, .wkt or .geojson"), path);
}

Pattern planKeeps(PlanFormat format) {
  return format == PlanFormat::Pdf
             ? FOOTFALL_TEXT(
                   "a drawing to scale, all pages in one file: walkable area, walls, steps, drops, doors, areas")
             : FOOTFALL_TEXT(
                   "a drawing to scale, a file for each page: walkable area, walls, steps, drops, doors, areas");
}

Pattern planLoses(PlanFormat format) {
  return format == PlanFormat::Pdf ? FOOTFALL_TEXT("data for other programs; letters beyond Western Europe's")
                                   : FOOTFALL_TEXT("data for other programs: heights, connectivity");
}

std::vector<OutputFile> makePlanFiles(const Environment& environment, const Pipeline& pipeline,
                                      const NavigationMesh& mesh, const std::string& path, const PlanOptions& options,
                                      Poll poll) {
  const PlanFormat format = planFormatOf(path);
  if (format == PlanFormat::Wkt || format == PlanFormat::GeoJson) {
    ExportOptions polygons;
    polygons.part = options.part;
    polygons.coordinateSystem = options.coordinateSystem;
    return formatExport(exportFormatOf(path), path, mesh, {}, polygons, {}, poll).files;
  }
  const std::vector<Sheet> sheets = drawFloorPlan(environment, pipeline, mesh, options, poll);
  if (format == PlanFormat::Pdf) return {{path, formatSheetsPdf(sheets)}};
  if (sheets.size() == 1) return {{path, formatSheetSvg(sheets.front())}};
  std::vector<OutputFile> files;
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    poll();
    files.push_back({besideName(path, std::to_string(i)), formatSheetSvg(sheets[i])});
  }
  return files;
}

}  // namespace footfall::detail
