// footfall-fuzz-slowest: looks for the slowest input of 1,000 triangles, by mutation.
//
//   footfall-fuzz-slowest [--seconds N] [--seed S] [--triangles T] [--limit MS] [--noise] [--folder F]
//
// Soups that took long are changed and crossed; what takes longer yet takes their places. A case is measured by the CPU
// time of its one thread in the default pipeline, in a process of its own. The slowest is written to F (the current
// folder) as OBJ. The exit code is 1 when it took more than MS.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>

#include "core/base/number_text.hpp"
#include "core/base/process_usage.hpp"
#include "core/io/export.hpp"
#include "core/pipeline/runner.hpp"
#include "footfall/pipeline.hpp"
#include "tests/fuzz/isolated_call.hpp"
#include "tests/fuzz/slow_soups.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::fuzz;

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kPopulation = 12;

struct Case {
  Triangles soup;
  double cpuMs = 0;
  std::string steps;  ///< the steps that took most of it, or how it ended
};

std::shared_ptr<Environment> environmentOf(const Triangles& soup) {
  auto environment = std::make_shared<Environment>();
  environment->source = "a slow soup";
  for (const auto& triangle : soup) {
    const auto first = static_cast<std::uint32_t>(environment->vertices.size());
    environment->vertices.insert(environment->vertices.end(), triangle.begin(), triangle.end());
    environment->triangles.push_back({first, first + 1, first + 2});
  }
  return environment;
}

std::string shown(double x) {
  std::string text;
  appendNumber(text, std::round(x * 10) / 10);
  return text;
}

/// "MS text" of the default pipeline on one thread.
std::string run(const Triangles& soup) {
  const auto environment = environmentOf(soup);
  RunContext context;
  const double before = processCpuMs();
  const RunResult result = runPipeline(environment, defaultPipeline(*environment), context, nullptr, 1);
  const double cpuMs = processCpuMs() - before;
  std::string steps;
  for (const StepStatistics& step : result.steps)
    if (step.cpuMs > 0.1 * cpuMs) steps += (steps.empty() ? "" : ", ") + step.name + ' ' + shown(step.cpuMs) + " ms";
  return shown(cpuMs) + ' ' + steps + "; " + std::to_string(result.mesh->triangles.size()) + " triangles come out";
}

Case measured(Triangles soup, double limitMs) {
  Case result;
  const auto limit = std::chrono::seconds(5 + static_cast<long>(3 * limitMs / 1000));
  const std::string told = callIsolated([&] { return run(soup); }, limit, true);
  char* end = nullptr;
  result.cpuMs = std::strtod(told.c_str(), &end);
  result.steps = end;
  if (end == told.c_str()) result.cpuMs = 1e9;  // it crashed, or was killed for lasting too long
  result.soup = std::move(soup);
  return result;
}

std::string objOf(const Case& found, std::uint64_t seed) {
  std::string text = "# footfall-fuzz-slowest --seed " + std::to_string(seed) + ": " + shown(found.cpuMs) + " ms\n#" +
                     found.steps + "\n# Z up, 1 m per unit\n";
  for (const auto& triangle : found.soup) {
    for (const Vec3& v : triangle) {
      text += 'v';
      for (const double c : {v.x, v.y, v.z}) {
        text += ' ';
        appendNumber(text, c);
      }
      text += '\n';
    }
    text += "f -3 -2 -1\n";
  }
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  double seconds = 60, limitMs = 20000;
  std::uint64_t seed = 1;
  std::size_t triangles = 1000;
  bool noisy = false;
  std::string folder = ".";
  CLI::App options("Looks for the slowest input of so many triangles");
  options.add_option("--seconds", seconds, "How long; the case under way is finished")->capture_default_str();
  options.add_option("--seed", seed, "Where to begin")->capture_default_str();
  options.add_option("--triangles", triangles, "How many")->check(CLI::Range(10, 1000000))->capture_default_str();
  options.add_option("--limit", limitMs, "The most CPU milliseconds that are no finding")->capture_default_str();
  options.add_flag("--noise", noisy, "Coordinates that are off by their last bits as floats, too");
  options.add_option("--folder", folder, "Where the slowest case is written")->capture_default_str();
  CLI11_PARSE(options, argc, argv);

  const auto start = Clock::now();
  SlowSoups soups(seed, triangles, noisy);
  std::mt19937_64 dice(seed);
  std::vector<Case> best;
  std::size_t tried = 0;
  while (Clock::now() - start < std::chrono::duration<double>(seconds) && (best.empty() || best[0].cpuMs <= limitMs)) {
    const bool isNew = best.size() < kPopulation || dice() % 8 == 0;
    const auto any = [&] { return best[dice() % best.size()].soup; };
    Case next = measured(isNew ? soups.make() : soups.mutate(any(), any()), limitMs);
    ++tried;
    const bool isSlowest = best.empty() || next.cpuMs > best[0].cpuMs;
    if (isSlowest) std::cout << "case " << tried << ": " << shown(next.cpuMs) << " ms," << next.steps << std::endl;
    best.push_back(std::move(next));
    std::stable_sort(best.begin(), best.end(), [](const Case& a, const Case& b) { return a.cpuMs > b.cpuMs; });
    if (best.size() > kPopulation) best.pop_back();
  }
  if (best.empty()) return 0;
  const std::string path = folder + "/fuzz-slowest-" + std::to_string(seed) + ".obj";
  writeFileSafely(path, objOf(best[0], seed));
  std::cout << "the slowest of " << tried << " cases takes " << shown(best[0].cpuMs) << " ms: " << path << std::endl;
  return best[0].cpuMs > limitMs ? 1 : 0;
}
