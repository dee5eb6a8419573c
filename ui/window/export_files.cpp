// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/export_files.hpp"

#include "footfall/report.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

ExportFiles makeExport(const ExportSettings& settings, const std::string& target, const FinishedRun& run,
                       std::span<const ExportExtra> extras, Poll poll) {
  const NavigationMesh& mesh = *run.result.mesh;
  if (const FormatDescriptor* format = meshFormat(settings.kind()))
    return formatExport(format->format, target, mesh, makeExportHeader(run.pipeline), settings.options, extras, poll);
  return {makePlanFiles(*run.environment, run.pipeline, mesh, target, settings.plan, poll), 0};
}

}  // namespace footfall::ui
