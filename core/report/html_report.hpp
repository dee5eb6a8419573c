// A report of a run as one HTML file: how the result was made and what it holds.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/pipeline/runner.hpp"
#include "footfall/corridor_map.hpp"
#include "footfall/environment.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/report.hpp"

namespace footfall::detail {

struct ReportPicture {
  std::string caption;
  std::string png;  ///< the bytes of a PNG file
};

/// Details that the result of a run lacks.
struct ReportDetails {
  std::string date;  ///< date of the report, for people; empty: none
  std::span<const ReportPicture> pictures;
  std::span<const ReportPicture> legend;   ///< a small picture of each colour, and as its caption what it means
  const CorridorMap* corridors = nullptr;  ///< of the result; null: the report has no bottlenecks
};

/// The present time in UTC, "2026-11-22 10:15 UTC", or the one that SOURCE_DATE_EPOCH states
/// (reproducible-builds.org), for reports whose bytes must not change.
std::string reportDate();

/// HTML5 that is also well-formed XML: date, environment with what import left out, agent and pipeline, time of each
/// step with bars, counts, layers and connected parts with their areas, the narrowest bottlenecks of a corridor map,
/// the cells and threads of parallel blocks where there were any, and the pictures with their legend. Everything is
/// inside: no file, font or script from elsewhere, and no script at all. Light or dark, as the reader's system is.
/// Names of files and pipelines are text, whatever they hold. Nothing but the input decides the bytes.
std::string formatHtmlReport(const Environment& environment, const Pipeline& pipeline, const RunResult& result,
                             const ProgramTimes& times, const ReportDetails& details = {});

/// Text for HTML: &, <, > and quotes are written out, control characters left out, bytes that are no UTF-8 replaced.
std::string escapeHtml(std::string_view text);

}  // namespace footfall::detail
