// Floor plans of a result, to scale, for people who read plans.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/poll.hpp"
#include "core/io/output_files.hpp"
#include "core/report/plan_sheet.hpp"
#include "footfall/environment.hpp"
#include "footfall/navigation_mesh.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/text.hpp"

namespace footfall::detail {

enum class PlanPages {
  Layers,  ///< one for each layer
  /// One for each storey: levels at least an agent's height apart, from those with the largest area on. What lies
  /// between two belongs to the lower one.
  Storeys
};
enum class PlanColours { Colour, BlackAndWhite };
enum class Paper { A4, A3, A2, A1, A0 };

struct PlanOptions {
  PlanPages pages = PlanPages::Layers;
  PlanColours colours = PlanColours::Colour;
  /// 100 for 1:100; empty: the largest of the usual ones that fits. At least 1.
  std::optional<double> scale;
  /// Empty: A4, or A3 where A4 would be smaller than 1:100; with a scale the smallest that holds it.
  std::optional<Paper> paper;
  /// SVG and PDF: bottlenecks narrower than this are drawn as dimension lines, in the environment's units; empty: none.
  std::optional<double> narrowerThan;
  std::optional<double> widerThan;    ///< and wider than this; empty: 0.1 m
  bool hasCorridors = false;          ///< SVG and PDF: the corridor map is drawn
  std::optional<std::uint32_t> part;  ///< WKT and GeoJSON: this connected part alone, from 0
  std::string coordinateSystem = {};  ///< GeoJSON: "EPSG:25832"; empty: none is named
};

/// "A4" to "A0", in either case; empty for anything else.
std::optional<Paper> paperFrom(std::string_view name);
inline constexpr const char* kPaperNames = "A4|A3|A2|A1|A0";

/// A sheet for each layer or storey of `mesh`, all in the same place of the plan: walkable area, obstacle edges,
/// steps with an arrow up each flight, gaps, drops (ticks point down), where pages are connected, areas of the
/// connected parts, and what of `environment` stands within the agent's height, cut about half of it above each floor.
/// Around it a title, the agent, a scale bar and the file's axes. X of the environment points right and Y up. There is
/// no date: the same input gives the same sheets.
///
/// Throws InputError when there is nothing to draw or a scale does not fit the paper, and what `poll` throws.
std::vector<Sheet> drawFloorPlan(const Environment& environment, const Pipeline& pipeline, const NavigationMesh& mesh,
                                 const PlanOptions& options = {}, Poll poll = {});

/// The file formats of plans.
enum class PlanFormat { Svg, Pdf, Wkt, GeoJson };
/// Chooses by the ending of a name, in either case. Throws InputError for one that is no plan.
PlanFormat planFormatOf(const std::string& path);

/// The phrases about what a plan in SVG or PDF keeps of a result and loses; for polygons see format_table.hpp.
Pattern planKeeps(PlanFormat format);
Pattern planLoses(PlanFormat format);

/// Makes the files of a plan, by the ending of `path`: one PDF with all pages, an SVG file for each ("plan-0.svg", or
/// "plan.svg" where there is a single one), well-known text for each layer in the same way and "plan-links.wkt"
/// (core/io/formats/wkt_export.hpp), or one GeoJSON file (geojson_export.hpp). Throws as drawFloorPlan() does.
std::vector<OutputFile> makePlanFiles(const Environment& environment, const Pipeline& pipeline,
                                      const NavigationMesh& mesh, const std::string& path,
                                      const PlanOptions& options = {}, Poll poll = {});

}  // namespace footfall::detail
