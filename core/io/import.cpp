// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/import.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "core/base/counted_text.hpp"
#include "core/base/sorted_list.hpp"
#include "core/environment/part_rules.hpp"
#include "core/io/assimp_reader.hpp"
#include "core/io/folder_reader.hpp"
#include "core/io/ifc_reader.hpp"
#include "core/io/input_file.hpp"
#include "core/io/obj_reader.hpp"
#include "footfall/up_axis.hpp"

namespace footfall {
using namespace detail;
namespace {

std::string lowerExtension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return extension;
}

/// By format where the file does not say. Game and web formats have Y up, or Assimp turns them so; formats of
/// scanning, printing and building have Z up, as does 3DS.
UpAxis usualUpAxis(const std::string& extension) {
  for (const std::string_view zUp : {"stl", "ply", "3ds", "off", "dxf", "3mf", "amf"}) {
    if (extension == zUp) return UpAxis::Z;
  }
  return UpAxis::Y;
}

/// Formats for printing count in millimetres; all others have or suggest metres.
double usualMetresPerUnit(const std::string& extension) {
  if (extension == "3mf" || extension == "amf") return 0.001;
  if (extension == "fbx") return 0.01;
  return 1;
}

/// As long as the converter is not installed, Assimp does what it can.
FileFrame readIfc(const std::string& path, Environment& environment, RunContext* context) {
  if (const std::optional<std::string> converter = findIfcConverter())
    return readWithIfcConverter(*converter, path, environment, context);
  environment.notes.emplace_back(FOOTFALL_TEXT(
      "IFC is read without its converter: openings may be closed, doors are in the way, and elements have "
      "no classes or storeys; ifc.sh installs it (docs/buildings.md)"));
  try {
    return readWithAssimp(path, environment, context);
  } catch (const InputError& error) {
    throw InputError(FOOTFALL_TEXT("%1; IFC files that are in order may need the converter that ifc.sh installs "
                                   "(docs/buildings.md)"),
                     error.text());
  }
}

Environment readFile(const std::string& path, const ImportOptions& options, RunContext* context) {
  checkInputFile(path);
  const std::string extension = lowerExtension(path);
  Environment environment;
  environment.source = path;

  FileFrame frame;
  if (extension == "obj") {
    readObj(path, readInputFile(path, context), environment, context);
  } else {
    const std::vector<std::string> known = importableExtensions();
    if (std::find(known.begin(), known.end(), extension) == known.end()) {
      failInput(path, 0,
                extension.empty() ? Text(FOOTFALL_TEXT("has no extension"))
                                  : Text(FOOTFALL_TEXT("unknown extension '.%1'"), extension),
                FOOTFALL_TEXT("use OBJ, glTF, FBX, DAE, PLY, STL, 3DS or another format that Assimp reads"));
    }
    frame = extension == "ifc" ? readIfc(path, environment, context) : readWithAssimp(path, environment, context);
  }
  if (environment.triangles.empty()) {
    const SkippedElements& skipped = environment.skipped;
    failInput(path, 0,
              Text(FOOTFALL_TEXT("no triangles in it (skipped: %1, %2, %3)"),
                   countedText(skipped.polygons, FOOTFALL_TEXT("1 polygon"), FOOTFALL_TEXT("%1 polygons")),
                   countedText(skipped.lines, FOOTFALL_TEXT("1 line"), FOOTFALL_TEXT("%1 lines")),
                   countedText(skipped.points, FOOTFALL_TEXT("1 point"), FOOTFALL_TEXT("%1 points"))),
              FOOTFALL_TEXT("choose a file that has faces"));
  }

  environment.upGuessed = !options.up && !frame.up;
  environment.up = options.up.value_or(frame.up.value_or(usualUpAxis(extension)));
  environment.scaleGuessed = !options.metresPerUnit && !frame.metresPerUnit;
  environment.metresPerUnit =
      options.metresPerUnit.value_or(frame.metresPerUnit.value_or(usualMetresPerUnit(extension)));
  environment.bothSides = options.bothSides;
  for (Vec3& p : environment.vertices) p = fromFileFrame(p, environment.up);
  for (SkippedPolygon& polygon : environment.skipped.listed)
    for (Vec3& p : polygon.corners) p = fromFileFrame(p, environment.up);
  if (environment.up != frame.up.value_or(environment.up))
    environment.storeys.clear();  // heights are along another axis
  return environment;
}

Environment readEnvironment(const std::string& path, const ImportOptions& options, RunContext* context) {
  if (options.metresPerUnit && !(std::isfinite(*options.metresPerUnit) && *options.metresPerUnit > 0)) {
    throw InputError(
        FOOTFALL_TEXT("scale: must be a positive number of metres per unit; give for example 0.01 for centimetres"));
  }
  std::error_code error;
  if (!std::filesystem::is_directory(path, error)) return readFile(path, options, context);
  return readFolder(path, [&](const std::string& file) { return readFile(file, options, context); });
}

}  // namespace

Environment load(const std::string& path, const ImportOptions& options, RunContext* context) {
  Environment whole = readEnvironment(path, options, context);
  const auto isUsual = [](PartRole role) { return role == PartRole::Floor; };
  if (std::all_of(whole.usualRoles.begin(), whole.usualRoles.end(), isUsual)) return whole;
  Environment level = *applyPartRules(std::make_shared<const Environment>(std::move(whole)), {});
  level.edit = nullptr;
  if (level.triangles.empty())
    failInput(path, 0, FOOTFALL_TEXT("nothing of it is a floor or an obstacle"),
              FOOTFALL_TEXT("choose a file that has walls, slabs or stairs"));
  return level;
}

std::vector<std::string> importableExtensions() {
  std::vector<std::string> extensions = assimpExtensions();
  extensions.push_back("obj");
  sortOnce(extensions);
  return extensions;
}

std::shared_ptr<const Environment> detail::importEnvironment(const std::string& path, const ImportOptions& options,
                                                             RunContext* context) {
  return std::make_shared<const Environment>(readEnvironment(path, options, context));
}

}  // namespace footfall
