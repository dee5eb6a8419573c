// Checks where filters can be added to a list.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstddef>

#include "ui/document/document.hpp"
#include "ui/filters/filter_edits.hpp"

namespace footfall::ui {

/// The reason why a new `filter` at the place `index` would prevent the list from running; empty where it would not. A
/// filter without seeds is accepted, because seeds are added later.
QString whyNotAt(const Pipeline& pipeline, std::size_t index, const FilterDescriptor& filter, double metresPerUnit);

/// Adds a new filter as one edit. A strategy is added with a Collapse behind the local filters that follow it. Returns
/// the id of the filter alone.
FilterIds addFilterAt(Document& document, std::size_t index, const FilterDescriptor& filter, double metresPerUnit,
                      const QString& text);

/// Enables the last Vertical clearance filter before a row, or adds one before it, as one edit.
void provideClearance(Document& document, int id, double metresPerUnit);
/// Returns whether a disabled Vertical clearance filter stands before the row.
bool hasClearanceOff(const Document& document, int id);

}  // namespace footfall::ui
