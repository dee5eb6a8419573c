// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <set>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/io/export.hpp"
#include "core/io/output_files.hpp"
#include "core/io/pipe_output.hpp"
#include "core/io/stale_files.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // the limit of Linux

fs::path folderOf(const fs::path& target) { return target.has_parent_path() ? target.parent_path() : fs::path("."); }

/// The first part of a path that exists and is not a folder.
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

/// The problem behind an error that depends on the target and its folder.
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
      return {FOOTFALL_TEXT("cannot be written: its disk is read-only"), FOOTFALL_TEXT("choose another disk")};
    case ENOSPC:
      return {FOOTFALL_TEXT("cannot be written: the disk is full"),
              FOOTFALL_TEXT("free some space or choose another disk")};
    case EDQUOT:
      return {FOOTFALL_TEXT("cannot be written: your disk quota is used up"),
              FOOTFALL_TEXT("free some space or choose another disk")};
    case EFBIG:
      return {FOOTFALL_TEXT("cannot be written: it is too large for this disk"), FOOTFALL_TEXT("choose another disk")};
    case ENAMETOOLONG:
      return {FOOTFALL_TEXT("cannot be written: its name or path is too long"), FOOTFALL_TEXT("shorten it")};
    case ELOOP:
      return {FOOTFALL_TEXT("cannot be written: its symbolic links form a circle"),
              FOOTFALL_TEXT("remove the link or choose another name")};
    case EPIPE:
      return {FOOTFALL_TEXT("was closed by its reader before all was written"),
              FOOTFALL_TEXT("check why it ended, and run this again")};
    case EMFILE:
    case ENFILE:
      return {FOOTFALL_TEXT("cannot be written: too many files are open"),
              FOOTFALL_TEXT("close other programs, or raise the limit (ulimit -n)")};
    case EBUSY:
    case ETXTBSY:
      return {FOOTFALL_TEXT("cannot be written: another program uses it"),
              FOOTFALL_TEXT("close that program or choose another name")};
    default:
      return {Text(FOOTFALL_TEXT("cannot be written: %1"), std::strerror(error))};
  }
}

/// `target` is the file that the path leads to.
[[noreturn]] void failWriting(const std::string& path, const fs::path& target, int error) {
  const Problem problem = problemOf(target, error);
  throw RunError(Pattern{"%1: %2; %3"}, path, problem.what, problem.todo);
}

[[noreturn]] void failWriting(const std::string& path, int error) { failWriting(path, path, error); }

