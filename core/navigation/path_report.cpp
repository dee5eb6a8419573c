// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/navigation/path_report.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/counted_text.hpp"
#include "core/environment/number_text.hpp"
#include "core/environment/obj_text.hpp"
#include "core/environment/up_axis.hpp"

namespace footfall {
namespace {

/// Six digits are more than enough to read.
std::string shown(double x) {
  std::string text;
  appendNumber(text, std::fabs(x) < 1e9 ? std::round(x * 1e6) / 1e6 : x);
  return text;
}

std::string place(const SurfacePlace& p, UpAxis up) {
  const Vec3 q = inFileFrame(p.position, up);
  return shown(q.x) + ' ' + shown(q.y) + ' ' + shown(q.z);
}

nlohmann::ordered_json pointJson(const Vec3& p, UpAxis up) {
  const Vec3 q = inFileFrame(p, up);
  return {q.x + 0.0, q.y + 0.0, q.z + 0.0};
}

nlohmann::ordered_json placeJson(const NavigationMesh& mesh, const std::optional<SurfacePlace>& p, UpAxis up) {
  if (!p) return nullptr;
  nlohmann::ordered_json json;
  json["position"] = pointJson(p->position, up);
  json["distance"] = p->distance;
  json["layer"] = mesh.layers.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(mesh.layers[p->triangle]);
  return json;
}

const char* statusName(PathStatus status) {
  switch (status) {
    case PathStatus::Found:
      return "found";
    case PathStatus::StartNotWalkable:
      return "start_not_walkable";
    case PathStatus::TargetNotWalkable:
      return "target_not_walkable";
    case PathStatus::NotConnected:
      return "not_connected";
    case PathStatus::NothingWalkable:
      break;
  }
  return "nothing_walkable";
}

}  // namespace

std::string formatPlace(const Vec3& p, UpAxis up) {
  const Vec3 q = inFileFrame(p, up);
  std::string text;
  appendNumber(text, q.x);
  text += ' ';
  appendNumber(text, q.y);
  text += ' ';
  appendNumber(text, q.z);
  return text;
}

std::string formatPath(const Environment& environment, const PathResult& path) {
  std::string text;
  if (path.start)
    text += (path.status == PathStatus::StartNotWalkable ? "nearest  " : "start    ") +
            place(*path.start, environment.up) + '\n';
  if (path.end && path.hasPath())
    text += (path.reached() ? "end      " : "fails at ") + place(*path.end, environment.up) + '\n';
  if (path.hasPath()) {
    text += "length   " + shown(path.length) + " (" + shown(path.planLength) + " in the plan), " +
            counted(path.bends.size(), "bend", "bends") + '\n';
    if (!path.layers.empty()) {
      text += "layers   ";
      for (std::size_t i = 0; i < path.layers.size(); ++i)
        text += (i == 0 ? "" : " > ") + std::to_string(path.layers[i]);
      text += ", " + counted(path.connections, "connection", "connections") + '\n';
    }
    text += "slope    " + shown(path.maxSlopeDegrees) + " degrees at most; climbs or falls at " +
            shown(path.maxInclineDegrees) + " degrees at most\n";
  }
  return text;
}

std::string formatPathJson(const NavigationMesh& mesh, const Environment& environment, const PathResult& path) {
  const UpAxis up = environment.up;
  nlohmann::ordered_json json;
  json["status"] = statusName(path.status);
  json["message"] = describeFailure(path);
  json["from"] = pointJson(path.from, up);
  json["to"] = pointJson(path.to, up);
  json["start"] = placeJson(mesh, path.start, up);
  json["end"] = path.status == PathStatus::StartNotWalkable ? nullptr : placeJson(mesh, path.end, up);
  json["length"] = path.length;
  json["plan_length"] = path.planLength;
  json["layers"] = path.layers;
  json["connections"] = path.connections;
  json["max_slope_degrees"] = path.maxSlopeDegrees;
  json["max_incline_degrees"] = path.maxInclineDegrees;
  json["bends"] = nlohmann::ordered_json::array();
  for (const std::size_t i : path.bends) json["bends"].push_back(pointJson(path.points[i], up));
  json["points"] = nlohmann::ordered_json::array();
  for (const Vec3& p : path.points) json["points"].push_back(pointJson(p, up));
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

std::string formatPathObj(const Environment& environment, const ExportHeader& header, const PathResult& path) {
  std::string text;
  appendHeader(text, "Shortest path", environment, header,
               counted(path.points.size(), "point", "points") + ", length " + shown(path.length) + ", in the plan " +
                   shown(path.planLength));
  for (const Vec3& p : path.points) appendVertex(text, p, environment.up);
  text += "g path\n";
  if (path.points.size() > 1) {
    text += 'l';
    for (std::size_t i = 1; i <= path.points.size(); ++i) {
      text += ' ';
      appendNumber(text, i);
    }
    text += '\n';
  } else if (!path.points.empty()) {
    text += "p 1\n";
  }
  return text;
}

}  // namespace footfall
