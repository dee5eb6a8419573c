// Files with each of the six up axes: turned to Z up and back, exactly, as turns and never as mirror images.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <array>
#include <cfloat>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/io/export.hpp"
#include "footfall/io.hpp"
#include "footfall/up_axis.hpp"
#include "tests/unit/environment_files.hpp"
#include "tests/unit/program_run.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

void addAxes() {
  QTest::addColumn<int>("axis");
  for (const UpAxis up : kUpAxes) QTest::newRow(shownName(up).c_str()) << static_cast<int>(up);
}

double determinant(const std::array<Vec3, 3>& m) {
  return m[0].x * (m[1].y * m[2].z - m[1].z * m[2].y) - m[0].y * (m[1].x * m[2].z - m[1].z * m[2].x) +
         m[0].z * (m[1].x * m[2].y - m[1].y * m[2].x);
}

bool sameBits(double a, double b) { return a == b && std::signbit(a) == std::signbit(b); }

/// A floor of 12 by 6 whose right side lies 1 higher, turned the way that a file of this up axis has it.
QByteArray floorFile(UpAxis up) {
  QByteArray text;
  for (const Vec3& corner : {Vec3{0, 0, 0}, Vec3{12, 0, 1}, Vec3{12, 6, 1}, Vec3{0, 6, 0}}) {
    const Vec3 p = inFileFrame(corner, up);
    text += QByteArray("v ") + QByteArray::number(p.x) + ' ' + QByteArray::number(p.y) + ' ' + QByteArray::number(p.z) +
            '\n';
  }
  return text + "f 1 2 3\nf 1 3 4\n";
}

}  // namespace

class TestUpAxes : public QObject {
  Q_OBJECT
 private slots:
  void turnsAreExactAndNoMirrorImages_data() { addAxes(); }
  void turnsAreExactAndNoMirrorImages() {
    QFETCH(int, axis);
    const auto up = static_cast<UpAxis>(axis);
    const std::array<Vec3, 3> images{fromFileFrame({1, 0, 0}, up), fromFileFrame({0, 1, 0}, up),
                                     fromFileFrame({0, 0, 1}, up)};
    QCOMPARE(determinant(images), 1.0);
    // The axis that is named points up.
    const std::string name(nameOf(up));
    const double sign = name[0] == '-' ? -1 : 1;
    QCOMPARE(images.at(static_cast<std::size_t>(name.back() - 'x')).z, sign);

    for (const Vec3& p : {Vec3{122000.123, 487000.456, 0.1}, Vec3{1e300, -5e-324, DBL_MIN / 4},
                          Vec3{DBL_MAX, -DBL_MAX, 1.0 / 3}, Vec3{0.0, -0.0, 7}}) {
      const Vec3 back = inFileFrame(fromFileFrame(p, up), up);
      QVERIFY(back == p && fromFileFrame(inFileFrame(p, up), up) == p);
      for (const double x : {back.x, back.y, back.z}) QVERIFY(x != 0 || sameBits(x, 0.0));
    }
  }

  void namesReadBack() {
    for (const UpAxis up : kUpAxes) {
      QVERIFY(upAxisFrom(nameOf(up)) == up && upAxisFrom(shownName(up)) == up);
      QVERIFY(std::string(kUpAxisNames).find(nameOf(up)) != std::string::npos);
    }
    for (const char* other : {"", "w", "+y", "--y", "y ", "up"}) QVERIFY2(!upAxisFrom(other), other);
  }

  void exportsLieOnTheFileAndReadBack_data() { addAxes(); }
  void exportsLieOnTheFileAndReadBack() {
    QFETCH(int, axis);
    const auto up = static_cast<UpAxis>(axis);
    NavigationMesh mesh;
    mesh.vertices = {{122000.123, 487000.456, 0.1}, {1.0 / 3, -2.0 / 3, 1e22}, {-5e-324, 0.3, 1e5}};
    mesh.triangles = {{0, 1, 2}};
    mesh.frame.up = up;
    const TemporaryFolder folder;
    const std::string path = folder.path("a.obj");
    save(mesh, path);
    QVERIFY(readAll(path).contains(("# frame: " + shownName(up) + " up, 1 metres").c_str()));
    const NavigationMeshFile stated = readNavigationMesh(path);
    QVERIFY(stated.statedUp == up && stated.up == up && stated.mesh.vertices == mesh.vertices);

    ImportOptions options;
    options.up = up;
    const auto environment = importEnvironment(path, options);
    QVERIFY(environment->up == up && environment->vertices == mesh.vertices);
    mesh.vertices = environment->vertices;
    QCOMPARE(formatObj(mesh, {}).c_str(), readAll(path).constData());
  }

