// The built program as a user meets it: output, files, exit codes and signals.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <signal.h>
#include <unistd.h>

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>

#include "tests/unit/program_run.hpp"

using namespace footfall::test;

namespace {

// A floor of 10 by 10, Z up, with a board of 2 by 2 one above it.
constexpr const char* kFloorWithBoard =
    "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 4 4 1\nv 6 4 1\nv 6 6 1\nv 4 6 1\n"
    "f 1 2 3\nf 1 3 4\nf 5 6 7\nf 5 7 8\n";

// A hilly ground of 2 * n * n triangles under as many others: enough work for a signal to arrive in the middle.
QByteArray largeEnvironment(int n) {
  QByteArray text;
  for (int level = 0; level < 2; ++level) {
    for (int y = 0; y <= n; ++y) {
      for (int x = 0; x <= n; ++x) {
        const int height = (x * 7 + y * 13 + level * 5) % 11;
        text += QByteArray("v ") + QByteArray::number(x) + ' ' + QByteArray::number(y) + ' ' +
                QByteArray::number(height * 0.125 + level) + '\n';
      }
    }
  }
  for (int level = 0; level < 2; ++level) {
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        const int a = level * (n + 1) * (n + 1) + y * (n + 1) + x + 1, b = a + 1, c = b + n + 1, d = a + n + 1;
        for (const auto& [p, q, r] : {std::array{a, b, c}, std::array{a, c, d}}) {
          text += QByteArray("f ") + QByteArray::number(p) + ' ' + QByteArray::number(q) + ' ' + QByteArray::number(r) +
                  '\n';
        }
      }
    }
  }
  return text;
}

// True when the process blocks SIGINT: from then on it cancels instead of dying of it.
bool blocksInterrupt(qint64 pid) {
  for (const QByteArray& line : contentOf(QString("/proc/%1/status").arg(pid)).split('\n')) {
    if (line.startsWith("SigBlk:")) return (line.mid(7).trimmed().toULongLong(nullptr, 16) & (1u << (SIGINT - 1))) != 0;
  }
  return false;
}

}  // namespace

class TestCommandLine : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void version();
  void help();
  void filtersAreListed();
  void oneFilterIsExplained();
  void referenceAsMarkdown();
  void info();
  void runWithDefaultPipeline();
  void runWritesNothingByDefault();
  void quietRun();
  void noProgressBarInAPipe();
  void exportSaysHowItWasMade();
  void sameBytesWithAnyNumberOfThreads();
  void statisticsSchema();
  void statisticsOfComponents();
  void parallelListingRuns();
  void wrongUsageOrInput_data();
  void wrongUsageOrInput();
  void nothingThatIsReadIsWrittenOver();
  void whereNothingCanBeWrittenIsToldFirst();
  void failedRunKeepsAnEarlierFile();
  void signalsCancel_data();
  void signalsCancel();

 private:
  QString path(const QString& name) const { return folder_->filePath(name); }
  QStringList names() const {
    return QDir(folder_->path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden);
  }

  std::unique_ptr<QTemporaryDir> folder_;
};

void TestCommandLine::init() {
  folder_ = std::make_unique<QTemporaryDir>();
  QVERIFY(folder_->isValid());
  write(path("board.obj"), kFloorWithBoard);
}

void TestCommandLine::version() {
  const Outcome outcome = runProgram({"--version"});
  QCOMPARE(outcome.exitCode, 0);
  QVERIFY(outcome.out.startsWith("footfall "));
  QVERIFY(outcome.out.at(9) >= '0' && outcome.out.at(9) <= '9');
}

void TestCommandLine::help() {
  const Outcome outcome = runProgram({"--help"});
  QCOMPARE(outcome.exitCode, 0);
  for (const char* word : {"run", "compare", "info", "filters", "--version"}) QVERIFY(outcome.out.contains(word));
  const Outcome run = runProgram({"run", "--help"});
  QCOMPARE(run.exitCode, 0);
  for (const char* word :
       {"-p", "--filter", "--up", "--scale", "--both-sides", "--threads", "-o", "--stats", "--quiet"}) {
    QVERIFY2(run.out.contains(word), word);
  }
}

