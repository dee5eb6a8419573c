// The editor program: reads the command line and hands over to footfall::ui.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "footfall/errors.hpp"
#include "footfall/up_axis.hpp"
#include "footfall/version.hpp"
#include "ui/window/editor_application.hpp"
#include "ui/window/turntable/turntable.hpp"

namespace {

QSize sizeFrom(const std::string& text) {
  int width = 0;
  int height = 0;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) != 2 || width < 320 || height < 240 ||
      width > 16384 || height > 16384) {
    throw footfall::InputError("--size " + text + ": not a size; give WIDTHxHEIGHT, from 320x240 to 16384x16384");
  }
  return {width, height};
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Footfall's editor: shows the walkable area of an environment while you change the filters.",
               "footfall-editor");
  footfall::ui::EditorOptions options;
  std::string pipelinePath;
  std::string size;
  std::string view = "oblique";
  std::string up;
  double scale = 0;
  std::vector<std::string> shown;
  std::string colouring = footfall::ui::nameOf(footfall::ui::CellsShown().colouring);
  app.set_version_flag("--version", "footfall-editor " FOOTFALL_VERSION);
  app.add_option("ENV", options.environment, "environment (OBJ, glTF, PLY, ...) or session (.footfall)");
  app.add_option("-p,--pipeline", pipelinePath, "pipeline file instead of the default filters");
  std::vector<std::string> ups;
  for (const footfall::UpAxis axis : footfall::kUpAxes) ups.emplace_back(footfall::nameOf(axis));
  app.add_option("--up", up, "axis of the file that points up")->check(CLI::IsMember(ups));
  auto* scaleOption = app.add_option("--scale", scale, "metres per unit of the file")->check(CLI::PositiveNumber);
  auto* screenshot =
      app.add_option("--screenshot", options.screenshot, "write a picture of the finished result and exit");
  auto* turntable =
      app.add_option("--turntable", options.turntable, "write pictures of the finished result from all around and exit")
          ->type_name("FOLDER")
          ->excludes(screenshot);
  app.add_option("--frames", options.frames, "number of the turntable's pictures")
      ->check(CLI::Range(footfall::ui::kLeastFrames, footfall::ui::kMostFrames))
      ->capture_default_str()
      ->needs(turntable);
  app.add_option("--size", size, "size of the window, or of the turntable's pictures, e.g. 1600x1000");
  app.add_option("--view", view, "where to look from")->check(CLI::IsMember({"top", "oblique"}))->capture_default_str();
  std::vector<std::string> modes;
  for (const footfall::ui::ViewMode mode : footfall::ui::kViewModes) modes.emplace_back(footfall::ui::nameOf(mode));
  std::string mode;
  auto* modeOption =
      app.add_option("--mode", mode, "what the view shows, e.g. --mode slope")->check(CLI::IsMember(modes));
  auto* showOption = app.add_option("--show", shown, "what to show of parallel blocks, e.g. --show cells,timeline")
                         ->delimiter(',')
                         ->check(CLI::IsMember({"cells", "timeline"}));
  app.add_option("--cell-colours", colouring, "what the colours of cells mean")
      ->check(CLI::IsMember({"thread", "time", "triangles", "cost"}))
      ->capture_default_str();
  std::string theme;
  app.add_option("--theme", theme, "colours of the window, for this start only")
      ->check(CLI::IsMember({"light", "dark", "system"}));
  app.add_option("--language", options.language, "language of the window, for this start only, such as de")
      ->type_name("CODE");
  try {
    app.parse(argc, argv);
    if (!options.screenshot.empty() && options.environment.empty()) {
      throw footfall::InputError("--screenshot needs an environment; name one");
    }
    if (*turntable && options.environment.empty())
      throw footfall::InputError("--turntable needs an environment; name one");
    if (*turntable && options.turntable.empty()) throw footfall::InputError("--turntable needs a folder; name one");
    if (!pipelinePath.empty() && options.environment.empty()) {
      throw footfall::InputError("-p needs an environment; name one");
    }
    if (!pipelinePath.empty()) options.pipeline = footfall::readPipelineFile(pipelinePath);
    if (!size.empty()) options.size = sizeFrom(size);
    options.import.up = footfall::upAxisFrom(up);
    if (*scaleOption) options.import.metresPerUnit = scale;
    options.top = view == "top";
    if (!theme.empty()) {
      options.theme = theme == "light"  ? footfall::ui::ThemeChoice::Light
                      : theme == "dark" ? footfall::ui::ThemeChoice::Dark
                                        : footfall::ui::ThemeChoice::System;
    }
    if (*modeOption) options.mode = footfall::ui::viewModeFrom(mode);
    if (*showOption) {
      const auto wants = [&](const char* part) { return std::find(shown.begin(), shown.end(), part) != shown.end(); };
      options.cells = {wants("cells"), wants("timeline"), *footfall::ui::colouringFrom(colouring)};
    }
    return footfall::ui::runEditor(argc, argv, options);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    std::fprintf(stderr, "footfall-editor: %s; see footfall-editor --help\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "footfall-editor: %s\n", error.what());
    return 2;
  }
}
