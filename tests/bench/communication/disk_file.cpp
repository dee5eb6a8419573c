// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/communication/disk_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "footfall/errors.hpp"

namespace footfall::bench {
namespace {
constexpr std::uint64_t kLongestBlock = std::uint64_t{1} << 32;
}

DiskFile::DiskFile(const std::string& path, Mode mode) : path_(path) {
  file_ = mode == Mode::Write ? ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600)
                              : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file_ < 0) fail("cannot be opened");
}

DiskFile::~DiskFile() {
  if (file_ >= 0) ::close(file_);
}

void DiskFile::fail(const char* what) const {
  throw RunError(path_ + ": " + what + " (" + std::strerror(errno) + "); choose another folder with --folder");
}

void DiskFile::writeAll(const char* from, std::size_t count) {
  while (count > 0) {
    const ssize_t done = ::write(file_, from, count);
    if (done < 0) fail("cannot be written");
    from += done;
    count -= static_cast<std::size_t>(done);
  }
}

void DiskFile::readAll(char* to, std::size_t count) {
  while (count > 0) {
    const ssize_t done = ::read(file_, to, count);
    if (done <= 0) fail("cannot be read");
    to += done;
    count -= static_cast<std::size_t>(done);
  }
}

void DiskFile::writeBlock(const std::string& bytes) {
  const std::uint64_t length = bytes.size();
  char head[sizeof(length)];
  std::memcpy(head, &length, sizeof(length));
  writeAll(head, sizeof(head));
  writeAll(bytes.data(), bytes.size());
}

void DiskFile::readBlock(std::string& bytes) {
  std::uint64_t length = 0;
  char head[sizeof(length)];
  readAll(head, sizeof(head));
  std::memcpy(&length, head, sizeof(length));
  if (length > kLongestBlock) fail("has a block that is too long");
  bytes.resize(length);
  readAll(bytes.data(), bytes.size());
}

void DiskFile::finish() {
  if (::fsync(file_) != 0) fail("cannot be written");
  ::close(file_);
  file_ = -1;
}

void DiskFile::forget(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return;
  ::posix_fadvise(file, 0, 0, POSIX_FADV_DONTNEED);
  ::close(file);
}

}  // namespace footfall::bench
