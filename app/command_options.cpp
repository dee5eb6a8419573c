// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_options.hpp"

#include <charconv>
#include <cmath>

#include "core/base/worker_arena.hpp"
#include "core/pipeline/pipeline_fragment.hpp"
#include "footfall/errors.hpp"
#include "footfall/up_axis.hpp"

namespace footfall::app {
using namespace detail;

void EnvironmentOptions::addFileTo(CLI::App& command) {
  command
      .add_option("ENV", path,
                  "The environment: OBJ, glTF, FBX, PLY, STL, IFC or another mesh file, one that `footfall pack` wrote "
                  "(.ffenv), or a folder: all meshes in it")
      ->required();
  addUpAxis(command, "--up", up, "The file's up axis; guessed from the format when left out");
  command.add_option("--scale", metresPerUnit, "Metres in one unit of the file; guessed when left out")
      ->type_name("METRES");
  command.add_flag("--both-sides", bothSides,
                   "Take both sides of every triangle as its upper side, for files with unreliable winding");
  command
      .add_option(
          "--grid", grid,
          "Round coordinates to a grid: auto (files of floats, such as glTF and FBX), on, off, or a step in units "
          "of the file; auto when left out")
      ->type_name("auto|on|off|STEP");
  command.add_flag(
      "--no-import-limits", withoutImportLimits,
      "Read glTF, FBX and other formats without limits; usually reading ends where it takes far more time or "
      "memory than files of that size need");
}

void EnvironmentOptions::addTo(CLI::App& command) {
  addFileTo(command);
  const auto addNames = [&command](const char* name, std::vector<std::string>& names, const char* help) {
    command.add_option(name, names, help)->allow_extra_args(false)->type_name("NAME");
  };
  addNames("--ignore", ignored,
           "A mesh, a material or MESH/MATERIAL to leave out altogether; give it once for each. `footfall info` lists "
           "the names");
  addNames("--obstacle-only", obstacleOnly,
           "A mesh, a material or MESH/MATERIAL that is an obstacle, but never walkable; give it once for each");
  addNames("--as-usual", asUsual,
           "A mesh, a material or MESH/MATERIAL that is floor and obstacle as usual, though its file says otherwise, "
           "such as the doors of a building (IfcDoor); give it once for each");
}

ImportOptions EnvironmentOptions::import() const {
  if (metresPerUnit && !(std::isfinite(*metresPerUnit) && *metresPerUnit > 0))
    throw InputError("--scale: must be the metres in one unit of the file; give a number above 0");
  ImportOptions options{upAxisFrom(up), metresPerUnit, bothSides};
  options.limitReaders = !withoutImportLimits;
  if (grid == "on") {
    options.grid = GridChoice::On;
  } else if (grid == "off") {
    options.grid = GridChoice::Off;
  } else if (!grid.empty() && grid != "auto") {
    options.grid = GridChoice::Step;
    const auto [end, error] = std::from_chars(grid.data(), grid.data() + grid.size(), options.gridStep);
    if (error != std::errc() || end != grid.data() + grid.size() || !(std::isfinite(options.gridStep)) ||
        !(options.gridStep > 0))
      throw InputError("--grid: '" + grid + "' is no choice; give auto, on, off or a step above 0, such as 0.001");
  }
  return options;
}

std::vector<PartRule> EnvironmentOptions::rules(const Environment& environment) const {
  std::vector<PartRule> all;
  const auto add = [&](const std::vector<std::string>& names, PartRole role, const char* option) {
    for (const std::string& name : names) {
      const std::vector<PartRule> named = rulesForName(environment, name, role, option);
      all.insert(all.end(), named.begin(), named.end());
    }
  };
  add(asUsual, PartRole::Floor, "--as-usual");
  add(obstacleOnly, PartRole::ObstacleOnly, "--obstacle-only");
  add(ignored, PartRole::Ignored, "--ignore");
  return all;
}

void PipelineOptions::addTo(CLI::App& command, const std::string& fileHelp, const std::string& stepHelp) {
  CLI::Option* fileOption = command.add_option("-p,--pipeline", file, fileHelp)->type_name("FILE");
  command.add_option("--filter", steps, stepHelp)->allow_extra_args(false)->excludes(fileOption)->type_name("STEP");
}

std::optional<Pipeline> PipelineOptions::given(const RunContext* context) const {
  if (!file.empty()) return readPipeline(file, context);
  if (steps.empty()) return std::nullopt;
  std::string text;
  for (const std::string& step : steps) text += step + '\n';
  return parsePipeline(text, "--filter");
}

CLI::Validator hasName() {
  CLI::Validator validator;
  validator.operation(
      [](std::string& name) { return name.empty() ? std::string("an empty name is no file") : std::string(); });
  return validator;
}

void addThreads(CLI::App& command, int& threads, const std::string& help) {
  command.add_option("--threads", threads, help)->check(CLI::Range(1, kMostThreads))->type_name("N");
}

void addUpAxis(CLI::App& command, const std::string& name, std::string& up, const std::string& help) {
  std::vector<std::string> names;
  for (const UpAxis axis : kUpAxes) names.emplace_back(nameOf(axis));
  command.add_option(name, up, help)->check(CLI::IsMember(names, CLI::ignore_case))->type_name(kUpAxisNames);
}

void addPolygonOptions(CLI::App& command, std::uint32_t& part, std::string& coordinateSystem) {
  command
      .add_option("--part", part,
                  "Write only this connected part of polygons; 1 is the largest, as `footfall run` lists them")
      ->check(CLI::Range(1U, 0x7fffffffU))
      ->type_name("N");
  command
      .add_option("--crs", coordinateSystem,
                  "The coordinate system of the environment, which GeoJSON then names; no coordinate is changed")
      ->type_name("EPSG:N");
}

CLI::Option* addPlace(CLI::App& command, const std::string& name, std::array<double, 3>& place,
                      const std::string& help) {
  return command.add_option(name, place, help)->required()->type_name("X Y Z");
}

WriteTargets targetsBeside(const EnvironmentOptions& environment, const PipelineOptions& pipeline) {
  WriteTargets targets;
  targets.protectEnvironment(environment.path);
  targets.protect(pipeline.file, FOOTFALL_TEXT("the pipeline"));
  return targets;
}

}  // namespace footfall::app
