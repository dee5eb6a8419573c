// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/import.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "core/base/sorted_list.hpp"
#include "core/environment/part_rules.hpp"
#include "core/io/assimp_reader.hpp"
#include "core/io/file_frame.hpp"
#include "core/io/folder_reader.hpp"
#include "core/io/ifc_reader.hpp"
#include "core/io/input_file.hpp"
#include "core/io/obj_reader.hpp"
#include "core/io/packed/packed_environment.hpp"

namespace footfall {
using namespace detail;
namespace {

/// As long as the converter is not installed, Assimp does what it can.
FileFrame readIfc(const std::string& path, Environment& environment, RunContext* context) {
  if (const std::optional<std::string> converter = findIfcConverter())
    return readWithIfcConverter(*converter, path, environment, context);
  environment.notes.emplace_back(FOOTFALL_TEXT(
      "IFC is read without its converter: openings may be closed, doors are in the way, and elements have "
      "no classes or storeys; ifc.sh installs it (docs/how-to/buildings.md)"));
  try {
    return readWithAssimp(path, environment, context);
  } catch (const InputError& error) {
    throw InputError(FOOTFALL_TEXT("%1; IFC files that are in order may need the converter that ifc.sh installs "
                                   "(docs/how-to/buildings.md)"),
                     error.text());
  }
}

Environment readFile(const std::string& path, const ImportOptions& options, RunContext* context) {
  checkInputFile(path);
  const std::string extension = lowerExtension(path);
  if (extension == kPackedExtension) return readPacked(path, options, context);
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
  if (environment.triangles.empty()) failWithoutTriangles(path, environment.skipped);
  setFrame(environment, frame, options, usualFrame(extension));
  return environment;
}

Environment readEnvironment(const std::string& path, const ImportOptions& options, RunContext* context) {
  checkScale(options);
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
  extensions.emplace_back(kPackedExtension);
  sortOnce(extensions);
  return extensions;
}

std::shared_ptr<const Environment> detail::importEnvironment(const std::string& path, const ImportOptions& options,
                                                             RunContext* context) {
  return std::make_shared<const Environment>(readEnvironment(path, options, context));
}

}  // namespace footfall
