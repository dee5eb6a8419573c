// The measurements of the thesis (5.3 to 5.5), on environments of the sizes of our samples, with 32 threads on 16
// cores.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace footfall::bench {

/// A column of the tables of 5.4.
struct ThesisRun {
  double totalMs = 0;
  std::optional<double> speedUp;  ///< none where the sequential pipeline never ended
  /// t_preprocessing, t_partitioning, t_parallel, t_merging, t_postprocessing, t_overhead. Below 0 where the text that
  /// we have is scrambled: in the arena's columns by the sorted recursive strategy.
  std::array<double, 6> phasesMs{};
};

/// `strategy` as formatStep() writes it, such as "SortedRecursiveStrategy 50 3 true"; nothing where the thesis has no
/// such run.
std::optional<ThesisRun> findThesisRun(const std::string& sample, const std::string& strategy);

struct ThesisEnvironment {
  int triangles = 0;
  double sequentialMs = 0;         ///< 0: it never ended
  bool sequentialIsBound = false;  ///< memory ran out after so long; the thesis computes with it
};
std::optional<ThesisEnvironment> findThesisEnvironment(const std::string& sample);

/// The differences between the outputs of its sequential and its parallel pipeline: table 6, in metres, and table 7, in
/// its units.
struct ThesisCorrectness {
  double min = 0, max = 0, mean = 0, rms = 0;
  double maxUnits = 0, meanUnits = 0, rmsUnits = 0;  ///< table 5: in the environment's units
  double sequentialArea = 0, parallelArea = 0;
};
std::optional<ThesisCorrectness> findThesisCorrectness(const std::string& sample);

/// Tables 2 and 3.
struct ThesisCommunication {
  double readMs = 0, writeMs = 0;
};
/// `format`: ascii, binary or tree. The thesis has no depth for the first two; they are found at depth 1.
std::optional<ThesisCommunication> findThesisCommunication(const std::string& format, int depth, std::size_t values);

}  // namespace footfall::bench
