// The editor's data without a window: undo, sessions, numbers, the background queue.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <set>

#include "core/pipeline/pipeline_fragment.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "footfall/up_axis.hpp"
#include "tests/editor/editor_driver.hpp"
#include "ui/agents/agent_edits.hpp"
#include "ui/base/text/localized_numbers.hpp"
#include "ui/base/work/background_queue.hpp"
#include "ui/base/work/time_estimate.hpp"
#include "ui/filters/filter_edits.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

class TestDocument : public QObject {
  Q_OBJECT

 private slots:
  void everyEditCanBeUndone() {
    Document document;
    const Pipeline start = parsePipeline("SlopeFilter 45\nVerticalClearanceFilter 2\nAreaFilter 1\n", "test");
    document.reset(start, {});
    const auto id = [&](std::size_t row) { return document.filters()[row].id; };
    document.addFilter(filterDescriptor(FilterType::LayerSubdivision), 1);
    document.moveFilter(id(0), 2);
    document.setEnabled(id(1), false);
    document.setValue(id(2), 0, 30, 1);
    document.removeFilter(id(0));
    ImportOptions options;
    options.up = UpAxis::Z;
    document.setImportAndPipeline(options, document.pipeline(), "import");
    const Pipeline end = document.pipeline();
    QCOMPARE(document.undoStack()->count(), 6);
    while (document.undoStack()->canUndo()) document.undoStack()->undo();
    QCOMPARE(document.pipeline(), start);
    QVERIFY(!document.state().import.up.has_value());
    while (document.undoStack()->canRedo()) document.undoStack()->redo();
    QCOMPARE(document.pipeline(), end);
    QVERIFY(document.state().import.up == UpAxis::Z);
  }

  void typingIsOneEditAndTypingBackIsNone() {
    Document document;
    document.reset(parsePipeline("SlopeFilter 45\n", "test"), {});
    const int id = document.filters()[0].id;
    for (const double value : {4.0, 40.0, 40.5}) document.setValue(id, 0, value, 7);
    QCOMPARE(document.undoStack()->count(), 1);
    document.setValue(id, 0, 45, 7);
    QCOMPARE(document.undoStack()->count(), 0);
    document.setValue(id, 0, 45, 8);  // the value that it has
    QCOMPARE(document.undoStack()->count(), 0);
    document.setValue(id, 0, 30, 8);
    document.setValue(id, 0, 20, 9);  // left and entered again
    QCOMPARE(document.undoStack()->count(), 2);
  }

  void editsHaveNames() {
    Document document;
    document.reset(parsePipeline("SlopeFilter 45\nVerticalClearanceFilter 2\nSimplificationFilter\n", "test"), {});
    const auto id = [&](std::size_t row) { return document.filters()[row].id; };
    const auto text = [&] { return document.undoStack()->undoText(); };
    for (const double value : {4.0, 40.0, 50.0}) document.setValue(id(0), 0, value, 1);
    QCOMPARE(text(), QString::fromUtf8("Change maximum slope 45° → 50°"));  // the first and the last
    document.setValue(id(1), 0, 1.8, 2);
    QCOMPARE(text(), QString::fromUtf8("Change clearance 2 → 1.8"));
    document.setValue(id(2), 0, 1, -1);
    QCOMPARE(text(), QString::fromUtf8("Change approximate no → yes"));
    document.moveFilter(id(1), 0);
    QCOMPARE(text(), QString("Move Vertical clearance up"));
    document.moveFilter(id(0), 2);
    QCOMPARE(text(), QString("Move Vertical clearance down"));
    document.setEnabled(id(0), false);
    QCOMPARE(text(), QString("Switch off Slope"));
    document.removeFilter(id(0));
    QCOMPARE(text(), QString("Remove Slope"));
    duplicateFilters(document, {id(0)});
    QCOMPARE(text(), QString("Duplicate Simplification"));
  }