void TestCommandLine::filtersAreListed() {
  const Outcome outcome = runProgram({"filters"});
  QCOMPARE(outcome.exitCode, 0);
  QVERIFY(outcome.out.contains("SlopeFilter max_slope"));
  QVERIFY(outcome.out.contains("Collapse"));
}

void TestCommandLine::oneFilterIsExplained() {
  const Outcome outcome = runProgram({"filters", "PEELFilter"});
  QCOMPARE(outcome.exitCode, 0);
  QVERIFY(outcome.out.startsWith("LayerSubdivisionFilter\n"));
  QVERIFY(outcome.out.contains("precondition:"));
}

void TestCommandLine::referenceAsMarkdown() {
  const Outcome outcome = runProgram({"filters", "--markdown"});
  QCOMPARE(outcome.exitCode, 0);
  QCOMPARE(outcome.out, contentOf(FOOTFALL_SOURCE_DIR "/docs/reference/filters.md"));
}

void TestCommandLine::info() {
  const Outcome outcome = runProgram({"info", path("board.obj"), "--up", "z"});
  QCOMPARE(outcome.exitCode, 0);
  QVERIFY(outcome.out.contains("triangles") && outcome.out.contains('4'));
  QVERIFY(outcome.err.isEmpty());
}

void TestCommandLine::runWithDefaultPipeline() {
  const Outcome outcome = runProgram({"run", path("board.obj"), "--up", "z", "--scale", "1", "-o", path("out.obj")});
  QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
  QVERIFY(outcome.out.contains("VerticalClearanceFilter 2"));
  QVERIFY(outcome.out.contains("LayerSubdivisionFilter"));
  QVERIFY(contentOf(path("out.obj")).contains("\nf "));
  QCOMPARE(names(), (QStringList{"board.obj", "out.obj"}));
}

void TestCommandLine::runWritesNothingByDefault() {
  QCOMPARE(runProgram({"run", path("board.obj"), "--up", "z"}).exitCode, 0);
  QCOMPARE(names(), QStringList{"board.obj"});
}

void TestCommandLine::quietRun() {
  const Outcome outcome = runProgram({"run", path("board.obj"), "--quiet", "--both-sides"});
  QCOMPARE(outcome.exitCode, 0);
  QVERIFY(outcome.out.isEmpty() && outcome.err.isEmpty());
}

void TestCommandLine::noProgressBarInAPipe() {
  const Outcome outcome = runProgram({"run", path("board.obj")});
  QCOMPARE(outcome.exitCode, 0);
  QVERIFY(!outcome.err.contains('\r') && !outcome.err.contains('\x1b'));
  QVERIFY(!outcome.out.contains('\r') && !outcome.out.contains('\x1b'));
}

void TestCommandLine::exportSaysHowItWasMade() {
  const Outcome outcome =
      runProgram({"run", path("board.obj"), "--up", "z", "--filter", "SlopeFilter 44.5", "--filter",
                  "VerticalClearanceFilter 1.5", "--filter", "#off AreaFilter 3", "-o", path("out.obj"), "--quiet"});
  QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
  QByteArray comments;
  for (const QByteArray& line : contentOf(path("out.obj")).split('\n')) {
    if (line.startsWith('#')) comments += line + '\n';
  }
  for (const char* text :
       {"board.obj", "SlopeFilter 44.5", "VerticalClearanceFilter 1.5", "slope 44.5 degrees, height 1.5"}) {
    QVERIFY2(comments.contains(text), text);
  }
  QVERIFY(!comments.contains("AreaFilter"));
}

void TestCommandLine::sameBytesWithAnyNumberOfThreads() {
  for (const char* threads : {"1", "2", "5"}) {
    const Outcome outcome =
        runProgram({"run", path("board.obj"), "--up", "z", "--threads", threads, "-o", path(threads), "--quiet"});
    QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
    QCOMPARE(contentOf(path(threads)), contentOf(path("1")));
  }
}

