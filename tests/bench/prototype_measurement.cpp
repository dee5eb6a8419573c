// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/prototype_measurement.hpp"

#include <sstream>
#include <stdexcept>

#include "core/base/number_text.hpp"

namespace footfall::bench {
using namespace detail;
namespace {

double readTotal(const std::string& output) {
  const std::string label = "TOTAL ";
  const std::size_t found = output.find(label);
  double total = 0;
  if (found == std::string::npos || !(std::istringstream(output.substr(found + label.size())) >> total))
    throw std::runtime_error("does not say its TOTAL");
  return total;
}

}  // namespace

Json measurePrototype(const std::string& program, const Subject& subject, int threads, const Repetition& repetition) {
  std::string clearance;
  appendNumber(clearance, subject.clearance);
  const std::vector<std::string> command{program, subject.path, clearance, "/dev/null", std::to_string(threads)};
  Samples samples;
  try {
    const auto once = [&] {
      const Json answer = runProgram(command);
      if (answer.contains("fails")) throw std::runtime_error(answer["fails"].get<std::string>());
      samples.add("wall_ms", readTotal(answer["output"]));
      samples.add("peak_bytes", answer["peak_bytes"].get<double>());
    };
    const int runs = repeat(repetition, once, [&] { samples.clear(); });
    return {{"runs", runs}, {"wall_ms", samples.median("wall_ms")}, {"peak_bytes", samples.median("peak_bytes")}};
  } catch (const std::runtime_error& error) {
    return {{"fails", error.what()}};
  }
}

}  // namespace footfall::bench
