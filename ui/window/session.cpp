// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/session.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "footfall/errors.hpp"
#include "footfall/filter.hpp"
#include "footfall/up_axis.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/document/agent_rules.hpp"

namespace footfall::ui {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr const char* kMark = "footfall_session";
constexpr int kVersion = 1;
constexpr Pattern kAtPlace{"%1: %2"};
constexpr std::size_t kMarkWithin = 256;  // bytes from the start of the file

Json toJson(const Vec3& v) { return {v.x, v.y, v.z}; }

Vec3 vectorFrom(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

Json toJson(const ParameterDescriptor& parameter, double value) {
  return parameter.type == ParameterType::Boolean ? Json(value != 0) : Json(value);
}

Json toJson(const PipelineStep& step) {
  const FilterDescriptor& filter = *step.filter;
  const std::size_t once = filter.parameters.size() - filter.repeats;
  Json parameters = Json::object();
  for (std::size_t i = 0; i < once; ++i)
    parameters[std::string(filter.parameters[i].name)] = toJson(filter.parameters[i], step.values[i]);
  if (filter.repeats > 0) {
    Json groups = Json::array();
    for (std::size_t i = once; i < step.values.size(); ++i) {
      if ((i - once) % filter.repeats == 0) groups.push_back(Json::array());
      groups.back().push_back(toJson(filter.parameterOf(i), step.values[i]));
    }
    parameters[std::string(filter.groups)] = std::move(groups);
  }
  return {{"filter", filter.name}, {"enabled", step.enabled}, {"parameters", parameters}};
}

double valueFrom(const FilterDescriptor& filter, const ParameterDescriptor& parameter, const Json& json) {
  const double value = json.is_boolean() ? (json.get<bool>() ? 1 : 0) : json.get<double>();
  const Text wrong = checkValue(parameter, value);
  if (!wrong.empty()) throw InputError(kAtPlace, filter.name, wrong);
  return value;
}

PipelineStep stepFrom(const Json& json) {
  const auto name = json.at("filter").get<std::string>();
  const FilterDescriptor* filter = findFilter(name);
  if (!filter) throw InputError(FOOTFALL_TEXT("unknown filter '%1'; see 'footfall filters'"), name);
  PipelineStep step = defaultStep(*filter, 1);
  step.enabled = json.value("enabled", true);
  const Json parameters = json.value("parameters", Json::object());
  std::vector<char> isGiven(filter->parameters.size(), 0);
  for (const auto& [key, value] : parameters.items()) {
    if (filter->repeats > 0 && key == filter->groups) {
      for (const Json& group : value)
        for (const Json& each : group)
          step.values.push_back(valueFrom(*filter, filter->parameterOf(step.values.size()), each));
      if (!filter->takes(step.values.size()))
        throw InputError(FOOTFALL_TEXT("%1: '%2' has %3 values; give a multiple of %4"), name, key, step.values.size(),
                         filter->repeats);
      continue;
    }
    std::size_t index = 0;
    const std::size_t once = filter->parameters.size() - filter->repeats;
    while (index < once && filter->parameters[index].name != key) ++index;
    if (index == once) {
      throw InputError(FOOTFALL_TEXT("%1 has no parameter '%2'; see 'footfall filters %1'"), name, key);
    }
    step.values[index] = valueFrom(*filter, filter->parameters[index], value);
    isGiven[index] = 1;
  }
  for (std::size_t i = 0; i < filter->parameters.size() - filter->repeats; ++i)
    if (const int follows = filter->parameters[i].follows; isGiven[i] == 0 && follows >= 0)
      step.values[i] = step.values[follows];
  return step;
}

CameraPose cameraFrom(const Json& json) {
  CameraPose pose;
  pose.position = vectorFrom(json.at("position"));
  pose.pivot = vectorFrom(json.at("pivot"));
  double norm = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    pose.orientation[i] = json.at("orientation").at(i).get<double>();
    norm += pose.orientation[i] * pose.orientation[i];
  }
  if (!(norm > 0.9 && norm < 1.1))
    throw InputError(FOOTFALL_TEXT("view: the orientation is no unit quaternion; remove 'view'"));
  pose.orthographic = json.value("orthographic", false);
  return pose;
}

CellsShown cellsFrom(const Json& json) {
  CellsShown cells;
  cells.inView = json.value("in_view", false);
  cells.load = json.value("load", false);
  const auto name = json.value("colours", std::string(nameOf(cells.colouring)));
  const std::optional<CellColouring> colouring = colouringFrom(name);
  if (!colouring)
    throw InputError(FOOTFALL_TEXT("cells: colours are '%1'; give thread, time, triangles or cost"), name);
  cells.colouring = *colouring;
  return cells;
}

template <typename Value, std::size_t kCount>
Value named(const Json& json, const char* key, const std::array<std::pair<const char*, Value>, kCount>& names) {
  const auto text = json.at(key).get<std::string>();
  std::string known;
  for (const auto& [name, value] : names) {
    if (text == name) return value;
    known += (known.empty() ? "" : ", ") + std::string(name);
  }
  throw InputError(FOOTFALL_TEXT("%1 is '%2'; give one of %3"), key, text, known);
}

template <typename Value, std::size_t kCount>
const char* nameOf(Value value, const std::array<std::pair<const char*, Value>, kCount>& names) {
  return std::ranges::find(names, value, [](const auto& entry) { return entry.second; })->first;
}

constexpr std::array<std::pair<const char*, PartRole>, 3> kRoles = {
    {{"floor", PartRole::Floor}, {"obstacle_only", PartRole::ObstacleOnly}, {"ignored", PartRole::Ignored}}};
constexpr std::array<std::pair<const char*, PlacedObstacle::Shape>, 3> kShapes = {
    {{"box", PlacedObstacle::Shape::Box},
     {"cylinder", PlacedObstacle::Shape::Cylinder},
     {"ramp", PlacedObstacle::Shape::Ramp}}};

void requireFinite(const Vec3& v, const char* what) {
  if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
    throw InputError(FOOTFALL_TEXT("%1 is not finite; give three numbers"), what);
}

PlacedObstacle obstacleFrom(const Json& json) {
  PlacedObstacle obstacle;
  obstacle.shape = named(json, "shape", kShapes);
  obstacle.name = json.value("name", std::string());
  obstacle.base = vectorFrom(json.at("base"));
  obstacle.size = vectorFrom(json.at("size"));
  obstacle.turn = json.value("turn", 0.0);
  requireFinite(obstacle.base, "obstacles: base");
  requireFinite(obstacle.size, "obstacles: size");
  if (!(obstacle.size.x > 0 && obstacle.size.y > 0 && obstacle.size.z > 0) || !std::isfinite(obstacle.turn))
    throw InputError(FOOTFALL_TEXT("obstacles: a size is not above 0, or a turn not finite; mend or remove it"));
  return obstacle;
}

/// The value of a size in the enabled filters, or `otherwise` where none has it.
double sizeIn(const Pipeline& pipeline, AgentSize size, double otherwise) {
  for (const PipelineStep& step : pipeline.steps)
    for (std::size_t i = 0; step.enabled && i < step.values.size(); ++i)
      if (agentSizeOf(*step.filter, i) == size) return step.values[i];
  return otherwise;
}

/// A size that agents did not have when the session was saved belonged to the filters alone, whichever agent was
/// active.
NamedAgent agentFrom(const Json& json, const Pipeline& pipeline) {
  const auto sizeOr = [&](const char* name, AgentSize size, double none) {
    return json.contains(name) ? json.at(name).get<double>() : sizeIn(pipeline, size, none);
  };
  NamedAgent agent{0,
                   json.at("name").get<std::string>(),
                   json.at("height").get<double>(),
                   json.at("max_slope").get<double>(),
                   sizeOr("step", AgentSize::Step, 0),
                   sizeOr("gap", AgentSize::Gap, parameterOf(AgentSize::Gap).defaultValue),
                   sizeOr("radius", AgentSize::Radius, 0),
                   sizeOr("drop", AgentSize::Drop, 0)};
  if (!(agent.height > 0 && std::isfinite(agent.height) && agent.maxSlope > 0 && agent.maxSlope < 90))
    throw InputError(FOOTFALL_TEXT("agents: '%1' needs a height above 0 and a slope between 0 and 90 degrees"),
                     agent.name);
  if (!(agent.step >= 0 && std::isfinite(agent.step)))
    throw InputError(FOOTFALL_TEXT("agents: the step of '%1' is below 0; give 0 or more"), agent.name);
  if (!(agent.gap >= 0 && std::isfinite(agent.gap)))
    throw InputError(FOOTFALL_TEXT("agents: the gap of '%1' is below 0; give 0 or more"), agent.name);
  if (!(agent.radius >= 0 && std::isfinite(agent.radius)))
    throw InputError(FOOTFALL_TEXT("agents: the radius of '%1' is below 0; give 0 or more"), agent.name);
  if (!(agent.drop >= 0 && std::isfinite(agent.drop)))
    throw InputError(FOOTFALL_TEXT("agents: the drop of '%1' is below 0; give 0 or more"), agent.name);
  return agent;
}

void readLevel(const Json& json, Session& session) {
  for (const Json& rule : json.value("parts", Json::array())) {
    session.partRules.push_back(
        {rule.value("mesh", std::string()), rule.value("material", std::string()), named(rule, "role", kRoles)});
  }
  for (const Json& obstacle : json.value("obstacles", Json::array())) {
    session.obstacles.push_back(obstacleFrom(obstacle));
    session.obstacles.back().id = static_cast<std::uint32_t>(session.obstacles.size());
  }
  for (const Json& agent : json.value("agents", Json::array())) {
    session.agents.push_back(agentFrom(agent, session.pipeline));
    session.agents.back().id = static_cast<int>(session.agents.size());
  }
  const int agent = json.value("agent", 0);  // counts from 1
  session.agent = agent > 0 && agent <= static_cast<int>(session.agents.size()) ? agent : 0;
}

void writeLevel(const Session& session, Json& json) {
  for (const PartRule& rule : session.partRules)
    json["parts"].push_back({{"mesh", rule.mesh}, {"material", rule.material}, {"role", nameOf(rule.role, kRoles)}});
  for (const PlacedObstacle& obstacle : session.obstacles) {
    json["obstacles"].push_back({{"shape", nameOf(obstacle.shape, kShapes)},
                                 {"name", obstacle.name},
                                 {"base", toJson(obstacle.base)},
                                 {"size", toJson(obstacle.size)},
                                 {"turn", obstacle.turn}});
  }
  for (std::size_t i = 0; i < session.agents.size(); ++i) {
    const NamedAgent& agent = session.agents[i];
    json["agents"].push_back({{"name", agent.name},
                              {"height", agent.height},
                              {"max_slope", agent.maxSlope},
                              {"step", agent.step},
                              {"gap", agent.gap},
                              {"radius", agent.radius},
                              {"drop", agent.drop}});
    if (agent.id == session.agent) json["agent"] = i + 1;
  }
}

std::string relativeTo(const std::string& environment, const std::string& sessionPath) {
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(fs::absolute(sessionPath), error).parent_path();
  const fs::path target = fs::weakly_canonical(fs::absolute(environment), error);
  const fs::path relative = target.lexically_relative(folder);
  const auto ups = std::count(relative.begin(), relative.end(), fs::path(".."));
  return relative.empty() || ups > 1 ? target.string() : relative.generic_string();
}

constexpr std::array<std::string_view, 3> kGridChoices{"auto", "on", "off"};

/// Reads "auto", "on", "off" or a step, and the step that the level had.
void readGrid(const Json& import, ImportOptions& options) {
  const Json grid = import.value("grid", Json("auto"));
  if (grid.is_number()) {
    options.grid = GridChoice::Step;
    options.gridStep = grid.get<double>();
  } else {
    const auto choice = std::ranges::find(kGridChoices, grid.get<std::string>());
    if (choice == kGridChoices.end())
      throw InputError(FOOTFALL_TEXT("import: grid is '%1'; give auto, on, off or a step"), grid.get<std::string>());
    options.grid = static_cast<GridChoice>(choice - kGridChoices.begin());
  }
  options.keptGridStep = import.value("grid_step", 0.0);
  for (const double step : {options.gridStep, options.keptGridStep})
    if (!(std::isfinite(step) && step >= 0))
      throw InputError(FOOTFALL_TEXT("import: a step of the grid is not above 0; give for example 0.001"));
}

void writeGrid(const ImportOptions& options, Json& import) {
  if (options.grid == GridChoice::Step)
    import["grid"] = options.gridStep;
  else if (options.grid != GridChoice::Auto)
    import["grid"] = kGridChoices[static_cast<std::size_t>(options.grid)];
  if (options.keptGridStep > 0) import["grid_step"] = options.keptGridStep;
}

Session sessionFrom(const Json& json, const std::string& path) {
  if (!json.is_object() || !json.contains(kMark))
    throw InputError(FOOTFALL_TEXT("is not a session; open a file that Footfall saved"));
  if (json.at(kMark).get<int>() > kVersion)
    throw InputError(FOOTFALL_TEXT("comes from a newer Footfall; update this one"));
  Session session;
  session.environment = json.value("environment", std::string());
  if (!session.environment.empty()) {
    session.environment = (fs::path(path).parent_path() / session.environment).lexically_normal().string();
  }
  const Json import = json.value("import", Json::object());
  if (import.contains("up")) {
    const auto up = import.at("up").get<std::string>();
    session.import.up = upAxisFrom(up);
    if (!session.import.up) throw InputError(FOOTFALL_TEXT("import: up is '%1'; give y, z, x, -y, -z or -x"), up);
  }
  if (import.contains("metres_per_unit")) {
    const auto scale = import.at("metres_per_unit").get<double>();
    if (!(std::isfinite(scale) && scale > 0))
      throw InputError(FOOTFALL_TEXT("import: metres_per_unit is not above 0; give for example 0.01"));
    session.import.metresPerUnit = scale;
  }
  session.import.bothSides = import.value("both_sides", false);
  readGrid(import, session.import);
  for (const Json& step : json.at("pipeline")) session.pipeline.steps.push_back(stepFrom(step));
  if (json.contains("view")) session.camera = cameraFrom(json.at("view"));
  if (json.contains("cells")) session.cells = cellsFrom(json.at("cells"));
  readLevel(json, session);
  const Json tools = json.value("tools", Json::object());
  for (const auto& [name, section] : tools.items()) session.sections[name] = section.dump();
  return session;
}

}  // namespace

