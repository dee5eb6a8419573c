// The result of a run as it is without the filters that keep off borders.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "ui/run/finished_runs.hpp"

namespace footfall::ui {

/// The largest distance that an enabled RadiusFilter keeps off borders; 0 without one.
double radiusOf(const Pipeline& pipeline);

/// Returns whether there is an enabled RadiusFilter.
bool hasRadius(const Pipeline& pipeline);

/// The mesh of `run` without its enabled RadiusFilters. It is computed where there is one, which takes as long as a run
/// that uses `cache` (may be null). Throws Cancelled.
std::shared_ptr<const NavigationMesh> meshWithoutRadius(const FinishedRun& run, ResultCache* cache,
                                                        RunContext& context);

}  // namespace footfall::ui
