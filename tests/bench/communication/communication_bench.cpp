// footfall-communication-bench: the thesis's communication benchmark (4.2, 5.3, tables 2 and 3) with random expression
// graphs, to disk and back, beside Footfall's provenance.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "core/base/process_usage.hpp"
#include "core/io/export.hpp"
#include "footfall/errors.hpp"
#include "tests/bench/communication/disk_file.hpp"
#include "tests/bench/communication/exchange_formats.hpp"
#include "tests/bench/machine.hpp"
#include "tests/bench/markdown.hpp"
#include "tests/bench/thesis_figures.hpp"

namespace {

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::bench;

// Graphs of so many points are in memory at once.
constexpr std::size_t kBlockPoints = 10'000;
constexpr std::size_t kRepeated = 10'000;  // up to so many points, a measurement is repeated

struct Contender {
  std::string format;
  int depth = 0;  ///< binary operations of a graph, 1 for a single node (5.3); 0: there are no graphs
  std::unique_ptr<ExchangeFormat> points;
};

std::vector<Contender> contenders() {
  std::vector<Contender> list;
  for (const int depth : {1, 3, 12}) {
    const int operations = depth == 1 ? 0 : depth;
    list.push_back({"ascii", depth, makeAsciiFormat(operations)});
    list.push_back({"binary", depth, makeBinaryFormat(operations)});
    list.push_back({"tree", depth, makeTreeFormat(operations)});
  }
  list.push_back({"provenance", 0, makeProvenanceFormat()});
  return list;
}

/// Time that runs only between start() and stop().
class PausedWatch {
 public:
  void start() { watch_ = Stopwatch(); }
  void stop() {
    wallMs_ += watch_.wallMs();
    cpuMs_ += watch_.cpuMs();
  }
  [[nodiscard]] double wallMs() const { return wallMs_; }
  [[nodiscard]] double cpuMs() const { return cpuMs_; }