  void agentsDriveFiltersInOneEdit() {
    Document document;
    document.reset(parsePipeline("SlopeFilter 45\n#off SlopeFilter 60\nVerticalClearanceFilter 2\n", "test"), {});
    const auto value = [&](std::size_t row) { return document.filters()[row].step.values[0]; };
    const int id = addAgent(document, {0, "Cart", 1.2, 10});
    QCOMPARE(value(0), 10.0);
    QCOMPARE(value(1), 10.0);
    QCOMPARE(value(2), 1.2);
    resizeAgent(document, id, AgentSize::Height, 1.3);
    QCOMPARE(value(2), 1.3);
    QCOMPARE(document.undoStack()->undoText(), QString::fromUtf8("Change height of Cart 1.2 → 1.3"));
    QCOMPARE(addAgent(document, {0, "Cart", 1, 20}), 2);
    QCOMPARE(document.state().agents[1].name, std::string("Cart 2"));
    QCOMPARE(pipelineFor(document.state(), id).steps[2].values[0], 1.3);
    QCOMPARE(value(2), 1.0);
    renameAgent(document, id, "  ");
    renameAgent(document, id, "Cart 2");  // taken
    QCOMPARE(document.state().agents[0].name, std::string("Cart 2 2"));
    removeAgent(document, 2);
    QCOMPARE(document.state().agent, 0);
    QCOMPARE(value(2), 1.0);
    QCOMPARE(document.undoStack()->count(), 5);
    while (document.undoStack()->canUndo()) document.undoStack()->undo();
    QCOMPARE(value(1), 60.0);
    QVERIFY(document.state().agents.empty());
  }

  void stepsOfAgentsComeAndGo() {
    Document document;
    const std::string before = "SlopeFilter 45\nVerticalClearanceFilter 2\nDegeneracyFilter\nAreaFilter 1\n";
    document.reset(parsePipeline(before, "test"), {});
    const auto text = [&] { return formatPipeline(document.pipeline()); };
    const int climber = addAgent(document, {0, "Climber", 2, 45, 0.4, 0.05});
    const std::string with =
        "SlopeFilter 45\nVerticalClearanceFilter 2\nDegeneracyFilter\nStepFilter 0.4\nAreaFilter 1\n";
    QCOMPARE(text(), with);  // The place is behind filters that would lose the links, in front of those that count
                             // them.
    const int roller = addAgent(document, {0, "Roller", 2, 45, 0});
    QCOMPARE(text(), before);
    QCOMPARE(formatPipeline(pipelineFor(document.state(), climber)), with);
    activateAgent(document, climber);
    QCOMPARE(text(), with);
    QCOMPARE(formatPipeline(pipelineFor(document.state(), roller)), before);
    document.undoStack()->undo();
    QCOMPARE(text(), before);
    document.undoStack()->redo();
    resizeAgent(document, climber, AgentSize::Step, 0.25);
    QCOMPARE(document.undoStack()->undoText(), QString::fromUtf8("Change step of Climber 0.4 → 0.25"));
    QCOMPARE(document.filters()[3].step.values[0], 0.25);
    document.setValue(document.filters()[3].id, 0, 0.3, 1);  // the row is the agent's
    QCOMPARE(document.state().agents[0].step, 0.3);
    resizeAgent(document, climber, AgentSize::Step, 0);
    QCOMPARE(text(), before);
    QCOMPARE(document.state().agent, climber);
    document.undoStack()->undo();
    QCOMPARE(document.filters()[3].step.values[0], 0.3);
    document.undoStack()->redo();
    // A filter for steps is not for who climbs none.
    document.addFilter(filterDescriptor(FilterType::Step), 1);
    QCOMPARE(document.state().agent, 0);
    QCOMPARE(document.filters().back().step.values[0], 0.4);
    std::set<int> ids;
    for (const FilterEntry& entry : document.filters()) ids.insert(entry.id);
    QCOMPARE(ids.size(), document.filters().size());
  }

