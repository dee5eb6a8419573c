// Output of a command or the editor never replaces its input, whatever name leads there.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <QtTest>
#include <filesystem>

#include "core/io/write_targets.hpp"
#include "tests/unit/environment_files.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

/// Goes back to the folder that was the current one.
class InFolder {
 public:
  explicit InFolder(const std::string& path) : before_(std::filesystem::current_path()) {
    std::filesystem::current_path(path);
  }
  ~InFolder() { std::filesystem::current_path(before_); }
  InFolder(const InFolder&) = delete;
  InFolder& operator=(const InFolder&) = delete;

 private:
  std::filesystem::path before_;
};

QString refusalOf(const WriteTargets& targets, const std::string& target) {
  return messageOf<InputError>([&] { targets.check(target); });
}

QStringList companionsOf(const TemporaryFolder& folder, const char* name) {
  QStringList names;
  for (const std::string& path : companionFiles(folder.path(name)))
    names << QString::fromStdString(std::filesystem::path(path).lexically_relative(folder.path("")).string());
  names.sort();
  return names;
}

}  // namespace

class TestWriteTargets : public QObject {
  Q_OBJECT
 private slots:
  void oneFileHasManyNames() {
    const TemporaryFolder folder;
    const std::string level = folder.write("level.obj", "v 0 0 0\n");
    std::filesystem::create_directory(folder.path("inside"));
    QCOMPARE(::symlink("level.obj", folder.path("link.obj").c_str()), 0);
    QCOMPARE(::symlink("link.obj", folder.path("chain.obj").c_str()), 0);
    QCOMPARE(::symlink(folder.path("").c_str(), folder.path("inside/up").c_str()), 0);
    QCOMPARE(::link(level.c_str(), folder.path("hard.obj").c_str()), 0);
    const InFolder in(folder.path(""));
    for (const std::string name : {"level.obj", "./level.obj", "inside/../level.obj", "link.obj", "chain.obj",
                                   "inside/up/level.obj", "hard.obj", ".//level.obj"}) {
      QVERIFY2(sameFile(name, level), name.c_str());
      QVERIFY2(sameFile(level, name), name.c_str());
    }
    // Names are compared as on the disk: here, this is another file.
    if (!std::filesystem::exists("LEVEL.OBJ")) QVERIFY(!sameFile("LEVEL.OBJ", level));
    folder.write("other.obj", "v 0 0 0\n");
    QVERIFY(!sameFile("other.obj", level));
    QVERIFY(!sameFile("", level) && !sameFile("", ""));
  }

