// `footfall path`, run as a user does.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

#include "tests/unit/environment_files.hpp"
#include "tests/unit/program_run.hpp"

using namespace footfall::test;

namespace {

// Y up: a floor of 4 by 8 at height 1, with a wall across it that leaves a gap.
const QByteArray kRoom =
    "v 0 1 0\nv 8 1 0\nv 8 1 -4\nv 0 1 -4\nf 1 2 3 4\n"
    "v 4 1 0\nv 4 1 -3\nv 4 2 -3\nv 4 2 0\nf 5 6 7 8\n"
    "v 20 1 0\nv 22 1 0\nv 22 1 -2\nv 20 1 -2\nf 9 10 11 12\n";

QStringList path(const std::string& file, const QStringList& rest) {
  return QStringList{"path", QString::fromStdString(file), "--up", "y", "--scale", "1"} + rest;
}

}  // namespace

class TestPathCommand : public QObject {
  Q_OBJECT
 private slots:
  void findsTheWayAroundAWall() {
    const TemporaryFolder folder;
    const std::string file = folder.write("room.obj", kRoom);
    const Outcome outcome = runProgram(path(file, {"--from", "2", "1", "-1", "--to", "6", "1", "-1"}));
    QCOMPARE(outcome.err, QByteArray());
    QCOMPARE(outcome.exitCode, 0);
    QVERIFY2(
        outcome.out.startsWith("start    2 1 -1\nend      6 1 -1\nlength   5.656854 (5.656854 in the plan), 1 bend\n"),
        outcome.out.constData());
  }

  void tellsAllAsJsonAndWritesThePolyline() {
    const TemporaryFolder folder;
    const std::string file = folder.write("room.obj", kRoom), out = folder.path("path.obj");
    const Outcome outcome = runProgram(
        path(file, {"--from", "2", "1", "-1", "--to", "6", "1", "-1", "--json", "-o", QString::fromStdString(out)}));
    QCOMPARE(outcome.exitCode, 0);
    const QJsonObject json = QJsonDocument::fromJson(outcome.out).object();
    QCOMPARE(json["status"].toString(), QString("found"));
    QCOMPARE(json["plan_length"].toDouble(), 2 * std::sqrt(8.0));
    QCOMPARE(json["bends"].toArray(), (QJsonArray{QJsonArray{4, 1, -3}}));
    QCOMPARE(json["points"].toArray().first().toArray(), (QJsonArray{2, 1, -1}));
    QCOMPARE(json["points"].toArray().last().toArray(), (QJsonArray{6, 1, -1}));
    const QByteArray text = readAll(out);
    QVERIFY(text.startsWith("# Shortest path by Footfall "));
    QVERIFY2(text.contains("\nv 2 1 -1\n") && text.contains("\nv 4 1 -3\n") && text.contains("\ng path\nl 1 2 3"),
             text.constData());
  }

  void tellsWhereItFails() {
    const TemporaryFolder folder;
    const std::string file = folder.write("room.obj", kRoom);
    const Outcome apart = runProgram(path(file, {"--from", "6", "1", "-2", "--to", "21", "1", "-2"}));
    QCOMPARE(apart.exitCode, 1);
    QVERIFY2(apart.out.contains("fails at 8 1 -2\n"), apart.out.constData());
    QVERIFY2(
        apart.err.contains("no way leads from the start to the target; the nearest place that can be reached lies"),
        apart.err.constData());
    QVERIFY2(apart.err.contains("; the parts are nearest at 8 1 -1: a gap of 12, 11.95 too wide\n"),
             apart.err.constData());
    const Outcome told = runProgram(path(file, {"--from", "6", "1", "-2", "--to", "21", "1", "-2", "--json"}));
    const QJsonObject separation = QJsonDocument::fromJson(told.out).object()["separation"].toObject();
    const QJsonObject link = separation["links"].toArray().at(separation["largest"].toInt()).toObject();
    QCOMPARE(link["kind"].toString(), QString("open"));
    QCOMPARE(link["gap"].toDouble(), 12.0);
    QCOMPARE(link["to"].toArray(), (QJsonArray{20, 1, -1}));
    // The place is on the wall: higher than the floor, but less than the clearance.
    const Outcome off = runProgram(path(file, {"--from", "-2", "1", "-2", "--to", "6", "1", "-2", "--json"}));
    QCOMPARE(off.exitCode, 1);
    const QJsonObject json = QJsonDocument::fromJson(off.out).object();
    QCOMPARE(json["status"].toString(), QString("start_not_walkable"));
    QCOMPARE(json["start"].toObject()["position"].toArray(), (QJsonArray{0, 1, -2}));
    QVERIFY(json["end"].isNull());
    QVERIFY(json["points"].toArray().isEmpty());
  }

  void reachCanBeGiven() {
    const TemporaryFolder folder;
    const std::string file = folder.write("room.obj", kRoom);
    const QStringList places{"--from", "2", "9", "-1", "--to", "3", "1", "-1"};
    QCOMPARE(runProgram(path(file, places)).exitCode, 1);
    QCOMPARE(runProgram(path(file, places + QStringList{"--reach", "8"})).exitCode, 0);
  }

  void wrongUse_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("message");
    const QStringList places{"--from", "2", "1", "-1", "--to", "6", "1", "-1"};
    QTest::newRow("no target") << QStringList{"--from", "2", "1", "-1"} << QByteArray("--to");
    QTest::newRow("two numbers") << QStringList{"--from", "2", "1", "--to", "6", "1", "-1"} << QByteArray("--from");
    QTest::newRow("no number") << QStringList{"--from", "2", "1", "x", "--to", "6", "1", "-1"} << QByteArray("--from");
    QTest::newRow("not finite") << QStringList{"--from", "2", "1", "inf", "--to", "6", "1", "-1"}
                                << QByteArray("--from: takes three finite numbers");
    QTest::newRow("reach") << (places + QStringList{"--reach", "-1"}) << QByteArray("--reach: must be");
    QTest::newRow("ending") << (places + QStringList{"-o", "path.glb"}) << QByteArray("-o writes .obj files");
    QTest::newRow("filter") << (places + QStringList{"--filter", "Slope 4"}) << QByteArray("Slope");
  }

  void wrongUse() {
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, message);
    const TemporaryFolder folder;
    const Outcome outcome = runProgram(path(folder.write("room.obj", kRoom), arguments));
    QCOMPARE(outcome.exitCode, 2);
    QVERIFY2(outcome.err.contains(message), outcome.err.constData());
  }

  void targetsThatCannotBeWritten() {
    const TemporaryFolder folder;
    const std::string file = folder.write("room.obj", kRoom);
    const QStringList places{"--from", "2", "1", "-1", "--to", "6", "1", "-1", "-o"};
    const Outcome full = runProgram(path(file, places + QStringList{"/dev/full"}));
    QCOMPARE(full.exitCode, 1);
    QVERIFY2(full.err.contains("the disk is full"), full.err.constData());
    const Outcome missing = runProgram(path(file, places + QStringList{"/nowhere/at/all.obj"}));
    QCOMPARE(missing.exitCode, 1);
    QVERIFY2(missing.err.contains("its folder does not exist"), missing.err.constData());
    QCOMPARE(runProgram(path(file, places + QStringList{QString::fromStdString(file)})).exitCode, 2);
  }
};

QTEST_GUILESS_MAIN(TestPathCommand)
#include "test_path_command.moc"
