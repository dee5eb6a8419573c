// Edits of several rows of the filter list at once, each one entry of the undo history.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "ui/document/document.hpp"

namespace footfall::ui {

/// Ids of FilterEntry; ids that are not in the list are ignored.
using FilterIds = std::vector<int>;

void removeFilters(Document& document, const FilterIds& ids);
/// Inserts copies together behind the last copied filter. Returns their ids.
FilterIds duplicateFilters(Document& document, const FilterIds& ids);
/// `index` counts in the present list. Returns the new ids.
FilterIds insertFilters(Document& document, std::size_t index, const std::vector<PipelineStep>& steps,
                        const QString& text);
/// Moves filters by one row, all together. Changes nothing when one of them is at that end of the list.
void moveFilters(Document& document, const FilterIds& ids, int direction);
/// Moves filters together into the gap before the row `gap` of the present list.
void moveFiltersTo(Document& document, const FilterIds& ids, std::size_t gap);
void switchFilters(Document& document, const FilterIds& ids, bool on);
/// Switches off all later filters, except the Collapse of a block that is open there.
void runOnlyUpTo(Document& document, int id);
/// Switches off all filters except the given ones and those that the blocks around them need.
void switchOthersOff(Document& document, const FilterIds& ids);
void switchAllOn(Document& document);
/// The filters as lines of a pipeline file.
std::string filtersAsText(const Document& document, const FilterIds& ids);

}  // namespace footfall::ui
