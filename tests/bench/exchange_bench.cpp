// footfall-exchange-bench ENV...: the environment behind a clearance filter in two formats of the thesis (5.3) and in
// ours: time to write and to read, size and speed, as Markdown. In memory, so that no disk is measured; the least of
// five.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <iostream>
#include <limits>
#include <string>

#include "core/assembly/mesh_assembly.hpp"
#include "core/base/process_usage.hpp"
#include "core/base/worker_arena.hpp"
#include "core/filters/apply_filter.hpp"
#include "footfall/io.hpp"
#include "footfall/pipeline.hpp"
#include "tests/support/intermediate.hpp"

namespace {

using namespace footfall;
using namespace footfall::detail;

double leastMs(const std::function<void()>& work) {
  constexpr int kRuns = 5;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kRuns; ++i) {
    const Stopwatch watch;
    work();
    least = std::min(least, watch.wallMs());
  }
  return least;
}

void printRow(const std::string& name, std::size_t values, const char* format, double writeMs, double readMs,
              std::size_t bytes, const std::string& lost) {
  const double megabytes = static_cast<double>(bytes) / 1e6;
  std::printf("| %s | %zu | %s | %.2f | %.2f | %.2f | %.0f | %.0f | %s |\n", name.c_str(), values, format, writeMs,
              readMs, megabytes, megabytes / writeMs * 1000, megabytes / readMs * 1000, lost.c_str());
}

void measure(const std::string& path) {
  RunContext context;
  const auto environment = std::make_shared<const Environment>(load(path));
  const StatePtr source = makeInitialState(environment, context);
  StatePtr state = source;
  const double unit = 1 / environment->metresPerUnit;
  const Pipeline pipeline =
      parsePipeline("DegeneracyFilter\nSlopeFilter 45\nVerticalClearanceFilter " + std::to_string(2 * unit) + '\n', "");
  for (const PipelineStep& step : pipeline.steps) state = applyFilter(*step.filter, step.values, state, context).state;

  RoundedState rounded;
  const double roundingMs = leastMs([&] { rounded = roundState(*state, context); });
  const std::size_t values = 3 * rounded.triangles.vertices.size();
  const std::string lost = std::to_string(rounded.inexact) + " of " + std::to_string(values / 3) + " vertices rounded";
  const std::string name = path.substr(path.rfind('/') + 1);
  std::string bytes;
  double writeMs = leastMs([&] { bytes = writeAscii(rounded.triangles); });
  double readMs = leastMs([&] { readAscii(bytes); });
  printRow(name, values, "ASCII", roundingMs + writeMs, readMs, bytes.size(), lost);
  writeMs = leastMs([&] { bytes = writeBinary(rounded.triangles); });
  readMs = leastMs([&] { readBinary(bytes); });
  printRow(name, values, "binary", roundingMs + writeMs, readMs, bytes.size(), lost);
  writeMs = leastMs([&] { bytes = writeExact(*state); });
  readMs = leastMs([&] { readExact(bytes, *source, context); });
  ExactFallbacks ignored;
  const double meshMs = leastMs([&] { assembleMesh(*state, context, ignored); });
  printRow(name, values, "exact", writeMs, readMs, bytes.size(), "nothing");
  printRow(name, values, "exact, less making the mesh", writeMs, std::max(readMs - meshMs, 0.001), bytes.size(),
           "nothing");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: footfall-exchange-bench ENV...\n";
    return 2;
  }
  try {
    std::puts("| environment | values | format | write (ms) | read (ms) | MB | write (MB/s) | read (MB/s) | lost |");
    std::puts("|---|--:|---|--:|--:|--:|--:|--:|---|");
    onThreads(1, [&](int) {
      for (int i = 1; i < argc; ++i) measure(argv[i]);
      return 0;
    });
  } catch (const std::exception& error) {
    std::cerr << "footfall-exchange-bench: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
