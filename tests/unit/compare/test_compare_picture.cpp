// `footfall compare --picture` as a user meets it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <nlohmann/json.hpp>

#include "tests/unit/environment_files.hpp"
#include "tests/unit/program_run.hpp"

using namespace footfall::test;

namespace {

constexpr const char* kSquare = "v 0 0 0\nv 4 0 0\nv 4 0 -4\nv 0 0 -4\nf 1 2 3\nf 1 3 4\n";
constexpr const char* kHalf = "v 0 0 0\nv 2 0 0\nv 2 0 -4\nv 0 0 -4\nf 1 2 3\nf 1 3 4\n";

}  // namespace

class TestComparePicture : public QObject {
  Q_OBJECT

 private slots:
  // A square against its half: the farthest corner is 2 away.
  void draws() {
    const QString square = file("square.obj", kSquare), half = file("half.obj", kHalf);
    const QString picture = QString::fromStdString(folder_.path("map.svg"));
    const Outcome drawn = runProgram({"compare", square, half, "--picture", picture});
    QVERIFY2(drawn.exitCode == 0, drawn.err.constData());
    QVERIFY(drawn.out.contains("map.svg\n"));
    QFile svg(picture);
    QVERIFY(svg.open(QIODevice::ReadOnly));
    QVERIFY(svg.readAll().contains("d_max 2,"));
    const Outcome json = runProgram({"compare", square, half, "--picture", picture, "--json"});
    QVERIFY(nlohmann::json::parse(json.out.toStdString()).at("equal") == false);

    const Outcome other =
        runProgram({"compare", square, half, "--picture", QString::fromStdString(folder_.path("map.png"))});
    QVERIFY(other.exitCode == 2 && other.err.contains("give one that ends in .svg or .pdf"));
    const QString empty = file("empty.obj",
                               "# Walkable area by Footfall 1\n# content: 0 vertices, 0 triangles, 0 layers, 0 "
                               "connections, 0 obstacle edges\ng walkable\n");
    const Outcome nothing = runProgram({"compare", square, empty, "--picture", picture});
    QVERIFY2(nothing.exitCode == 2 && nothing.err.contains("leave --picture out"), nothing.err.constData());
    const Outcome self = runProgram({"compare", square, half, "--picture", square});
    QVERIFY(self.exitCode == 2 && self.err.contains("give one that ends"));
    const Outcome over = runProgram({"compare", picture, half, "--picture", picture});
    QVERIFY2(over.exitCode == 2 && over.err.contains("one of the two meshes"), over.err.constData());
  }

 private:
  QString file(const char* name, const QByteArray& content) {
    return QString::fromStdString(folder_.write(name, content));
  }
  TemporaryFolder folder_;
};

QTEST_GUILESS_MAIN(TestComparePicture)
#include "test_compare_picture.moc"
