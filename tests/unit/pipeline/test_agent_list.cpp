// Lists of agents, and the runs for several of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <memory>
#include <string>
#include <vector>

#include "footfall/agent_list.hpp"
#include "footfall/errors.hpp"
#include "footfall/io.hpp"
#include "footfall/report.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/soup.hpp"
#include "tests/unit/environment_files.hpp"

using namespace footfall;
using namespace footfall::test;

namespace {

/// The bytes of a result as an OBJ.
QByteArray bytesOf(const NavigationMesh& mesh, const Pipeline& pipeline) {
  const TemporaryFolder folder;
  const std::string file = folder.path("out.obj");
  save(mesh, file, {}, makeExportHeader(pipeline));
  return readAll(file);
}

std::shared_ptr<const Environment> house() {
  return std::make_shared<const Environment>(load(FOOTFALL_SOURCE_DIR "/samples/house/house.obj"));
}

const std::vector<Agent> kAgents{{}, {.radius = 0.3}, {.maxSlope = 20, .height = 1.2}, {.radius = 0.4, .drop = 1}, {}};

}  // namespace

class TestAgentList : public QObject {
  Q_OBJECT

 private slots:
  void eachResultHasTheBytesOfARunOfItsOwn() {
    const auto level = house();
    RunContext context;
    const std::vector<AgentRun> runs = runAgents(level, kAgents, context);
    QCOMPARE(runs.size(), kAgents.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
      RunContext alone;
      const Pipeline pipeline = pipelineFor(*level, kAgents[i]);
      const RunResult expected = runPipeline(level, pipeline, alone);
      QVERIFY(runs[i].pipeline == pipeline);
      QVERIFY(!expected.mesh->triangles.empty());
      QCOMPARE(bytesOf(*runs[i].result.mesh, runs[i].pipeline), bytesOf(*expected.mesh, pipeline));
    }
    // The first agent computes everything. The second one differs from the radius on, and the last one in nothing.
    QCOMPARE(computedSteps(runs[0].result), runs[0].result.steps.size());
    QVERIFY(computedSteps(runs[1].result) > 0);
    QVERIFY(computedSteps(runs[1].result) < runs[1].result.steps.size());
    QCOMPARE(computedSteps(runs[4].result), std::size_t{0});
    // The first five steps, up to the StepFilter, are those of the first agent, although another one ran meanwhile.
    QCOMPARE(computedSteps(runs[3].result), runs[3].result.steps.size() - 5);
  }

  void manyAgentsStillShareTheirFirstSteps() {
    // Each agent has states of its own, and together they are more than a ResultCache keeps by default.
    const auto level = Soup().floor(0, 0, 20, 20, 0).environment();
    std::vector<Agent> agents;
    for (int i = 0; i < 30; ++i) agents.push_back({.height = 1 + i / 100.0});
    agents.push_back(agents.front());
    RunContext context;
    QCOMPARE(computedSteps(runAgents(level, agents, context).back().result), std::size_t{0});
  }

  void eventsComeInOrder() {
    const auto level = Soup().floor(0, 0, 4, 4, 0).environment();
    std::vector<std::string> seen;
    AgentRunEvents events;
    events.started = [&](std::size_t agent, const Pipeline& pipeline) {
      seen.push_back("start " + std::to_string(agent) + " of " + std::to_string(pipeline.steps.size()));
    };
    events.finished = [&](std::size_t agent, const AgentRun& run) {
      seen.push_back("end " + std::to_string(agent) + " with " + std::to_string(run.result.steps.size()));
    };
    RunContext context;
    runAgents(level, std::vector<Agent>{{}, {.step = 0}}, context, events);
    const std::string all = std::to_string(pipelineFor(*level).steps.size());
    const std::string fewer = std::to_string(pipelineFor(*level, {.step = 0}).steps.size());
    QCOMPARE(seen, (std::vector<std::string>{"start 0 of " + all, "end 0 with " + all, "start 1 of " + fewer,
                                             "end 1 with " + fewer}));
  }

  void exportsStateTheAgent() {
    const auto agentOf = [](const Agent& agent) { return makeExportHeader(pipelineFor({}, agent)).agent; };
    QCOMPARE(agentOf({}), std::string("slope 45 degrees, height 2, step 0.4, gap 0.05"));
    QCOMPARE(agentOf({.step = 0}), std::string("slope 45 degrees, height 2"));
    QCOMPARE(agentOf({.gap = 0, .radius = 0.3}), std::string("slope 45 degrees, height 2, step 0.4, radius 0.3"));
    QCOMPARE(makeExportHeader({}).agent, std::string("slope any, height any"));
  }

  void aCancelledContextEndsAllRuns() {
    RunContext context;
    context.cancel();
    QVERIFY_THROWS_EXCEPTION(Cancelled, runAgents(house(), kAgents, context));
  }

  void aWrongNumberIsRefusedBeforeTheFirstRun() {
    bool hasStarted = false;
    AgentRunEvents events;
    events.started = [&](std::size_t, const Pipeline&) { hasStarted = true; };
    RunContext context;
    const std::string message = messageOf([&] {
      runAgents(house(), std::vector<Agent>{{}, {.height = -1}}, context, events);
    });
    QVERIFY2(message.find("agents[1]: agent: ") == 0, message.c_str());
    QVERIFY(!hasStarted);
  }

  void listsAreReadByNameAndFromFiles() {
    const std::vector<ListedAgent> named = readAgents("human,Wheelchair", 1);
    QCOMPARE(named.size(), std::size_t{2});
    QCOMPARE(named[0].name, std::string("Human"));
    QVERIFY(named[1].agent == knownAgents()[2].agent);
    QVERIFY(messageOf([] { readAgents("Human,crew.json", 1); }).find("'crew.json'; give a file, or some of Human") !=
            std::string::npos);

    const TemporaryFolder folder;
    const std::string file = folder.write("crew.json", R"([{"name": "cart", "radius": 50, "minimum_area": 20000}])");
    const std::vector<ListedAgent> read = readAgents(file, 0.01);
    QVERIFY(read == (std::vector<ListedAgent>{{"cart", {.minimumArea = 2, .radius = 0.5}}}));
    const std::string wrong = folder.write("wrong.json", R"({"agents": [{"name": "cart", "radius": -1}]})");
    QVERIFY(messageOf([&] { readAgents(wrong, 1); }).find(wrong + ": agents: 'cart': agent: ") == 0);
  }
};

QTEST_GUILESS_MAIN(TestAgentList)
#include "test_agent_list.moc"
