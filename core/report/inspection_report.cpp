// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/inspection_report.hpp"

#include <array>
#include <cctype>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/inspect/removal_text.hpp"
#include "footfall/filter.hpp"
#include "footfall/report.hpp"
#include "footfall/up_axis.hpp"

namespace footfall {
using namespace detail;
namespace {

using Json = nlohmann::ordered_json;

std::string number(double value, int digits = 6) {
  std::array<char, 400> buffer;
  std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value + 0.0);
  return buffer.data();
}

std::string coordinates(const Vec3& place) {
  return number(place.x, 9) + ' ' + number(place.y, 9) + ' ' + number(place.z, 9);
}

const EnvironmentPart* partOf(const Environment& environment, std::uint32_t triangle) {
  return triangle < environment.partOf.size() ? &environment.parts.at(environment.partOf[triangle]) : nullptr;
}

constexpr std::string_view kTriangle = "triangle ";

/// "triangle 12 (mesh door, material wood)"
std::string triangleText(const Environment& environment, std::uint32_t triangle) {
  std::string text = std::string(kTriangle) + std::to_string(triangle);
  const EnvironmentPart* part = partOf(environment, triangle);
  if (part == nullptr || (part->mesh.empty() && part->material.empty())) return text;
  text += " (";
  if (!part->mesh.empty()) text += "mesh " + part->mesh;
  if (!part->material.empty()) text += std::string(part->mesh.empty() ? "" : ", ") + "material " + part->material;
  return text + ')';
}

/// The headline and the reason of a removal: "not walkable: too steep. It rises by ...".
std::string removalText(const Inspector& inspector, const PlaceExplanation& told) {
  const Removal* removal = removalOf(inspector.pipeline(), told);
  if (removal == nullptr) return "not walkable: the filter of this step removed it";
  const std::string unit = removal->measure == PlaceMeasure::Slope ? " degrees" : "";
  const std::optional<double> measured = measureOf(*removal, told);
  const std::string measure = measured ? textBeside(*measured, told.limit) + unit : "";
  std::string obstacle;
  if (told.obstacle) obstacle = triangleText(inspector.environment(), told.obstacle->triangle).substr(kTriangle.size());
  std::string headline = Text(removal->headline).str();
  headline.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(headline.front())));
  return headline + ". " + reasonText(*removal, measure, number(told.limit) + unit, obstacle).str();
}

struct VerdictWords {
  std::string_view word, sentence;
};

/// The words of the verdicts that no filter gives. Those of others are their filter's (Removal); where a filter removed
/// a place without describing it, the word is "removed".
VerdictWords wordsOf(PlaceVerdict verdict) {
  switch (verdict) {
    case PlaceVerdict::Walkable:
      return {"walkable", "walkable"};
    case PlaceVerdict::Vertical:
      return {"vertical", "not walkable: the triangle is a vertical wall"};
    case PlaceVerdict::FacesDown:
      return {"faces_down", "not walkable: the triangle faces down"};
    case PlaceVerdict::NeverFloor:
      return {"obstacle_only", "not walkable: the triangle counts as an obstacle only"};
    case PlaceVerdict::NoArea:
    case PlaceVerdict::TooSteep:
    case PlaceVerdict::TooLow:
    case PlaceVerdict::RegionTooSmall:
    case PlaceVerdict::Moved:
    case PlaceVerdict::Unreachable:
    case PlaceVerdict::TooNearWall:
    case PlaceVerdict::TooNearLedge:
    case PlaceVerdict::Removed:
      break;
  }
  return {"removed", {}};
}

std::string verdictText(const Inspector& inspector, const PlaceExplanation& told) {
  std::string text(wordsOf(told.verdict).sentence);
  if (text.empty()) return removalText(inspector, told);
  if (told.verdict != PlaceVerdict::Walkable) return text;
  if (told.layer) text += ", layer " + std::to_string(*told.layer);
  return text + ", component " + std::to_string(told.component + 1) + " of " +
         std::to_string(inspector.components().list.size()) + " with an area of " + number(told.componentArea);
}

}  // namespace

