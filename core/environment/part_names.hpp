// Names of meshes and materials, and the list of parts that they make.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "footfall/environment.hpp"
#include "footfall/text.hpp"

namespace footfall::detail {

/// A name from a file as valid UTF-8 without control characters: what is no UTF-8 is taken as Latin-1, so that a name
/// survives sessions and command lines, whatever wrote the file.
std::string cleanName(std::string_view name);

/// The name of a part in lists and on the command line: MESH/MATERIAL, or the one that it has, or "(unnamed)".
Text partLabel(const EnvironmentPart& part);

/// The number of triangles of each of Environment::parts.
std::vector<std::uint64_t> countPartTriangles(const Environment& environment);

/// Numbers parts in the order in which they come.
class PartList {
 public:
  /// `parts` must live as long; it grows.
  explicit PartList(std::vector<EnvironmentPart>& parts) : parts_(parts) {}
  /// Names as the file has them.
  std::uint32_t numberOf(std::string_view mesh, std::string_view material);

 private:
  std::vector<EnvironmentPart>& parts_;
  std::map<std::pair<std::string, std::string>, std::uint32_t> clean_;
  std::map<std::pair<std::string, std::string>, std::uint32_t, std::less<>> given_;
};

/// Empties both lists when there is only one part, without names.
void dropUnnamedPart(Environment& environment);

}  // namespace footfall::detail