std::string formatSession(const Session& session, const std::string& path) {
  Json json;
  json[kMark] = kVersion;
  if (!session.environment.empty()) json["environment"] = relativeTo(session.environment, path);
  Json import = Json::object();
  if (session.import.up) import["up"] = nameOf(*session.import.up);
  if (session.import.metresPerUnit) import["metres_per_unit"] = *session.import.metresPerUnit;
  import["both_sides"] = session.import.bothSides;
  writeGrid(session.import, import);
  json["import"] = import;
  json["pipeline"] = Json::array();
  for (const PipelineStep& step : session.pipeline.steps) json["pipeline"].push_back(toJson(step));
  if (session.camera) {
    json["view"] = {{"position", toJson(session.camera->position)},
                    {"pivot", toJson(session.camera->pivot)},
                    {"orientation", session.camera->orientation},
                    {"orthographic", session.camera->orthographic}};
  }
  json["cells"] = {
      {"in_view", session.cells.inView}, {"load", session.cells.load}, {"colours", nameOf(session.cells.colouring)}};
  writeLevel(session, json);
  for (const auto& [name, section] : session.sections) json["tools"][name] = Json::parse(section);
  // Paths need not be UTF-8; a replaced letter is better than a session that cannot be saved.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

Session parseSession(const std::string& text, const std::string& path) { return sessionFrom(Json::parse(text), path); }

Session readSession(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file || text.empty()) {
    throw InputError(FOOTFALL_TEXT("%1: cannot be read or is empty; choose a session that Footfall saved"), path);
  }
  try {
    return parseSession(text, path);
  } catch (const InputError& error) {
    throw InputError(kAtPlace, path, error.text());
  } catch (const nlohmann::json::parse_error& error) {
    throw InputError(FOOTFALL_TEXT("%1: broken at byte %2; choose a session that Footfall saved"), path, error.byte);
  } catch (const nlohmann::json::exception&) {
    throw InputError(
        FOOTFALL_TEXT("%1: something is missing or of the wrong type; choose a session that Footfall saved"), path);
  }
}

bool isSessionFile(const std::string& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return false;
  std::ifstream file(path, std::ios::binary);
  std::string start(kMarkWithin, '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(file.gcount()));
  return start.find(kMark) != std::string::npos || fs::path(path).extension() == std::string(".") + kSessionExtension;
}

}  // namespace footfall::ui
