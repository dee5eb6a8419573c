// What a packed environment says of itself apart from its geometry, as bytes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/io/packed/packed_format.hpp"
#include "footfall/environment.hpp"

namespace footfall::detail {

/// The parts, roles, storeys, notes, what import left out, the frame and the name of the file. Of lists that count
/// vertices or triangles, nothing.
std::string encodeDescription(const Environment& environment);

/// The other way round; `source` is left empty, and Environment::origin is the name of the file that was packed. Throws
/// std::runtime_error for bytes that are none. `version`: PackedHeader::version.
Environment decodeDescription(std::string_view bytes, std::uint32_t version = kPackedVersion);

}  // namespace footfall::detail
