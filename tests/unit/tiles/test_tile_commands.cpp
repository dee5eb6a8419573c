// `footfall run --memory` and `footfall join` as a user runs them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "core/io/formats/format_table.hpp"
#include "tests/unit/program_run.hpp"

using namespace footfall;
using namespace footfall::test;

namespace {

const QStringList kPipeline{"--filter", "SlopeFilter 45", "--filter", "VerticalClearanceFilter 2",
                            "--filter", "AreaFilter 1"};

QString sample(const QString& name) { return QString(FOOTFALL_SOURCE_DIR "/samples/%1/%1.obj").arg(name); }

QStringList entriesOf(const QString& folder) {
  return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot);
}

/// A city that needs more memory than the bound below when it is held as a whole.
QString makeCity(const QTemporaryDir& folder, const QString& triangles = "600000") {
  const QString path = folder.filePath("city.obj");
  QProcess process;
  process.start(FOOTFALL_BINARY_DIR "/footfall-samples", {"city", triangles, path});
  return process.waitForFinished(120000) && process.exitCode() == 0 ? path : QString();
}

}  // namespace

class TestTileCommands : public QObject {
  Q_OBJECT

 private slots:
  void everyFormatHasTheSameBytes();
  void theBoundIsKept();
  void theNamedMemoryIsEnough_data();
  void theNamedMemoryIsEnough();
  void statisticsGoElsewhere();
  void partsHaveRoles();
  void noMemoryAtAllIsRefused();
  void slicesOfOtherSidesAreNotJoined();
  void slicesAreJoined();
  void stepsAreLinked();
  void whatCannotBeIsRefused();
  void nothingOfOthersIsTouched();
  void damagedTilesAreRefused();
};

void TestTileCommands::everyFormatHasTheSameBytes() {
  const QTemporaryDir folder;
  const QString packed = folder.filePath("house.ffenv"), tiles = folder.filePath("tiles");
  QCOMPARE(runProgram({"pack", sample("house"), "-o", packed, "--quiet"}).exitCode, 0);
  const Outcome tiled = runProgram(QStringList{"run", packed, "--memory", "70M", "-o", tiles} + kPipeline);
  QVERIFY2(tiled.exitCode == 0, tiled.err);
  QVERIFY2(tiled.out.contains(" walkable triangles of "), tiled.out);
  for (const detail::FormatDescriptor& format : detail::exportFormats()) {
    const QString whole = folder.filePath("whole") + format.ending, joined = folder.filePath("joined") + format.ending;
    const Outcome run = runProgram(QStringList{"run", packed, "--quiet", "-o", whole} + kPipeline);
    const Outcome join = runProgram({"join", tiles, "--quiet", "-o", joined});
    QCOMPARE(join.exitCode, run.exitCode);  // a format can be missing
    QCOMPARE(contentOf(joined), contentOf(whole));
  }
  // The default pipeline.
  const QString usual = folder.filePath("usual");
  QCOMPARE(runProgram({"run", packed, "--memory", "70M", "--quiet", "-o", usual}).exitCode, 0);
  QCOMPARE(runProgram({"join", usual, "--quiet", "-o", usual + ".obj"}).exitCode, 0);
  QCOMPARE(runProgram({"run", packed, "--quiet", "-o", usual + "-whole.obj"}).exitCode, 0);
  QCOMPARE(contentOf(usual + ".obj"), contentOf(usual + "-whole.obj"));
  // The run is from the original, which is packed for the run alone, and with options of the export.
  const QString again = folder.filePath("again"), first = folder.filePath("1.obj"), second = folder.filePath("2.obj");
  QCOMPARE(
      runProgram(QStringList{"run", sample("house"), "--memory", "1G", "--quiet", "-o", again} + kPipeline).exitCode,
      0);
  QVERIFY(!entriesOf(again).contains("environment.ffenv"));
  const QStringList scaled{"--export-up", "z", "--export-scale", "2", "--no-obstacle-edges", "--quiet"};
  QCOMPARE(runProgram(QStringList{"join", again, "-o", first} + scaled).exitCode, 0);
  QCOMPARE(runProgram(QStringList{"run", packed, "-o", second} + scaled + kPipeline).exitCode, 0);
  QVERIFY(!contentOf(first).isEmpty());
  QCOMPARE(contentOf(first), contentOf(second));
}