  // A list that is wrong elsewhere, or has no clearance, has no place for steps: this is reported, and nothing else
  // changes.
  void whyAFilterHasNoPlace() {
    Document document;
    for (const char* text :
         {"SlopeFilter 45\nAreaFilter 1\n", "Collapse\nSlopeFilter 45\nVerticalClearanceFilter 2\n"}) {
      document.reset({}, {});
      for (const PipelineStep& step : parsePipeline(QString(text).remove("Collapse\n").toStdString(), "test").steps)
        document.addFilter(*step.filter, static_cast<int>(document.filters().size()));
      if (QString(text).startsWith("Collapse")) document.addFilter(filterDescriptor(FilterType::Collapse), 0);
      addAgent(document, {0, "Climber", 2, 45, 0.4, 0.05, 0.3, 1});
      const auto has = [&](FilterType type) {
        return std::ranges::any_of(document.filters(),
                                   [&](const FilterEntry& e) { return e.step.filter->type == type; });
      };
      QVERIFY(!has(FilterType::Step) && !has(FilterType::Drop));
      const std::string why = whyNoPlace(document.state(), AgentSize::Step).str();
      QVERIFY2(!why.empty(), text);
      QVERIFY2((why.find("Collapse") != std::string::npos) == QString(text).startsWith("Collapse"), why.c_str());
      QVERIFY(!whyNoPlace(document.state(), AgentSize::Drop).empty());
      QVERIFY(whyNoPlace(document.state(), AgentSize::Radius).empty());
      QVERIFY(whyNoPlace(document.state(), AgentSize::Height).empty());
    }
    document.reset(parsePipeline("SlopeFilter 45\nVerticalClearanceFilter 2\n", "test"), {});
    addAgent(document, {0, "Climber", 2, 45, 0.4});
    QVERIFY(whyNoPlace(document.state(), AgentSize::Step).empty());
    QVERIFY(whyNoPlace(document.state(), AgentSize::Drop).empty());
  }

  void agentsThatDrop() {
    Document document;
    document.reset(parsePipeline("SlopeFilter 45\nVerticalClearanceFilter 2\nSimplificationFilter\nAreaFilter 1\n"
                                 "ReachableFilter 1 2 3\n",
                                 "test"),
                   {});
    const auto text = [&] { return formatPipeline(document.pipeline()); };
    const std::string before = text();
    const int jumper = addAgent(document, {0, "Jumper", 2, 45, 0.4, 0.05, 0, 1.5});
    const std::string with =
        "SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.4\nSimplificationFilter\nDropFilter 1.5\n"
        "AreaFilter 1\nReachableFilter 1 2 3\n";
    QCOMPARE(text(), with);
    std::set<int> ids;
    for (const FilterEntry& entry : document.filters()) ids.insert(entry.id);
    QCOMPARE(ids.size(), document.filters().size());
    addAgent(document, {0, "Roller", 2, 45, 0});
    QCOMPARE(text(), before);
    activateAgent(document, jumper);
    QCOMPARE(text(), with);
    resizeAgent(document, jumper, AgentSize::Drop, 3);
    QCOMPARE(document.undoStack()->undoText(), QString::fromUtf8("Change drop of Jumper 1.5 → 3"));
    QCOMPARE(document.filters()[4].step.values[0], 3.0);
    document.setValue(document.filters()[4].id, 0, 2, 1);  // the row is the agent's
    QCOMPARE(document.state().agents[0].drop, 2.0);
    document.setValue(document.filters()[4].id, 1, 0.5, 1);  // the reach is not
    QCOMPARE(document.state().agent, jumper);
    resizeAgent(document, jumper, AgentSize::Drop, 0);
    QVERIFY(text().find("DropFilter") == std::string::npos);
    QVERIFY(text().find("StepFilter 0.4") != std::string::npos);
    QVERIFY(!checkValue(parameterOf(AgentSize::Drop), -0.1).empty());
    QVERIFY(checkValue(parameterOf(AgentSize::Drop), 0).empty());
    QCOMPARE(rescaledAgents({{1, "Jumper", 2, 45, 0.4, 0.05, 0, 1.5}}, 1, 0.01)[0].drop, 150.0);
  }

