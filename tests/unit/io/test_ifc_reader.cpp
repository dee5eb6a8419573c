// Buildings through the converter: with a stand-in for Node.js that has the output of a test, and with the real one
// where it is installed.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QElapsedTimer>
#include <QProcess>
#include <QtTest>
#include <cmath>
#include <fstream>
#include <thread>

#include "core/environment/part_rules.hpp"
#include "core/io/ifc_reader.hpp"
#include "core/mesh/storey_names.hpp"
#include "footfall/inspect.hpp"
#include "footfall/walkable_area.hpp"
#include "tests/unit/environment_files.hpp"
#include "tests/unit/ifc_stand_in.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

bool hasConverter() { return findIfcConverter().has_value(); }
constexpr const char* kMissing = "the converter of IFC files is not installed (installer/ifc.sh)";

std::vector<double> areasOf(const NavigationMesh& mesh) {
  std::vector<double> areas;
  for (const Component& component : findComponents(mesh).list) areas.push_back(component.area);
  return areas;
}

}  // namespace

class TestIfcReader : public QObject {
  Q_OBJECT
 private slots:
  void partsRolesStoreysAndUnitsCome() {
    const Converter converter(kHouse);
    const auto all = importEnvironment(converter.building);
    QVERIFY(all->up == UpAxis::Z && !all->upGuessed);
    QCOMPARE(all->metresPerUnit, 0.001);
    QVERIFY(!all->scaleGuessed);
    QCOMPARE(all->triangles.size(), std::size_t{4});
    QVERIFY((all->parts == std::vector<EnvironmentPart>{{"IfcSlab", "Ground: Floor"},
                                                        {"IfcDoor", "Ground: Door"},
                                                        {"IfcFurniture", "Ground: Table"}}));
    QVERIFY((all->usualRoles == std::vector<PartRole>{PartRole::Floor, PartRole::Ignored, PartRole::ObstacleOnly}));
    QVERIFY((all->storeys == std::vector<Storey>{{"Ground", 0}, {"Above", 3000}}));
    QVERIFY(all->notes.empty());
  }

  void usualRolesHoldUntilARuleNamesThePart() {
    const Converter converter(kHouse);
    const auto all = importEnvironment(converter.building);
    const auto usual = applyPartRules(all, {});
    QCOMPARE(usual->triangles.size(), std::size_t{3});
    QVERIFY((usual->obstacleOnly == std::vector<std::uint8_t>{0, 0, 1}));
    const auto closed = applyPartRules(all, rulesForName(*all, "IfcDoor", PartRole::Floor, "--as-usual"));
    QCOMPARE(closed->triangles.size(), std::size_t{4});
    QVERIFY((rolesOf(*closed, {}) == all->usualRoles));
    // The library has them already in a loaded environment.
    const Environment loaded = load(converter.building);
    QVERIFY(loaded.triangles == usual->triangles && loaded.obstacleOnly == usual->obstacleOnly);
    QVERIFY(loaded.edit == nullptr);
    checkEnvironment(loaded);
  }

  void aTurnedFileHasNoStoreys() {
    const Converter converter(kHouse);
    ImportOptions options;
    options.up = UpAxis::Y;
    QVERIFY(importEnvironment(converter.building, options)->storeys.empty());
  }

  void whatTheConverterSaysIsTheMessage() {
    const auto messageWith = [](const QByteArray& script) {
      const Converter converter(script);
      QString message = messageOf<InputError>([&] { importEnvironment(converter.building); });
      return message.remove(QString::fromStdString(converter.building));
    };
    QCOMPARE(messageWith("echo 'is cut off' >&2; echo more >&2; exit 1"),
             QStringLiteral(": is cut off; check that the file is complete, or export it again"));
    QCOMPARE(
        messageWith("exit 3"),
        QStringLiteral(": cannot be converted (exit status 3); check that the file is complete, or export it again"));
    QCOMPARE(
        messageWith("kill -9 $$"),
        QStringLiteral(": cannot be converted (exit status 137); check that the file is complete, or export it again"));
    QVERIFY(messageWith("echo '# footfall-ifc 2'")
                .contains(QStringLiteral("is of another version; to install it, type in a terminal: ")));
    QVERIFY(messageWith("echo '# footfall-ifc 1'").contains(QStringLiteral("no triangles in it")));
    QVERIFY(messageWith("printf '# footfall-ifc 1\\nv 0 0 nan\\n'").contains(QStringLiteral(":2: ")));
  }

