// What edits are called in the undo history: "Change maximum slope 45° → 50°".
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "ui/document/document.hpp"

namespace footfall::ui {

/// A step's name for people, e.g. "Vertical clearance".
QString labelOf(const PipelineStep& step);
/// A parameter's value for people, in the shown unit, with degrees but without other names of units: "45°", "2", "yes".
QString valueText(const ParameterDescriptor& parameter, double value, const LevelUnits& units);
/// Names the first value that differs between filters that are in both states; empty when none does.
QString valueEditText(const DocumentState& before, const DocumentState& after, const LevelUnits& units);
/// The filter's label where it is one, else how many there are: "Slope", "3 filters".
QString stepsText(const std::vector<PipelineStep>& steps);

}  // namespace footfall::ui