void TestTileCommands::theBoundIsKept() {
  const QTemporaryDir folder;
  const QString city = makeCity(folder);
  if (city.isEmpty()) QSKIP("the generator of samples is not there");
  const QString packed = folder.filePath("city.ffenv");
  QCOMPARE(runProgram({"pack", city, "-o", packed, "--quiet"}).exitCode, 0);
  qint64 whole = 0;
  for (const int megabytes : {4000, 160}) {
    const QString statistics = folder.filePath("stats.json");
    const Outcome run =
        runProgram(QStringList{"run", packed, "--memory", QString("%1M").arg(megabytes), "--quiet", "-o",
                               folder.filePath(QString::number(megabytes)), "--stats", statistics} +
                   kPipeline);
    QVERIFY2(run.exitCode == 0, run.err);
    const QJsonObject memory = QJsonDocument::fromJson(contentOf(statistics))["memory"].toObject();
    const auto bound = static_cast<qint64>(megabytes) << 20;
    QCOMPARE(memory["bound_bytes"].toInteger(), bound);
    const qint64 peak = memory["peak_bytes"].toInteger();
    QVERIFY2(peak > 0 && peak <= bound, qPrintable(QString::number(peak)));
    if (whole > 0) QVERIFY2(whole > bound, "the bound is none for this city");
    whole = peak;
  }
}

void TestTileCommands::theNamedMemoryIsEnough_data() {
  QTest::addColumn<QStringList>("steps");
  QTest::newRow("the default pipeline: floors at gaps are one cell") << QStringList();
  QTest::newRow("layers of what is not simplified")
      << QStringList{"--filter", "SlopeFilter 45", "--filter", "LayerSubdivisionFilter"};
}

// The first message names enough, whatever came first that had no room.
void TestTileCommands::theNamedMemoryIsEnough() {
  QFETCH(QStringList, steps);
  const QTemporaryDir folder;
  const QString city = makeCity(folder, "100000");
  if (city.isEmpty()) QSKIP("the generator of samples is not there");
  const QString packed = folder.filePath("city.ffenv");
  QCOMPARE(runProgram({"pack", city, "-o", packed, "--quiet"}).exitCode, 0);
  int runs = 0;
  const auto runWithin = [&](const QString& megabytes) {
    return runProgram(QStringList{"run", packed, "--memory", megabytes + "M", "--quiet", "-o",
                                  folder.filePath("run" + QString::number(++runs))} +
                      steps);
  };
  int refused = 0;
  for (const QString megabytes : {"70", "80", "95"}) {
    const Outcome first = runWithin(megabytes);
    if (first.exitCode == 0) continue;
    ++refused;
    QVERIFY2(first.err.contains("a memory of " + megabytes.toUtf8() + " MB is too little; give "), first.err);
    const QString named = QString(first.err).section("give ", 1).section(" MB", 0, 0);
    const Outcome second = runWithin(named);
    QVERIFY2(second.exitCode == 0, second.err);
  }
  QVERIFY(refused > 0);
}

void TestTileCommands::statisticsGoElsewhere() {
  const QTemporaryDir folder;
  const QString tiles = folder.filePath("tiles");
  for (const QString& statistics : {tiles + "/index.json", tiles}) {
    const Outcome run = runProgram(
        QStringList{"run", sample("house"), "--memory", "1G", "-o", tiles, "--stats", statistics} + kPipeline.first(4));
    QCOMPARE(run.exitCode, 2);
    QVERIFY2(run.err.contains("--stats"), run.err);
    QVERIFY(QDir(folder.path()).isEmpty());
  }
}

