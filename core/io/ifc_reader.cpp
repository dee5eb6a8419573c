// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ifc_reader.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "core/environment/part_names.hpp"
#include "core/io/foreign_reader.hpp"
#include "core/io/input_file.hpp"
#include "core/io/obj_reader.hpp"
#include "core/io/own_files.hpp"

namespace footfall::detail {
namespace {

constexpr std::string_view kFirstLine = "# footfall-ifc 1";
constexpr double kConverterStep = 1e-6;  // in metres; the converter rounds to the power of two that is nearest in ratio
constexpr const char* kPlace = "footfall/ifc/footfall-ifc.mjs";
constexpr int kFoldersUpToSources = 4;  // from build/release/tests

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view() : value;
}

/// Removes the next line from a text and returns it.
std::string_view takeLine(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

/// The rest of a line that begins with `start`.
std::optional<std::string_view> after(std::string_view line, std::string_view start) {
  if (!line.starts_with(start)) return std::nullopt;
  return line.substr(start.size());
}

/// Removes the number at the start of a text and returns it.
std::optional<double> takeNumber(std::string_view& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

std::string firstLineOf(std::string_view text) { return std::string(takeLine(text)); }

/// A path as it is typed in a shell.
std::string typedPath(const std::string& path) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789/._-+,@%:=";
  if (path.find_first_not_of(kPlain) == std::string::npos) return path;
  std::string quoted = "'";
  for (const char c : path) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + '\'';
}

}  // namespace

std::optional<std::string> findIfcConverter() {
  std::vector<std::filesystem::path> places;
  if (const std::string_view given = variable("FOOTFALL_IFC"); !given.empty()) {
    places.emplace_back(given);
  } else {
    if (const std::string_view data = variable("XDG_DATA_HOME"); !data.empty())
      places.push_back(std::filesystem::path(data) / kPlace);
    else if (const std::string_view home = variable("HOME"); !home.empty())
      places.push_back(std::filesystem::path(home) / ".local/share" / kPlace);
    std::string_view shared = variable("XDG_DATA_DIRS");
    if (shared.empty()) shared = "/usr/local/share:/usr/share";
    while (!shared.empty()) {
      const std::size_t end = std::min(shared.find(':'), shared.size());
      if (end > 0) places.push_back(std::filesystem::path(shared.substr(0, end)) / kPlace);
      shared.remove_prefix(std::min(end + 1, shared.size()));
    }
  }
  // Packages contain the converter itself, without the modules that it needs.
  for (const std::filesystem::path& place : places)
    if (::access(place.c_str(), R_OK) == 0 &&
        ::access((place.parent_path() / "node_modules/web-ifc/package.json").c_str(), R_OK) == 0)
      return place.string();
  return std::nullopt;
}

std::optional<std::string> ifcInstallCommand() {
  for (const std::filesystem::path& file : ownFiles()) {
    std::filesystem::path folder = file.parent_path();
    for (int up = 0; up < kFoldersUpToSources; ++up, folder = folder.parent_path())
      for (const char* place : {"share/footfall/ifc.sh", "installer/ifc.sh"})
        if (::access((folder / place).c_str(), X_OK) == 0) return typedPath((folder / place).string());
  }
  return std::nullopt;
}

Text adviceOnIfcConverter() {
  if (const std::optional<std::string> command = ifcInstallCommand())
    return {FOOTFALL_TEXT("to install it, type in a terminal: %1"), *command};
  return {FOOTFALL_TEXT("docs/how-to/buildings.md says how to install it")};
}

PartRole usualRoleOfClass(std::string_view ifcClass) {
  constexpr std::array<std::string_view, 7> kIgnored = {"IfcDoor",           "IfcDoorStandardCase", "IfcSpace",
                                                        "IfcOpeningElement", "IfcAnnotation",       "IfcGrid",
                                                        "IfcVirtualElement"};
  constexpr std::array<std::string_view, 17> kObstacles = {"IfcFurnishingElement",
                                                           "IfcFurniture",
                                                           "IfcSystemFurnitureElement",
                                                           "IfcWindow",
                                                           "IfcWindowStandardCase",
                                                           "IfcRailing",
                                                           "IfcSanitaryTerminal",
                                                           "IfcFlowTerminal",
                                                           "IfcElectricAppliance",
                                                           "IfcLightFixture",
                                                           "IfcFlowSegment",
                                                           "IfcFlowFitting",
                                                           "IfcPipeSegment",
                                                           "IfcPipeFitting",
                                                           "IfcDuctSegment",
                                                           "IfcDuctFitting",
                                                           "IfcSpaceHeater"};
  if (std::ranges::find(kIgnored, ifcClass) != kIgnored.end()) return PartRole::Ignored;
  if (std::ranges::find(kObstacles, ifcClass) != kObstacles.end()) return PartRole::ObstacleOnly;
  return PartRole::Floor;
}

FileFrame readWithIfcConverter(const std::string& converter, const std::string& path, Environment& environment,
                               const ChildLimits& limits, RunContext* context) {
  // Node does not take an absolute path for an option.
  ChildResult result = runChild({"node", converter, std::filesystem::absolute(path).string()}, Poll(context),
                                ChildEnding::Killed, kChildGraceMs, limits);
  failBeyondLimits(path, "IFC", result.end, limits);
  if (result.status == 127)
    failInput(path, 0, FOOTFALL_TEXT("IFC files are read by a converter that needs Node.js, which cannot be started"),
              FOOTFALL_TEXT("install it (package nodejs)"));
  if (result.status != 0) {
    const std::string reason = firstLineOf(result.errors);
    failInput(
        path, 0,
        reason.empty() ? Text(FOOTFALL_TEXT("cannot be converted (exit status %1)"), result.status) : Text(reason),
        FOOTFALL_TEXT("check that the file is complete, or export it again"));
  }
  FileFrame frame;
  frame.up = UpAxis::Z;
  std::string_view rest = result.output;
  if (takeLine(rest) != kFirstLine)
    failInput(path, 0, Text(FOOTFALL_TEXT("its converter %1 is of another version"), converter),
              adviceOnIfcConverter());
  while (rest.starts_with('#')) {
    const std::string_view line = takeLine(rest);
    if (auto value = after(line, "# metres per unit: ")) {
      frame.metresPerUnit = takeNumber(*value);
    } else if (auto storey = after(line, "# storey: ")) {
      const std::optional<double> height = takeNumber(*storey);
      if (height && storey->starts_with(' ')) environment.storeys.push_back({cleanName(storey->substr(1)), *height});
    }
  }
  std::ranges::stable_sort(environment.storeys, {}, &Storey::height);
  if (frame.metresPerUnit && *frame.metresPerUnit > 0)
    frame.gridStep = std::exp2(std::round(std::log2(kConverterStep / *frame.metresPerUnit)));
  readObj(path, std::move(result.output), environment, context);
  for (const EnvironmentPart& part : environment.parts) environment.usualRoles.push_back(usualRoleOfClass(part.mesh));
  return frame;
}

}  // namespace footfall::detail