void writeAll(const std::string& path, int descriptor, std::string_view text, const Poll& poll) {
  constexpr std::size_t kPiece = std::size_t{1} << 22;
  while (!text.empty()) {
    poll();
    const ssize_t count = ::write(descriptor, text.data(), std::min(text.size(), kPiece));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) failWriting(path, errno);
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

/// Creates a new file with an unused name in the folder of the target, because a rename is atomic only within a file
/// system.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& shownPath, const fs::path& target) : shownPath_(shownPath), target_(target) {
    const fs::path folder = folderOf(target);
    static std::atomic<unsigned> counter{0};
    removeStaleFiles(folder.string());
    do {
      // The name is short, so that it fits wherever the target's name fits.
      name_ = folder / temporaryName(counter++);
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

  /// Writes all of the text and flushes it to the disk.
  void write(std::string_view text, const Poll& poll) {
    writeAll(shownPath_, descriptor_, text, poll);
    close();
  }
  void close() {
    if (::fsync(descriptor_) != 0) failWriting(shownPath_, errno);
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (::close(descriptor) != 0) failWriting(shownPath_, target_, errno);
  }
  void takeMode(mode_t mode) { ::fchmod(descriptor_, mode); }
  [[nodiscard]] int descriptor() const { return descriptor_; }

  void replaceTarget() {
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

/// A file without a name in that folder.
int openNameless(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDWR | O_TMPFILE | O_CLOEXEC, 0600);
  if (descriptor >= 0 || (errno != EOPNOTSUPP && errno != EISDIR && errno != EINVAL)) return descriptor;
  // Some file systems have no nameless files.
  std::string name = (folder / ".footfall-XXXXXX").string();
  const int named = ::mkostemp(name.data(), O_CLOEXEC);
  if (named >= 0) ::unlink(name.c_str());
  return named;
}

/// Writes at an offset; the position in the file does not change.
void writeAllAt(const std::string& path, int descriptor, std::uint64_t offset, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::pwrite(descriptor, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) failWriting(path, errno);
    bytes.remove_prefix(static_cast<std::size_t>(count));
    offset += static_cast<std::uint64_t>(count);
  }
}

/// Writes to a terminal, a pipe or a device, which a file cannot replace.
void writeInPlace(const std::string& path, std::string_view text, const Poll& poll) {
  if (const int error = writeToPipe(path, text, poll); error != 0) failWriting(path, error);
}

struct Target {
  fs::path path;  ///< target of all links
  bool exists = false;
  mode_t mode = 0;
};

/// Throws RunError when it is known beforehand that writing will fail.
Target findTarget(const std::string& path) {
  if (path.empty()) throw RunError(FOOTFALL_TEXT("no file name to write to; give one"));
  if (path.back() == '/') failWriting(path, EISDIR);
  // A link stays a link: the file that it points to is replaced.
  Target target{path};
  std::error_code ignored;
  for (int links = 0; fs::is_symlink(target.path, ignored); ++links) {
    if (links == kMostLinks) failWriting(path, ELOOP);
    const fs::path next = fs::read_symlink(target.path, ignored);
    if (ignored) failWriting(path, target.path, ignored.value());
    target.path = target.path.parent_path() / next;  // an absolute path replaces the folder
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

/// Makes the rename survive a power failure. Some file systems cannot; the file is complete in any case.
void syncFolder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

void checkWritable(const std::string& path) { findTarget(path); }

std::string besideName(const std::string& path, const std::string& suffix) {
  const fs::path target(path);
  return (target.parent_path() / (target.stem().string() + '-' + suffix + target.extension().string())).string();
}

std::vector<std::string> existingOutputs(const std::string& path) {
  const fs::path target(path);
  const std::string start = target.stem().string() + '-', ending = target.extension().string();
  std::vector<std::string> found;
  std::error_code ignored;
  if (fs::is_regular_file(target, ignored)) found.push_back(path);
  const auto isPage = [&](const std::string& name) {
    if (!name.starts_with(start) || !name.ends_with(ending) || name.size() <= start.size() + ending.size())
      return false;
    const std::string_view suffix =
        std::string_view(name).substr(start.size(), name.size() - start.size() - ending.size());
    return suffix == kLinksSuffix || suffix.find_first_not_of("0123456789") == std::string_view::npos;
  };
  const std::size_t single = found.size();
  for (fs::directory_iterator at(folderOf(target), ignored), end; !ignored && at != end; at.increment(ignored))
    if (isPage(at->path().filename().string()))
      found.push_back((target.parent_path() / at->path().filename()).string());
  // plan-2 precedes plan-10.
  std::sort(
      found.begin() + static_cast<std::ptrdiff_t>(single), found.end(),
      [](const std::string& a, const std::string& b) { return a.size() != b.size() ? a.size() < b.size() : a < b; });
  return found;
}

void writeFilesSafely(std::span<const OutputFile> files, Poll poll) {
  struct Output {
    const OutputFile& file;
    Target target;
    std::unique_ptr<TemporaryFile> temporary = nullptr;  ///< null where the target cannot be replaced
  };
  std::vector<Output> outputs;
  outputs.reserve(files.size());
  for (const OutputFile& file : files) outputs.push_back({file, findTarget(file.path)});
  for (Output& output : outputs) {
    const Target& target = output.target;
    if (target.exists && !S_ISREG(target.mode)) continue;
    output.temporary = std::make_unique<TemporaryFile>(output.file.path, target.path);
    if (target.exists) output.temporary->takeMode(target.mode & 07777);
    output.temporary->write(output.file.bytes, poll);
  }
  poll();
  // The renames follow each other directly, so that a kill hardly ever separates them.
  std::set<fs::path> folders;
  for (Output& output : outputs) {
    if (!output.temporary) continue;
    output.temporary->replaceTarget();
    folders.insert(folderOf(output.target.path));
  }
  for (const fs::path& folder : folders) syncFolder(folder);
  for (const Output& output : outputs)
    if (!output.temporary) writeInPlace(output.file.path, output.file.bytes, poll);
}

void writeFileSafely(const std::string& path, const std::string& text, Poll poll) {
  const Target target = findTarget(path);
  if (target.exists && !S_ISREG(target.mode)) return writeInPlace(path, text, poll);

  TemporaryFile file(path, target.path);
  if (target.exists) file.takeMode(target.mode & 07777);
  file.write(text, poll);
  file.replaceTarget();
  syncFolder(folderOf(target.path));
}

struct GrowingFile::State {
  std::string path;
  Target target;
  std::unique_ptr<TemporaryFile> file = nullptr;
  std::uint64_t size = 0;
};

GrowingFile::GrowingFile(const std::string& path) : state_(std::make_unique<State>(State{path, findTarget(path)})) {
  const Target& target = state_->target;
  if (target.exists && !S_ISREG(target.mode))
    throw RunError(FOOTFALL_TEXT("%1: is not an ordinary file; choose a file"), path);
  state_->file = std::make_unique<TemporaryFile>(state_->path, target.path);
  if (target.exists) state_->file->takeMode(target.mode & 07777);
}

GrowingFile::~GrowingFile() = default;

void GrowingFile::append(std::string_view bytes, const Poll& poll) {
  writeAll(state_->path, state_->file->descriptor(), bytes, poll);
  state_->size += bytes.size();
}

void GrowingFile::writeAt(std::uint64_t offset, std::string_view bytes) {
  writeAllAt(state_->path, state_->file->descriptor(), offset, bytes);
}

std::uint64_t GrowingFile::size() const { return state_->size; }

void GrowingFile::finish(const Poll& poll) {
  state_->file->close();
  poll();
  state_->file->replaceTarget();
  syncFolder(folderOf(state_->target.path));
}

ScratchFile::ScratchFile(const std::string& path, std::size_t memory) : path_(path), memory_(memory) {}

ScratchFile::~ScratchFile() { clear(); }

void ScratchFile::append(std::string_view bytes) {
  if (kept_.size() + bytes.size() <= memory_) {
    kept_.append(bytes);
    return;
  }
  if (descriptor_ < 0) descriptor_ = openNameless(folderOf(findTarget(path_).path));
  if (descriptor_ < 0) failWriting(path_, errno);
  for (const std::string_view piece : {std::string_view(kept_), bytes}) {
    writeAllAt(path_, descriptor_, written_, piece);
    written_ += piece.size();
  }
  kept_.clear();
}

void ScratchFile::read(std::uint64_t offset, void* bytes, std::size_t size) const {
  char* out = static_cast<char*>(bytes);
  while (size > 0 && offset < written_) {
    const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(size, written_ - offset));
    const ssize_t count = ::pread(descriptor_, out, wanted, static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0)
      throw RunError(FOOTFALL_TEXT("%1: the temporary file beside it cannot be read (%2); check the disk"), path_,
                     std::strerror(count < 0 ? errno : EIO));
    out += count;
    offset += static_cast<std::uint64_t>(count);
    size -= static_cast<std::size_t>(count);
  }
  if (size > 0) std::memcpy(out, kept_.data() + (offset - written_), size);
}

void ScratchFile::clear() {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
  written_ = 0;
  kept_ = {};
}

}  // namespace footfall::detail
