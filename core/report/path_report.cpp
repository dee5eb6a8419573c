// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/path_report.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/counted_text.hpp"
#include "core/base/number_text.hpp"
#include "core/io/obj_text.hpp"
#include "core/navigation/separation_text.hpp"
#include "core/report/inspection_report.hpp"
#include "footfall/up_axis.hpp"

namespace footfall {
using namespace detail;
namespace {

/// Six digits are more than enough to read.
std::string shown(double x) {
  std::string text;
  appendNumber(text, std::fabs(x) < 1e9 ? std::round(x * 1e6) / 1e6 : x);
  return text;
}

/// Also what is less than that, which may be all that is missing.
std::string shownLength(double x) { return std::fabs(x) < 1e-6 ? formatted(x, "%.3g") : shown(x); }

std::string place(const Vec3& p, UpAxis up) {
  const Vec3 q = inFileFrame(p, up);
  return shown(q.x) + ' ' + shown(q.y) + ' ' + shown(q.z);
}

nlohmann::ordered_json pointJson(const Vec3& p, UpAxis up) {
  const Vec3 q = inFileFrame(p, up);
  return {q.x + 0.0, q.y + 0.0, q.z + 0.0};
}

std::string lackAt(const BorderLink& link, const Separation& separation) {
  return lackText(link, separation, shownLength).str();
}

std::string barrierSentence(const Separation& separation, UpAxis up) {
  constexpr std::size_t kShown = 3;
  const BorderLink& link = separation.barrier();
  std::string text = "the parts are nearest at " + place(link.from, up) + ": " + lackAt(link, separation);
  if (separation.links.size() > 1)
    text += " (the largest of " + std::to_string(separation.links.size()) + " obstacles on the way)";
  const std::vector<BorderLink>& others = separation.others;
  if (others.empty()) return text;
  text += "; " + counted(others.size(), "more way", "more ways") + ": ";
  for (std::size_t i = 0; i < std::min(kShown, others.size()); ++i) {
    if (i > 0) text += "; ";
    text += lackAt(others[i], separation) + ", at " + place(others[i].from, up);
  }
  if (others.size() > kShown) text += "; ...";
  return text;
}

nlohmann::ordered_json linkJson(const BorderLink& link, UpAxis up) {
  nlohmann::ordered_json json;
  json["kind"] = linkWord(link.kind);
  json["from"] = pointJson(link.from, up);
  json["to"] = pointJson(link.to, up);
  json["gap"] = link.gap;
  json["rise"] = link.rise;
  json["obstacle"] = link.kind == LinkKind::Obstacle ? nlohmann::ordered_json(link.obstacle) : nullptr;
  json["headroom"] = link.kind == LinkKind::LowCeiling ? nlohmann::ordered_json(link.headroom) : nullptr;
  json["excess"] = link.excess;
  json["triangles"] = link.triangles;
  return json;
}

nlohmann::ordered_json separationJson(const std::optional<Separation>& separation, UpAxis up) {
  if (!separation) return nullptr;
  nlohmann::ordered_json json;
  json["largest"] = separation->largest;
  json["links"] = nlohmann::ordered_json::array();
  for (const BorderLink& link : separation->links) json["links"].push_back(linkJson(link, up));
  json["others"] = nlohmann::ordered_json::array();
  for (const BorderLink& link : separation->others) json["others"].push_back(linkJson(link, up));
  json["height"] = separation->height;
  json["step"] = separation->step;
  json["gap"] = separation->gap;
  return json;
}

nlohmann::ordered_json placeJson(const NavigationMesh& mesh, const std::optional<SurfacePlace>& p, UpAxis up) {
  if (!p) return nullptr;
  nlohmann::ordered_json json;
  json["position"] = pointJson(p->position, up);
  json["distance"] = p->distance;
  json["layer"] = mesh.layers.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(mesh.layers[p->triangle]);
  return json;
}

}  // namespace

std::string formatFailure(const PathResult& path, UpAxis up) {
  const std::string text = describeFailure(path);
  return path.separation ? text + "; " + barrierSentence(*path.separation, up) : text;
}

std::string detail::formatSeparation(const Environment& environment, const PathResult& path) {
  const UpAxis up = environment.up;
  std::string text = describeFailure(path) + '\n';
  if (!path.separation) return text;
  const Separation& separation = *path.separation;
  const auto line = [&](const BorderLink& link) {
    std::string all = "at " + place(link.from, up) + ": " + lackAt(link, separation);
    if (!link.triangles.empty()) all += "; " + triangleList(environment, link.triangles);
    return all + '\n';
  };
  text += "the least that is missing, " + line(separation.barrier());
  if (separation.links.size() > 1) {
    text += "on the same way, over parts between:\n";
    for (std::size_t i = 0; i < separation.links.size(); ++i)
      if (i != separation.largest) text += "  " + line(separation.links[i]);
  }
  if (!separation.others.empty()) text += counted(separation.others.size(), "more way", "more ways") + ":\n";
  for (const BorderLink& link : separation.others) text += "  " + line(link);
  return text;
}

std::string formatPath(const PathResult& path, UpAxis up) {
  std::string text;
  if (path.start)
    text += (path.status == PathStatus::StartNotWalkable ? "nearest  " : "start    ") +
            place(path.start->position, up) + '\n';
  if (path.end && path.hasPath())
    text += (path.reached() ? "end      " : "fails at ") + place(path.end->position, up) + '\n';
  if (path.hasPath()) {
    text += "length   " + shown(path.length) + " (" + shown(path.planLength) + " in the plan), " +
            counted(path.bends.size(), "bend", "bends") + '\n';
    if (!path.layers.empty()) {
      text += "layers   ";
      for (std::size_t i = 0; i < path.layers.size(); ++i)
        text += (i == 0 ? "" : " > ") + std::to_string(path.layers[i]);
      text += ", " + counted(path.connections, "connection", "connections") + '\n';
    }
    if (!path.steps.empty()) {
      text += "steps    " + std::to_string(path.steps.size()) + "; all in all " + shown(path.climb) + " up and " +
              shown(path.descent) + " down\n";
    }
    if (!path.gaps.empty()) text += "gaps     " + std::to_string(path.gaps.size()) + '\n';
    if (!path.drops.empty())
      text += "drops    " + std::to_string(path.drops.size()) + ", one way down; the deepest " +
              shown(path.deepestDrop) + '\n';
    text += "slope    " + shown(path.maxSlopeDegrees) + " degrees at most; climbs or falls at " +
            shown(path.maxInclineDegrees) + " degrees at most\n";
  }
  return text;
}

std::string formatPathJson(const NavigationMesh& mesh, const PathResult& path) {
  const UpAxis up = mesh.frame.up;
  nlohmann::ordered_json json;
  json["status"] = statusWord(path.status);
  json["message"] = formatFailure(path, up);
  json["from"] = pointJson(path.from, up);
  json["to"] = pointJson(path.to, up);
  json["start"] = placeJson(mesh, path.start, up);
  json["end"] = path.status == PathStatus::StartNotWalkable ? nullptr : placeJson(mesh, path.end, up);
  json["length"] = path.length;
  json["plan_length"] = path.planLength;
  if (!path.drops.empty()) json["least_plan_length"] = path.leastPlanLength;
  json["steps"] = path.steps.size();
  json["gaps"] = path.gaps.size();
  json["drops"] = path.drops.size();
  json["deepest_drop"] = path.drops.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(path.deepestDrop);
  json["leads_back"] = path.leadsBack;
  json["climb"] = path.climb;
  json["descent"] = path.descent;
  json["layers"] = path.layers;
  json["connections"] = path.connections;
  json["max_slope_degrees"] = path.maxSlopeDegrees;
  json["max_incline_degrees"] = path.maxInclineDegrees;
  json["bends"] = nlohmann::ordered_json::array();
  for (const std::size_t i : path.bends) json["bends"].push_back(pointJson(path.points[i], up));
  json["points"] = nlohmann::ordered_json::array();
  for (const Vec3& p : path.points) json["points"].push_back(pointJson(p, up));
  json["separation"] = separationJson(path.separation, up);
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

std::string detail::formatPathObj(const SourceFrame& frame, const ExportHeader& header, const PathResult& path) {
  std::string text;
  appendHeader(text, "Shortest path", frame, header,
               counted(path.points.size(), "point", "points") + ", length " + shown(path.length) + ", in the plan " +
                   shown(path.planLength));
  for (const Vec3& p : path.points) appendVertex(text, p, frame.up);
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
