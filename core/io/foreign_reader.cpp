// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/foreign_reader.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <vector>

#include "core/io/foreign_stream.hpp"
#include "core/io/input_file.hpp"
#include "core/io/own_files.hpp"
#include "core/io/write_targets.hpp"

namespace footfall::detail {
namespace {

namespace fs = std::filesystem;

constexpr const char* kProgram = "footfall-import";
constexpr int kFoldersUp = 3;
constexpr double kLeastMs = 60'000, kMsPerMiB = 20'000;
constexpr std::uint64_t kMiB = std::uint64_t{1} << 20, kLeastBytes = 1024 * kMiB, kBytesPerByte = 200;

bool isProgramOf(const fs::path& path, std::uint32_t owner) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode) && ::access(path.c_str(), X_OK) == 0 &&
         (status.st_uid == 0 || status.st_uid == owner);
}

std::string ended(int status) {
  const int signal = status - 128;
  const char* name = signal > 0 ? ::strsignal(signal) : nullptr;
  return std::to_string(signal) + (name == nullptr ? "" : " (" + std::string(name) + ")");
}

[[noreturn]] void failWithoutProgram(const std::string& path, const std::string& format) {
  const char* given = std::getenv("FOOTFALL_IMPORT");
  const Text what =
      given != nullptr && *given != '\0'
          ? Text(FOOTFALL_TEXT("%1 is read by the program footfall-import, and FOOTFALL_IMPORT names '%2', which is "
                               "none"),
                 format, given)
          : Text(FOOTFALL_TEXT("%1 is read by the program footfall-import, which is missing beside Footfall"), format);
  failInput(path, 0, what,
            FOOTFALL_TEXT("install Footfall again, name the program in the environment variable FOOTFALL_IMPORT, or "
                          "convert the file to OBJ"));
}

void checkEnd(const std::string& path, const std::string& format, const ChildResult& result,
              const ChildLimits& limits) {
  failBeyondLimits(path, format, result.end, limits);
  if (result.status == 127)
    failInput(path, 0,
              Text(FOOTFALL_TEXT("footfall-import, which reads %1, cannot be started (%2)"), format, result.errors),
              FOOTFALL_TEXT("install Footfall again"));
  const Pattern todo = FOOTFALL_TEXT("the file is damaged, or that reader is: export it again, or as OBJ");
  if (result.status > 128)
    failInput(path, 0, Text(FOOTFALL_TEXT("the reader for %1 ended by signal %2"), format, ended(result.status)), todo);
  if (result.status != 0)
    failInput(path, 0, Text(FOOTFALL_TEXT("the reader for %1 ended with exit status %2"), format, result.status), todo);
}

}  // namespace

std::optional<std::string> findImportProgram() {
  const char* given = std::getenv("FOOTFALL_IMPORT");
  if (given != nullptr && *given != '\0')
    return ::access(given, X_OK) == 0 && !fs::is_directory(given) ? std::optional<std::string>(given) : std::nullopt;
  for (const fs::path& file : ownFiles()) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) continue;
    fs::path folder = file.parent_path();
    for (int up = 0; up < kFoldersUp; ++up, folder = folder.parent_path())
      for (const fs::path& place : {folder / kProgram, folder / "libexec/footfall" / kProgram})
        if (isProgramOf(place, status.st_uid)) return place.string();
  }
  return std::nullopt;
}

ChildLimits importLimits(std::uint64_t bytes) {
  const auto pages = static_cast<std::uint64_t>(std::max(::sysconf(_SC_PHYS_PAGES), 0L));
  const std::uint64_t machine = pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  ChildLimits limits;
  limits.wallMs = kLeastMs + kMsPerMiB * static_cast<double>(bytes) / static_cast<double>(kMiB);
  limits.bytes = kLeastBytes + std::min(bytes, limits.bytes / (2 * kBytesPerByte)) * kBytesPerByte;
  if (machine > 0) limits.bytes = std::min(limits.bytes, machine / 5 * 4);
  return limits;
}

