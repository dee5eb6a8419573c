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

#include "core/io/export.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

namespace fs = std::filesystem;

fs::path folderOf(const fs::path& target) { return target.has_parent_path() ? target.parent_path() : fs::path("."); }

/// The first part of a path that is there and is no folder.
std::string fileWithin(const fs::path& folder) {
  fs::path part;
  std::error_code ignored;
  for (const fs::path& name : folder) {
    part /= name;
    if (fs::exists(part, ignored) && !fs::is_directory(part, ignored)) return part.string();
  }
  return folder.string();
}

struct Problem {
  Text what;
  Text todo = FOOTFALL_TEXT("choose another place");
};

/// For errors that depend on what lies at the target and around it.
Problem problemOfPlace(const fs::path& target, int error) {
  const fs::path folder = folderOf(target);
  std::error_code ignored;
  const Pattern another = FOOTFALL_TEXT("choose another folder");
  if (error == ENOTDIR)
    return {Text(FOOTFALL_TEXT("cannot be written: %1 is a file, not a folder"), fileWithin(folder)), another};
  if (error == ENOENT && fs::is_directory(folder, ignored))
    return {FOOTFALL_TEXT("cannot be written: no file can be made in its folder"), another};
  if (error == ENOENT)
    return {FOOTFALL_TEXT("cannot be written: its folder does not exist"),
            FOOTFALL_TEXT("create the folder or choose another one")};
  if (::access(target.c_str(), F_OK) == 0 && ::access(target.c_str(), W_OK) != 0)
    return {FOOTFALL_TEXT("no permission to write it"),
            FOOTFALL_TEXT("change the permissions of the file or choose another name")};
  return {FOOTFALL_TEXT("no permission to write in its folder"),
          FOOTFALL_TEXT("change the permissions of the folder or choose another one")};
}

Problem problemOf(const fs::path& target, int error) {
  switch (error) {
    case ENOENT:
    case ENOTDIR:
    case EACCES:
    case EPERM:
      return problemOfPlace(target, error);
    case EISDIR:
      return {FOOTFALL_TEXT("is a folder"), FOOTFALL_TEXT("give the name of a file in it")};
    case EROFS:
      return {FOOTFALL_TEXT("cannot be written: its disk can only be read"), FOOTFALL_TEXT("choose another disk")};
    case ENOSPC:
      return {FOOTFALL_TEXT("cannot be written: the disk is full"),
              FOOTFALL_TEXT("free some space or choose another disk")};
    case EDQUOT:
      return {FOOTFALL_TEXT("cannot be written: your share of the disk is used up"),
              FOOTFALL_TEXT("free some space or choose another disk")};
    case EFBIG:
      return {FOOTFALL_TEXT("cannot be written: it is too large for this disk"), FOOTFALL_TEXT("choose another disk")};
    case ENAMETOOLONG:
      return {FOOTFALL_TEXT("cannot be written: its name or path is too long"), FOOTFALL_TEXT("shorten it")};
    case ELOOP:
      return {FOOTFALL_TEXT("cannot be written: symbolic links lead round in a circle"),
              FOOTFALL_TEXT("remove the link or choose another name")};
    case EBUSY:
    case ETXTBSY:
      return {FOOTFALL_TEXT("cannot be written: another program uses it"),
              FOOTFALL_TEXT("close that program or choose another name")};
    default:
      return {Text(FOOTFALL_TEXT("cannot be written: %1"), std::strerror(error))};
  }
}

/// `target`: what the path leads to.
[[noreturn]] void failWriting(const std::string& path, const fs::path& target, int error) {
  const Problem problem = problemOf(target, error);
  throw RunError(Pattern{"%1: %2; %3"}, path, problem.what, problem.todo);
}

[[noreturn]] void failWriting(const std::string& path, int error) { failWriting(path, path, error); }

/// Creates a new file of a name that nobody has; its folder is the target's, since only there a rename is atomic.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& shownPath, const fs::path& target) : shownPath_(shownPath), target_(target) {
    const fs::path folder = folderOf(target);
    static std::atomic<unsigned> counter{0};
    do {
      // short, so that it fits wherever the target's name fits
      name_ = folder / (".footfall-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".tmp");
      descriptor_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (descriptor_ < 0 && errno == EEXIST);
    if (descriptor_ < 0) failWriting(shownPath_, target_, errno);
  }
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!renamed_) ::unlink(name_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  [[nodiscard]] int descriptor() const { return descriptor_; }

  void replaceTarget() {
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (::close(descriptor) != 0) failWriting(shownPath_, target_, errno);
    if (::rename(name_.c_str(), target_.c_str()) != 0) failWriting(shownPath_, target_, errno);
    renamed_ = true;
  }

 private:
  const std::string& shownPath_;
  const fs::path& target_;
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

struct Target {
  fs::path path;  ///< what links lead to
  bool exists = false;
  mode_t mode = 0;
};

/// Throws RunError when it is known beforehand that nothing can be written there.
Target findTarget(const std::string& path) {
  if (path.empty()) throw RunError(FOOTFALL_TEXT("no file name to write to; give one"));
  if (path.back() == '/') failWriting(path, EISDIR);
  // A link stays a link: what it points to is replaced.
  Target target{path};
  std::error_code ignored;
  if (fs::is_symlink(target.path, ignored)) {
    const fs::path resolved = fs::weakly_canonical(target.path, ignored);
    if (!ignored) target.path = resolved;
  }
  struct stat status {};
  target.exists = ::stat(target.path.c_str(), &status) == 0;
  if (!target.exists && errno != ENOENT) failWriting(path, target.path, errno);
  target.mode = status.st_mode;
  if (target.exists && S_ISDIR(target.mode)) failWriting(path, EISDIR);
  if (target.exists && ::access(target.path.c_str(), W_OK) != 0) failWriting(path, target.path, errno);
  const bool isReplaced = !target.exists || S_ISREG(target.mode);
  if (isReplaced && ::access(folderOf(target.path).c_str(), W_OK | X_OK) != 0) failWriting(path, target.path, errno);
  return target;
}

/// Makes the rename last over a power failure. Not all file systems can; the file is whole in any case.
void syncFolder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

void checkWritable(const std::string& path) { findTarget(path); }

void writeFileSafely(const std::string& path, const std::string& text) {
  const Target target = findTarget(path);
  if (target.exists && !S_ISREG(target.mode)) return writeInPlace(path, text);

  TemporaryFile file(path, target.path);
  if (target.exists) ::fchmod(file.descriptor(), target.mode & 07777);
  writeAll(path, file.descriptor(), text);
  if (::fsync(file.descriptor()) != 0) failWriting(path, errno);
  file.replaceTarget();
  syncFolder(folderOf(target.path));
}

}  // namespace footfall::detail
