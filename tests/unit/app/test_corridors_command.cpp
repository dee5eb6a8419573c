// `footfall corridors`, run as a user does.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>

#include "footfall/corridor_map.hpp"
#include "tests/unit/environment_files.hpp"
#include "tests/unit/program_run.hpp"

using namespace footfall::test;

namespace {

// Y up: two rooms of 4 by 4 at height 1, with a passage between them that is 1 wide and 2 long.
const QByteArray kRooms =
    "v 0 1 0\nv 4 1 0\nv 4 1 -4\nv 0 1 -4\nf 1 2 3 4\n"
    "v 4 1 -1.5\nv 6 1 -1.5\nv 6 1 -2.5\nv 4 1 -2.5\nf 5 6 7 8\n"
    "v 6 1 0\nv 10 1 0\nv 10 1 -4\nv 6 1 -4\nf 9 10 11 12\n";

QStringList corridors(const std::string& file, const QStringList& rest) {
  return QStringList{"corridors", QString::fromStdString(file), "--up", "y", "--scale", "1"} + rest;
}

}  // namespace

class TestCorridorsCommand : public QObject {
  Q_OBJECT

 private slots:
  void listsBottlenecks() {
    const TemporaryFolder folder;
    const Outcome outcome = runProgram(corridors(folder.write("rooms.obj", kRooms), {}));
    QCOMPARE(outcome.err, QByteArray());
    QCOMPARE(outcome.exitCode, 0);
    QVERIFY2(outcome.out.contains("; 1 bottleneck\nwidth 1 at 5 1 -2, from "), outcome.out.constData());
    QVERIFY2(outcome.out.contains("; the only way between areas of 17 and 17\n"), outcome.out.constData());
  }

  void leavesOutWhatIsWide() {
    const TemporaryFolder folder;
    const std::string file = folder.write("rooms.obj", kRooms);
    QVERIFY(runProgram(corridors(file, {"--narrower-than", "1"})).out.contains("; 0 bottlenecks narrower than 1\n"));
    QVERIFY(runProgram(corridors(file, {"--narrower-than", "1.5"})).out.contains("; 1 bottleneck narrower than 1.5\n"));
  }

  void leavesOutSlits() {
    // The passage is 0.08 m wide.
    QByteArray rooms = kRooms;
    rooms.replace("-2.5\n", "-1.58\n");
    const TemporaryFolder folder;
    const std::string file = folder.write("rooms.obj", rooms);
    const Outcome outcome = runProgram(corridors(file, {}));
    QVERIFY2(outcome.out.endsWith("; 0 bottlenecks; left out: 1, at most 0.1 wide\n"), outcome.out.constData());
    QVERIFY(runProgram(corridors(file, {"--wider-than", "0"})).out.contains("; 1 bottleneck\nwidth 0.08 at "));
    QVERIFY(runProgram(corridors(file, {"--wider-than", "0.05"})).out.contains("; 1 bottleneck\nwidth 0.08 at "));
  }

  void leavesOutWhatIsShallow() {
    // Halfway, the passage has a niche on either side, in which it is 2 % wider.
    QByteArray rooms = kRooms;
    rooms.replace("v 6 1 -1.5\nv 6 1 -2.5\n", "v 4.9 1 -1.5\nv 4.9 1 -2.5\n");
    rooms +=
        "v 4.9 1 -1.48\nv 5.1 1 -1.48\nv 5.1 1 -2.52\nv 4.9 1 -2.52\nf 13 14 15 16\n"
        "v 5.1 1 -1.5\nv 6 1 -1.5\nv 6 1 -2.5\nv 5.1 1 -2.5\nf 17 18 19 20\n";
    const TemporaryFolder folder;
    const std::string file = folder.write("rooms.obj", rooms);
    const Outcome outcome = runProgram(corridors(file, {}));
    QVERIFY2(outcome.out.contains(
                 "; 1 bottleneck; left out: 1, behind which the way gets wider by less than 5 %\nwidth 1 at "),
             outcome.out.constData());
    QVERIFY(runProgram(corridors(file, {"--prominence", "0"})).out.contains("; 2 bottlenecks\nwidth 1 at "));
    QVERIFY(runProgram(corridors(file, {"--prominence", "1"})).out.contains("; 2 bottlenecks\nwidth 1 at "));
  }

