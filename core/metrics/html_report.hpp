// One HTML file that tells how a result was made and what it holds, to send to somebody.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/environment/environment.hpp"
#include "core/metrics/run_statistics.hpp"
#include "core/pipeline/pipeline.hpp"
#include "core/pipeline/runner.hpp"

namespace footfall {

struct ReportPicture {
  std::string caption;
  std::string png;  ///< the bytes of a PNG file
};

/// HTML5 that is also well-formed XML: environment, agent and pipeline, time of each step with bars, counts, layers and
/// connected parts with their areas, the cells and threads of parallel blocks where there were any, and the pictures.
/// Everything is inside: no file, font or script from elsewhere, and no script at all. Light or dark, as the reader's
/// system is. Names of files and pipelines are text, whatever they hold. Nothing but the input decides the bytes.
std::string formatHtmlReport(const Environment& environment, const Pipeline& pipeline, const RunResult& result,
                             const ProgramTimes& times, std::span<const ReportPicture> pictures = {});

/// Text for HTML: &, <, > and quotes are written out, control characters left out, bytes that are no UTF-8 replaced.
std::string escapeHtml(std::string_view text);

}  // namespace footfall