  void filesToBeAreKnownByTheirPlace() {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path("inside"));
    QCOMPARE(::symlink(folder.path("").c_str(), folder.path("inside/up").c_str()), 0);
    const InFolder in(folder.path(""));
    QVERIFY(sameFile("new.json", "./new.json"));
    QVERIFY(sameFile("new.json", folder.path("new.json")));
    QVERIFY(sameFile("new.json", "inside/up/new.json"));
    QVERIFY(!sameFile("new.json", "inside/new.json"));
    QVERIFY(!sameFile("new.json", "newer.json"));
    QVERIFY(!sameFile("none/new.json", "new.json"));
  }

  void whatIsReadIsNotReplaced() {
    const TemporaryFolder folder;
    const std::string level = folder.write("level.obj", "mtllib level.mtl\nv 0 0 0\n");
    folder.write("level.mtl", "newmtl a\nmap_Kd -s 2 2 wood planks.png\n");
    folder.write("wood planks.png", "PNG");
    folder.write("free.png", "PNG");
    const std::string pipeline = folder.write("a.pipeline", "SlopeFilter 45\n");
    QCOMPARE(::link(folder.path("level.mtl").c_str(), folder.path("hard.json").c_str()), 0);
    WriteTargets targets;
    targets.protectEnvironment(level);
    targets.protect(pipeline, FOOTFALL_TEXT("the pipeline"));
    QCOMPARE(refusalOf(targets, level),
             QString::fromStdString(level) +
                 ": would be overwritten, and is the environment; give another file to write to");
    QVERIFY(refusalOf(targets, pipeline).contains("and is the pipeline;"));
    for (const char* name : {"level.mtl", "wood planks.png", "hard.json"})
      QVERIFY2(refusalOf(targets, folder.path(name)).contains("a file that the environment uses"), name);
    for (const char* name : {"free.png", "new.obj", "level.png"})
      QCOMPARE(refusalOf(targets, folder.path(name)), QString());
    QCOMPARE(refusalOf(targets, ""), QString());

    WriteTargets known;
    known.protectEnvironment(level, companionFiles(level));
    QVERIFY(refusalOf(known, folder.path("wood planks.png")).contains("a file that the environment uses"));
    QCOMPARE(refusalOf(known, folder.path("free.png")), QString());
  }

  void noFileIsWrittenTwice() {
    const TemporaryFolder folder;
    WriteTargets targets;
    targets.add(folder.path("a.obj"), FOOTFALL_TEXT("the export"));
    targets.add("", FOOTFALL_TEXT("the statistics"));
    targets.add(folder.path("a.json"), FOOTFALL_TEXT("the statistics"));
    const std::string again = folder.path("./a.json");
    QCOMPARE(messageOf<InputError>([&] { targets.add(again, FOOTFALL_TEXT("the timeline")); }),
             QString::fromStdString(again) + ": cannot hold both the statistics and the timeline; give two files");
    // An unwritable target is reported before anything is computed.
    QVERIFY(messageOf<RunError>([&] {
              targets.add(folder.path("none/a.html"), FOOTFALL_TEXT("the report"));
            }).contains("its folder does not exist"));
  }

  void companions_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QStringList>("expected");
    const auto row = [](const char* what, const char* name, const QByteArray& content, const QStringList& expected) {
      QTest::newRow(what) << name << content << expected;
    };
    row("two libraries", "a.obj", "mtllib one.mtl two.mtl\r\nv 0 0 0\n", {"one.mtl", "picture.png", "two.mtl"});
    row("a library with a blank", "a.obj", "# x\nmtllib my lib.mtl\n", {"my lib.mtl"});
    row("a library that is not there", "a.obj", "mtllib none.mtl\n", {});
    row("a library elsewhere, with the other slashes", "a.obj", "mtllib C:\\work\\two.mtl\n", {"two.mtl"});
    row("glTF", "a.gltf", R"({"buffers":[{"uri":"a%20b.bin"}],"images":[{"uri" : "sub\/deep.png"}]})",
        {"a b.bin", "sub/deep.png"});
    row("glTF with its data inside", "a.gltf", R"({"buffers":[{"uri":"data:application/octet-stream;base64,AAAA"}]})",
        {});
    row("binary glTF", "a.glb", QByteArray("glTF\x02\0\0\0", 8) + R"({"images":[{"uri":"picture.png"}]})",
        {"picture.png"});
    row("COLLADA", "a.dae", "<init_from>file://sub/deep.png</init_from>", {"sub/deep.png"});
    row("binary FBX", "a.fbx", QByteArray("S\x0b\0\0\0PICTURE.PNG", 16) + QByteArray("S\x0b\0\0\0picture.png", 16),
        {"picture.png"});
    row("PLY", "a.ply", "ply\ncomment TextureFile picture.png\n", {"picture.png"});
    row("STL names nothing", "a.stl", "solid picture.png\n", {});
    row("across a block", "a.obj", QByteArray((4 << 20) - 10, '#') + "\nmtllib two.mtl\n", {"two.mtl"});
  }
  void companions() {
    QFETCH(QString, name);
    QFETCH(QByteArray, content);
    QFETCH(QStringList, expected);
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path("sub"));
    folder.write("one.mtl", "map_Kd picture.png\n");
    for (const char* file : {"two.mtl", "my lib.mtl", "picture.png", "a b.bin", "sub/deep.png"})
      folder.write(file, "x");
    folder.write(qPrintable(name), content);
    QCOMPARE(companionsOf(folder, qPrintable(name)), expected);
  }

  void noEnvironmentHasNoCompanions() {
    const TemporaryFolder folder;
    QVERIFY(companionFiles(folder.path("none.obj")).empty());
    QVERIFY(companionFiles(folder.path("")).empty());
  }
};

QTEST_GUILESS_MAIN(TestWriteTargets)
#include "test_write_targets.moc"