  void theCommandLineTakesEveryAxis_data() { addAxes(); }
  void theCommandLineTakesEveryAxis() {
    QFETCH(int, axis);
    const auto up = static_cast<UpAxis>(axis);
    const TemporaryFolder folder;
    const auto at = [&](const char* name) { return QString::fromStdString(folder.path(name)); };
    const QString name = QString::fromStdString(std::string(nameOf(up)));
    write(at("z.obj"), floorFile(UpAxis::Z));
    write(at("in.obj"), floorFile(up));

    // Walkable from above, as the same floor with Z up is; seen from below it would not be.
    for (const bool isTurned : {false, true}) {
      const Outcome run =
          isTurned
              ? runProgram({"run", at("in.obj"), "--quiet", "--up", name, "-o", at("in_out.obj"), "--export-up", "z"})
              : runProgram({"run", at("z.obj"), "--quiet", "--up", "z", "-o", at("z_out.obj"), "--export-up", name});
      QVERIFY2(run.exitCode == 0, run.err.constData());
    }
    const NavigationMeshFile turned = readNavigationMesh(folder.path("z_out.obj"));
    const NavigationMeshFile straight = readNavigationMesh(folder.path("in_out.obj"));
    QVERIFY(turned.statedUp == up && straight.statedUp == UpAxis::Z);
    QCOMPARE(straight.mesh.triangles.size(), std::size_t{2});
    QVERIFY(turned.mesh.vertices == straight.mesh.vertices && turned.mesh.triangles == straight.mesh.triangles);

    const Outcome compared = runProgram({"compare", at("z_out.obj"), at("in_out.obj"), "--fail-if-different"});
    QVERIFY2(compared.exitCode == 0, compared.err.constData());
    const Outcome info = runProgram({"info", at("in.obj"), "--up", name});
    QVERIFY2(info.out.contains((shownName(up) + " (given)").c_str()), info.out.constData());
    const Outcome unknown = runProgram({"info", at("in.obj"), "--up", "w"});
    QVERIFY(unknown.exitCode == 2 && unknown.err.contains("--up"));
  }

  void placesAreInTheFramesOfFiles_data() { addAxes(); }
  void placesAreInTheFramesOfFiles() {
    QFETCH(int, axis);
    const auto up = static_cast<UpAxis>(axis);
    const TemporaryFolder folder;
    const QString in = QString::fromStdString(folder.write("in.obj", floorFile(up)));
    const QString name = QString::fromStdString(std::string(nameOf(up)));
    const auto words = [up](const Vec3& place) {
      const Vec3 p = inFileFrame(place, up);
      return QStringList{QString::number(p.x), QString::number(p.y), QString::number(p.z)};
    };
    const Outcome path = runProgram(QStringList{"path", in, "--up", name, "--json", "--from"} + words({3, 3, 1}) +
                                    QStringList{"--to"} + words({9, 3, 1}));
    QVERIFY2(path.exitCode == 0, path.err.constData());
    const auto found = nlohmann::json::parse(path.out.toStdString());
    const Vec3 end = inFileFrame({9, 3, 0.75}, up);
    QVERIFY2(found.at("end").at("position") == (std::vector<double>{end.x, end.y, end.z}), path.out.constData());

    const Outcome why = runProgram(QStringList{"why", in, "--up", name, "--at"} + words({9, 3, 1}));
    const QStringList below = words({9, 3, 0.75});
    QVERIFY2(why.exitCode == 0 && why.out.startsWith(below.join(' ').toUtf8()), why.out.constData());
    const Outcome outside = runProgram(QStringList{"why", in, "--up", name, "--at"} + words({9, 3, -1}));
    QVERIFY2(outside.err.contains((" and " + std::string(nameOf(up)) + " is up").c_str()), outside.err.constData());

    const Outcome cells = runProgram({"cells", in, "--up", name, "--json", "--strategy", "GridStrategy 1 2"});
    QVERIFY2(cells.exitCode == 0, cells.err.constData());
    const auto json = nlohmann::json::parse(cells.out.toStdString());
    QVERIFY(json.at("environment").at("up") == nameOf(up));
    for (const auto& cell : json.at("cells"))
      for (const std::size_t i : {0, 1, 2}) {
        const auto &lower = cell.at("lower")[i], &upper = cell.at("upper")[i];
        QVERIFY(lower.is_null() || upper.is_null() || lower.get<double>() < upper.get<double>());
      }
  }
};

QTEST_GUILESS_MAIN(TestUpAxes)
#include "test_up_axes.moc"