  void stepsNeedAPlace() {
    const auto with = [](const std::string& filters) {
      Document document;
      document.reset(parsePipeline(filters, "test"), {});
      addAgent(document, {0, "Climber", 2, 45, 0.4, 0.05});
      const std::vector<AgentSize> missing = sizesWithoutEffect(document.state());
      const bool isTold = std::ranges::find(missing, AgentSize::Step) != missing.end();
      return formatPipeline(document.pipeline()) + (isTold ? "no effect" : "");
    };
    QCOMPARE(with("SlopeFilter 45\n"), std::string("SlopeFilter 45\nno effect"));
    QCOMPARE(with("#off VerticalClearanceFilter 2\n"), std::string("#off VerticalClearanceFilter 2\nno effect"));
    QCOMPARE(with("VerticalClearanceFilter 2\n#off StepFilter 1\n"),
             std::string("VerticalClearanceFilter 2\n#off StepFilter 0.4\nno effect"));
    QCOMPARE(with("AutoStrategy\nVerticalClearanceFilter 2\nCollapse\nSimplificationFilter true 0.001\n"),
             std::string("AutoStrategy\nVerticalClearanceFilter 2\nCollapse\nSimplificationFilter true 0.001\n"
                         "StepFilter 0.4\n"));
  }

  void presetsClimbWhatTheySay() {
    for (const double metresPerUnit : {1.0, 0.01}) {
      for (const AgentPreset& preset : agentPresets(metresPerUnit)) {
        for (const AgentSize size : {AgentSize::Height, AgentSize::MaxSlope, AgentSize::Step, AgentSize::Radius}) {
          const double value = sizeOf(preset.agent, size);
          QVERIFY(checkValue(parameterOf(size), value).empty());
          const double shown = size == AgentSize::MaxSlope ? value : value * metresPerUnit;
          QVERIFY2(preset.help.contains(QString::number(shown)), qPrintable(preset.help));
        }
      }
    }
    QCOMPARE(agentPresets(0.01).front().agent.step, 22.0);
    QVERIFY(!checkValue(parameterOf(AgentSize::Height), 0).empty());
    QVERIFY(checkValue(parameterOf(AgentSize::Step), 0).empty());
    QVERIFY(!checkValue(parameterOf(AgentSize::Step), -0.1).empty());
  }

  void theDefaultPipelineRunsInParallel() {
    Document document;
    document.reset(defaultPipeline(Environment{}), {});
    QVERIFY(document.addParallelBlock());
    const std::string text = formatPipeline(document.pipeline());
    QVERIFY(text.find("Collapse\nStepFilter 0.4\n") != std::string::npos);
    QVERIFY(parsePipeline(text, "test") == document.pipeline());
  }

  void fragmentsNeedNotBeWhole() {
    QCOMPARE(parsePipelineFragment("GridStrategy 1 1\nSlopeFilter 45\n", "clipboard").steps.size(), std::size_t{2});
    QCOMPARE(parsePipelineFragment("Collapse\r\n#off AreaFilter 2", "clipboard").steps.size(), std::size_t{2});
    QVERIFY_THROWS_EXCEPTION(InputError, parsePipelineFragment("SlopeFilter 45\nSlopeFilter x", "clipboard"));
    QVERIFY_THROWS_EXCEPTION(InputError, parsePipeline("Collapse\n", "file"));
  }

  void timesLeftFollowWhatIsKnown() {
    QVERIFY(!remainingMs({{std::nullopt, 0, 0, false}}).has_value());
    // The same as before: 100 of 300 are gone.
    QCOMPARE(*remainingMs({{100, 100, 1, true}, {200, 0, 0, false}}), 200.0);
    // The estimate follows its own pace: a quarter took 50.
    QCOMPARE(*remainingMs({{std::nullopt, 50, 0.25, false}}), 150.0);
    // Slower than before: at half of it, half of each.
    QCOMPARE(*remainingMs({{100, 100, 0.5, false}}), 50.0);
    // A step that never ran takes as long as the others on average.
    QCOMPARE(*remainingMs({{100, 100, 1, true}, {std::nullopt, 0, 0, false}}), 100.0);
    QCOMPARE(expectedMs({{100, 0, 0, false}, {std::nullopt, 0, 0, false}}), 100.0);
  }