void TestCommandLine::statisticsSchema() {
  const QString pipeline = FOOTFALL_SOURCE_DIR "/resources/pipelines/thesis_sequential.pipeline";
  const Outcome outcome = runProgram({"run", path("board.obj"), "--up", "z", "-p", pipeline, "--stats",
                                      path("stats.json"), "--threads", "2", "-o", path("out.obj")});
  QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
  const auto json = nlohmann::json::parse(contentOf(path("stats.json")).toStdString());
  QCOMPARE(json.at("steps").size(), std::size_t{9});
  for (const auto& step : json.at("steps")) {
    QVERIFY(step.at("name").is_string() && step.at("note").is_string());
    QVERIFY(step.at("parameters").is_object());
    for (const char* key : {"wall_ms", "cpu_ms", "area_in", "area_out"}) QVERIFY2(step.at(key).is_number(), key);
    for (const char* key : {"triangles_in", "triangles_out"}) QVERIFY2(step.at(key).is_number_unsigned(), key);
  }
  QVERIFY(json.at("steps")[1].at("name") == "SlopeFilter");
  QVERIFY(json.at("steps")[1].at("parameters").at("max_slope") == 60);
  QVERIFY(json.at("steps")[7].at("parameters").at("approximate") == false);
  for (const char* key : {"load_ms", "export_ms", "total_ms"}) QVERIFY2(json.at(key).get<double>() > 0, key);
  QVERIFY(json.at("total_ms").get<double>() >= json.at("load_ms").get<double>() + json.at("export_ms").get<double>());
  QVERIFY(json.at("threads") == 2);
  QVERIFY(json.at("peak_rss_bytes").get<std::uint64_t>() > 1000000);
  for (const char* key : {"layers", "connections", "links", "obstacle_edges", "exact_fallbacks"}) {
    QVERIFY2(json.at(key).is_number_unsigned(), key);
  }
  std::uint64_t sum = 0;
  for (const auto& [kind, count] : json.at("exact_fallbacks_by_kind").items()) sum += count.get<std::uint64_t>();
  QCOMPARE(json.at("exact_fallbacks").get<std::uint64_t>(), sum);
  const auto& environment = json.at("environment");
  QVERIFY(environment.at("source") == path("board.obj").toStdString());
  QVERIFY(environment.at("triangles") == 4);
  QVERIFY(environment.at("up") == "z");
  QVERIFY(environment.at("metres_per_unit").get<double>() > 0);
}

// Three treads of 2, seven islands of 1 and one step that is too high; with steps three treads are one component.
void TestCommandLine::statisticsOfComponents() {
  QByteArray text;
  const auto floor = [&text](double x0, double x1, double z) {
    for (const auto& [x, y] : {std::pair{x0, 0}, std::pair{x1, 0}, std::pair{x1, 1}, std::pair{x0, 1}})
      text +=
          QByteArray("v ") + QByteArray::number(x) + ' ' + QByteArray::number(y) + ' ' + QByteArray::number(z) + '\n';
    text += "f -4 -3 -2 -1\n";
  };
  for (int i = 0; i < 3; ++i) floor(2 * i, 2 * i + 2, 0.25 * i);
  for (int i = 0; i < 6; ++i) floor(10 + 2 * i, 11 + 2 * i, 0);
  floor(6, 7, 3);
  write(path("stairs.obj"), text);
  const auto run = [&](const QString& step) {
    QStringList arguments{"run",      path("stairs.obj"),         "--up",     "z",
                          "--stats",  path("stats.json"),         "--filter", "SlopeFilter 45",
                          "--filter", "VerticalClearanceFilter 2"};
    if (!step.isEmpty()) arguments += {"--filter", step};
    arguments += {"--filter", "LayerSubdivisionFilter"};
    return runProgram(arguments);
  };
  const Outcome linked = run("StepFilter 0.3");
  QVERIFY2(linked.exitCode == 0, linked.err.constData());
  auto json = nlohmann::json::parse(contentOf(path("stats.json")).toStdString());
  QVERIFY(json.at("links") == 2 && json.at("link_length") == 2.0 && json.at("highest_link") == 0.25);
  QCOMPARE(json.at("components").size(), std::size_t{8});
  const auto& first = json.at("components")[0];
  QVERIFY(first.at("area") == 6.0 && first.at("triangles") == 6 && first.at("layers").size() == 1);
  QVERIFY(std::fabs(first.at("share").get<double>() - 6.0 / 13) < 1e-15);
  QVERIFY(std::fabs(json.at("connected_share").get<double>() - (36.0 + 7) / 169) < 1e-15);
  QVERIFY2(linked.out.contains("2 steps between borders, 2 long in the plan, the highest 0.25\n"),
           linked.out.constData());
  QVERIFY(linked.out.contains("8 components; two random places are connected with a probability of 0.254\n"));
  // Five of them, and the three others in one line.
  QVERIFY2(QString(linked.out).contains(QRegularExpression("\n1 +6 +46.2 % +6 +0\n2 +1 +7.69 % +2 +0\n")),
           linked.out.constData());
  QVERIFY(QString(linked.out).contains(QRegularExpression("\n5 +1 .*\n\\(3 more\\) +3 +23.1 % +6\n")));

  const Outcome apart = run({});
  json = nlohmann::json::parse(contentOf(path("stats.json")).toStdString());
  QVERIFY(json.at("links") == 0 && json.at("link_length") == 0.0 && json.at("highest_link").is_null());
  QCOMPARE(json.at("components").size(), std::size_t{10});
  QVERIFY(!apart.out.contains("between borders"));
}