std::string detail::triangleList(const Environment& environment, const std::vector<std::uint32_t>& triangles) {
  std::string text;
  for (const std::uint32_t t : triangles) text += (text.empty() ? "" : ", ") + triangleText(environment, t);
  return text;
}

std::string_view verdictWord(const Pipeline& pipeline, const PlaceExplanation& explanation) {
  if (const Removal* removal = removalOf(pipeline, explanation)) return removal->word;
  return wordsOf(explanation.verdict).word;
}

std::string detail::textBeside(double value, double limit) {
  std::string text;
  for (const int digits : {6, 9, 17}) {
    text = number(value, digits);
    if (text != number(limit, digits)) break;
  }
  return text;
}

std::string formatExplanation(const Inspector& inspector, const PlaceExplanation& told) {
  const Environment& environment = inspector.environment();
  std::string text = coordinates(inFileFrame(told.place.point, environment.up)) + " on " +
                     triangleText(environment, told.place.triangle) + '\n';
  text += verdictText(inspector, told) + '\n';
  if (told.step) {
    text += "rejected by step " + std::to_string(*told.step + 1) + ": " +
            formatStep(inspector.pipeline().steps[*told.step]) + '\n';
  }
  if (told.floor)
    text += "the floor here is " + triangleText(environment, *told.floor) + ", which lies in the same plane\n";
  if (told.verdict != PlaceVerdict::NoArea) text += "slope: " + number(told.slope) + " degrees\n";
  if (told.verdict != PlaceVerdict::NoArea && told.verdict != PlaceVerdict::Vertical) {
    text += "free height: ";
    if (told.above)
      text += number(told.above->height) + ", below " + triangleText(environment, told.above->triangle) + '\n';
    else
      text += "unlimited, nothing is above\n";
  }
  if (told.wallDistance) text += "nearest wall: " + number(*told.wallDistance) + '\n';
  if (told.ledgeDistance) text += "nearest ledge: " + number(*told.ledgeDistance) + '\n';
  if (!told.walls.empty())
    text += "on an obstacle edge: " + triangleList(environment, told.walls) +
            (told.walls.size() == 1 ? " stands here\n" : " stand here\n");
  return text;
}

std::string formatExplanationJson(const Inspector& inspector, const PlaceExplanation& told) {
  const Environment& environment = inspector.environment();
  const auto orNull = [](const auto& value) { return value ? Json(*value) : Json(); };
  const Vec3 point = inFileFrame(told.place.point, environment.up);
  const EnvironmentPart* part = partOf(environment, told.place.triangle);
  const bool walkable = told.verdict == PlaceVerdict::Walkable;
  Json json;
  json["point"] = {point.x, point.y, point.z};
  json["triangle"] = told.place.triangle;
  json["mesh"] = part != nullptr ? Json(part->mesh) : Json();
  json["material"] = part != nullptr ? Json(part->material) : Json();
  json["slope"] = told.verdict == PlaceVerdict::NoArea ? Json() : Json(told.slope);
  json["headroom"] = told.above ? Json(told.above->height) : Json();
  json["above"] = told.above ? Json(told.above->triangle) : Json();
  json["walkable"] = walkable;
  json["verdict"] = verdictWord(inspector.pipeline(), told);
  json["step"] = told.step ? Json(*told.step + 1) : Json();
  json["filter"] = told.step ? Json(inspector.pipeline().steps[*told.step].filter->name) : Json();
  json["limit"] = told.step && told.limit != 0 ? Json(told.limit) : Json();
  json["obstacle"] = told.obstacle ? Json(told.obstacle->triangle) : Json();
  json["obstacle_height"] = told.obstacle ? Json(told.obstacle->height) : Json();
  json["region_area"] = told.verdict == PlaceVerdict::RegionTooSmall ? Json(told.regionArea) : Json();
  json["wall_distance"] = orNull(told.wallDistance);
  json["ledge_distance"] = orNull(told.ledgeDistance);
  json["walls"] = told.walls;
  json["floor"] = orNull(told.floor);
  json["layer"] = orNull(told.layer);
  json["component"] = walkable ? Json(told.component + 1) : Json();
  json["component_area"] = walkable ? Json(told.componentArea) : Json();
  // Names in files are bytes; what is no UTF-8 must not lose the rest.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace footfall