void TestTileCommands::partsHaveRoles() {
  const QTemporaryDir folder;
  const auto named = [&](const char* name) { return folder.filePath(name); };
  const QStringList steps =
      kPipeline + QStringList{"--filter", "SimplificationFilter", "--filter", "LayerSubdivisionFilter"};
  // A table and a rug in a room; the tap is so small that the grid becomes another one without it.
  write(named("room.obj"),
        "v 0 0 0\nv 8 0 0\nv 8 8 0\nv 0 8 0\nv 1 1 1\nv 3 1 1\nv 3 3 1\nv 1 3 1\nv 4 4 0.25\nv 7 4 0.25\n"
        "v 7 7 0.25\nv 4 7 0.25\nv 2 6 1e-30\nv 2.5 6 1e-30\nv 2 6.123456789 1e-30\n"
        "o floor\nf 1 2 3\nf 1 3 4\no table\nf 5 6 7\nf 5 7 8\no rug\nf 9 10 11\nf 9 11 12\no tap\nf 13 14 15\n");
  for (const QStringList& roles :
       {QStringList{}, QStringList{"--obstacle-only", "rug"}, QStringList{"--ignore", "table", "--ignore", "tap"},
        QStringList{"--obstacle-only", "table", "--ignore", "rug"}, QStringList{"--ignore", "floor"}}) {
    const QStringList run = QStringList{"run", named("room.obj"), "--up", "z", "--quiet"} + roles + steps;
    QCOMPARE(runProgram(run + QStringList{"-o", named("whole.obj")}).exitCode, 0);
    QCOMPARE(runProgram(run + QStringList{"--memory", "1G", "-o", named("tiles")}).exitCode, 0);
    QCOMPARE(runProgram({"join", named("tiles"), "--quiet", "-o", named("joined.obj")}).exitCode, 0);
    QVERIFY(!contentOf(named("whole.obj")).isEmpty());
    QCOMPARE(contentOf(named("joined.obj")), contentOf(named("whole.obj")));
    QVERIFY(QDir(named("tiles")).removeRecursively());
  }
  QStringList all{"run", named("room.obj"), "--memory", "1G", "-o", named("tiles")};
  for (const char* part : {"floor", "table", "rug", "tap"}) all += {"--ignore", part};
  const Outcome nothing = runProgram(all + steps);
  QVERIFY2(nothing.exitCode == 2 && nothing.err.contains("--ignore: nothing of "), nothing.err);
}

void TestTileCommands::noMemoryAtAllIsRefused() {
  const QTemporaryDir folder;
  const Outcome run = runProgram(
      QStringList{"run", sample("house"), "--memory", "0", "--slice", "2/8", "-o", folder.filePath("out.obj")} +
      kPipeline.first(4));
  QCOMPARE(run.exitCode, 2);
  QVERIFY(QDir(folder.path()).isEmpty());
}

void TestTileCommands::slicesOfOtherSidesAreNotJoined() {
  const QTemporaryDir folder;
  const QString packed = folder.filePath("villa.ffenv");
  QCOMPARE(runProgram({"pack", sample("villa"), "-o", packed, "--quiet"}).exitCode, 0);
  for (const QStringList& slice : {QStringList{"1/2", "one"}, QStringList{"2/2", "two", "--both-sides"}})
    QCOMPARE(runProgram(QStringList{"run", packed, "--memory", "1G", "--slice", slice[0], "--quiet", "-o",
                                    folder.filePath(slice[1])} +
                        slice.mid(2) + kPipeline.first(4))
                 .exitCode,
             0);
  const Outcome joined =
      runProgram({"join", folder.filePath("one"), folder.filePath("two"), "-o", folder.filePath("out.obj")});
  QCOMPARE(joined.exitCode, 2);
  QVERIFY2(joined.err.contains("give folders of one run"), joined.err);
}