  void writesFiles() {
    const TemporaryFolder folder;
    const std::string file = folder.write("rooms.obj", kRooms), map = folder.path("map.json");
    QCOMPARE(runProgram(corridors(file, {"-o", QString::fromStdString(map)})).exitCode, 0);
    const std::string text = readAll(map).toStdString();
    QCOMPARE(formatCorridorsJson(footfall::parseCorridorsJson(text, map)), text);
    const std::string lines = folder.path("map.geojson");
    QCOMPARE(runProgram(corridors(file, {"--full", "-o", QString::fromStdString(lines)})).exitCode, 0);
    const QJsonObject json = QJsonDocument::fromJson(readAll(lines)).object();
    QCOMPARE(json["type"].toString(), QString("FeatureCollection"));
    QCOMPARE(json["features"].toArray().last().toObject()["properties"].toObject()["width"].toDouble(), 1.0);
  }

  void writesLinesForOtherPrograms() {
    const TemporaryFolder folder;
    const std::string file = folder.write("rooms.obj", kRooms), lines = folder.path("map.glb");
    QCOMPARE(runProgram(corridors(file, {"-o", QString::fromStdString(lines)})).exitCode, 0);
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(lines, aiProcess_ValidateDataStructure);
    QVERIFY2(scene != nullptr, importer.GetErrorString());
    QCOMPARE(scene->mNumMeshes, 2U);
    const aiMesh &edges = *scene->mMeshes[0], &bottlenecks = *scene->mMeshes[1];
    QCOMPARE(QString(edges.mName.C_Str()), QStringLiteral("corridors"));
    QCOMPARE(edges.mPrimitiveTypes, static_cast<unsigned>(aiPrimitiveType_LINE));
    QVERIFY(edges.mNumFaces > 3);
    // Y is up: both rooms are at height 1, from z = -4 to 0.
    for (unsigned i = 0; i < edges.mNumVertices; ++i) {
      const aiVector3D& p = edges.mVertices[i];
      QCOMPARE(p.y, 1.0F);
      QVERIFY(p.x > 0 && p.x < 10 && p.z > -4 && p.z < 0);
    }
    QCOMPARE(bottlenecks.mNumVertices, 2U);
    QVERIFY(std::fabs((bottlenecks.mVertices[0] - bottlenecks.mVertices[1]).Length() - 1) < 1e-6F);
    // 1 m is narrower than 2 m: more red than the widest place.
    const auto redOf = [](const aiMesh& mesh, unsigned vertex) { return mesh.mColors[0][vertex].r; };
    float least = 1;
    for (unsigned i = 0; i < edges.mNumVertices; ++i) least = std::min(least, redOf(edges, i));
    QVERIFY(redOf(bottlenecks, 0) > least + 0.1F);
  }

  void refusesWhatMeansNothing() {
    const TemporaryFolder folder;
    const std::string file = folder.write("rooms.obj", kRooms);
    const auto refused = [&](const QStringList& rest) {
      const Outcome outcome = runProgram(corridors(file, rest));
      return outcome.exitCode == 2 ? outcome.err : QByteArray();
    };
    QVERIFY(refused({"--narrower-than", "-1"}).contains("--narrower-than"));
    QVERIFY(refused({"--prominence", "-1"}).contains("--prominence"));
    QVERIFY(refused({"--narrower-than", "nan"}).contains("--narrower-than"));
    QVERIFY(refused({"--wider-than", "-1"}).contains("--wider-than"));
    QVERIFY(refused({"-o", QString::fromStdString(folder.path("map.obj"))}).contains("map.obj"));
    QCOMPARE(readAll(file), kRooms);
  }
};

QTEST_GUILESS_MAIN(TestCorridorsCommand)
#include "test_corridors_command.moc"
