// The table of export formats, used by save(), the command line and the editor.
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
  Pattern name;        ///< name for people: "Wavefront OBJ"
  Pattern keeps;       ///< a phrase: "everything, in doubles"
  Pattern loses;       ///< a phrase; empty where nothing is lost
  // The options and extras that the format supports.
  bool hasLayers = true;         ///< layers
  bool hasLines = true;          ///< connections, obstacleEdges
  bool hasDrops = true;          ///< drops; all have steps
  bool hasFrame = false;         ///< up
  bool hasExtras = true;         ///< ExportExtra
  bool hasGodotVersion = false;  ///< godot
  bool hasNavmeshNode = false;   ///< navmeshNode
  bool hasParts = false;         ///< part
  bool hasCoordinateSystem = false;
  bool hasFilesBeside = false;  ///< a file for each layer, and more: existingOutputs()
  // The form of layers in the format, for a list of choices.
  Pattern layersAs = FOOTFALL_TEXT("A group for each layer");
  Pattern stepsAs = FOOTFALL_TEXT("Steps as faces");
};

/// All formats; the default one is first.
std::span<const FormatDescriptor> exportFormats();
const FormatDescriptor& descriptorOf(ExportFormat format);

/// ".obj, .gltf, ... or .geojson", for messages.
std::string exportEndings();

/// The format of a name's ending, in any case; a name without an ending is OBJ. Throws InputError that lists the
/// formats.
ExportFormat exportFormatOf(const std::string& path);

/// Throws InputError for an option that differs from its default and that the format does not support, except options
/// that leave out content the format does not have. Also throws for an invalid coordinate system.
void checkOptions(ExportFormat format, const ExportOptions& options);

/// The requested content of the mesh that the format cannot hold: "3 drops, 12 obstacle edges"; empty where nothing is
/// lost. save() reports rounding to floats.
Text lossesOf(ExportFormat format, const NavigationMesh& mesh, const ExportOptions& options);

}  // namespace footfall::detail
