// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/subject.hpp"

#include <filesystem>
#include <stdexcept>

#include "core/io/import.hpp"
#include "footfall/errors.hpp"

namespace footfall::bench {
using namespace detail;

Subject parseSubject(const std::string& text, double clearance) {
  Subject subject{"", text, clearance};
  const std::size_t colon = text.rfind(':');
  if (colon != std::string::npos && !std::filesystem::exists(text)) {
    std::size_t used = 0;
    try {
      subject.clearance = std::stod(text.substr(colon + 1), &used);
    } catch (const std::logic_error&) {
    }
    if (used == 0 || used + colon + 1 != text.size() || !(subject.clearance > 0))
      throw InputError(text + ": the height after ':' must be a number above 0; give FILE:HEIGHT");
    subject.path.resize(colon);
  }
  if (!std::filesystem::is_regular_file(subject.path)) throw InputError(subject.path + ": no such file");
  subject.name = std::filesystem::path(subject.path).stem().string();
  return subject;
}

std::vector<Subject> sampleSubjects() {
  std::vector<Subject> subjects;
  for (const char* name : {"house", "villa", "arena", "docks", "tower"})
    subjects.push_back({name, std::string(FOOTFALL_SOURCE_DIR "/samples/") + name + '/' + name + ".obj", 2});
  return subjects;
}

std::shared_ptr<const Environment> loadSubject(const Subject& subject) {
  ImportOptions options;
  options.metresPerUnit = subject.metresPerUnit();
  return importEnvironment(subject.path, options);
}

}  // namespace footfall::bench
