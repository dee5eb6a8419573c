// What footfall-import writes to its standard output and who started it reads: an environment in the file's own frame,
// or an error. Numbers are as the machine has them; both ends are one build.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/io/file_frame.hpp"
#include "footfall/environment.hpp"
#include "footfall/text.hpp"

namespace footfall::detail {

/// What of an environment a reader fills.
std::string encodeEnvironment(const Environment& environment, const FileFrame& frame);
std::string encodeError(const Text& message);

/// A stream that is cut off, or that no reader can have written.
struct BadStream {};

/// Fills what the reader has filled, or returns its error. Nothing in the stream is believed: counts fit its length,
/// indices are in range, coordinates finite and names clean. Throws BadStream, and what `environment` holds then means
/// nothing.
std::optional<Text> decodeStream(std::string_view bytes, Environment& environment, FileFrame& frame);

}  // namespace footfall::detail
