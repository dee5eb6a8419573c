// The description of a packed environment, apart from its geometry, as bytes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/io/packed/packed_format.hpp"
#include "footfall/environment.hpp"

namespace footfall::detail {

/// Encodes the parts, roles, storeys, notes, elements that import left out, the frame and the name of the file. Lists
/// with an entry for each vertex or triangle are left out.
std::string encodeDescription(const Environment& environment);

/// Decodes a description. `source` is left empty, and Environment::origin is the name of the file that was packed.
/// Throws std::runtime_error for invalid bytes. `version` is PackedHeader::version.
Environment decodeDescription(std::string_view bytes, std::uint32_t version = kPackedVersion);

}  // namespace footfall::detail
