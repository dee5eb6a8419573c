// A file that is written to the disk and read from it in blocks, not from memory that the system keeps of it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace footfall::bench {

/// Each block has its length before it (eight bytes). Throws RunError where the disk fails, with the path and reason.
class DiskFile {
 public:
  enum class Mode { Write, Read };
  DiskFile(const std::string& path, Mode mode);
  DiskFile(const DiskFile&) = delete;
  DiskFile& operator=(const DiskFile&) = delete;
  ~DiskFile();

  void writeBlock(const std::string& bytes);
  void readBlock(std::string& bytes);
  /// Waits until the disk has everything (fsync), and closes.
  void finish();
  /// Makes the system forget what it keeps of the file, so that reading comes from the disk. Not every file system
  /// does.
  static void forget(const std::string& path);

 private:
  void readAll(char* to, std::size_t count);
  void writeAll(const char* from, std::size_t count);
  [[noreturn]] void fail(const char* what) const;

  std::string path_;
  int file_ = -1;
};

}  // namespace footfall::bench
