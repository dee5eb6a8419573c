// What a result can be written as: one table for save(), the command line and the editor.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "footfall/io.hpp"
#include "footfall/text.hpp"

namespace footfall::detail {

enum class ExportFormat { Obj, Gltf, Glb, Detour, Godot, Wkt, GeoJson };

struct FormatDescriptor {
  ExportFormat format;
  const char* ending;  ///< with its dot, in lower case
  Pattern name;        ///< for people: "Wavefront OBJ"
  Pattern keeps;       ///< a phrase: "everything, in doubles"
  Pattern loses;       ///< a phrase; empty where nothing is lost
  // Which of ExportOptions and extras the format has.
  bool hasLayers = true;         ///< layers
  bool hasLines = true;          ///< connections, obstacleEdges
  bool hasDrops = true;          ///< drops; all have steps
  bool hasFrame = false;         ///< up
  bool hasExtras = true;         ///< ExportExtra
  bool hasGodotVersion = false;  ///< godot
  bool hasNavmeshNode = false;   ///< navmeshNode
  bool hasParts = false;         ///< part
  bool hasCoordinateSystem = false;
  bool hasFloats = true;        ///< coordinates are rounded
  bool hasFilesBeside = false;  ///< a file for each layer, and more: existingOutputs()
  // What becomes of them, for a choice that people make.
  Pattern layersAs = FOOTFALL_TEXT("A group for each layer");
  Pattern stepsAs = FOOTFALL_TEXT("Steps as faces");
};

/// All formats, the usual one first.
std::span<const FormatDescriptor> exportFormats();
const FormatDescriptor& descriptorOf(ExportFormat format);

/// ".obj, .gltf, ... or .geojson", for messages.
std::string exportEndings();

/// Which format a name asks for by its ending, in any case; one without an ending is OBJ. Throws InputError that names
/// what can be written.
ExportFormat exportFormatOf(const std::string& path);

/// Throws InputError for an option that is not as it stands in ExportOptions and that the format knows nothing of. To
/// leave out what the format does not have is no such option. Throws for a coordinate system that is none, too.
void checkOptions(ExportFormat format, const ExportOptions& options);

/// What is in the mesh, is asked for in `options`, and is not in the format: "3 drops, 12 obstacle edges"; empty where
/// nothing is lost. Rounding to floats is told by save().
Text lossesOf(ExportFormat format, const NavigationMesh& mesh, const ExportOptions& options);

}  // namespace footfall::detail
