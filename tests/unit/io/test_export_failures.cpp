// Every format of the table: bad options, bad targets, a full disk and cancelling leave what was there.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QProcess>
#include <QtTest>

#include "core/io/formats/detour_export.hpp"
#include "core/io/formats/save.hpp"
#include "core/report/floor_plan.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/report.hpp"
#include "footfall/run.hpp"
#include "tests/unit/environment_files.hpp"
#include "tests/unit/program_run.hpp"
#include "tests/unit/small_files.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

const QString kSample = QStringLiteral(FOOTFALL_SOURCE_DIR "/samples/tower/tower.obj");

/// Files of a folder with what is in them.
using Contents = std::map<QString, QByteArray>;

Contents contentsOf(const QString& folder) {
  Contents contents;
  for (const QString& name : QDir(folder).entryList(QDir::Files | QDir::Hidden))
    contents[name] = contentOf(folder + '/' + name);
  return contents;
}

/// `name` in a folder.
std::string in(const TemporaryFolder& folder, const std::string& name) { return folder.path(name.c_str()); }

/// The files that an export of the sample in one format, or a plan of it, writes.
struct Case {
  std::string ending;
  /// The bytes; throws what `poll` throws.
  std::function<std::vector<OutputFile>(const std::string& path, Poll poll)> make;
};

}  // namespace

