// A share with what it is a share of, sealed: the same bytes as a message and as a file of a work folder.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/byte_stream.hpp"
#include "core/base/digest.hpp"

namespace footfall::detail {

/// Raise this with each change of the meaning of shares, of their bytes, or of the results of a clearance filter.
constexpr std::uint64_t kShareVersion = 2;

/// The name of a share.
struct ShareName {
  Digest::Value key{};      ///< CellPhase::key of the pass
  std::uint64_t phase = 0;  ///< CellPhase::number
  std::uint64_t cell = 0;
  bool operator==(const ShareName&) const = default;
};

/// Bytes of the head.
constexpr std::size_t kShareHead = 72;

/// `bytes` with a head and a check sum in front.
std::string sealShare(const ShareName& name, std::string_view bytes);

/// The name in the head of a sealed share, and the bytes in it, which point into `sealed`.
struct OpenedShare {
  ShareName name;
  std::string_view bytes;
};
/// Throws BadBytes: no share, of another version, cut off or damaged. The message is the end of a sentence that begins
/// with the file's name.
OpenedShare openShare(std::string_view sealed);

/// The whole content of a file, or none where there is none. Throws BadBytes, likewise, when it cannot be read.
std::optional<std::string> contentOf(const std::string& path);

}  // namespace footfall::detail