  void onlyDefaultsFollowTheScale() {
    const Pipeline pipeline =
        parsePipeline("VerticalClearanceFilter 2\nVerticalClearanceFilter 1.8\nAreaFilter 1\n", "test");
    const Pipeline rescaled = rescaleDefaults(pipeline, 1, 0.05);
    QCOMPARE(rescaled.steps[0].values[0], 40.0);
    QCOMPARE(rescaled.steps[1].values[0], 1.8);
    QCOMPARE(rescaled.steps[2].values[0], 400.0);
    QCOMPARE(rescaleDefaults(rescaled, 0.05, 1), pipeline);
  }

  void numbersAreTakenAsTyped() {
    QCOMPARE(parseNumber("0.1").value(), 0.1);
    QCOMPARE(parseNumber(" 1e-3 ").value(), 1e-3);
    QCOMPARE(parseNumber("+5").value(), 5.0);
    QCOMPARE(parseNumber("122000.123456789").value(), 122000.123456789);
    for (const char* text : {"", "abc", "1,5", "1.5m", "0x10", "--1", "+-1"}) QVERIFY2(!parseNumber(text), text);
  }

  void sessionsKeepEveryNumber() {
    const QTemporaryDir folder;
    Session session;
    session.environment = folder.filePath("level.obj").toStdString();
    session.import.up = UpAxis::Y;
    session.import.metresPerUnit = 0.1;
    session.import.bothSides = true;
    session.pipeline = parsePipeline("#off SlopeFilter 44.99999999999999\nSimplificationFilter true 1e-7\n", "test");
    session.camera = CameraPose{{122000.123, 487000.456, 7}, {1.0 / 3, 2, 3}, {0, 0.6, 0, 0.8}, true};
    const std::string path = folder.filePath("a.footfall").toStdString();
    const std::string text = formatSession(session, path);
    writeFile(folder, "a.footfall", QByteArray::fromStdString(text));
    QVERIFY(isSessionFile(path));
    const Session back = readSession(path);
    QCOMPARE(back.environment, session.environment);
    QVERIFY(sameImport(back.import, session.import));
    QCOMPARE(back.pipeline, session.pipeline);
    QVERIFY(back.camera->position == session.camera->position && back.camera->pivot == session.camera->pivot);
    QCOMPARE(back.camera->orientation, session.camera->orientation);
    QCOMPARE(formatSession(back, path), text);
  }

  void sessionsKeepTheGrid() {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.footfall").toStdString();
    for (const GridChoice choice : {GridChoice::Auto, GridChoice::On, GridChoice::Off, GridChoice::Step}) {
      Session session;
      session.import.grid = choice;
      session.import.gridStep = choice == GridChoice::Step ? 0.003 : 0;
      session.import.keptGridStep = 0x1p-21;
      writeFile(folder, "a.footfall", QByteArray::fromStdString(formatSession(session, path)));
      const Session back = readSession(path);
      QVERIFY(sameImport(back.import, session.import));
      QCOMPARE(back.import.keptGridStep, 0x1p-21);
    }
    const QByteArray wrong("{\"footfall_session\": 1, \"import\": {\"grid\": \"fine\"}, \"pipeline\": []}");
    const std::string bad = writeFile(folder, "bad.footfall", wrong).toStdString();
    QVERIFY_EXCEPTION_THROWN(readSession(bad), InputError);
  }

  void sessionsKeepEveryUpAxis() {
    const QTemporaryDir folder;
    for (const UpAxis up : kUpAxes) {
      Session session;
      session.import.up = up;
      const std::string path = folder.filePath("a.footfall").toStdString();
      writeFile(folder, "a.footfall", QByteArray::fromStdString(formatSession(session, path)));
      QVERIFY(readSession(path).import.up == up);
    }
    const QByteArray wrong("{\"footfall_session\": 1, \"import\": {\"up\": \"w\"}, \"pipeline\": []}");
    const std::string path = writeFile(folder, "bad.footfall", wrong).toStdString();
    QVERIFY_EXCEPTION_THROWN(readSession(path), InputError);
  }

