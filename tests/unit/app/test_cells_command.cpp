// `footfall cells` as a user meets it: the table, JSON, the cut environment and bad input.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "core/io/import.hpp"
#include "footfall/environment.hpp"
#include "tests/unit/program_run.hpp"

using namespace footfall::test;

namespace {

Outcome footfallCells(const QStringList& arguments) { return runProgram(QStringList("cells") + arguments); }

// A floor of 12 by 6, and a wall across its middle.
constexpr const char* kFloorZUp =
    "v 0 0 0\nv 12 0 0\nv 12 6 0\nv 0 6 0\nv 0 3 0\nv 12 3 0\nv 12 3 2\nv 0 3 2\n"
    "f 1 2 3\nf 1 3 4\nf 5 6 7\nf 5 7 8\n";
// The same with Y up.
constexpr const char* kFloorYUp =
    "v 0 0 0\nv 12 0 0\nv 12 0 -6\nv 0 0 -6\nv 0 0 -3\nv 12 0 -3\nv 12 2 -3\nv 0 2 -3\n"
    "f 1 2 3\nf 1 3 4\nf 5 6 7\nf 5 7 8\n";

/// Area of each group of an OBJ file with triangles.
std::map<std::string, double> areasOf(const QByteArray& obj) {
  std::vector<std::array<double, 3>> vertices;
  std::map<std::string, double> areas;
  std::string group;
  for (const QByteArray& line : obj.split('\n')) {
    const QList<QByteArray> words = line.split(' ');
    if (words[0] == "g") areas[group = words[1].toStdString()] += 0;
    if (words[0] == "v") vertices.push_back({words[1].toDouble(), words[2].toDouble(), words[3].toDouble()});
    if (words[0] != "f") continue;
    std::array<std::array<double, 3>, 2> side{};
    for (int k = 0; k < 3; ++k)
      for (int s = 0; s < 2; ++s)
        side[s][k] = vertices.at(words[2 + s].toUInt() - 1)[k] - vertices.at(words[1].toUInt() - 1)[k];
    double square = 0;
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      square += std::pow(side[0][i] * side[1][j] - side[0][j] * side[1][i], 2);
    }
    areas[group] += std::sqrt(square) / 2;
  }
  return areas;
}

}  // namespace

