// footfall-editor-bench: how long after an edit in the editor one sees something, in its own window and widgets.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <iostream>

#include "core/environment/export.hpp"
#include "core/errors.hpp"
#include "core/metrics/process_usage.hpp"
#include "tests/bench/sampling.hpp"
#include "tests/bench/view_watch.hpp"
#include "tests/editor/editor_driver.hpp"

namespace {

using namespace footfall;
using namespace footfall::bench;

constexpr double kDueMs = 50;  // from an edit to the first visible change
constexpr QSize kWindow(1100, 800);
constexpr int kRepaints = 9;
constexpr int kRestMs = 400;  // between two edits: nothing of the one before is under way any more

struct Arguments {
  std::string environment = FOOTFALL_SOURCE_DIR "/samples/docks/docks.obj";
  int edits = 12;
  std::string json, markdown;
};

/// A way to edit: which field, and the values that it gets one after the other. None comes twice, so that nothing is
/// answered from the cache, and each changes what one sees of the docks.
struct Series {
  const char* name;
  const char* filter;
  std::array<double, 12> values;
};
constexpr std::array<Series, 3> kSeries{{
    {"slope", "SlopeFilter", {52.5, 64.5, 66.5, 68.5, 70.5, 73.5, 75.5, 76.5, 77.5, 79.5, 80.5, 82}},
    {"clearance", "VerticalClearanceFilter", {2.1, 2.2, 2.3, 2.4, 2.5, 2.6, 2.7, 2.8, 2.9, 3, 3.1, 3.2}},
    {"minimum area", "AreaFilter", {10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110, 120}},
}};

NumberField& fieldOf(EditorWindow& window, const char* filter) {
  const auto& entries = window.document().filters();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (entries[i].step.filter->name == filter)
      return *qobject_cast<NumberField*>(window.filterList().rows()[i]->field(0));
  }
  throw RunError(std::string("no ") + filter + " in the list");
}

// Replaces the text of a field as one edit, from the clipboard, as the digits of a typed number are one edit each.
EditTimes edit(EditorWindow& window, ViewWatch& watch, NumberField& field, double value) {
  QApplication::clipboard()->setText(numberText(value));
  QTest::mouseClick(&field, Qt::LeftButton);
  QTest::keyClick(&field, Qt::Key_A, Qt::ControlModifier);
  QTest::qWait(kRestMs);
  watch.begin();
  QTest::keyClick(&field, Qt::Key_V, Qt::ControlModifier);
  if (!QTest::qWaitFor([&] { return watch.done(); }, 60000)) throw RunError("an edit leads to no result");
  if (!window.controller().upToDate()) throw RunError("the result is not that of the edit");
  return watch.times();
}

Json measureSeries(EditorWindow& window, ViewWatch& watch, const Series& series, int edits) {
  NumberField& field = fieldOf(window, series.filter);
  const double original = field.value();
  Samples samples;
  int unseen = 0;
  for (int i = 0; i < edits; ++i) {
    const EditTimes times = edit(window, watch, field, series.values[static_cast<std::size_t>(i)]);
    if (times.visible) samples.add("visible_ms", *times.visible);
    if (times.visible) samples.add("visible_cpu_ms", times.visibleCpu);
    if (times.visible) samples.add("visible_begun_ms", times.begun);
    if (!times.visible) ++unseen;
    samples.add("finished_ms", times.finished);
    samples.add("longest_pause_ms", times.longestPause);
    samples.add("slowest_frame_ms", times.slowestFrame);
  }
  edit(window, watch, field, original);
  Json json{{"name", series.name}, {"filter", series.filter}, {"edits", edits}, {"without_visible_change", unseen}};
  for (const char* figure :
       {"visible_ms", "visible_begun_ms", "visible_cpu_ms", "finished_ms", "longest_pause_ms", "slowest_frame_ms"}) {
    if (unseen == edits && std::string_view(figure).starts_with("visible")) continue;
    json[figure] = {{"median", samples.median(figure)}, {"most", samples.most(figure)}};
  }
  return json;
}

// What no edit can be quicker than: the window painted with nothing new in it.
Json measureRepaint(EditorWindow& window) {
  Samples samples;
  QSignalSpy swapped(&window.view(), &LevelView::frameSwapped);
  for (int i = 0; i < kRepaints; ++i) {
    QTest::qWait(kRestMs / 4);
    const double cpu = processCpuMs();
    QElapsedTimer clock;
    clock.start();
    window.view().update();
    if (!swapped.wait()) throw RunError("the view does not paint");
    samples.add("ms", static_cast<double>(clock.nsecsElapsed()) * 1e-6);
    samples.add("cpu_ms", processCpuMs() - cpu);
  }
  return {{"ms", samples.median("ms")}, {"cpu_ms", samples.median("cpu_ms")}};
}

Json measureEditor(const Arguments& arguments) {
  EditorWindow window;
  window.setRemembering(false);
  window.resize(kWindow);
  if (!test::showWindow(window)) throw RunError("the window does not appear");
  ViewWatch watch(window);
  watch.begin();
  window.open(QString::fromStdString(arguments.environment));
  if (!QTest::qWaitFor([&] { return watch.done() || window.messageBar().isVisible(); }, 120000) || !watch.done())
    throw RunError(arguments.environment + ": " + window.messageBar().text().toStdString());
  QTest::qWait(kRestMs);
  Json json;
  json["environment"] = arguments.environment;
  json["triangles"] = window.environment()->triangles.size();
  json["due_ms"] = kDueMs;
  json["repaint"] = measureRepaint(window);
  json["series"] = Json::array();
  for (const Series& series : kSeries) json["series"].push_back(measureSeries(window, watch, series, arguments.edits));
  return json;
}

std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f", value);
  return text;
}

std::string formatEditorReport(const Json& results) {
  std::string text = "Edits of one parameter with " + std::to_string(results["triangles"].get<int>()) +
                     " triangles loaded in a window of " + std::to_string(kWindow.width()) + " x " +
                     std::to_string(kWindow.height()) +
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
         rounded(results["repaint"]["cpu_ms"]) + " ms of processor time.\n";
}

void runBench(const Arguments& arguments) {
  const Json results = measureEditor(arguments);
  if (!arguments.json.empty()) writeFileSafely(arguments.json, results.dump(2) + '\n');
  if (arguments.markdown.empty()) {
    std::cout << formatEditorReport(results);
  } else {
    writeFileSafely(arguments.markdown, formatEditorReport(results));
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Measures how long after an edit the editor shows something. Needs a display; xvfb-run -a gives one.",
               "footfall-editor-bench");
  Arguments arguments;
  app.add_option("ENV", arguments.environment, "The environment")->capture_default_str();
  app.add_option("--edits", arguments.edits, "Edits of each parameter")
      ->check(CLI::Range(1, 12))
      ->capture_default_str();
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
  QApplication application(argc, argv);
  prepareApplication();
  try {
    runBench(arguments);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "footfall-editor-bench: " << error.what() << '\n';
    return 1;
  }
}
