// Filters that test one triangle at a time and need no environment around it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/assembly/walkable_state.hpp"
#include "core/filters/apply_filter.hpp"
#include "footfall/statistics.hpp"

namespace footfall {
struct FilterDescriptor;
}

namespace footfall::detail {

/// Returns true when a triangle that is a floor stays one; counts the cases that doubles cannot decide.
using FaceTest = std::function<bool(Index face, ExactFallbacks& count)>;

/// The test of a filter that looks at one triangle at a time, on the triangles of a kernel's mesh, which it keeps;
/// empty for all other filters. Thread-safe.
FaceTest makeFaceTest(const FilterDescriptor& filter, const std::vector<double>& values,
                      const std::shared_ptr<const PlanKernel>& kernel);

/// The state without the floors that fail the test, which stay obstacles. A triangle of the state's mesh has the result
/// of the face that it was cut from; a triangle that SimplificationFilter made of several coplanar faces, that of one
/// of them. Steps stay where both their borders do. On all threads.
FilterOutcome keepFaces(const StatePtr& state, const FaceTest& test, RunContext& context);

/// The floors, while the filters before the clearance go from cell to cell. One for each thread: a triangle needed
/// before its cell's turn is tested on demand, with the same result.
class FloorFlags {
 public:
  FloorFlags(const std::vector<char>& walkable, const std::vector<FaceTest>& tests);

  [[nodiscard]] bool isFloor(Index face) {
    if (flags_[face] == kUnknown) flags_[face] = static_cast<char>(passesAll(face));
    return flags_[face] != 0;
  }
  /// Sets the answer for a face whose tests were made elsewhere.
  void set(Index face, bool isFloor) { flags_[face] = static_cast<char>(isFloor); }

  ExactFallbacks fallbacks;

 private:
  static constexpr char kUnknown = 2;
  [[nodiscard]] bool passesAll(Index face);

  const std::vector<FaceTest>& tests_;
  std::vector<char> flags_;
};

}  // namespace footfall::detail