void TestTileCommands::slicesAreJoined() {
  const QTemporaryDir folder;
  const QStringList local = kPipeline.first(4);  // the filters without the area
  const auto named = [&](const char* name) { return folder.filePath(name); };
  for (const char* slice : {"1", "2", "3"})
    QCOMPARE(runProgram(QStringList{"run", sample("villa"), "--memory", "1G", "--slice", QString(slice) + "/3",
                                    "--quiet", "-o", named(slice)} +
                        local)
                 .exitCode,
             0);
  QCOMPARE(
      runProgram(QStringList{"run", sample("villa"), "--memory", "1G", "--quiet", "-o", named("all")} + local).exitCode,
      0);
  QCOMPARE(runProgram({"join", named("all"), "--quiet", "-o", named("all.obj")}).exitCode, 0);
  QCOMPARE(runProgram({"join", named("3"), named("1"), named("2"), "--quiet", "-o", named("joined.obj")}).exitCode, 0);
  QVERIFY(!contentOf(named("all.obj")).isEmpty());
  QCOMPARE(contentOf(named("joined.obj")), contentOf(named("all.obj")));
  const auto refused = [&](const QStringList& folders, const char* words) {
    const Outcome outcome = runProgram(QStringList{"join"} + folders + QStringList{"-o", named("no.obj")});
    return outcome.exitCode == 2 && outcome.err.contains(words) ? QByteArray() : outcome.err;
  };
  QCOMPARE(refused({named("1"), named("2")}, "is slice 1 of 3, and the folders given are not all"), QByteArray());
  QCOMPARE(refused({named("1"), named("2"), named("2")}, "is slice 2 of 3"), QByteArray());
  QCOMPARE(refused({named("1"), named("2"), named("all")}, "are tiles of different environments"), QByteArray());
  const QStringList run{"run", sample("house"), "--memory", "1G", "-o", named("x"), "--slice"};
  for (const char* wrong : {"0/3", "4/3", "x", "1/", "/2", "1/2x"}) {
    const Outcome outcome = runProgram(run + QStringList{wrong} + local);
    QVERIFY2(outcome.exitCode == 2 && outcome.err.contains("is not a slice"), outcome.err);
  }
  const Outcome area = runProgram(run + QStringList{"1/2"} + kPipeline);
  QVERIFY2(area.exitCode == 2 && area.err.contains("AreaFilter sees over the borders of slices"), area.err);
}

void TestTileCommands::stepsAreLinked() {
  const QTemporaryDir folder;
  const auto named = [&](const QString& name) { return folder.filePath(name); };
  const QStringList linked = kPipeline.first(4) + QStringList{"--filter", "StepFilter 0.4 0"};
  QCOMPARE(runProgram(QStringList{"run", sample("villa"), "--quiet", "-o", named("whole.obj")} + linked).exitCode, 0);
  QVERIFY(contentOf(named("whole.obj")).contains("\nl "));
  // Links go over slices as well.
  QStringList parts;
  for (const QString slice : {"1", "2", "3"}) {
    parts.push_back(named(slice));
    QCOMPARE(runProgram(QStringList{"run", sample("villa"), "--memory", "80M", "--slice", slice + "/3", "--quiet", "-o",
                                    parts.back()} +
                        linked)
                 .exitCode,
             0);
  }
  QCOMPARE(runProgram(QStringList{"join"} + parts + QStringList{"--quiet", "-o", named("joined.obj")}).exitCode, 0);
  QCOMPARE(contentOf(named("joined.obj")), contentOf(named("whole.obj")));
  // The links are as many as in memory, each once; with gaps.
  const QStringList area = kPipeline.first(4) + QStringList{"--filter", "StepFilter 0.4", "--filter", "AreaFilter 1"};
  QCOMPARE(runProgram(QStringList{"run", sample("villa"), "--quiet", "--stats", named("whole.json"), "-o",
                                  named("again.obj")} +
                      area)
               .exitCode,
           0);
  QCOMPARE(runProgram(QStringList{"run", sample("villa"), "--memory", "90M", "--quiet", "--stats", named("tiles.json"),
                                  "-o", named("tiles")} +
                      area)
               .exitCode,
           0);
  const QJsonObject whole = QJsonDocument::fromJson(contentOf(named("whole.json"))).object();
  const QJsonObject tiles = QJsonDocument::fromJson(contentOf(named("tiles.json")))["tiles"].toObject();
  QVERIFY(tiles["count"].toInteger() > 1);
  QVERIFY(whole["links"].toInteger() > 0);
  QCOMPARE(tiles["links"].toInteger(), whole["links"].toInteger());
  // Connected parts are reported when tiles are joined.
  const Outcome outcome =
      runProgram({"join", named("tiles"), "-o", named("told.obj"), "--stats", named("joined.json")});
  QVERIFY2(outcome.out.contains(" steps between borders, ") && outcome.out.contains(" gaps between borders, "),
           outcome.out);
  const QJsonObject joined = QJsonDocument::fromJson(contentOf(named("joined.json"))).object();
  for (const char* key : {"vertices", "triangles", "links", "link_length", "highest_link", "links_by_kind",
                          "obstacle_edges", "components", "connected_share"})
    QVERIFY2(joined[key] == whole[key] && !joined[key].isUndefined(), key);
  QVERIFY(joined["components"].toArray().size() > 1);
  QVERIFY(std::abs(joined["area"].toDouble() - whole["area"].toDouble()) < 1e-6);
}