 private:
  Stopwatch watch_;
  double wallMs_ = 0, cpuMs_ = 0;
};

struct Passage {
  PausedWatch write, read;
  std::uint64_t bytes = 0;
};

std::size_t pointsOfBlock(std::size_t first, std::size_t points) { return std::min(kBlockPoints, points - first); }

/// Writes to the disk and reads back once. The times include opening, fsync and closing, and exclude making and
/// comparing points.
Passage passOnce(ExchangeFormat& points, std::size_t count, const std::string& path) {
  Passage passage;
  std::string bytes;
  passage.write.start();
  DiskFile out(path, DiskFile::Mode::Write);
  passage.write.stop();
  for (std::size_t first = 0; first < count; first += kBlockPoints) {
    points.prepare(first + 1, pointsOfBlock(first, count));
    passage.write.start();
    bytes.clear();
    points.write(bytes);
    out.writeBlock(bytes);
    passage.write.stop();
    passage.bytes += bytes.size();
  }
  passage.write.start();
  out.finish();
  passage.write.stop();

  DiskFile::forget(path);
  passage.read.start();
  DiskFile in(path, DiskFile::Mode::Read);
  passage.read.stop();
  for (std::size_t first = 0; first < count; first += kBlockPoints) {
    passage.read.start();
    in.readBlock(bytes);
    points.read(bytes, pointsOfBlock(first, count));
    passage.read.stop();
    // Later blocks would cost as much again to make: the first one stands for them.
    if (first == 0) {
      points.prepare(1, pointsOfBlock(0, count));
      if (!points.isSame()) throw RunError(path + ": what was read is not what was written");
    }
  }
  return passage;
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

Json measure(Contender& contender, std::size_t count, int runs, const std::string& folder) {
  const std::string path = (std::filesystem::path(folder) / "footfall-communication.bin").string();
  std::vector<double> write, writeCpu, read, readCpu;
  std::uint64_t bytes = 0;
  for (int run = 0; run < (count <= kRepeated ? runs : 1); ++run) {
    const Passage passage = passOnce(*contender.points, count, path);
    write.push_back(passage.write.wallMs());
    writeCpu.push_back(passage.write.cpuMs());
    read.push_back(passage.read.wallMs());
    readCpu.push_back(passage.read.cpuMs());
    bytes = passage.bytes;
  }
  std::filesystem::remove(path);
  Json entry{{"format", contender.format},
             {"depth", contender.depth},
             {"points", count},
             {"bytes", bytes},
             {"write_ms", median(write)},
             {"write_cpu_ms", median(writeCpu)},
             {"read_ms", median(read)},
             {"read_cpu_ms", median(readCpu)}};
  const double megabytes = static_cast<double>(bytes) / 1e6;
  entry["write_mb_s"] = 1000 * megabytes / std::max(median(write), 1e-6);
  entry["read_mb_s"] = 1000 * megabytes / std::max(median(read), 1e-6);
  if (const auto thesis = findThesisCommunication(contender.format, contender.depth, count))
    entry["thesis"] = {{"read_ms", thesis->readMs}, {"write_ms", thesis->writeMs}};
  return entry;
}

std::string format(const Json& entries) {
  Table table({"points", "format", "depth", "bytes", "write, ms", "of it processor", "MB/s", "read, ms",
               "of it processor", "MB/s", "thesis: write, ms", "thesis: read, ms"},
              2);
  for (const Json& e : entries) {
    const int depth = e["depth"];
    const auto ms = [&](const char* key) { return number(e[key].get<double>()); };
    std::vector<std::string> row{grouped(e["points"]), e["format"],    depth == 0 ? "-" : std::to_string(depth),
                                 grouped(e["bytes"]),  ms("write_ms"), ms("write_cpu_ms"),
                                 ms("write_mb_s"),     ms("read_ms"),  ms("read_cpu_ms"),
                                 ms("read_mb_s")};
    for (const char* key : {"write_ms", "read_ms"})
      row.push_back(e.contains("thesis") ? groupedWithDecimals(e["thesis"][key], 1) : "");
    table.addRow(row);
  }
  return table.text() +
         "To disk (with fsync) and back (the system forgets the file in between). depth: binary operations of each "
         "coordinate's graph; 1 is one node, as 5.3 has it. The thesis's figures are for so many values, on a hard "
         "disk; its rows of binary and ASCII have no depth, and stand at 1. provenance: ours, without expressions.\n";
}

void runProgramWith(int argc, char** argv) {
  CLI::App app(
      "Repeats the thesis's communication benchmark (5.3): random expression graphs are written to disk and read "
      "back as ASCII with 17 digits, as binary doubles and as expression trees, and points by provenance. Graphs are "
      "made in blocks, so that a million points fit into little memory.",
      "footfall-communication-bench");
  std::vector<std::size_t> counts{1, 10, 100, 1000, 10'000, 100'000, 1'000'000};
  std::string folder = std::filesystem::temp_directory_path().string(), json;
  int runs = 9;
  app.add_option("--points", counts, "Numbers of points")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::Range(1, 100'000'000))
      ->capture_default_str();
  app.add_option("--folder", folder, "A folder on the disk to measure")
      ->check(CLI::ExistingDirectory)
      ->capture_default_str();
  app.add_option("--runs", runs, "Repetitions up to 10,000 points, of which medians are told; one above")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--json", json, "Write all figures to this file")->type_name("FILE");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    app.exit(success);  // --help
    return;
  }
  Json entries = Json::array();
  std::vector<Contender> all = contenders();
  for (const std::size_t count : counts) {
    for (Contender& contender : all) {
      std::fprintf(stderr, "%zu points, %s, depth %d\n", count, contender.format.c_str(), contender.depth);
      entries.push_back(measure(contender, count, runs, folder));
    }
  }
  const Json results{
      {"machine", describeMachine()}, {"runs", runs}, {"peak_bytes", peakRssBytes()}, {"entries", entries}};
  if (!json.empty()) writeFileSafely(json, results.dump(2) + '\n');
  std::cout << format(entries);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    runProgramWith(argc, argv);
    return 0;
  } catch (const CLI::ParseError& error) {
    std::cerr << "footfall-communication-bench: " << error.what() << "; --help tells what can be given\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "footfall-communication-bench: " << error.what() << '\n';
    return 1;
  }
}
