// Writing the walkable area as GeoJSON.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/io/formats/plan_polygons.hpp"

namespace footfall::detail {

/// Throws InputError for a name that is not "EPSG:" and a number.
void checkCoordinateSystem(const std::string& name);

/// Writes one FeatureCollection (RFC 7946; with a coordinate system its predecessor of 2008, which has the member "crs"
/// for that). Coordinates are metres as in WKT, with heights. Polygons have the properties `kind` ("walkable"), `layer`
/// (as exports number them, from 0), `part` (connected part, from 1), `area` and `plan_area` (square metres). Lines
/// have `kind`: "connection" (where layers meet; with `part`), "step", "gap" and "drop" (the edge that an agent leaves
/// from; with `height`, `width`, `from_layer`, `to_layer`, `from_part` and `to_part`, steps and gaps in both
/// directions), "barrier" (inside a polygon, not to be crossed; with `part`). The same mesh gives the same bytes.
/// `layer` is left out without layers. Throws InputError for a name that is not "EPSG:" and a number, and what
/// checkPolygonOptions() and `poll` throw.
std::string formatGeoJson(const NavigationMesh& mesh, const ExportOptions& options = {}, Poll poll = {});

}  // namespace footfall::detail
