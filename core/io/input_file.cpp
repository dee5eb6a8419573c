// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace footfall::detail {
namespace {

constexpr Pattern kEmpty = FOOTFALL_TEXT("the file is empty (0 bytes)");
constexpr Pattern kExportAgain = FOOTFALL_TEXT("export it again or choose another file");

}  // namespace

void failInput(const std::string& path, std::size_t line, const Text& what, const Text& todo) {
  const Text place = line == 0 ? Text(path) : Text(Pattern{"%1:%2"}, path, line);
  throw InputError(Text(Pattern{"%1: %2; %3"}, place, what, todo).inOneLine());
}

InputFile::InputFile(const std::string& path) : path_(path) {
  // Opening a FIFO for reading without O_NONBLOCK would wait for a writer for ever.
  descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor_ < 0) {
    const int error = errno;
    if (error == ENOENT || error == ENOTDIR)
      failInput(path, 0, FOOTFALL_TEXT("no such file"), FOOTFALL_TEXT("check the name"));
    if (error == EACCES || error == EPERM) {
      failInput(path, 0, FOOTFALL_TEXT("no permission to read it"),
                FOOTFALL_TEXT("change the permissions of the file and its folders"));
    }
    failInput(path, 0, Text(FOOTFALL_TEXT("cannot be opened: %1"), std::strerror(error)),
              FOOTFALL_TEXT("choose another file"));
  }
  struct stat status {};
  const bool known = ::fstat(descriptor_, &status) == 0;
  Text problem;
  Text todo = FOOTFALL_TEXT("choose a file");
  if (known && S_ISDIR(status.st_mode)) {
    problem = FOOTFALL_TEXT("is a folder, not a file");
    todo = FOOTFALL_TEXT("choose a file in it");
  } else if (!known || !S_ISREG(status.st_mode)) {
    problem = FOOTFALL_TEXT("is not an ordinary file");
  } else if (status.st_size == 0) {
    problem = kEmpty;
    todo = kExportAgain;
  }
  if (!problem.empty()) {
    ::close(descriptor_);
    failInput(path, 0, problem, todo);
  }
  size_ = static_cast<std::uint64_t>(status.st_size);
}

InputFile::~InputFile() { ::close(descriptor_); }

std::size_t InputFile::read(std::uint64_t offset, char* bytes, std::size_t size) const {
  std::size_t filled = 0;
  while (filled < size) {
    const ssize_t count = ::pread(descriptor_, bytes + filled, size - filled, static_cast<off_t>(offset + filled));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0)
      failInput(path_, 0, Text(FOOTFALL_TEXT("cannot be read: %1"), std::strerror(errno)),
                FOOTFALL_TEXT("check the disk"));
    if (count == 0) break;  // the file was shortened meanwhile
    filled += static_cast<std::size_t>(count);
  }
  return filled;
}

void checkInputFile(const std::string& path) { InputFile check(path); }

std::string readInputFile(const std::string& path, RunContext* context) {
  const InputFile file(path);
  constexpr std::size_t kBlock = std::size_t{4} << 20;  // small enough to notice a cancel in time
  std::string text(static_cast<std::size_t>(file.size()), '\0');
  std::size_t filled = 0;
  while (filled < text.size()) {
    if (context != nullptr) context->checkCancelled();
    const std::size_t wanted = std::min(kBlock, text.size() - filled);
    const std::size_t count = file.read(filled, text.data() + filled, wanted);
    filled += count;
    if (count < wanted) break;
  }
  text.resize(filled);
  if (text.empty()) failInput(path, 0, kEmpty, kExportAgain);
  return text;
}

}  // namespace footfall::detail