void TestCommandLine::parallelListingRuns() {
  const QString pipeline = FOOTFALL_SOURCE_DIR "/resources/pipelines/thesis_parallel.pipeline";
  const QString house = FOOTFALL_SOURCE_DIR "/samples/house/house.obj";
  const Outcome outcome = runProgram({"run", house, "-p", pipeline, "-o", path("out.obj"), "--stats", path("out.json"),
                                      "--trace", path("trace.json"), "--threads", "2", "--speed-up"});
  QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
  QVERIFY2(outcome.out.contains("block of "), outcome.out.constData());
  QVERIFY2(outcome.out.contains("speed-up "), outcome.out.constData());

  const auto json = nlohmann::json::parse(contentOf(path("out.json")).toStdString());
  const auto& block = json.at("blocks").at(0);
  QCOMPARE(block.at("first_step").get<int>(), 3);
  QCOMPARE(block.at("last_step").get<int>(), 7);
  QVERIFY(block.at("cells").size() > 1);
  for (const auto& cell : block.at("cells"))
    for (const char* key : {"lower", "upper", "cost", "triangles_in", "triangles_out", "thread", "start_ms", "end_ms",
                            "work_ms", "filters", "spans"})
      QVERIFY2(cell.contains(key), key);
  double sum = 0;
  for (const auto& [name, milliseconds] : json.at("times").items())
    sum += name == "total_ms" ? 0 : milliseconds.get<double>();
  QVERIFY(std::abs(sum - json.at("times").at("total_ms").get<double>()) < 1e-6);
  QCOMPARE(json.at("speed_up").at("speed_up").get<double>(),
           json.at("speed_up").at("one_thread_ms").get<double>() / json.at("speed_up").at("parallel_ms").get<double>());

  // Perfetto needs complete events with times, and names for the lanes.
  const auto trace = nlohmann::json::parse(contentOf(path("trace.json")).toStdString());
  std::size_t cells = 0, lanes = 0;
  for (const auto& event : trace.at("traceEvents")) {
    if (event.at("ph") == "M") {
      lanes += event.at("name") == "thread_name" ? 1 : 0;
      continue;
    }
    QVERIFY(event.at("ph") == "X");
    QVERIFY(event.at("ts").get<double>() >= 0 && event.at("dur").get<double>() >= 0);
    cells += event.at("cat") == "cell" ? 1 : 0;
  }
  QCOMPARE(lanes, std::size_t{3});
  QVERIFY(cells >= block.at("cells").size());
}

