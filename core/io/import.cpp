// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/import.hpp"

#include <algorithm>
#include <bit>
#include <filesystem>
#include <system_error>

#include "core/base/sorted_list.hpp"
#include "core/environment/coordinate_grid.hpp"
#include "core/environment/part_rules.hpp"
#include "core/io/file_frame.hpp"
#include "core/io/folder_reader.hpp"
#include "core/io/foreign_reader.hpp"
#include "core/io/ifc_reader.hpp"
#include "core/io/input_file.hpp"
#include "core/io/obj_reader.hpp"
#include "core/io/packed/packed_environment.hpp"
#include "core/io/packed/streams.hpp"

namespace footfall {
using namespace detail;
namespace {

/// Assimp reads IFC as far as it can while the converter is not installed.
FileFrame readIfc(const std::string& path, Environment& environment, const ChildLimits& limits, RunContext* context) {
  if (const std::optional<std::string> converter = findIfcConverter())
    return readWithIfcConverter(*converter, path, environment, limits, context);
  environment.notes.emplace_back(
      FOOTFALL_TEXT(
          "IFC is read without its converter: openings may be closed, doors are in the way, and elements have "
          "no classes or storeys; %1"),
      adviceOnIfcConverter());
  try {
    return readForeign(path, environment, limits, context);
  } catch (const InputError& error) {
    throw InputError(FOOTFALL_TEXT("%1; valid IFC files may need the converter of Footfall; %2"), error.text(),
                     adviceOnIfcConverter());
  }
}

/// Collects an environment in memory, in the file's own frame.
class EnvironmentSink : public MeshSink {
 public:
  explicit EnvironmentSink(Environment& environment) : environment_(environment) {}

  void addVertex(const Vec3& place) override { environment_.vertices.push_back(place); }
  [[nodiscard]] std::uint64_t vertexCount() const override { return environment_.vertices.size(); }
  [[nodiscard]] Vec3 vertex(std::uint32_t number) const override { return environment_.vertices[number]; }
  void addFace(const Triangle& corners, std::uint32_t part) override {
    environment_.triangles.push_back(corners);
    environment_.partOf.push_back(part);
  }

 private:
  Environment& environment_;
};

/// Reads PLY and STL files as most programs write them, with the exact doubles of the text. Returns false, with
/// `environment` unchanged, for all other files.
bool readPlain(const std::string& path, const std::string& extension, Environment& environment, FileFrame& frame,
               RunContext* context) {
  if (extension != "ply" && extension != "stl") return false;
  Environment read;
  read.source = path;
  EnvironmentSink sink(read);
  if (!(extension == "ply" ? streamPly(path, read, sink, context) : streamStl(path, read, sink, context))) return false;
  if (read.parts.empty()) read.partOf.clear();
  frame.areFloats = sink.areFloats;
  environment = std::move(read);
  return true;
}

/// Records the grid of `frame`, unless a packed environment has its own.
void noteGrid(Environment& environment, const FileFrame& frame) {
  if (frame.gridStep == 0) return;
  GridExtent extent;
  for (const Vec3& p : environment.vertices) extent.includeVertex(p);
  environment.grid.step = frame.gridStep;
  environment.grid.bits =
      static_cast<std::uint32_t>(std::bit_width(static_cast<std::uint64_t>(extent.largest / frame.gridStep)));
}

/// Rounds the whole environment to the grid that the options choose, unless it is already on a grid that is as coarse.
void chooseGrid(Environment& environment, const ImportOptions& options, bool areFloats, RunContext* context) {
  GridExtent extent;
  for (const Vec3& p : environment.vertices) extent.includeVertex(p);
  for (const Triangle& triangle : environment.triangles)
    for (const std::uint32_t corner : triangle) extent.include(environment.vertices[corner]);
  const double step = chosenGridStep(options, areFloats, extent, environment.metresPerUnit);
  if (step > environment.grid.step) putOnGrid(environment, step, Poll(context));
}

/// `areFloats` becomes true for files whose numbers are floats.
Environment readFile(const std::string& path, const ImportOptions& options, bool& areFloats, RunContext* context) {
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
    if (!readPlain(path, extension, environment, frame, context)) {
      const ChildLimits limits = options.limitReaders ? importLimitsFor(path) : ChildLimits{};
      frame = extension == "ifc" ? readIfc(path, environment, limits, context)
                                 : readForeign(path, environment, limits, context);
    }
  }
  if (environment.triangles.empty()) failWithoutTriangles(path, environment.skipped);
  setFrame(environment, frame, options, usualFrame(extension));
  noteGrid(environment, frame);
  areFloats = areFloats || frame.areFloats;
  return environment;
}

Environment readEnvironment(const std::string& path, const ImportOptions& options, RunContext* context) {
  checkScale(options);
  checkGrid(options);
  bool areFloats = false;
  const auto read = [&](const std::string& file) { return readFile(file, options, areFloats, context); };
  std::error_code error;
  Environment whole = std::filesystem::is_directory(path, error) ? readFolder(path, read) : read(path);
  chooseGrid(whole, options, areFloats, context);
  return whole;
}

}  // namespace

Environment load(const std::string& path, const ImportOptions& options, RunContext* context) {
  Environment whole = readEnvironment(path, options, context);
  const auto isUsual = [](PartRole role) { return role == PartRole::Floor; };
  if (std::all_of(whole.usualRoles.begin(), whole.usualRoles.end(), isUsual)) return whole;
  Environment level = *applyPartRules(std::make_shared<const Environment>(std::move(whole)), {});
  level.edit = nullptr;
  if (level.triangles.empty())
    failInput(path, 0, FOOTFALL_TEXT("it has no floors and no obstacles"),
              FOOTFALL_TEXT("choose a file that has walls, slabs or stairs"));
  return level;
}

std::vector<std::string> importableExtensions() {
  std::vector<std::string> extensions = foreignExtensions();
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