  void agentsOfOldSessionsClimbNoSteps() {
    const QTemporaryDir folder;
    const QByteArray old(
        "{\"footfall_session\": 1, \"pipeline\": [{\"filter\": \"SlopeFilter\", \"parameters\": {\"max_slope\": 45}}], "
        "\"agents\": [{\"name\": \"A\", \"height\": 2, \"max_slope\": 45}], \"agent\": 1}");
    const Session session = readSession(writeFile(folder, "old.footfall", old).toStdString());
    QCOMPARE(session.agents, (std::vector<NamedAgent>{{1, "A", 2, 45, 0, 0.05}}));
    Document document;
    DocumentState rest;
    rest.agents = session.agents;
    rest.agent = session.agent;
    document.reset(session.pipeline, {}, rest);
    QCOMPARE(document.state().agent, 1);  // its filters have its sizes
    QCOMPARE(formatPipeline(document.pipeline()), std::string("SlopeFilter 45\n"));
  }

  void agentsOfOldSessionsHaveTheFiltersSizes() {
    const QTemporaryDir folder;
    const QByteArray old(
        "{\"footfall_session\": 1, \"pipeline\": ["
        "{\"filter\": \"SlopeFilter\", \"parameters\": {\"max_slope\": 45}}, "
        "{\"filter\": \"VerticalClearanceFilter\", \"parameters\": {\"height\": 2}}, "
        "{\"filter\": \"StepFilter\", \"parameters\": {\"step\": 0.25, \"gap\": 0.125}}, "
        "{\"filter\": \"RadiusFilter\", \"parameters\": {\"radius\": 0.75}}, "
        "{\"filter\": \"DropFilter\", \"enabled\": false, \"parameters\": {\"depth\": 3}}], "
        "\"agents\": [{\"name\": \"A\", \"height\": 2, \"max_slope\": 45}, "
        "{\"name\": \"B\", \"height\": 2, \"max_slope\": 45, \"step\": 0, \"radius\": 0.5}], \"agent\": 1}");
    const Session session = readSession(writeFile(folder, "old.footfall", old).toStdString());
    QCOMPARE(session.agents,
             (std::vector<NamedAgent>{{1, "A", 2, 45, 0.25, 0.125, 0.75, 0}, {2, "B", 2, 45, 0, 0.125, 0.5, 0}}));
    QCOMPARE(session.pipeline.steps[3].values[1], 0.75);  // the ledges follow the radius
    Document document;
    DocumentState rest;
    rest.agents = session.agents;
    rest.agent = session.agent;
    document.reset(session.pipeline, {}, rest);
    QCOMPARE(document.state().agent, 1);
    QCOMPARE(formatPipeline(document.pipeline()), formatPipeline(session.pipeline));
    activateAgent(document, 2);
    activateAgent(document, 1);
    QCOMPARE(formatPipeline(document.pipeline()), formatPipeline(session.pipeline));
  }

  void draggingPastAValueLeavesIt() {
    for (const bool withAgent : {false, true}) {
      Document document;
      document.reset(
          parsePipeline("SlopeFilter 45\nVerticalClearanceFilter 2\nRadiusFilter 0.5 0.25\nRadiusFilter 0.5 0.25\n",
                        "test"),
          {});
      if (withAgent) addAgent(document, agentOfFilters(document.state(), 1));
      const auto values = [&](std::size_t row) -> const std::vector<double>& {
        return document.filters()[row].step.values;
      };
      const int id = document.filters()[2].id, edits = document.undoStack()->count();
      for (const double radius : {0.5, 0.375, 0.25, 0.125}) document.setValue(id, 0, radius, 1);
      QCOMPARE(values(2), (std::vector<double>{0.125, 0.25, 0.01}));
      QCOMPARE(values(3), (std::vector<double>{withAgent ? 0.125 : 0.5, 0.25, 0.01}));
      QCOMPARE(document.undoStack()->count(), edits + 1);
      // Left where both are the same, and dragged on: now they go together.
      document.setValue(id, 0, 0.25, 1);
      for (const double radius : {0.375, 0.75}) document.setValue(id, 0, radius, 2);
      QCOMPARE(values(2), (std::vector<double>{0.75, 0.75, 0.01}));
      document.undoStack()->undo();
      QCOMPARE(values(2), (std::vector<double>{0.25, 0.25, 0.01}));
      document.undoStack()->undo();
      QCOMPARE(values(2), (std::vector<double>{0.5, 0.25, 0.01}));
      QCOMPARE(document.state().agent != 0, withAgent);
    }
  }

