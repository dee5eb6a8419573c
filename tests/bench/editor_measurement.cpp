// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/editor_measurement.hpp"

#include <array>

#include "core/base/process_usage.hpp"
#include "footfall/errors.hpp"
#include "footfall/filter.hpp"
#include "tests/bench/sampling.hpp"
#include "tests/bench/view_watch.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/agents/agent_edits.hpp"
#include "ui/agents/agents_panel.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/base/text/localized_numbers.hpp"
#include "ui/base/work/frame_watchdog.hpp"
#include "ui/filters/filter_list.hpp"
#include "ui/level/obstacle_features.hpp"

namespace footfall::bench {
using namespace detail;
using namespace ui;
namespace {

constexpr int kRepaints = 9;
constexpr int kMoves = 40;    // moves of the mouse in a drag
constexpr int kRestMs = 400;  // pause between two edits: nothing of the one before is under way any more
constexpr int kPatienceMs = 300'000;

/// A series of edits: the field and its successive values. No value repeats, so that no result comes from the cache,
/// and each changes the picture of the docks.
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

/// Times of something that was done several times.
class Times {
 public:
  explicit Times(std::string name) : name_(std::move(name)) {}
  void add(double ms) { samples_.add(name_, ms); }
  [[nodiscard]] Json json() const { return {{"median", samples_.median(name_)}, {"most", samples_.most(name_)}}; }

 private:
  std::string name_;
  Samples samples_;
};

class Stopwatch {
 public:
  Stopwatch() { clock_.start(); }
  [[nodiscard]] double ms() const { return static_cast<double>(clock_.nsecsElapsed()) * 1e-6; }

