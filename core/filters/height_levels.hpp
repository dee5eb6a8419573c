// Heights above floors that filters compare with, as levels of the kernel.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/exact/plan_kernel.hpp"
#include "footfall/text.hpp"

namespace footfall::detail {

/// The kernel, or one with the same mesh that has one more level.
std::shared_ptr<const PlanKernel> kernelWithHeight(const std::shared_ptr<const PlanKernel>& kernel, double height);

/// A height above the whole extent in z lets no obstacle escape, and neither does any other: the smallest power of two
/// above it stands for all of them, and does not stretch the grid on which doubles can decide.
double sufficientHeight(const SourceMesh& mesh, double height);

/// Refuses heights that are tiny beside the coordinates: they make every number as wide as what lies between the two.
/// On slanted floors there is no height that makes no difference; but one below the coordinates' common step, and
/// beyond the digits that decisions are quick with, is a slip of the hand or a wrong scale. Throws InputError
/// `tooSmall` with the height, the largest coordinate and the least height that may be given.
void checkHeight(const SourceMesh& mesh, double height, Pattern tooSmall);

}  // namespace footfall::detail