ChildLimits importLimitsFor(const std::string& path) {
  std::error_code error;
  std::uint64_t bytes = InputFile(path).size();
  const std::string extension = lowerExtension(path);
  if (extension == "gltf" || extension == "glb")
    for (const std::string& companion : companionFiles(path)) {
      const std::uintmax_t size = fs::file_size(companion, error);
      if (!error) bytes += size;
    }
  return importLimits(bytes);
}

std::string formatName(std::string_view extension) {
  constexpr std::array<std::array<std::string_view, 2>, 6> kNames{{{"gltf", "glTF"},
                                                                   {"glb", "glTF"},
                                                                   {"dae", "COLLADA"},
                                                                   {"zae", "COLLADA"},
                                                                   {"blend", "Blender"},
                                                                   {"x", "DirectX"}}};
  for (const auto& name : kNames)
    if (name[0] == extension) return std::string(name[1]);
  std::string upper(extension);
  std::transform(upper.begin(), upper.end(), upper.begin(), [](unsigned char c) { return std::toupper(c); });
  return upper;
}

const std::vector<std::string>& foreignExtensions() {
  static const std::vector<std::string> kExtensions{
      "3d",     "3ds", "3mf",  "ac",       "ac3d", "acc",  "amf",  "ase", "ask",  "assbin",  "b3d",       "blend",
      "bsp",    "bvh", "cob",  "csm",      "dae",  "dxf",  "enff", "fbx", "glb",  "gltf",    "hmp",       "ifc",
      "ifczip", "iqm", "irr",  "irrmesh",  "lwo",  "lws",  "lxo",  "md2", "md3",  "md5anim", "md5camera", "md5mesh",
      "mdc",    "mdl", "mesh", "mesh.xml", "mot",  "ms3d", "ndo",  "nff", "off",  "ogex",    "pk3",       "ply",
      "pmx",    "prj", "q3o",  "q3s",      "raw",  "scn",  "sib",  "smd", "step", "stl",     "stp",       "ter",
      "uc",     "vta", "x",    "x3d",      "x3db", "xgl",  "xml",  "zae", "zgl"};
  return kExtensions;
}

void failBeyondLimits(const std::string& path, std::string_view format, ChildEnd end, const ChildLimits& limits) {
  if (end == ChildEnd::Itself) return;
  const Pattern todo =
      FOOTFALL_TEXT("export it again, or as OBJ; if the file is valid, switch the limits off (--no-import-limits)");
  if (end == ChildEnd::Time)
    failInput(path, 0,
              Text(FOOTFALL_TEXT("reading it as %1 took more than %2 seconds, far more than files of its size need"),
                   format, static_cast<std::uint64_t>(std::ceil(limits.wallMs / 1000))),
              todo);
  failInput(path, 0,
            Text(FOOTFALL_TEXT("reading it as %1 took more than %2 MB of memory, far more than files of its size need"),
                 format, limits.bytes / kMiB),
            todo);
}

FileFrame readForeign(const std::string& path, Environment& environment, const ChildLimits& limits,
                      RunContext* context) {
  const std::string format = formatName(lowerExtension(path));
  const std::optional<std::string> program = findImportProgram();
  if (!program) failWithoutProgram(path, format);
  const ChildResult result =
      runChild({*program, std::to_string(::getpid()), path}, Poll(context), ChildEnding::Killed, kChildGraceMs, limits);
  checkEnd(path, format, result, limits);
  FileFrame frame;
  std::optional<Text> problem;
  try {
    problem = decodeStream(result.output, environment, frame);
  } catch (const BadStream&) {
    failInput(path, 0, Text(FOOTFALL_TEXT("the reader for %1 ended too early"), format),
              FOOTFALL_TEXT("install Footfall again; where that does not help, convert the file to OBJ"));
  }
  if (problem) throw InputError(*problem);
  frame.areFloats = true;
  return frame;
}

}  // namespace footfall::detail
