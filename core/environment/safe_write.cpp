// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "core/environment/export.hpp"
#include "core/errors.hpp"

namespace footfall {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void failWriting(const std::string& path, int error) {
  Text what(FOOTFALL_TEXT("cannot be written: %1"), std::strerror(error));
  Text todo = FOOTFALL_TEXT("choose another place");
  switch (error) {
    case ENOENT:
    case ENOTDIR:
      what = FOOTFALL_TEXT("cannot be written: its folder does not exist");
      todo = FOOTFALL_TEXT("create the folder or choose another one");
      break;
    case EISDIR:
      what = FOOTFALL_TEXT("is a folder");
      todo = FOOTFALL_TEXT("give the name of a file in it");
      break;
    case EACCES:
    case EPERM:
    case EROFS:
      what = FOOTFALL_TEXT("no permission to write it");
      todo = FOOTFALL_TEXT("change the permissions or choose another folder");
      break;
    case ENOSPC:
    case EDQUOT:
      what = FOOTFALL_TEXT("cannot be written: the disk is full");
      todo = FOOTFALL_TEXT("free some space or choose another disk");
      break;
    default:
      break;
  }
  throw RunError(Pattern{"%1: %2; %3"}, path, what, todo);
}

/// Creates a new file of a name that nobody has; its folder is the target's, since only there a rename is atomic.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& shownPath, const fs::path& folder) : shownPath_(shownPath) {
    static std::atomic<unsigned> counter{0};
    do {
      // short, so that it fits wherever the target's name fits
      name_ = folder / (".footfall-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".tmp");
      descriptor_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (descriptor_ < 0 && errno == EEXIST);
    if (descriptor_ < 0) failWriting(shownPath_, errno);
  }
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!renamed_) ::unlink(name_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  [[nodiscard]] int descriptor() const { return descriptor_; }

  void renameTo(const fs::path& target) {
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (::close(descriptor) != 0) failWriting(shownPath_, errno);
    if (::rename(name_.c_str(), target.c_str()) != 0) failWriting(shownPath_, errno);
    renamed_ = true;
  }

 private:
  const std::string& shownPath_;
  fs::path name_;
  int descriptor_ = -1;
  bool renamed_ = false;
};

void writeAll(const std::string& path, int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) failWriting(path, errno);
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

/// A terminal, a pipe or a device cannot be replaced by a file.
void writeInPlace(const std::string& path, const std::string& text) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) failWriting(path, errno);
  try {
    writeAll(path, descriptor, text);
  } catch (...) {
    ::close(descriptor);
    throw;
  }
  if (::close(descriptor) != 0) failWriting(path, errno);
}

/// Makes the rename last over a power failure. Not all file systems can; the file is whole in any case.
void syncFolder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

void writeFileSafely(const std::string& path, const std::string& text) {
  if (path.empty()) throw RunError(FOOTFALL_TEXT("no file name to write to; give one"));
  if (path.back() == '/') failWriting(path, EISDIR);
  // A link stays a link: what it points to is replaced.
  fs::path target(path);
  std::error_code ignored;
  if (fs::is_symlink(target, ignored)) {
    const fs::path resolved = fs::weakly_canonical(target, ignored);
    if (!ignored) target = resolved;
  }

  struct stat status {};
  const bool exists = ::stat(target.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) failWriting(path, EISDIR);
  if (exists && !S_ISREG(status.st_mode)) return writeInPlace(path, text);
  if (exists && ::access(target.c_str(), W_OK) != 0) failWriting(path, errno);

  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  TemporaryFile file(path, folder);
  if (exists) ::fchmod(file.descriptor(), status.st_mode & 07777);
  writeAll(path, file.descriptor(), text);
  if (::fsync(file.descriptor()) != 0) failWriting(path, errno);
  file.renameTo(target);
  syncFolder(folder);
}

}  // namespace footfall
