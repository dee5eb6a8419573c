// footfall-fuzz-pipeline: random environments and filters against the reference implementation, for any length of time.
//
//   footfall-fuzz-pipeline [--seconds N | --cases C] [--seed S] [--folder F]
//
// Case S, S + 1, ... until N seconds are over (0: until stopped; default 60), or C cases. Each runs in a process of its
// own, so that crashes and hangs are found, too. The first that fails is shrunk, written to F (the current folder) as
// OBJ with its story in the comments, and the exit code is 1.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>

#include "core/base/number_text.hpp"
#include "core/io/export.hpp"
#include "tests/fuzz/isolated_call.hpp"
#include "tests/fuzz/pipeline_check.hpp"
#include "tests/support/pipeline_case.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::fuzz;

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kCaseLimit{60};  ///< a case takes milliseconds, with sanitizers and load far less

std::string findError(const PipelineCase& experiment, bool quiet) {
  return callIsolated([&] { return findPipelineError(experiment); }, kCaseLimit, quiet);
}

/// Leaves out runs of `items`, first long ones, then single ones, while `stillFails` with what is left.
template <class Item, class StillFails>
std::vector<Item> shrink(std::vector<Item> items, StillFails stillFails) {
  for (std::size_t length = std::max<std::size_t>(items.size() / 2, 1); length > 0; length /= 2) {
    for (std::size_t at = 0; at + length <= items.size();) {
      std::vector<Item> fewer = items;
      const auto first = fewer.begin() + static_cast<std::ptrdiff_t>(at);
      fewer.erase(first, first + static_cast<std::ptrdiff_t>(length));
      if (stillFails(fewer)) {
        items = std::move(fewer);
      } else {
        at += length;
      }
    }
  }
  return items;
}

test::Soup soupOf(const std::vector<std::array<Vec3, 3>>& triangles) {
  test::Soup soup;
  for (const auto& [a, b, c] : triangles) soup.triangle(a, b, c);
  return soup;
}

PipelineCase shrunk(PipelineCase experiment) {
  const auto fails = [](const PipelineCase& smaller) { return !findError(smaller, true).empty(); };
  PipelineCase single = experiment;
  single.copies = 1;
  if (fails(single)) experiment = single;
  experiment.soup = soupOf(shrink(experiment.soup.triangles(), [&](const auto& triangles) {
    PipelineCase smaller = experiment;
    smaller.soup = soupOf(triangles);
    return fails(smaller);
  }));
  experiment.anyFilters = shrink(experiment.anyFilters, [&](const auto& filters) {
    PipelineCase smaller = experiment;
    smaller.anyFilters = filters;
    return fails(smaller);
  });
  return experiment;
}

std::string joined(const std::vector<std::string>& filters) {
  std::string text;
  for (const std::string& line : filters) text += (text.empty() ? "" : "; ") + line;
  return text;
}

/// The case as OBJ, Z up, with its story as comments.
std::string describe(const PipelineCase& experiment, std::uint64_t seed, const std::string& error) {
  std::string text =
      "# footfall-fuzz-pipeline --cases 1 --seed " + std::to_string(seed) + " (" + experiment.kind + "), shrunk";
  text += "\n# " + error + "\n# both sides: " + (experiment.bothSides ? "yes" : "no") + ", slope ";
  appendNumber(text, experiment.slope);
  text += ", clearance ";
  appendNumber(text, experiment.clearance);
  text += "\n# filters that keep the set: " + joined(experiment.sameSetFilters);
  text += "\n# any filters: " + joined(experiment.anyFilters);
  if (experiment.copies > 1) {
    text += ", on " + std::to_string(experiment.copies) + " x " + std::to_string(experiment.copies) + " copies every ";
    appendNumber(text, experiment.copyDistance);
  }
  text += '\n';
  for (const auto& triangle : experiment.soup.triangles()) {
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

int report(std::uint64_t seed, const PipelineCase& experiment, const std::string& error, const std::string& folder) {
  std::cerr << "case " << seed << " (" << experiment.kind << "): " << error << "\nshrinking it" << std::endl;
  const PipelineCase smallest = shrunk(experiment);
  const std::string text = describe(smallest, seed, findError(smallest, true));
  const std::string path = folder + "/fuzz-pipeline-" + std::to_string(seed) + ".obj";
  writeFileSafely(path, text);
  std::cerr << text << "written to " << path << std::endl;
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  double seconds = 60;
  std::uint64_t seed = 1;
  std::uint64_t cases = 0;
  std::string folder = ".";
  CLI::App options("Random environments and filters against the reference implementation");
  auto* limit = options.add_option("--seconds", seconds, "How long; 0: until stopped")->capture_default_str();
  options.add_option("--seed", seed, "The first case")->capture_default_str();
  options.add_option("--cases", cases, "How many, however long that takes")->excludes(limit);
  options.add_option("--folder", folder, "Where a failing case is written")->capture_default_str();
  CLI11_PARSE(options, argc, argv);

  const auto start = Clock::now();
  std::uint64_t next = seed;
  const auto isOver = [&] {
    if (cases > 0) return next - seed >= cases;
    return seconds > 0 && Clock::now() - start >= std::chrono::duration<double>(seconds);
  };
  do {
    const PipelineCase experiment = makePipelineCase(next);
    const std::string error = findError(experiment, false);
    if (!error.empty()) return report(next, experiment, error, folder);
    ++next;
  } while (!isOver());
  std::cout << next - seed << " cases from " << seed << " on agree with the reference" << std::endl;
  return 0;
}