class TestCellsCommand : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    QVERIFY(folder_->isValid());
    write(path("z.obj"), kFloorZUp);
    write(path("y.obj"), kFloorYUp);
  }

  void help() {
    const Outcome outcome = footfallCells({"--help"});
    QCOMPARE(outcome.exitCode, 0);
    for (const char* word :
         {"--strategy", "-p", "--filter", "--up", "--scale", "--both-sides", "--threads", "-o", "--json"})
      QVERIFY2(outcome.out.contains(word), word);
  }

  void table() {
    const Outcome outcome = footfallCells({path("z.obj"), "--up", "z", "--strategy", "GridStrategy 3 2"});
    QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
    QVERIFY(outcome.err.isEmpty());
    const QList<QByteArray> lines = outcome.out.split('\n');
    QVERIFY(QRegularExpression("^cell +x +y +z +floors +obstacles +cost$").match(lines[0]).hasMatch());
    QVERIFY2(outcome.out.contains("4 .. 8"), outcome.out.constData());
    QVERIFY(outcome.out.contains(".. 3") && outcome.out.contains("3 .."));
    QVERIFY(outcome.out.contains("6 cells by GridStrategy 3 2"));
    QVERIFY(!outcome.out.contains("why:"));
    QVERIFY(!QFile::exists(path("out.obj")));
  }

  void tableInTheFramesOfFiles() {
    const Outcome outcome = footfallCells({path("y.obj"), "--up", "y", "--strategy", "GridStrategy 1 3"});
    QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
    QVERIFY(QRegularExpression("^cell +x +z +y ").match(outcome.out).hasMatch());
    QVERIFY2(outcome.out.contains("-4 .. -2"), outcome.out.constData());
    // Numbered as people count, and as the editor does.
    QVERIFY(QRegularExpression("\n1 .*\n2 .*\n3 .*\n\n3 cells by ").match(outcome.out).hasMatch());
  }

  void autoSaysWhatItPicked() {
    const Outcome outcome = footfallCells({path("z.obj"), "--threads", "2"});
    QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
    QVERIFY2(outcome.out.contains("why: "), outcome.out.constData());
    QVERIFY(outcome.out.contains("on 2 threads"));
  }

  void strategyOfThePipeline() {
    write(path("p.pipeline"), "SlopeFilter 45\nRecursiveStrategy 1 1 true\nVerticalClearanceFilter 2\nCollapse\n");
    const Outcome own = footfallCells({path("z.obj"), "-p", path("p.pipeline")});
    QVERIFY2(own.exitCode == 0, own.err.constData());
    QVERIFY2(own.out.contains("4 cells by RecursiveStrategy 1 1 true"), own.out.constData());
    const Outcome other = footfallCells({path("z.obj"), "-p", path("p.pipeline"), "--strategy", "GridStrategy 2 1"});
    QVERIFY(other.out.contains("2 cells by GridStrategy 2 1"));
    const Outcome steps = footfallCells(
        {path("z.obj"), "--filter", "GridStrategy 1 2", "--filter", "SlopeFilter 45", "--filter", "Collapse"});
    QVERIFY(steps.out.contains("2 cells by GridStrategy 1 2"));
  }

  void json() {
    const Outcome outcome =
        footfallCells({path("y.obj"), "--up", "y", "--strategy", "GridStrategy 2 2", "--json", "-o", path("out.obj")});
    QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
    const auto json = nlohmann::json::parse(outcome.out.toStdString());
    QVERIFY(json.at("strategy") == "GridStrategy 2 2");
    QVERIFY(json.at("plan_axes") == (std::vector<std::string>{"x", "z"}));
    QVERIFY(json.at("environment").at("triangles") == 4);
    QVERIFY(json.at("imbalance").get<double>() >= 1);
    QCOMPARE(json.at("cells").size(), std::size_t{4});
    int open = 0, number = 0;
    for (const auto& cell : json.at("cells")) {
      QCOMPARE(cell.at("cell").get<int>(), ++number);
      for (const char* key : {"floors", "obstacles"}) QVERIFY(cell.at(key).is_number_unsigned());
      QVERIFY(cell.at("cost").is_number());
      QVERIFY(cell.at("lower")[0].is_null() != cell.at("upper")[0].is_null());
      QVERIFY(cell.at("lower")[1].is_null() && cell.at("upper")[1].is_null());
      QVERIFY(cell.at("lower")[2].is_null() || cell.at("lower")[2] == -3);
      if (cell.at("upper")[2].is_null()) ++open;
    }
    QCOMPARE(open, 2);
    const auto& cut = json.at("cut");
    QCOMPARE(cut.at("triangles").get<std::size_t>(), std::size_t(contentOf(path("out.obj")).count("\nf ")));
    QCOMPARE(cut.at("vertices").get<std::size_t>(), std::size_t(contentOf(path("out.obj")).count("\nv ")));
    QVERIFY(cut.at("closed_triangles") == 0);
  }

  void cutEnvironmentIsExported_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("up");
    QTest::newRow("z up") << "z.obj"
                          << "z";
    QTest::newRow("y up") << "y.obj"
                          << "y";
  }
  void cutEnvironmentIsExported() {
    QFETCH(QString, name);
    QFETCH(QString, up);
    const Outcome outcome =
        footfallCells({path(name), "--up", up, "--strategy", "GridStrategy 3 2", "-o", path("out.obj")});
    QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
    const QByteArray obj = contentOf(path("out.obj"));
    QVERIFY(obj.startsWith("# Cells by Footfall "));
    QVERIFY(obj.contains(("# source: " + name).toUtf8()));
    QVERIFY(obj.contains("# pipeline: GridStrategy 3 2\n"));
    QVERIFY(obj.contains("# agent: slope 45 degrees"));
    const auto areas = areasOf(obj);
    QCOMPARE(areas.size(), std::size_t{6});
    double sum = 0;
    int walls = 0;
    for (const auto& [group, area] : areas) {
      QVERIFY2(group.rfind("cell_", 0) == 0, group.c_str());
      sum += area;
      // 4 by 3 of the floor; the wall stands on the border and belongs to the upper cells
      QVERIFY(std::abs(area - 12) < 1e-9 || std::abs(area - 20) < 1e-9);
      if (std::abs(area - 20) < 1e-9) ++walls;
    }
    QCOMPARE(walls, 3);
    QVERIFY(std::abs(sum - (72 + 24)) < 1e-9);
    // it lies on the file, and reads back
    footfall::ImportOptions options;
    options.up = up == "y" ? footfall::UpAxis::Y : footfall::UpAxis::Z;
    const auto back = footfall::detail::importEnvironment(path("out.obj").toStdString(), options);
    QVERIFY(outcome.out.contains(QByteArray::number(qlonglong(back->triangles.size())) + " triangles from 4"));
    for (const footfall::Vec3& p : back->vertices)
      QVERIFY(0 <= p.x && p.x <= 12 && 0 <= p.y && p.y <= 6 && 0 <= p.z && p.z <= 2);
  }

  void sameBytesWithAnyNumberOfThreads() {
    for (const char* threads : {"1", "2", "5"}) {
      const Outcome outcome =
          footfallCells({path("z.obj"), "--strategy", "GridStrategy 5 5", "--threads", threads, "-o", path(threads)});
      QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
      QCOMPARE(contentOf(path(threads)), contentOf(path("1")));
    }
  }

  void wrongUsageOrInput_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("says");
    const auto row = [](const char* name, const QStringList& arguments, const char* says) {
      QTest::newRow(name) << arguments << QByteArray(says);
    };
    row("no environment", {}, "ENV is required");
    row("missing environment", {"nowhere.obj"}, "nowhere.obj");
    row("unknown strategy", {"ENV", "--strategy", "Grid 2 2"}, "did you mean GridStrategy?");
    row("no strategy", {"ENV", "--strategy", "SlopeFilter 45"}, "--strategy: takes one strategy");
    row("Collapse", {"ENV", "--strategy", "Collapse"}, "--strategy: takes one strategy");
    row("comment", {"ENV", "--strategy", "#GridStrategy 2 2"}, "--strategy: takes one strategy");
    row("blank", {"ENV", "--strategy", "  "}, "--strategy: takes one strategy");
    row("two strategies", {"ENV", "--strategy", "GridStrategy 2 2\nGridStrategy 2 2"}, "takes one strategy");
    row("bad parameter", {"ENV", "--strategy", "GridStrategy 0 2"}, "--strategy:1:14: n 0 is out of range");
    row("missing parameter", {"ENV", "--strategy", "GridStrategy 2"}, "--strategy:1:");
    row("missing pipeline", {"ENV", "-p", "nowhere.pipeline"}, "nowhere.pipeline: cannot be opened");
    row("bad filter", {"ENV", "--filter", "SlopeFilter 95"}, "--filter:1:13: max_slope 95 is out of range; give");
    row("filter and file", {"ENV", "--filter", "DegeneracyFilter", "-p", "x"}, "excludes");
    row("threads", {"ENV", "--threads", "0"}, "--threads");
    row("environment as output", {"ENV", "-o", "ENV"}, "z.obj: would be overwritten");
    row("another format as output", {"ENV", "-o", "level.stl"}, "level.stl: -o writes .obj files");
  }
  void wrongUsageOrInput() {
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, says);
    arguments.replaceInStrings(QRegularExpression("^ENV$"), path("z.obj"));
    const Outcome outcome = footfallCells(arguments);
    QVERIFY(!outcome.crashed);
    QCOMPARE(outcome.exitCode, 2);
    QVERIFY2(outcome.err.contains(says), outcome.err.constData());
    QVERIFY2(outcome.err.startsWith("footfall: ") && outcome.err.count('\n') == 1, outcome.err.constData());
    QVERIFY(outcome.out.isEmpty());
    QCOMPARE(contentOf(path("z.obj")), QByteArray(kFloorZUp));
  }

  void unwritableOutput() {
    const Outcome outcome = footfallCells({path("z.obj"), "-o", path("nowhere/out.obj")});
    QCOMPARE(outcome.exitCode, 1);
    QVERIFY2(outcome.err.startsWith("footfall: ") && outcome.err.count('\n') == 1, outcome.err.constData());
    QVERIFY(outcome.out.isEmpty());
  }

  void emptyEnvironment() {
    write(path("line.obj"), "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    for (const char* strategy : {"GridStrategy 3 2", "RecursiveStrategy 1 3 true", "AutoStrategy"}) {
      const Outcome outcome = footfallCells({path("line.obj"), "--strategy", strategy, "-o", path("out.obj")});
      QVERIFY(!outcome.crashed && (outcome.exitCode == 0 || outcome.exitCode == 2));
      if (outcome.exitCode == 0) QVERIFY(contentOf(path("out.obj")).contains("\ng cell_1\n"));
    }
  }

 private:
  QString path(const QString& name) const { return folder_->filePath(name); }
  std::unique_ptr<QTemporaryDir> folder_;
};

QTEST_GUILESS_MAIN(TestCellsCommand)
#include "test_cells_command.moc"
