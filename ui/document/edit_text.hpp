// The texts of edits in the undo history: "Change maximum slope 45° → 50°".
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "ui/document/document.hpp"

namespace footfall::ui {

/// A step's label, e.g. "Vertical clearance".
QString labelOf(const PipelineStep& step);
/// A parameter's value in the shown unit, with a degree sign but without other units: "45°", "2", "yes".
QString valueText(const ParameterDescriptor& parameter, double value, const LevelUnits& units);
/// Describes the first value that differs between filters of both states; empty when none does.
QString valueEditText(const DocumentState& before, const DocumentState& after, const LevelUnits& units);
/// The label of a single filter, or the number of filters: "Slope", "3 filters".
QString stepsText(const std::vector<PipelineStep>& steps);

}  // namespace footfall::ui
