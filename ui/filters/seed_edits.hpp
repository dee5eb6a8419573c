// Edits of the seeds of a ReachableFilter, each one entry of the undo history.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstddef>
#include <vector>

#include "ui/document/document.hpp"

namespace footfall::ui {

/// Places are along the file's axes, in its units. Edits of a missing filter or seed have no effect.

/// The seeds of a filter by its id.
std::vector<Vec3> seedsOf(const Document& document, int id);
/// The last ReachableFilter, preferably an enabled one; -1: there is none.
int filterOfSeeds(const Document& document);
void addSeed(Document& document, int id, const Vec3& place);
/// Moves with the same merge key become one edit.
void moveSeed(Document& document, int id, std::size_t seed, const Vec3& place, const QString& mergeKey);
void removeSeed(Document& document, int id, std::size_t seed);
/// Adds a filter with one seed behind the last enabled StepFilter or clearance outside of blocks, else at the end.
/// Returns its id.
int addFilterWithSeed(Document& document, const Vec3& place);

}  // namespace footfall::ui
