// The process that reads foreign formats: whatever it does, the program that started it goes on and reports the
// failure.
#include <sys/stat.h>

#include <QtTest>
#include <chrono>
#include <thread>

#include "core/io/foreign_reader.hpp"
#include "core/io/foreign_stream.hpp"
#include "core/io/import.hpp"
#include "tests/unit/environment_files.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::test;

namespace {

/// While it lives, a script is what reads other formats.
class FakeProgram {
 public:
  FakeProgram(const TemporaryFolder& folder, const QByteArray& script) {
    const std::string path = folder.write("reader.sh", "#!/bin/sh\n" + script + "\n");
    chmod(path.c_str(), 0755);
    qputenv("FOOTFALL_IMPORT", path.c_str());
  }
  ~FakeProgram() { qunsetenv("FOOTFALL_IMPORT"); }
  FakeProgram(const FakeProgram&) = delete;
  FakeProgram& operator=(const FakeProgram&) = delete;
};

Environment someEnvironment() {
  Environment environment;
  environment.vertices = {{0, 0, 0.1}, {1, 0, 0}, {0, 1e300, 0}};
  environment.triangles = {{0, 1, 2}, {2, 1, 0}};
  environment.parts = {{"wall", "stone"}, {"floor", ""}};
  environment.partOf = {1, 0};
  environment.skipped.lines = 7;
  environment.skipped.polygons = 1;
  environment.skipped.listed = {{SkipReason::RepeatedCorners, 3, 0, 2, "wall", {{0, 0, 2}}}};
  environment.notes = {Text(FOOTFALL_TEXT("%1 of %2"), Text::count(3), "x")};
  return environment;
}

QString readWith(const std::string& path, const ChildLimits& limits = {}, RunContext* context = nullptr) {
  return messageOf<InputError>([&] {
    Environment environment;
    readForeign(path, environment, limits, context);
  });
}

}  // namespace

class TestForeignReader : public QObject {
  Q_OBJECT
 private slots:
  void theStreamHoldsAllThatAReaderFinds() {
    const Environment given = someEnvironment();
    Environment taken;
    FileFrame frame;
    QVERIFY(!decodeStream(encodeEnvironment(given, {UpAxis::NegativeX, 0.0254}), taken, frame));
    QVERIFY(taken.vertices == given.vertices && taken.triangles == given.triangles && taken.parts == given.parts &&
            taken.partOf == given.partOf && taken.notes == given.notes);
    QVERIFY(taken.skipped.listed == given.skipped.listed && taken.skipped.lines == 7 && taken.skipped.polygons == 1);
    QVERIFY(frame.up == UpAxis::NegativeX && frame.metresPerUnit == 0.0254);
  }

  void errorsKeepTheirPatterns() {
    const Text message(FOOTFALL_TEXT("%1: %2; %3"), "a.dae", Text(FOOTFALL_TEXT("line %1"), 7), "do it");
    Environment none;
    FileFrame frame;
    const std::optional<Text> taken = decodeStream(encodeError(message), none, frame);
    QVERIFY(taken && *taken == message && taken->isPattern());
    QCOMPARE(QString::fromStdString(taken->str()), QString("a.dae: line 7; do it"));
  }

  void streamsThatAreCutOrChangedAreRefused() {
    const std::string whole = encodeEnvironment(someEnvironment(), {UpAxis::Z, std::nullopt});
    for (std::size_t length = 0; length < whole.size(); ++length) {
      Environment environment;
      FileFrame frame;
      QVERIFY_EXCEPTION_THROWN(decodeStream(whole.substr(0, length), environment, frame), BadStream);
    }
    std::size_t refused = 0;
    for (std::size_t at = 0; at < whole.size(); ++at)
      for (const char with : {'\0', '\x7f', '\xff'}) {
        std::string changed = whole;
        changed[at] = with;
        Environment environment;
        FileFrame frame;
        try {
          decodeStream(changed, environment, frame);
          for (const Triangle& t : environment.triangles)
            for (const std::uint32_t corner : t) QVERIFY(corner < environment.vertices.size());
        } catch (const BadStream&) {
          ++refused;
        }
      }
    QVERIFY(refused > whole.size());
  }

  void aReaderThatDoesNotEndWellIsNamed_data() {
    QTest::addColumn<QByteArray>("script");
    QTest::addColumn<QString>("expected");
    QTest::newRow("killed by a signal") << QByteArray("kill -SEGV $$") << "the reader for IFC ended by signal 11";
    QTest::newRow("an exit status") << QByteArray("exit 9") << "the reader for IFC ended with exit status 9";
    QTest::newRow("nothing") << QByteArray("exit 0") << "the reader for IFC ended too early";
    QTest::newRow("something else") << QByteArray("head -c 100000 /dev/zero") << "ended too early";
    QTest::newRow("the start of a stream") << QByteArray("printf 'footfall-import 1\\n\\001'") << "ended too early";
  }
  void aReaderThatDoesNotEndWellIsNamed() {
    QFETCH(QByteArray, script);
    QFETCH(QString, expected);
    const TemporaryFolder folder;
    const std::string path = folder.write("a.ifc", "x");
    const FakeProgram program(folder, script);
    const QString message = readWith(path);
    QVERIFY2(message.startsWith(QString::fromStdString(path) + ": "), qPrintable(message));
    QVERIFY2(message.contains(expected) && message.contains("; "), qPrintable(message));
  }

