// Writing the walkable area as well-known text (OGC Simple Features), which JuPedSim and others read.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/io/formats/plan_polygons.hpp"
#include "core/io/output_files.hpp"

namespace footfall::detail {

// All coordinates are metres in the plan (X, Y of a Z-up frame) times ExportOptions::scale. Metres are the
// environment's units times its metresPerUnit. Numbers are the shortest that read back equal; outer rings are
// counter-clockwise. Each text ends with a line break, and the same mesh gives the same bytes.

/// The polygons of a layer, or of all layers: POLYGON where there is one, POLYGON EMPTY where there is none, else a
/// GEOMETRYCOLLECTION of them. MULTIPOLYGON is not used, because it forbids the borders that neighbouring parts share.
/// ExportOptions::part (from 0) limits it to the polygons of that connected part.
std::string formatLayerWkt(const NavigationMesh& mesh, const PlanPolygons& polygons, std::optional<std::uint32_t> layer,
                           const ExportOptions& options = {}, Poll poll = {});

/// A GEOMETRYCOLLECTION of five MULTILINESTRINGs, EMPTY where there are no lines: the edges where layers meet; the
/// edges of steps, gaps and drops; and the edges inside polygons that agents cannot cross.
std::string formatLinksWkt(const NavigationMesh& mesh, const PlanPolygons& polygons, const ExportOptions& options = {},
                           Poll poll = {});

/// Makes `path` for a single layer or without layers, else "level-0.wkt" and so on beside it, and "level-links.wkt".
/// Throws what checkPolygonOptions() and `poll` throw.
std::vector<OutputFile> makeWktFiles(const NavigationMesh& mesh, const std::string& path,
                                     const ExportOptions& options = {}, Poll poll = {});

}  // namespace footfall::detail