void TestTileCommands::whatCannotBeIsRefused() {
  const QTemporaryDir folder;
  const QString tiles = folder.filePath("tiles"), house = sample("house");
  const auto refused = [&](const QStringList& arguments, const char* words) {
    const Outcome outcome = runProgram(arguments);
    return outcome.exitCode == 2 && outcome.err.contains(words) && entriesOf(folder.path()).isEmpty()
               ? QByteArray()
               : outcome.err + outcome.out;
  };
  const QStringList run{"run", house, "--memory", "1G", "-o", tiles};
  QCOMPARE(refused(run + kPipeline + QStringList{"--filter", "RadiusFilter 0.4"}, "RadiusFilter sees across cells"),
           QByteArray());
  QCOMPARE(refused(run + kPipeline.first(4) + QStringList{"--filter", "StepFilter 0.4", "--slice", "1/2"},
                   "StepFilter with a gap sees over the borders of slices"),
           QByteArray());
  QCOMPARE(refused(run + kPipeline + QStringList{"--ignore", "x"}, "--ignore \"x\": "), QByteArray());
  QCOMPARE(refused(run + kPipeline + QStringList{"--no-layers"}, "--no-layers"), QByteArray());
  QCOMPARE(refused(QStringList{"run", house, "--memory", "1G"} + kPipeline, "give the folder for the tiles"),
           QByteArray());
  QCOMPARE(refused(QStringList{"run", house, "--memory", "1M", "-o", tiles} + kPipeline,
                   "a memory of 1 MB is too little; give "),
           QByteArray());
  // The error comes before anything is packed: these files do not exist.
  const QStringList missing{"run", folder.filePath("missing.obj"), "-o", tiles, "--memory"};
  QCOMPARE(refused(missing + QStringList{"1M"} + kPipeline, "a memory of 1 MB is too little; give "), QByteArray());
  QCOMPARE(refused(missing + QStringList{"1G", "--slice", "1/2"} + kPipeline, "AreaFilter sees over the borders"),
           QByteArray());
  QCOMPARE(refused(missing + QStringList{"1G", "--slice", "1/2", "--filter", "LayerSubdivisionFilter"},
                   "LayerSubdivisionFilter sees over the borders"),
           QByteArray());
  QCOMPARE(refused({"join", tiles, "-o", folder.filePath("a.obj")}, "is no folder of tiles"), QByteArray());
  QVERIFY(QDir().mkdir(tiles));
  const Outcome empty = runProgram({"join", tiles, "-o", folder.filePath("a.obj")});
  QVERIFY2(empty.exitCode == 2 && empty.err.contains("has no index.json"), empty.err);
  write(tiles + "/mine.txt", "x");
  const Outcome taken = runProgram(run + kPipeline);
  QVERIFY2(taken.exitCode == 2 && taken.err.contains("is not an empty folder"), taken.err);
  QCOMPARE(entriesOf(tiles), QStringList{"mine.txt"});
}