  void limitsOfTimeAndMemoryEndAReader() {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.dae", "x");
    ChildLimits limits;
    limits.wallMs = 300;
    {
      const FakeProgram program(folder, "sleep 1000");
      QVERIFY(readWith(path, limits).contains("reading it as COLLADA took more than 1 seconds"));
    }
    limits = {};
    limits.bytes = 64 << 20;
    {
      const FakeProgram program(folder, "exec tail -n 1000000000 /dev/zero");  // which keeps all of a line
      QVERIFY(readWith(path, limits).contains("took more than 64 MB of memory"));
    }
    const FakeProgram program(folder, "exec cat /dev/zero");
    QVERIFY(readWith(path, limits).contains("took more than 64 MB of memory"));
  }

  void limitsFollowFromTheSize() {
    QVERIFY(importLimits(0).bytes >= (512U << 20) && importLimits(0).wallMs >= 30000);
    QVERIFY(importLimits(100 << 20).wallMs > importLimits(1 << 20).wallMs);
    QVERIFY(importLimits(~std::uint64_t{0}).bytes >= importLimits(1 << 20).bytes);
    const TemporaryFolder folder;
    folder.write("b.bin", QByteArray(3 << 20, 'x'));
    const std::string alone = folder.write("a.gltf", "{}");
    const double before = importLimitsFor(alone).wallMs;
    QVERIFY(importLimitsFor(folder.write("b.gltf", R"({"buffers":[{"uri":"b.bin"}]})")).wallMs > before + 10000);
  }

  void cancellingKillsTheReader() {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.fbx", "x");
    const FakeProgram program(folder, "sleep 1000");
    RunContext context;
    std::thread canceller([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
      context.cancel();
    });
    const auto start = std::chrono::steady_clock::now();
    Environment environment;
    QVERIFY_EXCEPTION_THROWN(readForeign(path, environment, {}, &context), Cancelled);
    canceller.join();
    QVERIFY(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));  // 100 ms where nothing else runs
  }

  void withoutTheProgramTheMessageSaysSo() {
    qputenv("FOOTFALL_IMPORT", "/nowhere/footfall-import");
    const TemporaryFolder folder;
    const std::string path = folder.write("a.3ds", readAll(dataFile("floor.3ds")));
    const QString message = messageOf<InputError>([&] { importEnvironment(path); });
    qunsetenv("FOOTFALL_IMPORT");
    QVERIFY2(message.contains("footfall-import") && message.contains("/nowhere"), qPrintable(message));
    QVERIFY(findImportProgram().has_value());
    QCOMPARE(importEnvironment(path)->triangles.size(), std::size_t{1});
  }

  void damagedIfcEndsAReaderAtMost() {
    qputenv("FOOTFALL_IFC", "/nowhere");  // Assimp is to read it
    const QList<QByteArray> lines = readAll(dataFile("two_rooms.ifc")).split('\n');
    const TemporaryFolder folder;
    for (int gone = 0; gone < lines.size(); gone += 3) {
      QByteArray content;
      for (int i = 0; i < lines.size(); ++i)
        if (i != gone) content += lines[i] + '\n';
      const std::string path = folder.write("a.ifc", content);
      try {
        importEnvironment(path);
      } catch (const InputError& error) {
        QVERIFY2(std::string(error.what()).starts_with(path), error.what());
      }
    }
    qunsetenv("FOOTFALL_IFC");
  }

  void readingWorksWithClosedStandardFiles() {
    const QString command = QString("exec <&- >&- 2>&-; exec \"$0\" run \"$1\" --filter \"SlopeFilter 45\" -o \"$2\"");
    const TemporaryFolder folder;
    const std::string output = folder.path("out.obj");
    QProcess shell;
    shell.start("sh", {"-c", command, FOOTFALL_PROGRAM, QString::fromStdString(dataFile("floor.stl")),
                       QString::fromStdString(output)});
    QVERIFY(shell.waitForFinished(60000));
    QVERIFY2(QFile::exists(QString::fromStdString(output)), "nothing was written");
  }

  void bufferThatIsAPipeIsRefused() {
    const TemporaryFolder folder;
    QVERIFY(mkfifo(folder.path("b.bin").c_str(), 0600) == 0);
    const std::string path =
        folder.write("a.gltf", readAll(dataFile("transforms.gltf"))
                                   .replace("data:application/octet-stream;base64,", "b.bin?")
                                   .replace(QByteArray("b.bin?"), QByteArray("b.bin\", \"x\": \"")));
    QVERIFY(messageOf<InputError>([&] { importEnvironment(path); }).contains("not an ordinary file"));
  }
};

QTEST_GUILESS_MAIN(TestForeignReader)
#include "test_foreign_reader.moc"
