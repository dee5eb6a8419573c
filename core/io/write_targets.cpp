// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/write_targets.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <system_error>

#include "core/io/export.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

namespace fs = std::filesystem;

bool exists(const std::string& path) {
  std::error_code error;
  return fs::exists(path, error);
}

bool hasMeshEnding(const std::string& path) {
  std::string ending = fs::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  const std::vector<std::string> formats = importableExtensions();
  return !ending.empty() && std::find(formats.begin(), formats.end(), ending.substr(1)) != formats.end();
}

std::string folderOf(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

}  // namespace

bool sameFile(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return false;
  std::error_code error;
  if (a == b || fs::equivalent(a, b, error)) return true;
  if (exists(a) || exists(b)) return false;
  // Both are files to be written: they are the same when their names and folders are.
  const fs::path first = fs::weakly_canonical(fs::absolute(a, error), error);
  const fs::path second = fs::weakly_canonical(fs::absolute(b, error), error);
  return first == second ||
         (first.filename() == second.filename() && fs::equivalent(first.parent_path(), second.parent_path(), error));
}

void WriteTargets::protect(const std::string& path, const Text& what) {
  if (!path.empty()) protected_.push_back({path, what});
}

void WriteTargets::protectEnvironment(const std::string& path) {
  protect(path, FOOTFALL_TEXT("the environment"));
  unread_.push_back(path);
}

void WriteTargets::protectEnvironment(const std::string& path, const std::vector<std::string>& companions) {
  protect(path, FOOTFALL_TEXT("the environment"));
  for (const std::string& companion : companions) protect(companion, FOOTFALL_TEXT("a file that the environment uses"));
}

void WriteTargets::check(const std::string& target) const {
  const auto refuse = [&](const Text& what) {
    throw InputError(FOOTFALL_TEXT("%1: would be overwritten, and is %2; give another file to write to"), target, what);
  };
  for (const NamedFile& file : protected_)
    if (sameFile(target, file.path)) refuse(file.what);
  if (target.empty()) return;
  std::error_code error;
  for (const NamedFile& file : protected_)
    if (fs::is_directory(file.path, error) && hasMeshEnding(target) && sameFile(folderOf(target), file.path))
      throw InputError(
          FOOTFALL_TEXT("%1: would be a part of the environment, which is all meshes in its folder; give a file "
                        "in another folder"),
          target);
  if (!exists(target)) return;
  for (const std::string& environment : unread_)
    for (const std::string& companion : companionFiles(environment))
      if (sameFile(target, companion)) refuse(FOOTFALL_TEXT("a file that the environment uses"));
}

void WriteTargets::add(const std::string& target, const Text& what) {
  if (target.empty()) return;
  check(target);
  checkWritable(target);
  for (const NamedFile& other : targets_) {
    if (sameFile(target, other.path))
      throw InputError(FOOTFALL_TEXT("%1: cannot hold both %2 and %3; give two files"), target, other.what, what);
  }
  targets_.push_back({target, what});
}

void checkEnding(const std::string& target, const std::string& option, const std::string& allowed) {
  std::string ending = fs::path(target).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (ending.empty() || ending == allowed) return;
  if (ending == ".bin" || hasMeshEnding(target))
    throw InputError(FOOTFALL_TEXT("%1: %2 writes %3 files; give a name that ends so"), target, option, allowed);
}

}  // namespace footfall::detail
