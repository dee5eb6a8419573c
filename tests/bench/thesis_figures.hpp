// The thesis's own figures (5.4, 5.5), on environments of the sizes of our samples, with 32 threads on 16 cores.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace footfall::bench {

/// A line of the tables of 5.4.
struct ThesisRun {
  double totalMs = 0;
  std::optional<double> speedUp;  ///< none where the sequential pipeline never ended
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
  double sequentialArea = 0, parallelArea = 0;
};
std::optional<ThesisCorrectness> findThesisCorrectness(const std::string& sample);

}  // namespace footfall::bench