  void badSessionsAreOneLineWithTheFile_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("broken") << QByteArray("{\"footfall_session\": 1,");
    QTest::newRow("no session") << QByteArray("{}");
    QTest::newRow("newer") << QByteArray("{\"footfall_session\": 2, \"pipeline\": []}");
    QTest::newRow("no pipeline") << QByteArray("{\"footfall_session\": 1}");
    QTest::newRow("unknown filter") << QByteArray(
        "{\"footfall_session\": 1, \"pipeline\": [{\"filter\": \"NoFilter\"}]}");
    QTest::newRow("out of range") << QByteArray(
        "{\"footfall_session\": 1, \"pipeline\": [{\"filter\": \"SlopeFilter\", \"parameters\": {\"max_slope\": "
        "90}}]}");
    QTest::newRow("half a seed") << QByteArray(
        "{\"footfall_session\": 1, \"pipeline\": [{\"filter\": \"ReachableFilter\", \"parameters\": {\"seeds\": [[1, "
        "2]]}}]}");
    QTest::newRow("a seed without numbers") << QByteArray(
        "{\"footfall_session\": 1, \"pipeline\": [{\"filter\": \"ReachableFilter\", \"parameters\": {\"seeds\": [[1, "
        "2, "
        "\"z\"]]}}]}");
    QTest::newRow("no seeds") << QByteArray(
        "{\"footfall_session\": 1, \"pipeline\": [{\"filter\": \"ReachableFilter\", \"parameters\": {\"seeds\": 3}}]}");
    QTest::newRow("a coordinate") << QByteArray(
        "{\"footfall_session\": 1, \"pipeline\": [{\"filter\": \"ReachableFilter\", \"parameters\": {\"x\": 3}}]}");
    QTest::newRow("wrong type") << QByteArray("{\"footfall_session\": 1, \"pipeline\": 3}");
    QTest::newRow("bad scale") << QByteArray(
        "{\"footfall_session\": 1, \"import\": {\"metres_per_unit\": 0}, \"pipeline\": []}");
    QTest::newRow("step below 0") << QByteArray(
        "{\"footfall_session\": 1, \"pipeline\": [], \"agents\": [{\"name\": \"A\", \"height\": 2, \"max_slope\": 45, "
        "\"step\": -1}]}");
  }
  void badSessionsAreOneLineWithTheFile() {
    QFETCH(QByteArray, content);
    const QTemporaryDir folder;
    const std::string path = writeFile(folder, "bad.footfall", content).toStdString();
    try {
      readSession(path);
      QFAIL("a bad session was read");
    } catch (const InputError& error) {
      const QString message = error.what();
      QVERIFY2(message.startsWith(QString::fromStdString(path)), error.what());
      QVERIFY(!message.contains('\n'));
      QVERIFY2(message.contains("; "), error.what());
    }
  }

  void queuesDropOrFinishWhatIsLeft() {
    for (const auto atEnd : {BackgroundQueue::AtEnd::DropJobs, BackgroundQueue::AtEnd::FinishJobs}) {
      std::atomic<bool> go{false};
      std::atomic<int> done{0};
      std::thread opener;
      {
        BackgroundQueue queue(atEnd);
        std::atomic<bool> begun{false};
        queue.post([&] {
          begun = true;
          while (!go) std::this_thread::yield();
          ++done;
        });
        for (int i = 0; i < 5; ++i) queue.post([&] { ++done; });
        while (!begun) std::this_thread::yield();
        opener = std::thread([&] {
          std::this_thread::sleep_for(std::chrono::milliseconds(50));
          go = true;
        });
      }
      opener.join();
      QCOMPARE(done.load(), atEnd == BackgroundQueue::AtEnd::FinishJobs ? 6 : 1);
    }
  }
};

QTEST_GUILESS_MAIN(TestDocument)
#include "test_document.moc"
