// Finds files that are installed beside the programs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace footfall::ui {

/// The folder with the sample environments, NAME/NAME.obj and NAME/NAME.pipeline each: ../share/footfall/samples
/// relative to the running program, else (in a build tree) the source tree's. Empty where neither exists.
QString samplesFolder();

/// The samples of a program in the folder `programFolder`.
QString samplesFolder(const QString& programFolder);

}  // namespace footfall::ui
