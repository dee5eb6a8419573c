// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export_options.hpp"

#include <iostream>

#include "app/command_options.hpp"
#include "core/base/counted_text.hpp"
#include "core/base/poll.hpp"
#include "core/io/export.hpp"
#include "core/io/formats/save.hpp"
#include "footfall/report.hpp"
#include "footfall/up_axis.hpp"

namespace footfall::app {
using namespace detail;
namespace {

/// ".obj: OBJ, ...", a line for each format.
std::string formatHelp() {
  std::string help = "Write the walkable area to this file; its ending chooses the format:";
  for (const FormatDescriptor& format : exportFormats())
    help.append(&format == &exportFormats().front() ? "\n" : ";\n")
        .append(format.ending)
        .append("  ")
        .append(Text(format.name).str());
  return help;
}

}  // namespace

CLI::Option* ExportCommandOptions::addTo(CLI::App& command, const std::string& outputHelp) {
  CLI::Option* output =
      command.add_option("-o,--output", this->output, formatHelp() + outputHelp)->check(hasName())->type_name("OUT");
  const auto leaveOut = [&command](const char* name, bool& part, const char* help) {
    command.add_flag_callback(
        name, [&part] { part = false; }, help);
  };
  leaveOut("--no-layers", options.layers, "Export one group of triangles instead of one for each layer");
  leaveOut("--no-connections", options.connections, "Leave out the lines where two layers meet");
  leaveOut("--no-obstacle-edges", options.obstacleEdges, "Leave out the lines of obstacle edges");
  leaveOut("--no-steps", options.steps, "Leave out the faces of steps");
  leaveOut("--no-drops", options.drops, "Leave out the lines of drops");
  addUpAxis(command, "--export-up", up,
            "Up axis of an OBJ export; the environment's when left out. All other formats have one");
  command
      .add_option("--export-scale", options.scale,
                  "Multiply the coordinates of the export; 1 (the default) keeps the environment's units, in which OBJ "
                  "is exact. All other formats are in metres before that")
      ->type_name("S");
  command.add_option("--godot", options.godot, "The version of Godot that is to read a .tres: 4 (the default) or 3")
      ->check(CLI::IsMember({3, 4}))
      ->type_name("VERSION");
  command.add_flag(
      "--navmesh-node", options.navmeshNode,
      "For glTF: write one mesh, whose node is \"walkable-navmesh\", which Godot imports as a navigation region");
  addPolygonOptions(command, part, options.coordinateSystem);
  return output;
}

const std::vector<std::string>& ExportCommandOptions::names() {
  static const std::vector<std::string> kNames{
      "--no-layers",    "--no-connections", "--no-obstacle-edges", "--no-steps", "--no-drops", "--export-up",
      "--export-scale", "--godot",          "--navmesh-node",      "--part",     "--crs"};
  return kNames;
}

void ExportCommandOptions::finish() {
  options.up = upAxisFrom(up);
  if (part > 0) options.part = part - 1;
}

void ExportCommandOptions::check() const {
  if (!output.empty()) {
    checkReplaced(output);
    checkOptions(exportFormatOf(output), options);
  }
  checkScale(options, {});
}

double writeExport(const ExportCommandOptions& options, const NavigationMesh& mesh, const Pipeline& pipeline,
                   const WriteTargets& targets, const RunContext& context) {
  const ExportFiles made = formatExport(exportFormatOf(options.output), options.output, mesh,
                                        makeExportHeader(pipeline), options.options, {}, context);
  for (const OutputFile& file : made.files) targets.check(file.path);
  checkReplaced(options.output);
  writeFilesSafely(made.files, context);
  return made.largestError;
}

void printLosses(const NavigationMesh& mesh, const ExportCommandOptions& options, double error) {
  const Text lost = lossesOf(exportFormatOf(options.output), mesh, options.options);
  std::string line = lost.empty() ? std::string() : "the format cannot hold " + lost.str();
  // Invisible errors are not reported: floats are a tenth of a millimetre apart at 1 km.
  if (error > 0.0005) {
    line += line.empty() ? "" : "; ";
    line += formatted(error * 1000, "rounding to floats moved coordinates by up to %.3g mm");
  }
  if (!line.empty()) std::cerr << "footfall: note: " << options.output << ": " << line << '\n';
}

}  // namespace footfall::app
