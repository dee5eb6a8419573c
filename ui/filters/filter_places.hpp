// Where filters can be added to a list.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstddef>

#include "ui/document/document.hpp"
#include "ui/filters/filter_edits.hpp"

namespace footfall::ui {

/// Why a new `filter` at the place `index` of the list would keep it from running; empty where it would not. A filter
/// without seeds is not refused: seeds come after it.
QString whyNotAt(const Pipeline& pipeline, std::size_t index, const FilterDescriptor& filter, double metresPerUnit);

/// Adds a new filter, one edit. A strategy comes with a Collapse behind the local filters that follow it. Returns the
/// id of the filter alone.
FilterIds addFilterAt(Document& document, std::size_t index, const FilterDescriptor& filter, double metresPerUnit,
                      const QString& text);

/// Switches on the last Vertical clearance filter before a row, or adds one before it, one edit.
void provideClearance(Document& document, int id, double metresPerUnit);
/// Whether a Vertical clearance filter stands before the row, switched off.
bool hasClearanceOff(const Document& document, int id);

}  // namespace footfall::ui
