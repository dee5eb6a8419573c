// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/number_text.hpp"
#include "footfall/body_path.hpp"
#include "footfall/report.hpp"
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

std::string shownAt(const Vec3& p, UpAxis up) {
  const Vec3 q = inFileFrame(p, up);
  return shown(q.x) + ' ' + shown(q.y) + ' ' + shown(q.z);
}

std::string shownPassage(const Passage& passage, UpAxis up) {
  return shown(passage.width) + " wide at " + shownAt(passage.place, up) + ", from " + shownAt(passage.left, up) +
         " to " + shownAt(passage.right, up);
}

nlohmann::ordered_json pointJson(const Vec3& p, UpAxis up) {
  const Vec3 q = inFileFrame(p, up);
  return {q.x + 0.0, q.y + 0.0, q.z + 0.0};
}

nlohmann::ordered_json passageJson(const std::optional<Passage>& passage, UpAxis up) {
  if (!passage) return nullptr;
  nlohmann::ordered_json json;
  json["place"] = pointJson(passage->place, up);
  json["left"] = pointJson(passage->left, up);
  json["right"] = pointJson(passage->right, up);
  json["width"] = passage->width;
  return json;
}

}  // namespace

std::string_view statusWord(const BodyPath& path) {
  switch (path.status) {
    case BodyPathStatus::Found:
      return "found";
    case BodyPathStatus::NoPath:
      return statusWord(path.path.status);
    case BodyPathStatus::StartTooNear:
      return "start_too_near";
    case BodyPathStatus::TargetTooNear:
      return "target_too_near";
    case BodyPathStatus::TooNarrow:
      return "too_narrow";
  }
  return {};
}

std::string formatFailure(const BodyPath& path, UpAxis up) {
  const auto tooNear = [&](const char* what, double distance) {
    return std::string(what) + " is " + shown(distance) + " away from the border, " + shown(path.lacking) +
           " less than the radius; " +
           (path.admissible ? "a place that is far enough is " + shownAt(*path.admissible, up)
                            : std::string("no place of its part is far enough"));
  };
  switch (path.status) {
    case BodyPathStatus::Found:
      return {};
    case BodyPathStatus::NoPath:
      if (!path.path.drops.empty()) return "only drops lead to the target, and an agent with a radius takes none";
      return formatFailure(path.path, up);
    case BodyPathStatus::StartTooNear:
      return tooNear("the start", path.startDistance);
    case BodyPathStatus::TargetTooNear:
      return tooNear("the target", path.targetDistance);
    case BodyPathStatus::TooNarrow:
      if (!path.narrowest) return "no passage leads from the start to the target";
      return "every way is too narrow; the widest one has a passage " + shownPassage(*path.narrowest, up) + ": " +
             shown(path.lacking) + " less than the agent needs";
  }
  return {};
}

std::string formatPath(const BodyPath& path, UpAxis up) {
  std::string text = formatPath(path.path, up);
  if (path.reached() && path.narrowest) text += "narrow   " + shownPassage(*path.narrowest, up) + '\n';
  return text;
}

std::string formatPathJson(const NavigationMesh& mesh, const BodyPath& path) {
  const UpAxis up = mesh.frame.up;
  auto json = nlohmann::ordered_json::parse(formatPathJson(mesh, path.path));
  json["status"] = statusWord(path);
  json["message"] = formatFailure(path, up);
  json["start_distance"] = path.startDistance;
  json["target_distance"] = path.targetDistance;
  json["admissible"] = path.admissible ? pointJson(*path.admissible, up) : nlohmann::ordered_json(nullptr);
  json["narrowest"] = passageJson(path.narrowest, up);
  json["lacking"] = path.lacking;
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace footfall
