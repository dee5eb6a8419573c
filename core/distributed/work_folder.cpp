// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/distributed/work_folder.hpp"

#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <system_error>

#include "core/base/parallel.hpp"
#include "core/io/export.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnding = ".share";

std::string nameOf(const Digest::Value& key) {
  char text[40];
  std::snprintf(text, sizeof(text), "%016llx%016llx", static_cast<unsigned long long>(key[0]),
                static_cast<unsigned long long>(key[1]));
  return text;
}

void checkShare(std::string_view sealed, const ShareName& name, const CellPhase& phase) {
  const OpenedShare opened = openShare(sealed);
  if (opened.name != name) throw BadBytes("is a share of another cell or run");
  try {
    phase.check(static_cast<Index>(name.cell), opened.bytes);
  } catch (const BadBytes& error) {
    throw BadBytes(std::string("is no share that can be used (") + error.what() + ')');
  }
}

// Files that were being written when their process was killed. Those of processes at work are young.
bool isLeftOver(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  if (name.rfind(".footfall-", 0) != 0 || entry.path().extension() != ".tmp") return false;
  return fs::file_time_type::clock::now() - entry.last_write_time() > std::chrono::minutes(10);
}

}  // namespace

WorkFolder::WorkFolder(std::string path, Making making) : path_(std::move(path)) {
  if (making == Making::Nothing) return;
  std::error_code error;
  fs::create_directory(path_, error);
  if (error || !fs::is_directory(path_))
    throw RunError(FOOTFALL_TEXT("%1: this folder for shares cannot be made (%2); name a folder that can be written"),
                   path_, error ? error.message() : std::string(std::strerror(ENOTDIR)));
}

std::vector<WorkFolder::Stored> WorkFolder::load(const CellPhase& phase, std::vector<Text>& notes) {
  const std::size_t cells = phase.costs.size();
  std::vector<std::optional<std::string>> sealed(cells);
  std::vector<std::string> problems(cells);
  parallelFor(cells, [&](std::size_t cell) {
    const ShareName name{phase.key, phase.number, cell};
    try {
      sealed[cell] = contentOf(fileOf(name));
      if (sealed[cell]) checkShare(*sealed[cell], name, phase);
    } catch (const BadBytes& error) {
      sealed[cell].reset();
      problems[cell] = error.what();
    }
  });
  std::vector<Stored> found;
  for (std::size_t cell = 0; cell < cells; ++cell) {
    if (sealed[cell]) found.push_back({static_cast<Index>(cell), std::move(*sealed[cell])});
    if (!problems[cell].empty())
      notes.emplace_back(FOOTFALL_TEXT("%1 %2; its cell runs again"), fileOf({phase.key, phase.number, cell}),
                         problems[cell]);
  }
  return found;
}

std::vector<Index> WorkFolder::cellsOf(const CellPhase& phase) const {
  const std::string begin = nameOf(phase.key) + '-' + std::to_string(phase.number) + '-';
  std::vector<Index> cells;
  std::error_code error;
  for (fs::directory_iterator entry(path_, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.rfind(begin, 0) != 0 || !name.ends_with(kEnding)) continue;
    Index cell = -1;
    const char* last = name.data() + name.size() - kEnding.size();
    const auto [stop, problem] = std::from_chars(name.data() + begin.size(), last, cell);
    if (problem == std::errc() && stop == last && cell >= 0 && static_cast<std::size_t>(cell) < phase.costs.size())
      cells.push_back(cell);
  }
  return cells;
}

std::string WorkFolder::read(const ShareName& name) const {
  std::optional<std::string> sealed = contentOf(fileOf(name));
  if (!sealed) throw BadBytes("it is gone");
  if (openShare(*sealed).name != name) throw BadBytes("it is a share of another cell or run");
  sealed->erase(0, kShareHead);
  return std::move(*sealed);
}

void WorkFolder::store(const ShareName& name, const std::string& sealed) { writeFileSafely(fileOf(name), sealed); }

void WorkFolder::remove(const Digest::Value& key) noexcept {
  try {
    const std::string begin = nameOf(key);
    std::vector<fs::path> gone;
    for (const fs::directory_entry& entry : fs::directory_iterator(path_)) {
      const bool isShare = entry.path().filename().string().rfind(begin, 0) == 0 && entry.path().extension() == kEnding;
      if (isShare || isLeftOver(entry)) gone.push_back(entry.path());
    }
    std::error_code ignored;
    for (const fs::path& path : gone) fs::remove(path, ignored);
  } catch (const std::exception&) {
    // Files that cannot be removed take room and do no harm.
  }
}

std::string WorkFolder::fileOf(const ShareName& name) const {
  return (fs::path(path_) / (nameOf(name.key) + '-' + std::to_string(name.phase) + '-' + std::to_string(name.cell) +
                             std::string(kEnding)))
      .string();
}

}  // namespace footfall::detail
