// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ifc_reader.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <thread>
#include <vector>

#include "core/io/input_file.hpp"
#include "core/io/obj_reader.hpp"
#include "footfall/errors.hpp"

extern char** environ;

namespace footfall::detail {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNode = "node";
constexpr int kNotFound = 127;  // the exit code of a program that could not be started

/// A file that only this user can read, until this ends.
class TemporaryFile {
 public:
  TemporaryFile() {
    std::error_code ignored;
    const fs::path folder = fs::temp_directory_path(ignored);
    path_ = ((ignored ? fs::path("/tmp") : folder) / "footfall-XXXXXX").string();
    const int descriptor = ::mkstemp(path_.data());
    if (descriptor < 0) throw RunError(FOOTFALL_TEXT("%1: no file can be made there; free some space"), path_);
    ::close(descriptor);
  }
  ~TemporaryFile() { ::unlink(path_.c_str()); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// Runs a program, found in PATH, with no input and its messages in the file `messages`. Returns its exit code,
/// kNotFound where there is none. Cancelling kills it.
int runProgram(std::vector<std::string> words, const std::string& messages, const RunContext* context) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, messages.c_str(), O_WRONLY | O_TRUNC, 0);
  // Signals that the caller blocks would stay blocked.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  pid_t child = -1;
  const int error = ::posix_spawnp(&child, words[0].c_str(), &files, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0) return kNotFound;
  int status = 0;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    try {
      if (context != nullptr) context->checkCancelled();
    } catch (...) {
      ::kill(child, SIGKILL);
      ::waitpid(child, &status, 0);
      throw;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

bool isIfc(const std::string& path) {
  std::string ending = fs::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending == ".ifc";
}

bool hasNode() {
  static const bool found = [] {
    const TemporaryFile messages;
    return runProgram({kNode, "--version"}, messages.path(), nullptr) == 0;
  }();
  return found;
}

}  // namespace

std::string findIfcConverter() {
  if (const char* given = std::getenv("FOOTFALL_IFC")) return given;
  std::vector<fs::path> folders;
  const char *data = std::getenv("XDG_DATA_HOME"), *home = std::getenv("HOME");
  if (data != nullptr && *data == '/')
    folders.emplace_back(data);
  else if (home != nullptr && *home == '/')
    folders.push_back(fs::path(home) / ".local/share");
  folders.insert(folders.end(), {"/usr/local/share", "/usr/share"});
  for (const fs::path& folder : folders) {
    const fs::path converter = folder / "footfall/ifc/ifc_to_obj.mjs";
    std::error_code ignored;
    if (fs::is_regular_file(converter, ignored)) return converter.string();
  }
  return {};
}

std::optional<FileFrame> readIfc(const std::string& path, Environment& environment, RunContext* context) {
  const std::string converter = findIfcConverter();
  if (converter.empty() || !hasNode()) return std::nullopt;
  const TemporaryFile converted, messages;
  // A name that begins with a dash is no option.
  const std::string input = fs::absolute(path).string();
  const int code = runProgram({kNode, converter, input, converted.path()}, messages.path(), context);
  if (code != 0) {
    // The last line says it; lines before are Node's own.
    std::string said = readInputFile(messages.path(), context);
    while (!said.empty() && said.back() == '\n') said.pop_back();
    said.erase(0, said.find_last_of('\n') + 1);
    failInput(path, 0, Text(FOOTFALL_TEXT("the converter for IFC cannot read it: %1"), said),
              FOOTFALL_TEXT("check the file, or set FOOTFALL_IFC to nothing to read it without the converter"));
  }
  readObj(path, readInputFile(converted.path(), context), environment, context);
  return FileFrame{UpAxis::Z, 1.0};
}

Text missingIfcConverter(const std::string& path) {
  if (!isIfc(path) || (!findIfcConverter().empty() && hasNode())) return {};
  return FOOTFALL_TEXT(
      "read without the converter for IFC, which cuts openings, leaves doors open and knows storeys; "
      "installer/ifc.sh installs it");
}

bool isIfcFurniture(const std::string& material) {
  constexpr std::array<std::string_view, 3> kFurniture{"IfcFurnishingElement", "IfcFurniture",
                                                       "IfcSystemFurnitureElement"};
  return std::find(kFurniture.begin(), kFurniture.end(), material) != kFurniture.end();
}

}  // namespace footfall::detail