// The folder is one where another run is at work, where a file has the same name, or where the environment lies.
void TestTileCommands::nothingOfOthersIsTouched() {
  const QTemporaryDir folder;
  const QString target = folder.filePath("tiles");
  QVERIFY(QDir().mkdir(target));
  const auto run = [&](const QString& environment) {
    return runProgram(QStringList{"run", environment, "--memory", "1G", "-o", target, "--quiet"} + kPipeline);
  };
  const int lock = ::open(target.toLocal8Bit().constData(), O_RDONLY | O_DIRECTORY);
  QVERIFY(lock >= 0 && ::flock(lock, LOCK_EX | LOCK_NB) == 0);
  const Outcome locked = run(sample("house"));
  QVERIFY2(locked.exitCode == 2 && locked.err.contains("another run is using"), locked.err);
  QCOMPARE(entriesOf(target), QStringList());
  ::close(lock);

  QFile own(QDir(target).filePath("unfinished"));
  QVERIFY(own.open(QFile::WriteOnly) && own.write("chapters two and three\n") > 0);
  own.close();
  const Outcome taken = run(sample("house"));
  QVERIFY2(taken.exitCode == 2 && taken.err.contains("is not an empty folder"), taken.err);
  QCOMPARE(entriesOf(target), QStringList{"unfinished"});
  QVERIFY(own.remove());

  const QString packed = QDir(target).filePath("environment.ffenv");
  QCOMPARE(runProgram({"pack", sample("house"), "-o", packed, "--quiet"}).exitCode, 0);
  const Outcome inside = run(packed);
  QVERIFY2(inside.exitCode == 2 && inside.err.contains("this file is in the folder of the tiles"), inside.err);
  QCOMPARE(entriesOf(target), QStringList{"environment.ffenv"});
}

void TestTileCommands::damagedTilesAreRefused() {
  const QTemporaryDir folder;
  const QString tiles = folder.filePath("tiles"), out = folder.filePath("a.obj");
  QCOMPARE(
      runProgram(QStringList{"run", sample("house"), "--memory", "1G", "--quiet", "-o", tiles} + kPipeline).exitCode,
      0);
  const auto joinedWith = [&](const QString& file, const QByteArray& content) {
    const QByteArray before = contentOf(tiles + '/' + file);
    write(tiles + '/' + file, content);
    const Outcome outcome = runProgram({"join", tiles, "-o", out});
    write(tiles + '/' + file, before);
    return outcome.exitCode == 2 && !QFile::exists(out) ? outcome.err : QByteArray("was taken: ") + outcome.err;
  };
  const QString tile = "tile-0000001.fftile";
  const QByteArray bytes = contentOf(tiles + '/' + tile), index = contentOf(tiles + "/index.json");
  QByteArray changed = bytes;
  changed[changed.size() / 2] = static_cast<char>(changed[changed.size() / 2] ^ 1);
  for (const QByteArray& content : {changed, bytes.first(bytes.size() / 2), QByteArray("nothing")})
    QVERIFY(joinedWith(tile, content).contains("is damaged, or of another run"));
  QVERIFY(joinedWith("index.json", "{}").contains("is no index of tiles"));
  QVERIFY(joinedWith("index.json", index.first(index.size() / 2)).contains("is damaged"));
  QByteArray outside = index;
  QVERIFY(joinedWith("index.json", outside.replace("tile-0000001", "../tile-0000001")).contains("not in it"));
  QByteArray older = index;
  QVERIFY(joinedWith("index.json", older.replace("\"version\": 2", "\"version\": 1")).contains("of another version"));
  QCOMPARE(runProgram({"join", tiles, "-o", out, "--quiet"}).exitCode, 0);
}

QTEST_APPLESS_MAIN(TestTileCommands)
#include "test_tile_commands.moc"
