// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/file_frame.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "core/base/counted_text.hpp"
#include "core/io/input_file.hpp"
#include "footfall/up_axis.hpp"

namespace footfall::detail {

std::string lowerExtension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return extension;
}

UsualFrame usualFrame(const std::string& extension) {
  UsualFrame usual;
  // Game and web formats have Y up, or Assimp converts them so; formats of scanning, printing and building have Z up,
  // as does 3DS.
  for (const std::string_view zUp : {"stl", "ply", "3ds", "off", "dxf", "3mf", "amf"})
    if (extension == zUp) usual.up = UpAxis::Z;
  // Printing formats count in millimetres; all others have or suggest metres.
  if (extension == "3mf" || extension == "amf") usual.metresPerUnit = 0.001;
  if (extension == "fbx") usual.metresPerUnit = 0.01;
  return usual;
}

void setFrame(Environment& environment, const FileFrame& frame, const ImportOptions& options, const UsualFrame& usual) {
  environment.upGuessed = !options.up && !frame.up;
  environment.up = options.up.value_or(frame.up.value_or(usual.up));
  environment.scaleGuessed = !options.metresPerUnit && !frame.metresPerUnit;
  environment.metresPerUnit = options.metresPerUnit.value_or(frame.metresPerUnit.value_or(usual.metresPerUnit));
  environment.bothSides = options.bothSides;
  for (Vec3& p : environment.vertices) p = fromFileFrame(p, environment.up);
  for (SkippedPolygon& polygon : environment.skipped.listed)
    for (Vec3& p : polygon.corners) p = fromFileFrame(p, environment.up);
  if (environment.up != frame.up.value_or(environment.up))
    environment.storeys.clear();  // heights are along another axis
}

void failWithoutTriangles(const std::string& path, const SkippedElements& skipped) {
  failInput(path, 0,
            Text(FOOTFALL_TEXT("no triangles in it (skipped: %1, %2, %3)"),
                 countedText(skipped.polygons, FOOTFALL_TEXT("1 polygon"), FOOTFALL_TEXT("%1 polygons")),
                 countedText(skipped.lines, FOOTFALL_TEXT("1 line"), FOOTFALL_TEXT("%1 lines")),
                 countedText(skipped.points, FOOTFALL_TEXT("1 point"), FOOTFALL_TEXT("%1 points"))),
            FOOTFALL_TEXT("choose a file that has faces"));
}

void checkGrid(const ImportOptions& options) {
  const bool isStep = std::isfinite(options.gridStep) && options.gridStep > 0;
  if (options.grid == GridChoice::Step && !isStep)
    throw InputError(FOOTFALL_TEXT("grid: the step must be a positive number; give for example 0.001"));
}

void checkScale(const ImportOptions& options) {
  if (options.metresPerUnit && !(std::isfinite(*options.metresPerUnit) && *options.metresPerUnit > 0)) {
    throw InputError(
        FOOTFALL_TEXT("scale: must be a positive number of metres per unit; give for example 0.01 for centimetres"));
  }
}

}  // namespace footfall::detail
