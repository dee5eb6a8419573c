// The frame of an environment, from its file, the user's options and guesses.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "footfall/environment.hpp"

namespace footfall::detail {

/// The frame that a file declares; empty members are not declared.
struct FileFrame {
  std::optional<UpAxis> up;
  std::optional<double> metresPerUnit;
  /// Coordinates are floats, or products of floats and transforms: their last bits have no meaning.
  bool areFloats = false;
  double gridStep = 0;  ///< a power of two that all coordinates are multiples of, where a converter rounded them
};

/// glTF 2.0, section 3.4: metres, Y up.
inline FileFrame gltfFrame() { return {UpAxis::Y, 1.0, true}; }

/// The extension of a file, in lower case and without its dot.
std::string lowerExtension(const std::string& path);

/// Guesses that apply where neither the file nor the user declares a value.
struct UsualFrame {
  UpAxis up = UpAxis::Y;
  double metresPerUnit = 1;
};
UsualFrame usualFrame(const std::string& extension);

/// Sets up axis, scale, sides and which of them are guesses, and turns all coordinates of `environment` from the file's
/// own frame to Z up.
void setFrame(Environment& environment, const FileFrame& frame, const ImportOptions& options, const UsualFrame& usual);

/// Throws an InputError for a file without triangles, with the elements that were left out.
[[noreturn]] void failWithoutTriangles(const std::string& path, const SkippedElements& skipped);

/// Throws InputError for an invalid scale.
void checkScale(const ImportOptions& options);
/// Throws InputError for an invalid grid step.
void checkGrid(const ImportOptions& options);

}  // namespace footfall::detail
