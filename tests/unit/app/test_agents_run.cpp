// `footfall run --agents`, run as a user does.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

#include "footfall/agent.hpp"
#include "footfall/pipeline.hpp"
#include "tests/unit/environment_files.hpp"
#include "tests/unit/program_run.hpp"

using namespace footfall;
using namespace footfall::test;

namespace {

// Y up: two rooms of 4 by 4 with a passage between them that is 1 wide and 2 long.
const QByteArray kRooms =
    "v 0 1 0\nv 4 1 0\nv 4 1 -4\nv 0 1 -4\nf 1 2 3 4\n"
    "v 4 1 -1.5\nv 6 1 -1.5\nv 6 1 -2.5\nv 4 1 -2.5\nf 5 6 7 8\n"
    "v 6 1 0\nv 10 1 0\nv 10 1 -4\nv 6 1 -4\nf 9 10 11 12\n";

QStringList runOf(const std::string& file, const QStringList& rest) {
  return QStringList{"run", QString::fromStdString(file), "--up", "y", "--scale", "1"} + rest;
}

Agent agentNamed(std::string_view name) {
  for (const KnownAgent& known : knownAgents())
    if (known.name == name) return known.agent;
  return {};
}

/// A run of its own of the pipeline for an agent.
QByteArray runAlone(const TemporaryFolder& folder, const std::string& file, const Agent& agent) {
  const auto environment = importEnvironment(file, {.up = UpAxis::Y, .metresPerUnit = 1.0});
  const std::string pipeline =
      folder.write("alone.pipeline", QByteArray::fromStdString(formatPipeline(pipelineFor(*environment, agent))));
  const std::string out = folder.path("alone.obj");
  const Outcome outcome =
      runProgram(runOf(file, {"-p", QString::fromStdString(pipeline), "--quiet", "-o", QString::fromStdString(out)}));
  return outcome.exitCode == 0 ? readAll(out) : QByteArray();
}

}  // namespace

class TestAgentsRun : public QObject {
  Q_OBJECT

 private slots:
  void writesAResultForEach() {
    const TemporaryFolder folder;
    const std::string file = folder.write("rooms.obj", kRooms), stats = folder.path("stats.json");
    const Outcome outcome =
        runProgram(runOf(file, {"--agents", "Human,wheelchair", "-o", QString::fromStdString(folder.path("out.obj")),
                                "--stats", QString::fromStdString(stats)}));
    QCOMPARE(outcome.exitCode, 0);
    QVERIFY2(outcome.out.startsWith("Human: slope "), outcome.out.constData());
    QVERIFY2(outcome.out.contains("\nWheelchair: slope "), outcome.out.constData());
    QVERIFY2(outcome.out.contains(", radius 0.38; area "), outcome.out.constData());
    for (const auto& [name, output] : {std::pair{"Human", "out-human.obj"}, {"Wheelchair", "out-wheelchair.obj"}}) {
      const QByteArray expected = runAlone(folder, file, agentNamed(name));
      QVERIFY(!expected.isEmpty());
      QCOMPARE(readAll(folder.path(output)), expected);
    }
    const QJsonArray agents = QJsonDocument::fromJson(readAll(stats)).object()["agents"].toArray();
    QCOMPARE(agents.size(), 2);
    QCOMPARE(agents[1].toObject()["name"].toString(), QString("Wheelchair"));
    // What both have in common is computed once.
    QVERIFY(agents[1].toObject()["computed_steps"].toInt() < agents[0].toObject()["computed_steps"].toInt());
    QVERIFY(agents[1].toObject()["statistics"].toObject().contains("components"));
  }

  void readsFiles() {
    const TemporaryFolder folder;
    const std::string file = folder.write("rooms.obj", kRooms);
    const QByteArray agents =
        R"([{"name": "thin", "radius": 0.2}, {"name": "Fork lift", "radius": 0.6, "height": 2.5, "max_slope": 10}])";
    const QString out = QString::fromStdString(folder.path("out.obj"));
    for (const QByteArray& text : {agents, QByteArray("{\"filters\": [], \"agents\": " + agents + "}")}) {
      const std::string list = folder.write("agents.json", text);
      const Outcome outcome = runProgram(runOf(file, {"--agents", QString::fromStdString(list), "-o", out}));
      QCOMPARE(outcome.err, QByteArray());
      QCOMPARE(outcome.exitCode, 0);
      QCOMPARE(readAll(folder.path("out-thin.obj")), runAlone(folder, file, {.radius = 0.2}));
      QCOMPARE(readAll(folder.path("out-fork-lift.obj")),
               runAlone(folder, file, {.maxSlope = 10, .height = 2.5, .radius = 0.6}));
    }
  }

  void refusesWhatIsNoAgent() {
    const TemporaryFolder folder;
    const std::string file = folder.write("rooms.obj", kRooms);
    const auto refused = [&](const QStringList& rest) {
      const Outcome outcome = runProgram(runOf(file, rest));
      return outcome.exitCode == 2 ? outcome.err : QByteArray();
    };
    QVERIFY(refused({"--agents", "Human,Nobody"}).contains("'Nobody'; give a file, or some of Human"));
    const auto list = [&](const QByteArray& text) { return QString::fromStdString(folder.write("agents.json", text)); };
    QVERIFY(refused({"--agents", list("[]")}).contains("holds no agents"));
    QVERIFY(refused({"--agents", list("no JSON")}).contains("holds no agents"));
    QVERIFY(refused({"--agents", list("[{\"height\": 2}]")}).contains("an object with a name"));
    QVERIFY(refused({"--agents", list("[{\"name\": \"a\", \"height\": \"tall\"}]")}).contains("'a': height"));
    QVERIFY(refused({"--agents", list("[{\"name\": \"a\", \"radius\": -1}]")}).contains("'a': "));
    QVERIFY(refused({"--agents", list("[{\"name\": \"a\"}, {\"name\": \"A\"}]")}).contains("two agents have the name"));
    QVERIFY(refused({"--agents", "Human", "--filter", "SlopeFilter 45"}).contains("--agents"));
  }
};

QTEST_GUILESS_MAIN(TestAgentsRun)
#include "test_agents_run.moc"