  void withoutNodeItSaysSo() {
    const Converter converter("");
    const Variable none("PATH", "/nonexistent");
    QVERIFY(messageOf<InputError>([&] { importEnvironment(converter.building); }).contains(QStringLiteral("Node.js")));
  }

  void withoutTheConverterANoteSaysHowToGetIt() {
    const Variable none("FOOTFALL_IFC", "/nonexistent/footfall-ifc.mjs");
    QVERIFY(!findIfcConverter());
    const QString envs = sharedEnvironments();
    if (envs.isEmpty())
      QSKIP("without the real environments beside the project there is no IFC file that Assimp reads");
    const auto wall = importEnvironment(envs.toStdString() + "/ifc/SimpleWall.ifc");
    QCOMPARE(wall->notes.size(), std::size_t{1});
    QVERIFY(wall->notes[0].str().find(adviceOnIfcConverter().str()) != std::string::npos);
    QVERIFY(wall->usualRoles.empty());
  }

  // The command is one that a terminal runs: the script is there.
  void theAdviceNamesTheScript() {
    const QString advice = QString::fromStdString(adviceOnIfcConverter().str());
    const QString start = QStringLiteral("to install it, type in a terminal: ");
    QVERIFY2(advice.startsWith(start), qPrintable(advice));
    QProcess shell;
    shell.start(QStringLiteral("/bin/sh"), {"-c", "test -x " + advice.mid(start.size())});
    QVERIFY(shell.waitForFinished());
    QCOMPARE(shell.exitCode(), 0);
  }

  void theConverterIsFoundByDataFolders() {
    const TemporaryFolder folder;
    const Variable none("FOOTFALL_IFC", "");
    const Variable home("XDG_DATA_HOME", QByteArray::fromStdString(folder.path("home")));
    const Variable dirs("XDG_DATA_DIRS", "/nonexistent::" + QByteArray::fromStdString(folder.path("shared")));
    QVERIFY(!findIfcConverter());
    const auto install = [&](const char* where, bool complete) {
      const QString place = QString::fromStdString(folder.path(where)) + "/footfall/ifc/";
      QDir().mkpath(place + "node_modules/web-ifc");
      const std::string name = (place + "footfall-ifc.mjs").toStdString();
      std::ofstream(name) << "x";
      if (complete) std::ofstream((place + "node_modules/web-ifc/package.json").toStdString()) << "{}";
      return name;
    };
    const std::string shared = install("shared", true);
    QVERIFY(findIfcConverter() == shared);
    install("home", false);  // The folder is that of a package, without web-ifc.
    QVERIFY(findIfcConverter() == shared);
    const std::string mine = install("home", true);
    QVERIFY(findIfcConverter() == mine);
  }

  void cancellingEndsTheConverter_data() {
    QTest::addColumn<QByteArray>("script");
    QTest::newRow("silent") << QByteArray("exec sleep 60");
    QTest::newRow("without output any more") << QByteArray("exec sleep 60 >&- 2>&-");
  }
  void cancellingEndsTheConverter() {
    QFETCH(QByteArray, script);
    const Converter converter(script);
    RunContext context;
    std::thread later([&] {
      QThread::msleep(100);
      context.cancel();
    });
    QElapsedTimer timer;
    timer.start();
    QVERIFY_EXCEPTION_THROWN(importEnvironment(converter.building, {}, &context), Cancelled);
    later.join();
    QVERIFY(timer.elapsed() < 30000);  // not the 60 s of the converter
  }

