// The subjects of measurements: files with the clearance of their agents, and the samples of the repository.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "footfall/environment.hpp"

namespace footfall::bench {

/// A file to measure, and the free height that its agents need, in its units. That height stands for 2 m.
struct Subject {
  std::string name;
  std::string path;
  double clearance = 2;
  [[nodiscard]] double metresPerUnit() const { return 2 / clearance; }
};

/// "FILE" (with the given clearance) or "FILE:HEIGHT". Throws InputError for a height that is none or a missing file.
Subject parseSubject(const std::string& text, double clearance);

/// The samples of the source tree that the program was built from.
std::vector<Subject> sampleSubjects();

/// Reads the subject's file with the scale that its clearance implies.
std::shared_ptr<const Environment> loadSubject(const Subject& subject);

}  // namespace footfall::bench
