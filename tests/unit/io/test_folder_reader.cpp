// A folder as one environment: what is taken, parts, frames, messages, and what may not be written into it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <filesystem>

#include "core/environment/part_rules.hpp"
#include "core/io/folder_reader.hpp"
#include "core/io/packed/pack.hpp"
#include "core/io/write_targets.hpp"
#include "tests/unit/environment_files.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

constexpr const char* kFloor = "v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n";
constexpr const char* kTwoParts = "v 0 0 1\nv 4 0 1\nv 0 4 1\no a\nusemtl wood\nf 1 2 3\no b\nf 1 2 3\nf 1 2\n";

std::shared_ptr<const Environment> importZUp(const std::string& path) {
  ImportOptions options;
  options.up = UpAxis::Z;
  return importEnvironment(path, options);
}

}  // namespace

class TestFolderReader : public QObject {
  Q_OBJECT
 private slots:
  void allMeshesDirectlyInItComeByName() {
    const TemporaryFolder folder;
    folder.write("b.OBJ", kTwoParts);
    folder.write("a.obj", kFloor);
    folder.write("notes.txt", "no mesh");
    folder.write("a.mtl", "newmtl wood\n");
    folder.write(".hidden.obj", "not read");
    QVERIFY(QDir(QString::fromStdString(folder.path(""))).mkdir("c.obj"));
    folder.write("c.obj/d.obj", kFloor);
    const auto environment = importZUp(folder.path(""));
    QCOMPARE(environment->source, folder.path(""));
    QCOMPARE(environment->triangles.size(), std::size_t{3});
    QVERIFY((environment->triangles[1] == Triangle{3, 4, 5}));
    QVERIFY((environment->vertices[3] == Vec3{0, 0, 1}));
    QVERIFY((environment->parts ==
             std::vector<EnvironmentPart>{{"a.obj", ""}, {"b.OBJ: a", "wood"}, {"b.OBJ: b", "wood"}}));
    QVERIFY((environment->partOf == std::vector<std::uint32_t>{0, 1, 2}));
    QCOMPARE(environment->skipped.polygons, std::uint64_t{1});
    QCOMPARE(environment->skipped.listed[0].mesh, std::string("b.OBJ"));
    checkEnvironment(*environment);
  }

  void packedFilesBesideTheirOriginalsAreLeftOut() {
    const TemporaryFolder folder;
    const std::string original = folder.write("b.obj", kTwoParts);
    packEnvironment(original, folder.path("b.ffenv"), {}, nullptr);
    const auto both = importEnvironment(folder.path(""));
    QVERIFY(both->triangles == importEnvironment(original)->triangles);
    QCOMPARE(both->notes.size(), std::size_t{1});
    QCOMPARE(both->notes[0].str(),
             std::string("b.ffenv was left out: b.obj, of which it was packed, is in the folder, too"));
    std::filesystem::remove(original);
    QVERIFY(importEnvironment(folder.path(""))->triangles == both->triangles);
    // A file with that name is elsewhere.
    folder.write("b.obj", kFloor);
    std::filesystem::rename(folder.path("b.ffenv"), folder.path("a.ffenv"));
    QCOMPARE(importEnvironment(folder.path(""))->triangles.size(), both->triangles.size() + 1);
  }

  void bothSidesOfSomeFilesOnlyAreRefused_data() {
    QTest::addColumn<QByteArray>("packed");
    QTest::newRow("first") << QByteArray("a.ffenv");
    QTest::newRow("last") << QByteArray("c.ffenv");
  }
  void bothSidesOfSomeFilesOnlyAreRefused() {
    QFETCH(QByteArray, packed);
    const TemporaryFolder folder, elsewhere;
    folder.write("b.obj", kFloor);
    ImportOptions options;
    options.bothSides = true;
    packEnvironment(elsewhere.write("x.obj", kTwoParts), folder.path(packed.constData()), options, nullptr);
    const QString message = messageOf<InputError>([&] { importEnvironment(folder.path("")); });
    QVERIFY2(message.contains("both sides of ") && message.contains("pack it again"), qPrintable(message));
    QVERIFY(importEnvironment(folder.path(""), options)->bothSides);
  }

  void oneFileIsTheSameInAFolder() {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.obj", kTwoParts);
    const auto alone = importEnvironment(path), within = importEnvironment(folder.path(""));
    QVERIFY(alone->vertices == within->vertices && alone->triangles == within->triangles);
    QVERIFY(alone->up == within->up && alone->metresPerUnit == within->metresPerUnit);
    QVERIFY(alone->upGuessed == within->upGuessed && alone->scaleGuessed == within->scaleGuessed);
  }

  void axesAreTurnedAndUnitsMustAgree() {
    const TemporaryFolder folder;
    folder.write("a.obj", kFloor);  // Y up
    folder.write("b.stl",
                 "solid b\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
                 "endfacet\nendsolid b\n");  // Z up
    const auto both = importEnvironment(folder.path(""));
    QVERIFY(both->up == UpAxis::Z);
    QVERIFY((both->vertices[2] == Vec3{0, 0, 4}));
    QVERIFY((both->vertices[5] == Vec3{0, 1, 0}));
    QFile::copy(QString::fromStdString(dataFile("z_up_inches.fbx")), QString::fromStdString(folder.path("c.fbx")));
    const QString message = messageOf<InputError>([&] { importEnvironment(folder.path("")); });
    QVERIFY2(message.contains("c.fbx: a unit of it is 0.0254 metres, and one of "), qPrintable(message));
    ImportOptions options;
    options.metresPerUnit = 0.5;
    QCOMPARE(importEnvironment(folder.path(""), options)->metresPerUnit, 0.5);
  }

  void messages() {
    const TemporaryFolder folder;
    const auto message = [&] { return messageOf<InputError>([&] { importEnvironment(folder.path("")); }); };
    QVERIFY(message().contains("a folder without meshes"));
    folder.write("a.obj", kFloor);
    folder.write("b.obj", "v 0 0 x\n");
    QVERIFY2(message().contains("b.obj:1: "), qPrintable(message()));
  }

  void rolesGoByFile() {
    const TemporaryFolder folder;
    folder.write("a.obj", kFloor);
    folder.write("b.obj", kTwoParts);
    const auto environment = importZUp(folder.path(""));
    const auto without =
        applyPartRules(environment, rulesForName(*environment, "a.obj", PartRole::Ignored, "--ignore"));
    QCOMPARE(without->triangles.size(), std::size_t{2});
  }

  void nothingIsWrittenIntoIt() {
    const TemporaryFolder folder, other;
    const std::string file = folder.write("a.obj", kFloor);
    WriteTargets targets;
    targets.protectEnvironment(folder.path(""));
    const auto message = [&](const std::string& target) {
      return messageOf<InputError>([&] { targets.check(target); });
    };
    QVERIFY(!message(file).isEmpty());
    QVERIFY2(message(folder.path("new.obj")).contains("would be a part of the environment"), qPrintable(message(file)));
    QVERIFY(message(folder.path("report.html")).isEmpty());
    QVERIFY(message(other.path("new.obj")).isEmpty());
  }
};

QTEST_GUILESS_MAIN(TestFolderReader)
#include "test_folder_reader.moc"
