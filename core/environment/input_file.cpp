// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environment/input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace footfall {
namespace {

/// An open file descriptor of a non-empty regular file.
class InputDescriptor {
 public:
  explicit InputDescriptor(const std::string& path) {
    // Opening a FIFO for reading would wait for a writer for ever.
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor_ < 0) {
      const int error = errno;
      if (error == ENOENT || error == ENOTDIR) failInput(path, 0, "no such file", "check the name");
      if (error == EACCES || error == EPERM) {
        failInput(path, 0, "no permission to read it", "change the permissions of the file and its folders");
      }
      failInput(path, 0, std::string("cannot be opened: ") + std::strerror(error), "choose another file");
    }
    struct stat status {};
    const bool known = ::fstat(descriptor_, &status) == 0;
    const char* problem = nullptr;
    const char* todo = "choose a file";
    if (known && S_ISDIR(status.st_mode)) {
      problem = "is a folder, not a file";
      todo = "choose a file in it";
    } else if (!known || !S_ISREG(status.st_mode)) {
      problem = "is not an ordinary file";
    } else if (status.st_size == 0) {
      problem = "the file is empty (0 bytes)";
      todo = "export it again or choose another file";
    }
    if (problem != nullptr) {
      ::close(descriptor_);
      failInput(path, 0, problem, todo);
    }
    size_ = static_cast<std::size_t>(status.st_size);
  }
  ~InputDescriptor() { ::close(descriptor_); }
  InputDescriptor(const InputDescriptor&) = delete;
  InputDescriptor& operator=(const InputDescriptor&) = delete;

  [[nodiscard]] int get() const { return descriptor_; }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  int descriptor_ = -1;
  std::size_t size_ = 0;
};

}  // namespace

void failInput(const std::string& path, std::size_t line, std::string_view what, std::string_view todo) {
  std::string message = path;
  if (line != 0) message += ':' + std::to_string(line);
  message.append(": ").append(what).append("; ").append(todo);
  for (char& c : message) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  throw InputError(message);
}

void checkInputFile(const std::string& path) { InputDescriptor check(path); }

std::string readInputFile(const std::string& path, RunContext* context) {
  const InputDescriptor file(path);
  constexpr std::size_t kBlock = std::size_t{4} << 20;  // small enough to notice a cancel in time
  std::string text(file.size(), '\0');
  std::size_t filled = 0;
  while (filled < text.size()) {
    if (context != nullptr) context->checkCancelled();
    const ssize_t count = ::read(file.get(), text.data() + filled, std::min(kBlock, text.size() - filled));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) failInput(path, 0, std::string("cannot be read: ") + std::strerror(errno), "check the disk");
    if (count == 0) break;  // shortened while we read
    filled += static_cast<std::size_t>(count);
  }
  text.resize(filled);
  if (text.empty()) failInput(path, 0, "the file is empty (0 bytes)", "export it again or choose another file");
  return text;
}

}  // namespace footfall