void TestCommandLine::wrongUsageOrInput_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QByteArray>("says");
  const auto row = [](const char* name, const QStringList& arguments, const char* says) {
    QTest::newRow(name) << arguments << QByteArray(says);
  };
  row("nothing", {}, "subcommand");
  row("unknown command", {"frobnicate"}, "--help");
  row("unknown option", {"run", "ENV", "--fast"}, "--fast");
  row("no environment", {"run"}, "ENV is required");
  row("missing environment", {"run", "nowhere.obj"}, "nowhere.obj");
  row("missing environment for info", {"info", "nowhere.obj"}, "nowhere.obj");
  row("directory", {"run", "."}, ".");
  row("up", {"run", "ENV", "--up", "w"}, "--up");
  row("scale zero", {"run", "ENV", "--scale", "0"}, "--scale");
  row("scale infinite", {"run", "ENV", "--scale", "inf"}, "--scale");
  row("scale no number", {"run", "ENV", "--scale", "big"}, "--scale");
  row("threads", {"run", "ENV", "--threads", "0"}, "--threads");
  row("bad filter", {"run", "ENV", "--filter", "DegeneracyFilter", "--filter", "SlopeFilter 95"},
      "--filter:2:13: max_slope 95 is out of range; give");
  row("unknown filter", {"run", "ENV", "--filter", "Slop 45"}, "did you mean SlopeFilter?");
  row("filter and file", {"run", "ENV", "--filter", "DegeneracyFilter", "-p", "x"}, "excludes");
  row("missing pipeline", {"run", "ENV", "-p", "nowhere.pipeline"}, "nowhere.pipeline: cannot be opened");
  row("environment as pipeline", {"run", "ENV", "-p", "ENV"}, "board.obj:1:1: unknown filter \"v\"");
  row("environment as output", {"run", "ENV", "-o", "ENV"}, "board.obj: would be overwritten");
  row("another format as output", {"run", "ENV", "-o", "level.stl"}, "level.stl: cannot be written in the format");
  row("output and statistics in one", {"run", "ENV", "-o", "x", "--stats", "x"}, "give two files");
  row("explain an unknown filter", {"filters", "Slop"}, "did you mean SlopeFilter?");
}

void TestCommandLine::wrongUsageOrInput() {
  QFETCH(QStringList, arguments);
  QFETCH(QByteArray, says);
  arguments.replaceInStrings(QRegularExpression("^ENV$"), path("board.obj"));
  const Outcome outcome = runProgram(arguments);
  QVERIFY(!outcome.crashed);
  QCOMPARE(outcome.exitCode, 2);
  QVERIFY2(outcome.err.contains(says), outcome.err.constData());
  QVERIFY2(outcome.err.startsWith("footfall: ") && outcome.err.count('\n') == 1, outcome.err.constData());
  QVERIFY(outcome.out.isEmpty());
  QCOMPARE(names(), QStringList{"board.obj"});
}

void TestCommandLine::nothingThatIsReadIsWrittenOver() {
  const QByteArray level = QByteArray("mtllib board.mtl\n") + kFloorWithBoard, library = "newmtl a\n",
                   pipeline = "SlopeFilter 45\n";
  write(path("board.obj"), level);
  write(path("board.mtl"), library);
  write(path("steps"), pipeline);
  // Names have no ending, or the ending that an option needs.
  for (const char* ending : {"", ".obj", ".json", ".html"}) {
    QVERIFY(QFile::link(path("board.obj"), path(QString("link") + ending)));
    QCOMPARE(::link(qPrintable(path("board.mtl")), qPrintable(path(QString("hard") + ending))), 0);
    QVERIFY(QFile::link("steps", path(QString("steps-link") + ending)));
  }
  const QStringList run{"run", path("board.obj"), "-p", path("steps")};
  const QStringList cells{"cells", path("board.obj"), "-p", path("steps")};
  const QStringList way{"path", path("board.obj"), "-p", path("steps"), "--from", "1", "1", "0", "--to", "2", "2", "0"};
  for (const auto& [command, option, ending] : {std::tuple{run, "-o", ".obj"},
                                                {run, "--stats", ".json"},
                                                {run, "--trace", ".json"},
                                                {run, "--report", ".html"},
                                                {cells, "-o", ".obj"},
                                                {way, "-o", ".obj"}}) {
    for (const QString& end : {QString(), QString(ending)}) {
      for (const char* name : {"link", "hard", "steps-link"}) {
        const Outcome outcome = runProgram(command + QStringList{option, path(name + end)});
        QVERIFY2(outcome.err.contains("would be overwritten"), outcome.err + name + option);
        QCOMPARE(outcome.exitCode, 2);
      }
    }
  }
  // Two targets of one command that are one file, which is yet to be.
  const Outcome twice = runProgram(run + QStringList{"--stats", path("x.json"), "--trace", path("./x.json")});
  QCOMPARE(twice.exitCode, 2);
  QVERIFY2(twice.err.contains("cannot hold both the statistics and the timeline"), twice.err.constData());
  QCOMPARE(contentOf(path("board.obj")), level);
  QCOMPARE(contentOf(path("board.mtl")), library);
  QCOMPARE(contentOf(path("steps")), pipeline);
  QVERIFY(!QFile::exists(path("x.json")));
}