class TestExportFailures : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    environment_ = std::make_shared<const Environment>(load(kSample.toStdString()));
    pipeline_ = defaultPipeline(*environment_);
    RunContext context;
    mesh_ = runPipeline(environment_, pipeline_, context).mesh;
    QVERIFY(mesh_->layerCount > 1);
    for (const FormatDescriptor& format : exportFormats())
      if (format.format != ExportFormat::Detour || hasDetour())
        cases_.push_back(
            {format.ending, [this, &format](const std::string& path, Poll poll) {
               return formatExport(format.format, path, *mesh_, makeExportHeader(pipeline_), {}, {}, poll).files;
             }});
    for (const char* ending : {".svg", ".pdf"})
      cases_.push_back({ending, [this](const std::string& path, Poll poll) {
                          return makePlanFiles(*environment_, pipeline_, *mesh_, path, {}, poll);
                        }});
    QVERIFY(cases_.size() >= 8);
  }

  void optionsThatMeanNothingAreRefused() {
    for (const FormatDescriptor& format : exportFormats()) {
      const auto refused = [&](auto change) {
        ExportOptions options;
        change(options);
        try {
          checkOptions(format.format, options);
        } catch (const InputError&) {
          return true;
        }
        return false;
      };
      QVERIFY(!refused([](ExportOptions& o) {
        o.layers = o.connections = o.obstacleEdges = o.steps = o.drops = false;
        o.scale = 2;
      }));
      QCOMPARE(refused([](ExportOptions& o) { o.up = UpAxis::Y; }), format.format != ExportFormat::Obj);
      QCOMPARE(refused([](ExportOptions& o) { o.godot = 3; }), format.format != ExportFormat::Godot);
      QCOMPARE(refused([](ExportOptions& o) { o.navmeshNode = true; }),
               QByteArray(format.ending) != ".gltf" && QByteArray(format.ending) != ".glb");
      const bool isPolygons = format.format == ExportFormat::Wkt || format.format == ExportFormat::GeoJson;
      QCOMPARE(refused([](ExportOptions& o) { o.part = 0; }), !isPolygons);
      QCOMPARE(refused([](ExportOptions& o) { o.coordinateSystem = "EPSG:25832"; }),
               format.format != ExportFormat::GeoJson);
    }
    const TemporaryFolder folder;
    const QString out = QString::fromStdString(folder.path("a.obj"));
    const Outcome outcome = runProgram({"run", kSample, "--quiet", "-o", out, "--godot", "3"});
    QCOMPARE(outcome.exitCode, 2);
    QVERIFY2(outcome.err.contains("ends in .obj has no choice of a version of Godot"), outcome.err.constData());
    QVERIFY(!QFile::exists(out));
    QCOMPARE(runProgram({"run", kSample, "--quiet", "-o", QString::fromStdString(folder.path("a.wkt")), "--part", "99"})
                 .exitCode,
             2);
    QVERIFY(contentsOf(QString::fromStdString(folder.path("."))).empty());
  }

  // The targets are there already, and stay as they were.
  void cancelledAtEveryPoll() {
    for (const Case& one : cases_) {
      const TemporaryFolder folder;
      const std::string path = in(folder, "level" + one.ending);
      const QString place = QString::fromStdString(folder.path("."));
      writeFilesSafely(one.make(path, {}));
      const Contents finished = contentsOf(place);
      for (const auto& [name, bytes] : finished) {
        QFile file(place + '/' + name);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("before") == 6);
      }
      const Contents before = contentsOf(place);
      int polls = 0;
      for (int last = 0;; ++last) {
        polls = 0;
        const auto count = [&] {
          if (polls++ == last) throw Cancelled();
        };
        try {
          writeFilesSafely(one.make(path, count), count);
          break;
        } catch (const Cancelled&) {
          QVERIFY2(contentsOf(place) == before, one.ending.c_str());
        }
        if (last > 50) last += last / 2;  // Plans have many.
      }
      QVERIFY2(polls >= 3, one.ending.c_str());
      QVERIFY2(contentsOf(place) == finished, one.ending.c_str());
    }
  }

  void aDiskThatFillsUp() {
    for (const Case& one : cases_) {
      const TemporaryFolder folder;
      const std::string path = in(folder, "level" + one.ending);
      const QString place = QString::fromStdString(folder.path("."));
      std::vector<OutputFile> files = one.make(path, {});
      std::size_t largest = 0;
      for (OutputFile& file : files) {
        largest = std::max(largest, file.bytes.size());
        QFile before(QString::fromStdString(file.path));
        QVERIFY(before.open(QIODevice::WriteOnly) && before.write("before") == 6);
      }
      const Contents before = contentsOf(place);
      // The largest of several files alone does not fit; the others must stay as well.
      for (const std::size_t room : {largest - 1, std::size_t{1}}) {
        const SmallFiles small(room);
        const QString message = messageOf<RunError>([&] { writeFilesSafely(files); });
        QVERIFY2(message.contains("too large"), qPrintable(message));
        QVERIFY2(contentsOf(place) == before, one.ending.c_str());
      }
    }
  }

  // A real file system of 16 KB, where this may be made.
  void aFullFileSystem() {
    const TemporaryFolder folder;
    const QString place = QString::fromStdString(folder.path("."));
    const auto inside = [&](const QString& command) {
      QProcess process;
      process.start("unshare",
                    {"-rm", "sh", "-c", "mount -t tmpfs -o size=16k none \"$0\" && cd \"$0\" && " + command, place});
      return process.waitForFinished(120000) ? std::pair(process.exitCode(), process.readAll())
                                             : std::pair(-1, QByteArray());
    };
    if (inside("true").first != 0) QSKIP("no file system can be mounted here");
    for (const Case& one : cases_) {
      const QString name = "level" + QString::fromStdString(one.ending);
      const QString command = one.ending == ".svg" || one.ending == ".pdf" ? "plan" : "run";
      // The existing files take all the room but a page for the folder itself.
      const auto [code, out] =
          inside("printf before > before && { head -c 8192 /dev/zero > filler; " + QString(FOOTFALL_PROGRAM) + ' ' +
                 command + ' ' + kSample + " --quiet -o " + name + " 2>&1; echo $?; ls -A; }");
      QCOMPARE(code, 0);
      const bool fits = out.contains("\n0\n") || out.startsWith("0\n");
      QVERIFY2(fits || (out.contains("the disk is full") && out.contains("1\nbefore\nfiller\n")), out.constData());
      QVERIFY2(!out.contains(".tmp") && !(fits && one.ending == ".obj"), out.constData());
    }
  }

  void badTargets() {
    for (const FormatDescriptor& format : exportFormats()) {
      if (format.format == ExportFormat::Detour && !hasDetour()) continue;
      const TemporaryFolder folder;
      const auto failure = [&](const std::string& path) { return messageOf<RunError>([&] { save(*mesh_, path); }); };
      QVERIFY(failure(in(folder, std::string("nowhere/a") + format.ending)).contains("folder does not exist"));
      // One file of the set alone cannot be written.
      const std::string taken = in(folder, std::string(format.hasFilesBeside ? "a-links" : "a") + format.ending);
      QVERIFY(QDir().mkpath(QString::fromStdString(taken)));
      QVERIFY(failure(in(folder, std::string("a") + format.ending)).contains("is a folder"));
      QVERIFY(contentsOf(QString::fromStdString(folder.path("."))).empty());
    }
  }

  void filesThatMayBeReplaced() {
    const TemporaryFolder folder;
    for (const char* name : {"plan-10.svg", "plan-2.svg", "plan.svg", "plan-links.svg", "plan-old.svg", "plan-1.pdf",
                             "plane-1.svg", "plan-.svg"})
      folder.write(name, "x");
    QVERIFY((existingOutputs(folder.path("plan.svg")) == std::vector{folder.path("plan.svg"), folder.path("plan-2.svg"),
                                                                     folder.path("plan-10.svg"),
                                                                     folder.path("plan-links.svg")}));
    QVERIFY(existingOutputs(folder.path("none.svg")).empty());
    QVERIFY(existingOutputs("/no/such/folder/plan.svg").empty());
  }

 private:
  std::shared_ptr<const Environment> environment_;
  Pipeline pipeline_;
  std::shared_ptr<const NavigationMesh> mesh_;
  std::vector<Case> cases_;
};

QTEST_GUILESS_MAIN(TestExportFailures)
#include "test_export_failures.moc"
