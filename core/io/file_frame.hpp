// The frame of an environment: what its file says, what the user says, and what is guessed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "footfall/environment.hpp"

namespace footfall::detail {

/// What a file says about its own frame; empty where it says nothing.
struct FileFrame {
  std::optional<UpAxis> up;
  std::optional<double> metresPerUnit;
  /// Coordinates are floats of the file, or products of its transforms: their last bits have no meaning.
  bool areFloats = false;
  double gridStep = 0;  ///< a power of two of which all coordinates are multiples, where a converter rounded them
};

/// glTF 2.0, section 3.4: metres, Y up.
inline FileFrame gltfFrame() { return {UpAxis::Y, 1.0, true}; }

/// The extension of a file, in lower case and without its dot.
std::string lowerExtension(const std::string& path);

/// What is guessed where neither the file nor the user says anything.
struct UsualFrame {
  UpAxis up = UpAxis::Y;
  double metresPerUnit = 1;
};
UsualFrame usualFrame(const std::string& extension);

/// Sets up axis, scale, sides and what is a guess, and turns all places of `environment`, which are in the file's own
/// frame, to Z up.
void setFrame(Environment& environment, const FileFrame& frame, const ImportOptions& options, const UsualFrame& usual);

/// Throws InputError which says that there is no triangle in the file, and what was left out.
[[noreturn]] void failWithoutTriangles(const std::string& path, const SkippedElements& skipped);

/// Throws InputError for a scale that is none.
void checkScale(const ImportOptions& options);
/// Throws InputError for a step of the grid that is none.
void checkGrid(const ImportOptions& options);

}  // namespace footfall::detail