 private:
  QElapsedTimer clock_;
};

template <typename Condition>
void waitFor(const Condition& condition, const char* problem) {
  if (!QTest::qWaitFor(condition, kPatienceMs)) throw RunError(problem);
}

void addStalls(Json& json, const FrameWatchdog& watchdog) {
  json["longest_stall"] = {{"ms", watchdog.longestStallMs()}, {"during", watchdog.longestStall().during.toStdString()}};
  Json& stalls = json["stalls"] = Json::array();
  for (const FrameWatchdog::Stall& stall : watchdog.stallsOver(kPauseDueMs))
    stalls.push_back({{"ms", stall.milliseconds}, {"during", stall.during.toStdString()}});
}

NumberField& fieldOf(EditorWindow& window, const char* filter) {
  const auto& entries = test::partOf<Document>(window).filters();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (entries[i].step.filter->name == filter)
      return *qobject_cast<NumberField*>(test::partOf<FilterList>(window).rows()[i]->field(0));
  }
  throw RunError(std::string("no ") + filter + " in the list");
}

void sendMouse(LevelView& view, QEvent::Type type, const QPointF& place, Qt::MouseButton button,
               Qt::MouseButtons buttons) {
  QMouseEvent event(type, place, view.mapToGlobal(place), button, buttons, {});
  QCoreApplication::sendEvent(&view, &event);
}

// --- Opening

Json measureOpening(EditorWindow& window, ViewWatch& watch, const std::string& environment) {
  FrameWatchdog watchdog;
  watchdog.start();
  const Stopwatch clock;
  Json json;
  QObject guard;
  QObject::connect(&window.controller(), &RunController::started, &guard, [&] {
    if (!json.contains("loaded_ms")) json["loaded_ms"] = clock.ms();
  });
  QObject::connect(&window.controller(), &RunController::finished, &guard, [&] { json["computed_ms"] = clock.ms(); });
  watch.begin();
  window.open(QString::fromStdString(environment));
  waitFor([&] { return watch.done() || test::partOf<MessageBar>(window).isVisible(); }, "nothing is opened");
  if (!watch.done()) throw RunError(environment + ": " + test::partOf<MessageBar>(window).text().toStdString());
  json["ms"] = clock.ms();
  json["run_ms"] = window.controller().finishedRun()->result.totalMs;
  waitFor([&] { return window.idle() && window.view().isWhole(); }, "opening does not end");
  QTest::qWait(kRestMs);
  addStalls(json, watchdog);
  return json;
}

// The lower bound of any edit: the window painted with nothing new in it.
Json measureRepaint(EditorWindow& window) {
  Samples samples;
  QSignalSpy swapped(&window.view(), &LevelView::frameSwapped);
  for (int i = 0; i < kRepaints; ++i) {
    QTest::qWait(kRestMs / 4);
    const double cpu = processCpuMs();
    const Stopwatch clock;
    window.view().update();
    if (!swapped.wait()) throw RunError("the view does not paint");
    samples.add("ms", clock.ms());
    samples.add("cpu_ms", processCpuMs() - cpu);
  }
  return {{"ms", samples.median("ms")}, {"cpu_ms", samples.median("cpu_ms")}};
}

// --- Turning

// A drag of the left button, one move a frame, and the whole picture once it has ended.
Json measureTurning(LevelView& view) {
  const QPoint middle = view.rect().center();
  QSignalSpy swapped(&view, &LevelView::frameSwapped);
  Times frames("frame");
  FrameWatchdog watchdog;
  watchdog.start();
  sendMouse(view, QEvent::MouseButtonPress, middle, Qt::LeftButton, Qt::LeftButton);
  for (int i = 1; i <= kMoves; ++i) {
    const Stopwatch clock;
    swapped.clear();
    sendMouse(view, QEvent::MouseMove, middle + QPoint(5 * i, i), Qt::NoButton, Qt::LeftButton);
    waitFor([&] { return swapped.count() > 0; }, "the view does not turn");
    frames.add(clock.ms());
  }
  sendMouse(view, QEvent::MouseButtonRelease, middle + QPoint(5 * kMoves, kMoves), Qt::LeftButton, Qt::NoButton);
  waitFor([&] { return view.isWhole(); }, "the view does not come to rest");
  Json json{{"frame", frames.json()}};
  addStalls(json, watchdog);
  view.cameraController().viewOblique();
  waitFor([&] { return view.isWhole(); }, "the view does not come to rest");
  QTest::qWait(kRestMs);
  return json;
}

// --- Editing

// Replaces the text of a field as one edit, from the clipboard, as the digits of a typed number are one edit each.
EditTimes edit(EditorWindow& window, ViewWatch& watch, NumberField& field, double value) {
  QApplication::clipboard()->setText(numberText(value));
  QTest::mouseClick(&field, Qt::LeftButton);
  QTest::keyClick(&field, Qt::Key_A, Qt::ControlModifier);
  QTest::qWait(kRestMs);
  watch.begin();
  QTest::keyClick(&field, Qt::Key_V, Qt::ControlModifier);
  waitFor([&] { return watch.done(); }, "an edit leads to no result");
  if (!window.controller().upToDate()) throw RunError("the result is not that of the edit");
  return watch.times();
}

Json measureSeries(EditorWindow& window, ViewWatch& watch, const Series& series, int edits) {
  NumberField& field = fieldOf(window, series.filter);
  const double original = field.value();
  Samples samples;
  int unseen = 0;
  FrameWatchdog watchdog;
  watchdog.start();
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
  QTest::qWait(kRestMs);
  Json json{{"name", series.name}, {"filter", series.filter}, {"edits", edits}, {"without_visible_change", unseen}};
  addStalls(json, watchdog);
  edit(window, watch, field, original);
  for (const char* figure :
       {"visible_ms", "visible_begun_ms", "visible_cpu_ms", "finished_ms", "longest_pause_ms", "slowest_frame_ms"}) {
    if (unseen == edits && std::string_view(figure).starts_with("visible")) continue;
    json[figure] = {{"median", samples.median(figure)}, {"most", samples.most(figure)}};
  }
  return json;
}

// --- Obstacles

// Drags a box over the level: from a movement of the mouse to the frame with the result of it.
Json measureObstacle(EditorWindow& window) {
  LevelView& view = window.view();
  auto& features = *window.findChild<ObstacleFeatures*>();
  const FinishedRun& first = *window.controller().finishedRun();
  const double firstMs = first.result.totalMs;
  const NavigationMesh& mesh = *first.result.mesh;
  if (mesh.triangles.empty()) throw RunError("nowhere to place an obstacle");
  PlacedObstacle box = features.editor().makeDefault(PlacedObstacle::Shape::Box);
  box.base = mesh.vertices[mesh.triangles[mesh.triangles.size() / 2][0]];
  FrameWatchdog watchdog;
  watchdog.start();
  features.editor().add(box);
  waitFor([&] { return window.idle(); }, "an obstacle leads to no result");
  view.setTool(&features.selectTool());
  QTest::qWait(kRestMs);
  const auto handle = view.project(features.selectTool().gizmo()->placeOf(ObstacleHandle::MovePlan));
  if (!handle) throw RunError("the obstacle is out of sight");
  QSignalSpy swapped(&view, &LevelView::frameSwapped);
  QSignalSpy finished(&window.controller(), &RunController::finished);
  Times followed("followed"), runs("run");
  sendMouse(view, QEvent::MouseButtonPress, *handle, Qt::LeftButton, Qt::LeftButton);
  for (int i = 1; i <= kMoves; ++i) {
    const Stopwatch clock;
    finished.clear();
    sendMouse(view, QEvent::MouseMove, *handle + QPointF(i, 0.6 * i), Qt::NoButton, Qt::LeftButton);
    waitFor([&] { return finished.count() > 0; }, "the result does not follow an obstacle");
    swapped.clear();
    waitFor([&] { return swapped.count() > 0; }, "the view does not follow an obstacle");
    followed.add(clock.ms());
    runs.add(window.controller().finishedRun()->result.totalMs);
  }
  sendMouse(view, QEvent::MouseButtonRelease, *handle + QPointF(kMoves, 0.6 * kMoves), Qt::LeftButton, Qt::NoButton);
  waitFor([&] { return window.idle(); }, "a drag does not end");
  QTest::qWait(kRestMs);
  Json json{{"followed", followed.json()}, {"run", runs.json()}, {"first_run_ms", firstMs}};
  addStalls(json, watchdog);
  view.setTool(nullptr);
  test::partOf<Document>(window).undoStack()->undo();
  test::partOf<Document>(window).undoStack()->undo();
  waitFor([&] { return window.idle(); }, "undoing does not end");
  return json;
}

// --- Agents

// Switches between two agents with cached results.
Json measureAgents(EditorWindow& window) {
  LevelView& view = window.view();
  auto& panel = *window.findChild<AgentsPanel*>();
  for (const double slope : {50.0, 30.0}) {
    addAgent(test::partOf<Document>(window), {0, slope > 40 ? "agile" : "careful", 2, slope});
    waitFor([&] { return window.idle() && window.controller().upToDate(); }, "an agent leads to no result");
  }
  QTest::qWait(kRestMs);
  QSignalSpy swapped(&view, &LevelView::frameSwapped);
  Times switched("switched"), shown("shown");
  FrameWatchdog watchdog;
  watchdog.start();
  for (int i = 0; i < kRepaints; ++i) {
    swapped.clear();
    const Stopwatch clock;
    panel.activate(i % 2);
    if (!window.controller().upToDate()) throw RunError("the result of an agent is not known any more");
    switched.add(clock.ms());
    waitFor([&] { return swapped.count() > 0; }, "the view does not show the agent");
    shown.add(clock.ms());
    QTest::qWait(kRestMs);
  }
  Json json{{"switched", switched.json()}, {"shown", shown.json()}};
  addStalls(json, watchdog);
  return json;
}

}  // namespace

Json measureEditor(const EditorSubject& subject) {
  EditorWindow window;
  window.setRemembering(false);
  window.resize(kBenchWindow);
  if (!test::showWindow(window)) throw RunError("the window does not appear");
  ViewWatch watch(window);
  Json json;
  json["environment"] = subject.environment;
  json["opening"] = measureOpening(window, watch, subject.environment);
  json["triangles"] = window.file().environment()->triangles.size();
  json["due_ms"] = kEditDueMs;
  json["repaint"] = measureRepaint(window);
  json["turning"] = measureTurning(window.view());
  json["series"] = Json::array();
  for (const Series& series : kSeries) {
    if (subject.edits > 0) json["series"].push_back(measureSeries(window, watch, series, subject.edits));
  }
  if (!subject.whole) return json;
  json["obstacle"] = measureObstacle(window);
  json["agents"] = measureAgents(window);
  return json;
}

}  // namespace footfall::bench