  void layersAreNamedByStoreys() {
    NavigationMesh mesh;
    mesh.frame.metresPerUnit = 0.001;
    mesh.frame.storeys = {{"Cellar", -3000}, {"Ground", 0}, {"Above", 3000}};
    const auto addSquare = [&](double z, double side, std::uint32_t layer) {
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
      for (const auto& [x, y] : {std::pair{0.0, 0.0}, {side, 0.0}, {side, side}, {0.0, side}})
        mesh.vertices.push_back({x, y, z});
      for (const Triangle& t : {Triangle{0, 1, 2}, Triangle{0, 2, 3}}) {
        mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
        mesh.layers.push_back(layer);
      }
    };
    mesh.layerCount = 4;
    addSquare(-5000, 10, 0);  // The square is below all others.
    addSquare(-400, 10, 1);   // a floor a little under its storey's height
    addSquare(0, 10, 2);
    addSquare(3000, 10, 2);
    addSquare(6000, 3, 2);
    addSquare(-600, 10, 3);  // too far under it
    addSquare(3000, 3, 3);   // less than a tenth
    QVERIFY((storeyNames(mesh) == std::vector<std::string>{"Cellar", "Ground", "Ground, Above", "Cellar"}));
    mesh.frame.storeys.clear();
    QVERIFY(storeyNames(mesh).empty());
  }

  // IFC 4, in feet: two rooms with a door, a table, and a storey above.
  void aBuildingIsWalkableThroughItsDoors() {
    if (!hasConverter()) QSKIP(kMissing);
    const auto all = importEnvironment(dataFile("two_rooms.ifc"));
    QCOMPARE(all->metresPerUnit, 0.3048);
    QVERIFY((all->storeys == std::vector<Storey>{{"Ground floor", 0}, {"First floor", 10}}));
    QCOMPARE(all->parts.size(), std::size_t{5});  // no space, no opening
    // Text that would be a comment in OBJ is none here.
    QVERIFY(std::ranges::count(all->parts, EnvironmentPart{"IfcFurniture", "Ground floor: Table No. 1"}) == 1);
    Agent agent;
    agent.height = 6 * 0.3048;
    agent.step = 0;
    // 40 x 20 feet less a wall of 17 x 0.5 and a table of 3 x 3.
    QVERIFY((areasOf(walkableArea(load(dataFile("two_rooms.ifc")), agent)) == std::vector<double>{800, 782.5}));
    // A door in its place gives two rooms, with its two sides in the doorway.
    const std::vector<double> closed = areasOf(walkableArea(*all, agent));
    QVERIFY(closed.size() >= 3 && closed[1] < 400);
    const NavigationMesh mesh = walkableArea(load(dataFile("two_rooms.ifc")), agent);
    QVERIFY((storeyNames(mesh) == std::vector<std::string>{"Ground floor", "First floor"}));
  }

  void brokenBuildingsHaveOneMessage() {
    if (!hasConverter()) QSKIP(kMissing);
    const TemporaryFolder folder;
    const QByteArray whole = readAll(dataFile("two_rooms.ifc"));
    const auto message = [&](const QByteArray& content) {
      const std::string path = folder.write("x.ifc", content);
      return messageOf<InputError>([&] { importEnvironment(path); }).remove(QString::fromStdString(path));
    };
    QVERIFY(message("no building").startsWith(QStringLiteral(": is no IFC file")));
    QVERIFY(message(whole.left(whole.size() / 2)).startsWith(QStringLiteral(": is cut off")));
    QByteArray other = whole;
    other.replace("IFC4", "IFC9");
    QVERIFY(!message(other).isEmpty());
    QByteArray empty = whole;
    empty.replace("IFCEXTRUDEDAREASOLID", "IFCNOTHING");
    QVERIFY(message(empty).contains(QStringLiteral("no triangles in it")));
  }

  void realBuildingsAreWalkableThroughTheirDoors() {
    if (!hasConverter()) QSKIP(kMissing);
    const QString envs = sharedEnvironments();
    if (envs.isEmpty()) QSKIP("the real environments are not beside the project");
    for (const char* name : {"LargeBuilding", "TallBuilding"}) {
      const std::string path = envs.toStdString() + "/ifc/" + name + ".ifc";
      const auto all = importEnvironment(path);
      QCOMPARE(all->metresPerUnit, 0.001);
      QVERIFY(all->storeys.size() >= 2);
      const std::size_t open = areasOf(walkableArea(load(path))).size();
      const std::size_t closed = areasOf(walkableArea(*all)).size();
      QVERIFY2(open < closed, name);
    }
  }
};

QTEST_GUILESS_MAIN(TestIfcReader)
#include "test_ifc_reader.moc"
