// `footfall why` as a user meets it: words, JSON and bad input.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTemporaryDir>
#include <QtTest>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "tests/unit/program_run.hpp"

using namespace footfall::test;

namespace {

Outcome footfallWhy(const QStringList& arguments) { return runProgram(QStringList("why") + arguments); }

// A floor of 12 by 6; over its left third a slab at 1.5 that faces down; Z up and Y up.
constexpr const char* kZUp =
    "v 0 0 0\nv 12 0 0\nv 12 6 0\nv 0 6 0\nv 0 0 1.5\nv 4 0 1.5\nv 4 6 1.5\nv 0 6 1.5\n"
    "f 1 2 3\nf 1 3 4\nf 5 7 6\nf 5 8 7\n";
constexpr const char* kYUp =
    "v 0 0 0\nv 12 0 0\nv 12 0 -6\nv 0 0 -6\nv 0 1.5 0\nv 4 1.5 0\nv 4 1.5 -6\nv 0 1.5 -6\n"
    "f 1 2 3\nf 1 3 4\nf 5 7 6\nf 5 8 7\n";

}  // namespace

class TestWhyCommand : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    QVERIFY(folder_->isValid());
    write(path("z.obj"), kZUp);
    write(path("y.obj"), kYUp);
  }

  void help() {
    const Outcome outcome = footfallWhy({"--help"});
    QCOMPARE(outcome.exitCode, 0);
    for (const char* word :
         {"--at", "--from", "--to", "-p", "--filter", "--up", "--scale", "--both-sides", "--threads", "--json"})
      QVERIFY2(outcome.out.contains(word), word);
    QVERIFY(runProgram({"--help"}).out.contains("why"));
  }

  void walkable() {
    const Outcome outcome = footfallWhy({path("z.obj"), "--up", "z", "--at", "8", "3", "0"});
    QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
    QVERIFY(outcome.err.isEmpty());
    QVERIFY2(outcome.out.contains("8 3 0 on triangle ") && outcome.out.contains("walkable, layer 0, component 1 of 1"),
             outcome.out.constData());
    QVERIFY(outcome.out.contains("slope: 0 degrees") && outcome.out.contains("unlimited"));
    QVERIFY(!outcome.out.contains("not walkable") && !outcome.out.contains("rejected"));
  }

  void rejected() {
    for (const QStringList& arguments : {QStringList{path("z.obj"), "--up", "z", "--at", "1", "3", "0.5"},
                                         QStringList{path("y.obj"), "--up", "y", "--at", "1", "0.5", "-3"}}) {
      const Outcome outcome =
          footfallWhy(arguments + QStringList{"--filter", "SlopeFilter 45", "--filter", "VerticalClearanceFilter 2"});
      QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
      QVERIFY2(outcome.out.contains("not walkable: too low. Triangle ") &&
                   outcome.out.contains(" is 1.5 above it; agents need 2."),
               outcome.out.constData());
      QVERIFY(outcome.out.contains("rejected by step 2: VerticalClearanceFilter 2"));
      QVERIFY(outcome.out.startsWith(arguments[2] == "z" ? "1 3 0 on " : "1 0 -3 on "));
    }
  }

  void aGapBetweenCorners() {
    write(path("corners.obj"),
          "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nf 1 2 3 4\n"
          "v 4.03 4.03 0.125\nv 8 4.03 0.125\nv 8 8 0.125\nv 4.03 8 0.125\nf 5 6 7 8\n");
    const auto why = [&](const QString& gap) {
      return footfallWhy({path("corners.obj"), "--up", "z", "--filter", "VerticalClearanceFilter 2", "--filter",
                          "StepFilter 0.25 " + gap, "--from", "1", "1", "0", "--to", "7", "7", "0.125"});
    };
    const Outcome linked = why("0.05"), apart = why("0.04");
    QVERIFY2(linked.exitCode == 0 && apart.exitCode == 0, apart.err.constData());
    QVERIFY2(linked.out.contains("a way leads from the start to the target"), linked.out.constData());
    QVERIFY2(apart.out.contains("at 4 4 0: a gap of 0.042426 and a step of 0.125 up, 0.002426 too wide"),
             apart.out.constData());
  }

  void pipelineFile() {
    write(path("p.pipeline"), "SlopeFilter 45\nVerticalClearanceFilter 1\nAreaFilter 100\n");
    const Outcome outcome = footfallWhy({"--at", "1", "3", "0", "-p", path("p.pipeline"), path("z.obj"), "--up", "z"});
    QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
    QVERIFY2(outcome.out.contains("has an area of 72") && outcome.out.contains("AreaFilter 100"),
             outcome.out.constData());
  }

  void json() {
    const Outcome low = footfallWhy({path("y.obj"), "--up", "y", "--at", "1", "0", "-3", "--json"});
    QVERIFY2(low.exitCode == 0, low.err.constData());
    const auto object = nlohmann::json::parse(low.out.toStdString());
    QCOMPARE(object["verdict"].get<std::string>(), std::string("too_low"));
    QCOMPARE(object["walkable"].get<bool>(), false);
    QCOMPARE(object["filter"].get<std::string>(), std::string("VerticalClearanceFilter"));
    QCOMPARE(object["step"].get<int>(), 4);
    QCOMPARE(object["obstacle_height"].get<double>(), 1.5);
    QVERIFY(object["obstacle"].get<int>() >= 2);
    QVERIFY((object["point"].get<std::vector<double>>() == std::vector<double>{1, 0, -3}));
    QVERIFY(object["layer"].is_null() && object["component"].is_null());
    const Outcome free = footfallWhy({path("z.obj"), "--up", "z", "--at", "8", "3", "99", "--json"});
    const auto place = nlohmann::json::parse(free.out.toStdString());
    QCOMPARE(place["walkable"].get<bool>(), true);
    QCOMPARE(place["component"].get<int>(), 1);
    QVERIFY(place["headroom"].is_null() && place["step"].is_null());
  }

  // Two floors with a step of 0.5 and its riser between them.
  void pairOfPlaces() {
    write(path("step.obj"),
          "v 0 0 0\nv 6 0 0\nv 6 6 0\nv 0 6 0\nv 6 0 0.5\nv 12 0 0.5\nv 12 6 0.5\nv 6 6 0.5\n"
          "f 1 2 3 4\nf 5 6 7 8\nf 2 5 8 3\n");
    const auto ask = [&](const char* step, const QStringList& more = {}) {
      return footfallWhy(QStringList{path("step.obj"), "--up", "z", "--from", "1", "3", "0", "--to", "11", "3", "0.5",
                                     "--filter", "SlopeFilter 45", "--filter", "VerticalClearanceFilter 2", "--filter",
                                     step} +
                         more);
    };
    const Outcome low = ask("StepFilter 0.4");
    QVERIFY2(low.exitCode == 0 && low.err.isEmpty(), low.err.constData());
    QVERIFY2(low.out.startsWith("no way leads from the start to the target") &&
                 low.out.contains("the least that is missing, at 6 3 0: a step of 0.5 up, 0.1 too high; triangle "),
             low.out.constData());
    QVERIFY2(!low.out.contains("more way"), low.out.constData());
    const Outcome high = ask("StepFilter 0.5");
    QVERIFY2(high.exitCode == 0 && high.out.startsWith("a way leads from the start to the target\n"),
             high.out.constData());
    QVERIFY(high.out.contains("steps    1;"));
    const auto json = nlohmann::json::parse(ask("StepFilter 0.4", {"--json"}).out.toStdString());
    QCOMPARE(json["status"].get<std::string>(), std::string("not_connected"));
    const auto& link = json["separation"]["links"][0];
    QVERIFY(json["separation"]["step"] == 0.4 && json["separation"]["height"] == 2.0);
    QVERIFY(std::fabs(link["excess"].get<double>() - 0.1) < 1e-15);
    QVERIFY((link["triangles"].get<std::vector<int>>() == std::vector<int>{4, 5}));
    QVERIFY(json["separation"]["others"].empty());
  }

  void pairWithoutAFloor() {
    const QStringList common{"--filter", "SlopeFilter 45", "--filter", "VerticalClearanceFilter 2"};
    const Outcome start =
        footfallWhy(QStringList{path("z.obj"), "--up", "z", "--from", "1", "3", "0", "--to", "8", "3", "0"} + common);
    QVERIFY2(
        start.exitCode == 0 && start.out.startsWith("the start is not walkable; the nearest place that is lies 3 away"),
        start.out.constData());
    QVERIFY(start.out.contains("`footfall why --at` explains why the start"));
    const Outcome target =
        footfallWhy(QStringList{path("z.obj"), "--up", "z", "--from", "8", "3", "0", "--to", "1", "3", "0"} + common);
    QVERIFY2(target.out.startsWith("the target is not walkable") && target.out.contains("explains why the target"),
             target.out.constData());
  }

  void badInput_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("message");
    QTest::newRow("no place") << QStringList{"z.obj"} << "--at is required";
    QTest::newRow("no target") << QStringList{"z.obj", "--from", "1", "2", "0"} << "--from requires --to";
    QTest::newRow("no start") << QStringList{"z.obj", "--to", "1", "2", "0"} << "--to requires --from";
    QTest::newRow("place and pair") << QStringList{"z.obj", "--at", "1",    "2", "0", "--from", "1",
                                                   "2",     "0",    "--to", "1", "2", "0"}
                                    << "--at excludes --";
    QTest::newRow("nan among two") << QStringList{"z.obj", "--from", "1", "nan", "0", "--to", "1", "2", "0"}
                                   << "--from: takes three finite numbers";
    QTest::newRow("two numbers") << QStringList{"z.obj", "--at", "1", "2"} << "--at";
    QTest::newRow("no number") << QStringList{"z.obj", "--at", "1", "2", "up"} << "--at";
    QTest::newRow("nan") << QStringList{"z.obj", "--at", "1", "nan", "0"} << "three finite numbers";
    QTest::newRow("infinite") << QStringList{"z.obj", "--at", "1", "2", "inf"} << "three finite numbers";
    QTest::newRow("outside") << QStringList{"z.obj", "--up", "z", "--at", "-1", "2", "0"} << "nothing is at or under";
    QTest::newRow("below") << QStringList{"z.obj", "--up", "z", "--at", "1", "2", "-1"}
                           << "goes from 0 0 0 to 12 6 1.5";
    QTest::newRow("no file") << QStringList{"none.obj", "--at", "1", "2", "0"} << "none.obj";
    QTest::newRow("filter") << QStringList{"z.obj", "--at", "1", "2", "0", "--filter", "Slope"} << "unknown filter";
  }
  void badInput() {
    QFETCH(QStringList, arguments);
    QFETCH(QString, message);
    arguments[0] = path(arguments[0]);
    const Outcome outcome = footfallWhy(arguments);
    QCOMPARE(outcome.exitCode, 2);
    QVERIFY(outcome.out.isEmpty() && !outcome.crashed);
    QVERIFY2(outcome.err.contains(message.toUtf8()), outcome.err.constData());
    QCOMPARE(outcome.err.count('\n'), 1);
  }

 private:
  [[nodiscard]] QString path(const QString& name) const { return folder_->filePath(name); }

  std::unique_ptr<QTemporaryDir> folder_;
};

QTEST_APPLESS_MAIN(TestWhyCommand)
#include "test_why_command.moc"
