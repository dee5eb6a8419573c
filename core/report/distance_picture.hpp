// The heat map of distances as a drawing with a legend, for `footfall compare --picture`.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "core/compare/distance_bands.hpp"
#include "core/report/plan_sheet.hpp"

namespace footfall::detail {

/// The plan of the first mesh, coloured by the distance to the second, on A4. Larger distances lie over smaller ones,
/// so that no floor hides them. `names` are those of the files. `bands` is not empty.
Sheet drawDistances(const DistanceBands& bands, const std::array<std::string, 2>& names);

/// The bytes of a picture by the ending of `path`: .svg or .pdf, with the names of `files` without their folders.
/// Throws InputError for another ending.
std::string formatDistancePicture(const std::string& path, const DistanceBands& bands,
                                  const std::array<std::string, 2>& files);
/// Throws InputError unless `path` ends in .svg or .pdf.
void checkPictureName(const std::string& path);

}  // namespace footfall::detail
