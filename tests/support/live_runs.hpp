// Runs with the results of earlier ones at hand, held against runs from nothing.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "core/pipeline/runner.hpp"
#include "footfall/edit.hpp"
#include "tests/support/soup.hpp"

namespace footfall::test {
using namespace detail;

TriangleSoup soupFor(const Soup& soup);

RunResult run(const std::shared_ptr<const Environment>& environment, const std::string& pipeline, ResultCache* cache,
              int threads = 2);

/// The bytes of an export.
std::string exported(const RunResult& result);

/// Runs with the results of earlier runs at hand, and from nothing: the same bytes and figures?
bool agrees(const std::shared_ptr<const Environment>& environment, const std::string& pipeline, ResultCache& cache);

/// The default pipeline.
std::string defaultFilters(double slope, double clearance);

}  // namespace footfall::test
