// Files that belong together and are written together, and files that are too large to be made in memory.
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

/// What the file of links is called beside those of layers.
inline constexpr std::string_view kLinksSuffix = "links";

/// "plan-0.svg" for "plan.svg" and "0".
std::string besideName(const std::string& path, const std::string& suffix);

/// The files that are there already and may be replaced by an export of that name which has a file for each page or
/// layer: the name itself, then with numbers and "links" beside it, "plan-2.svg" before "plan-10.svg".
std::vector<std::string> existingOutputs(const std::string& path);

/// Writes all of them beside their targets, and renames them when the last one is whole: where one cannot be written,
/// or `poll` throws, all targets stay as they were. (Between two renames only a kill or a broken disk can part them.)
/// Pipes and devices are written to in their place. Throws RunError as writeFileSafely() does, and what `poll` throws.
void writeFilesSafely(std::span<const OutputFile> files, Poll poll = {});

/// A file that grows piece by piece beside its target and replaces it at the end, for what no memory holds.
class GrowingFile {
 public:
  /// Throws RunError as writeFileSafely() does, and for a target that is no ordinary file.
  explicit GrowingFile(const std::string& path);
  /// Without finish() nothing is left, and the target is as it was.
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  void append(std::string_view bytes, const Poll& poll);
  /// Writes over bytes that are there.
  void writeAt(std::uint64_t offset, std::string_view bytes);
  [[nodiscard]] std::uint64_t size() const;
  /// Down to the disk, and renamed.
  void finish(const Poll& poll);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Bytes beside a target that nobody else sees and that are gone with this object, however the process ends; in memory
/// as long as there are few.
class ScratchFile {
 public:
  /// `path`: the target, named in messages. Up to `memory` bytes are held in memory.
  ScratchFile(const std::string& path, std::size_t memory);
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  /// Throws RunError, as for a full disk.
  void append(std::string_view bytes);
  /// The bytes from `offset` on, which must be there.
  void read(std::uint64_t offset, void* bytes, std::size_t size) const;
  [[nodiscard]] std::uint64_t size() const { return written_ + kept_.size(); }
  /// Gives disk and memory back.
  void clear();

 private:
  std::string path_;
  std::size_t memory_;
  int descriptor_ = -1;
  std::uint64_t written_ = 0;  ///< bytes in the file; the others are kept
  std::string kept_;
};

}  // namespace footfall::detail
