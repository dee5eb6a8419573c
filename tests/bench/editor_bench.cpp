// footfall-editor-bench: how soon the editor answers, in its own window and widgets.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <QTemporaryDir>
#include <iostream>

#include "core/io/export.hpp"
#include "footfall/errors.hpp"
#include "tests/bench/editor_measurement.hpp"
#include "tests/bench/generated_levels.hpp"
#include "ui/base/work/guarded_application.hpp"
#include "ui/window/editor_application.hpp"

namespace {

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::bench;
using namespace footfall::ui;

struct Arguments {
  EditorSubject subject{FOOTFALL_SOURCE_DIR "/samples/docks/docks.obj"};
  std::uint32_t terrain = 0;
  std::string json, markdown;
};

std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f", value);
  return text;
}

std::string pair(const Json& times) { return rounded(times["median"]) + " / " + rounded(times["most"]); }

// A row for each way to use the editor, with the longest stretch in which it answered nothing.
std::string formatOthers(const Json& results) {
  std::string text = std::to_string(results["triangles"].get<int>()) +
                     " triangles. Stalls: stretches in which the event loop could not take the next event; at most " +
                     rounded(kPauseDueMs) +
                     " ms are due.\n\n| what | ms, median / most | longest stall | during | stalls above "
                     "|\n|---|---:|---:|---|---:|\n";
  const auto row = [&](const std::string& name, const std::string& times, const Json& json) {
    text += "| " + name + " | " + times + " | " + rounded(json["longest_stall"]["ms"]) + " | " +
            json["longest_stall"]["during"].get<std::string>() + " | " + std::to_string(json["stalls"].size()) + " |\n";
  };
  row("opening, until the first result is seen", rounded(results["opening"]["ms"]), results["opening"]);
  row("turning, each frame", pair(results["turning"]["frame"]), results["turning"]);
  for (const Json& series : results["series"]) {
    row("edits of " + series["name"].get<std::string>() + ", until the result is seen", pair(series["finished_ms"]),
        series);
  }
  if (results.contains("obstacle")) {
    const Json& obstacle = results["obstacle"];
    row("dragging an obstacle, until its result is seen (first run: " + rounded(obstacle["first_run_ms"]) + ")",
        pair(obstacle["followed"]), obstacle);
  }
  if (results.contains("agents")) {
    row("switching agents, until the result is seen", pair(results["agents"]["shown"]), results["agents"]);
  }
  return text;
}

std::string formatEdits(const Json& results) {
  std::string text = "Edits of one parameter with " + std::to_string(results["triangles"].get<int>()) +
                     " triangles loaded in a window of " + std::to_string(kBenchWindow.width()) + " x " +
                     std::to_string(kBenchWindow.height()) +
                     ", ms, median / most.\n\n"
                     "| parameter | edits | first visible change | due | | drawing begun | CPU until then | finished | "
                     "longest pause | "
                     "slowest frame |\n"
                     "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
  for (const Json& series : results["series"]) {
    const auto figure = [&](const char* name) {
      return rounded(series[name]["median"]) + " / " + rounded(series[name]["most"]);
    };
    const bool seen = series.contains("visible_ms");
    const bool met = seen && series["visible_ms"]["median"] <= results["due_ms"];
    text += "| " + series["name"].get<std::string>() + " | " + std::to_string(series["edits"].get<int>()) + " | " +
            (seen ? figure("visible_ms") : "none") + " | at most " + rounded(results["due_ms"]) + " | " +
            (met ? "met" : "**missed**") + " | " + (seen ? figure("visible_begun_ms") : "") + " | " +
            (seen ? figure("visible_cpu_ms") : "") + " | " + figure("finished_ms") + " | " +
            figure("longest_pause_ms") + " | " + figure("slowest_frame_ms") + " |\n";
  }
  return text + "\nPainting the window with nothing new in it takes " + rounded(results["repaint"]["ms"]) + " ms, " +
         rounded(results["repaint"]["cpu_ms"]) + " ms of processor time.\n\n";
}

std::string formatEditorReport(const Json& results) {
  return (results["series"].empty() ? std::string() : formatEdits(results)) + formatOthers(results);
}

void runBench(const Arguments& arguments) {
  EditorSubject subject = arguments.subject;
  const QTemporaryDir scratch;
  if (arguments.terrain > 0) {
    subject.environment = scratch.filePath(QStringLiteral("terrain.obj")).toStdString();
    writeEnvironment(subject.environment, makeTerrain(arguments.terrain));
    subject.edits = 0;
  }
  const Json results = measureEditor(subject);
  if (!arguments.json.empty()) writeFileSafely(arguments.json, results.dump(2) + '\n');
  if (arguments.markdown.empty()) {
    std::cout << formatEditorReport(results);
  } else {
    writeFileSafely(arguments.markdown, formatEditorReport(results));
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Measures how soon the editor shows what one does. Needs a display; xvfb-run -a gives one.",
               "footfall-editor-bench");
  Arguments arguments;
  app.add_option("ENV", arguments.subject.environment, "The environment")->capture_default_str();
  app.add_option("--edits", arguments.subject.edits, "Edits of each parameter")
      ->check(CLI::Range(0, 12))
      ->capture_default_str();
  app.add_option("--terrain", arguments.terrain, "Instead of ENV: a generated terrain of so many triangles, no edits")
      ->check(CLI::Range(1, 4'000'000))
      ->type_name("TRIANGLES");
  app.add_flag("!--no-tools", arguments.subject.whole, "Neither obstacles nor agents");
  app.add_option("--json", arguments.json, "Write all figures to this file")->type_name("FILE");
  app.add_option("--markdown", arguments.markdown, "Write the table to this file instead of to standard output")
      ->type_name("FILE");
  CLI11_PARSE(app, argc, argv);
  const std::string problem = findDisplayProblem();
  if (!problem.empty()) {
    std::cerr << "footfall-editor-bench: " << problem << '\n';
    return 2;
  }
  const QTemporaryDir settings;
  qputenv("XDG_CONFIG_HOME", settings.path().toUtf8());
  requestOpenGl();
  GuardedApplication application(argc, argv);
  prepareApplication();
  try {
    runBench(arguments);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "footfall-editor-bench: " << error.what() << '\n';
    return 1;
  }
}
