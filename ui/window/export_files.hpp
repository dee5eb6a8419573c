// The files of an export, made from a finished run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "core/base/poll.hpp"
#include "core/io/formats/save.hpp"
#include "ui/document/export_settings.hpp"
#include "ui/run/run_controller.hpp"

namespace footfall::ui {

/// Makes the files of every kind except pictures and reports; `target` is the first of them, or others lie beside it.
/// Any thread may call it. Throws what formatExport() and makePlanFiles() throw.
ExportFiles makeExport(const ExportSettings& settings, const std::string& target, const FinishedRun& run,
                       std::span<const ExportExtra> extras, Poll poll);

}  // namespace footfall::ui
