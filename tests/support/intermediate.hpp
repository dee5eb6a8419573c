// The environment between two filters as bytes, in three formats. Two are those of the thesis (4.2.1, 4.2.2): rounded
// numbers as text, and as they lie in memory. The third, provenance, is ours: it is exact as the expression trees of
// 4.2.3 are, which have no use here because no coordinate is an expression.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/assembly/walkable_state.hpp"
#include "core/base/byte_stream.hpp"
#include "footfall/geometry.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// A state after its coordinates are rounded.
struct RoundedState {
  TriangleSoup triangles;     ///< triangles of the walkable mesh
  std::uint64_t inexact = 0;  ///< vertices that lost something by rounding
};

/// `state` has a mesh. Throws Cancelled.
RoundedState roundState(const WalkableState& state, RunContext& context);

/// OBJ: "v" with 17 digits a coordinate, "f".
std::string writeAscii(const TriangleSoup& soup);
/// Reads what writeAscii() writes. Throws BadBytes, also for a coordinate that is not finite.
TriangleSoup readAscii(std::string_view text);

/// Eight bytes a coordinate, four a number of a vertex, behind a head with a version; lowest byte first.
std::string writeBinary(const TriangleSoup& soup);
/// Throws BadBytes, as readAscii().
TriangleSoup readBinary(std::string_view bytes);

/// Provenance only: which lines of which triangles cut which floor. No coordinate is computed. `state` is directly
/// behind a clearance filter: throws std::logic_error where something was taken away or simplified since.
std::string writeExact(const WalkableState& state);
/// The state again, in which all filters find what they would have found in the one that was written. `source`: any
/// state over the same source triangles, such as the first one. Throws BadBytes: other triangles, another version,
/// damaged, out of range. Cancelled.
std::shared_ptr<const WalkableState> readExact(std::string_view bytes, const WalkableState& source,
                                               RunContext& context);

}  // namespace footfall::detail