// Fails before the work, not after hours of it.
void TestCommandLine::whereNothingCanBeWrittenIsToldFirst() {
  write(path("broken.obj"), "v 0 0 0\nf 1 2 3\n");  // The next error would be reported.
  for (const auto& [target, says] : {std::pair{path("none/out.obj"), "its folder does not exist"},
                                     {path("."), "is a folder"},
                                     {path("board.obj/out.obj"), "board.obj is a file, not a folder"},
                                     {path(QString(300, 'x')), "its name or path is too long"}}) {
    const Outcome outcome = runProgram({"run", path("broken.obj"), "-o", target});
    QCOMPARE(outcome.exitCode, 1);
    QVERIFY2(outcome.err.contains(says), outcome.err.constData());
    QVERIFY(outcome.err.contains(target.toUtf8()));
  }
}

void TestCommandLine::failedRunKeepsAnEarlierFile() {
  const Outcome missing = runProgram({"run", path("board.obj"), "-o", path("nowhere/out.obj")});
  QCOMPARE(missing.exitCode, 1);
  QVERIFY2(missing.err.startsWith("footfall: ") && missing.err.count('\n') == 1, missing.err.constData());
  write(path("out.obj"), "earlier");
  QCOMPARE(runProgram({"run", path("board.obj"), "--filter", "SlopeFilter 95", "-o", path("out.obj")}).exitCode, 2);
  QCOMPARE(contentOf(path("out.obj")), QByteArray("earlier"));
  if (QFile::exists("/dev/full")) {
    QProcess process;
    process.setStandardOutputFile("/dev/full");
    process.start(FOOTFALL_PROGRAM, {"filters"});
    QVERIFY(process.waitForFinished());
    QCOMPARE(process.exitCode(), 1);
  }
}

void TestCommandLine::signalsCancel_data() {
  QTest::addColumn<int>("signal");
  QTest::newRow("SIGINT") << SIGINT;
  QTest::newRow("SIGTERM") << SIGTERM;
}

void TestCommandLine::signalsCancel() {
  QFETCH(int, signal);
  write(path("large.obj"), largeEnvironment(350));
  write(path("out.obj"), "earlier");
  QProcess process;
  process.start(FOOTFALL_PROGRAM,
                {"run", path("large.obj"), "--up", "z", "-o", path("out.obj"), "--stats", path("s.json")});
  QVERIFY(process.waitForStarted());
  QTRY_VERIFY_WITH_TIMEOUT(blocksInterrupt(process.processId()) || process.state() == QProcess::NotRunning, 10000);
  QElapsedTimer timer;
  timer.start();
  QCOMPARE(::kill(static_cast<pid_t>(process.processId()), signal), 0);
  QVERIFY(process.waitForFinished(20000));
  QVERIFY2(timer.elapsed() < 2000, QByteArray::number(timer.elapsed()).constData());
  QCOMPARE(process.exitStatus(), QProcess::NormalExit);
  QCOMPARE(process.exitCode(), 1);
  QCOMPARE(process.readAllStandardError(), QByteArray("footfall: cancelled\n"));
  QVERIFY(process.readAllStandardOutput().isEmpty());
  QCOMPARE(contentOf(path("out.obj")), QByteArray("earlier"));
  QCOMPARE(names(), (QStringList{"board.obj", "large.obj", "out.obj"}));
}

QTEST_GUILESS_MAIN(TestCommandLine)
#include "test_command_line.moc"
