// Edits of several rows of the filter list at once, each one entry of the undo history.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "ui/document/document.hpp"

namespace footfall::ui {

/// Ids of FilterEntry; those that are not in the list are left out.
using FilterIds = std::vector<int>;

void removeFilters(Document& document, const FilterIds& ids);
/// Copies stand together behind the last one that is copied. Returns their ids.
FilterIds duplicateFilters(Document& document, const FilterIds& ids);
/// `index` counts in the list as it is. Returns the new ids.
FilterIds insertFilters(Document& document, std::size_t index, const std::vector<PipelineStep>& steps,
                        const QString& text);
/// Moves filters by one row, all together; changes nothing when the first or last of them is at that end of the list.
void moveFilters(Document& document, const FilterIds& ids, int direction);
/// Moves filters together into the gap before the row `gap` of the list as it is.
void moveFiltersTo(Document& document, const FilterIds& ids, std::size_t gap);
void switchFilters(Document& document, const FilterIds& ids, bool on);
/// Switches off everything behind, but the Collapse that a block which is open there needs.
void runOnlyUpTo(Document& document, int id);
/// Leaves on what is given, and what blocks around it need.
void switchOthersOff(Document& document, const FilterIds& ids);
void switchAllOn(Document& document);
/// Filters as lines of a pipeline file.
std::string filtersAsText(const Document& document, const FilterIds& ids);

}  // namespace footfall::ui
