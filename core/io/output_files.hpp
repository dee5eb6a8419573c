// Writing several files together, and files that are too large for memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/poll.hpp"

namespace footfall::detail {

/// A file to write.
struct OutputFile {
  std::string path, bytes;
};

/// The suffix of the file of links beside those of layers.
inline constexpr std::string_view kLinksSuffix = "links";

/// "plan-0.svg" for "plan.svg" and "0".
std::string besideName(const std::string& path, const std::string& suffix);

/// Existing files that an export of that name may replace, for formats with a file for each page or layer: the name
/// itself, then the names with numbers and "links", "plan-2.svg" before "plan-10.svg".
std::vector<std::string> existingOutputs(const std::string& path);

/// Writes all files beside their targets, and renames them when the last one is complete. Where one cannot be written,
/// or `poll` throws, all targets keep their content. (Only a kill or a broken disk between two renames can separate
/// them.) Pipes and devices are written directly. Throws RunError as writeFileSafely() does, and what `poll` throws.
void writeFilesSafely(std::span<const OutputFile> files, Poll poll = {});

/// A file that grows piece by piece beside its target and replaces it at the end. It serves content that no memory
/// holds.
class GrowingFile {
 public:
  /// Throws RunError as writeFileSafely() does, and for a target that is no ordinary file.
  explicit GrowingFile(const std::string& path);
  /// A file without finish() is removed, and the target keeps its content.
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  void append(std::string_view bytes, const Poll& poll);
  /// Overwrites bytes that were appended before.
  void writeAt(std::uint64_t offset, std::string_view bytes);
  [[nodiscard]] std::uint64_t size() const;
  /// Flushes the file to the disk and renames it.
  void finish(const Poll& poll);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// A nameless file beside a target, removed with this object however the process ends. A short content stays in memory.
class ScratchFile {
 public:
  /// `path` is the target, named in messages. Up to `memory` bytes are held in memory.
  ScratchFile(const std::string& path, std::size_t memory);
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  /// Throws RunError, for instance for a full disk.
  void append(std::string_view bytes);
  /// Reads the bytes from `offset` on, which must have been appended.
  void read(std::uint64_t offset, void* bytes, std::size_t size) const;
  [[nodiscard]] std::uint64_t size() const { return written_ + kept_.size(); }
  /// Frees disk and memory.
  void clear();

 private:
  std::string path_;
  std::size_t memory_;
  int descriptor_ = -1;
  std::uint64_t written_ = 0;  ///< bytes in the file; the others are in memory
  std::string kept_;
};

}  // namespace footfall::detail
