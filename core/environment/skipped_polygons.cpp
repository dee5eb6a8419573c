// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environment/skipped_polygons.hpp"

#include <algorithm>
#include <utility>

#include "core/base/number_text.hpp"
#include "footfall/up_axis.hpp"

namespace footfall::detail {

SkippedPolygon skippedPolygon(std::span<const std::uint32_t> corners, const std::vector<Vec3>& vertices) {
  SkippedPolygon polygon;
  polygon.reason = corners.size() < 3 ? SkipReason::TooFewCorners : SkipReason::RepeatedCorners;
  polygon.cornerCount = corners.size();
  std::vector<std::uint32_t> distinct;
  for (const std::uint32_t corner : corners) {
    if (std::ranges::find(distinct, corner) != distinct.end()) continue;
    distinct.push_back(corner);
    polygon.corners.push_back(vertices[corner]);
  }
  return polygon;
}

void addSkipped(SkippedElements& skipped, SkippedPolygon polygon) {
  ++skipped.polygons;
  if (skipped.listed.size() < SkippedElements::kMostListed) skipped.listed.push_back(std::move(polygon));
}

void appendSkippedPolygons(SkippedElements& skipped, const SkippedElements& later, std::uint64_t linesBefore) {
  skipped.polygons += later.polygons;
  for (const SkippedPolygon& polygon : later.listed) {
    if (skipped.listed.size() == SkippedElements::kMostListed) return;
    skipped.listed.push_back(polygon);
    skipped.listed.back().line += linesBefore;
  }
}

Text skippedSource(const SkippedPolygon& polygon) {
  if (polygon.line > 0) return Text(FOOTFALL_TEXT("line %1"), polygon.line);
  if (polygon.mesh.empty()) return Text(FOOTFALL_TEXT("face %1"), polygon.face);
  return Text(FOOTFALL_TEXT("face %1 of mesh '%2'"), polygon.face, polygon.mesh);
}

Text skippedReason(const SkippedPolygon& polygon) {
  switch (polygon.reason) {
    case SkipReason::TooFewCorners:
      if (polygon.cornerCount == 0) return FOOTFALL_TEXT("has no corners; a polygon needs three");
      if (polygon.cornerCount == 1) return FOOTFALL_TEXT("has one corner; a polygon needs three");
      return FOOTFALL_TEXT("has two corners; a polygon needs three");
    case SkipReason::RepeatedCorners:
      if (polygon.corners.size() == 1)
        return Text(FOOTFALL_TEXT("all of its %1 corners are one vertex; a polygon needs three"), polygon.cornerCount);
      return Text(FOOTFALL_TEXT("its %1 corners are only two different vertices; a polygon needs three"),
                  polygon.cornerCount);
    case SkipReason::FreeForm:
      return FOOTFALL_TEXT("a curved surface, which is not read; export it as polygons");
  }
  return {};
}

std::string formatSkipped(const SkippedElements& skipped, UpAxis up, std::size_t most) {
  std::string text;
  const std::size_t shown = std::min(most, skipped.listed.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const SkippedPolygon& polygon = skipped.listed[i];
    text += "  " + skippedSource(polygon).str() + ": " + skippedReason(polygon).str();
    if (!polygon.corners.empty()) {
      const Vec3 p = inFileFrame(polygon.corners.front(), up);
      text += "; at";
      for (const double x : {p.x, p.y, p.z}) {
        text += ' ';
        appendNumber(text, x);
      }
    }
    text += '\n';
  }
  if (skipped.polygons > shown) text += "  and " + std::to_string(skipped.polygons - shown) + " more\n";
  return text;
}

}  // namespace footfall::detail
