// The stream from footfall-import to its parent process: an environment in the file's own frame, or an error. Numbers
// are in the machine's format; both ends are from one build.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/io/file_frame.hpp"
#include "footfall/environment.hpp"
#include "footfall/text.hpp"

namespace footfall::detail {

/// Encodes the members of an environment that a reader fills.
std::string encodeEnvironment(const Environment& environment, const FileFrame& frame);
std::string encodeError(const Text& message);

/// Thrown for a stream that is cut off, or that no reader can have written.
struct BadStream {};

/// Fills what the reader has filled, or returns its error. The stream is not trusted: counts must fit its length,
/// indices must be in range, coordinates finite and names clean. Throws BadStream; the content of `environment` is
/// undefined then.
std::optional<Text> decodeStream(std::string_view bytes, Environment& environment, FileFrame& frame);

}  // namespace footfall::detail
