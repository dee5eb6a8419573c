// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environment/part_names.hpp"

#include <cstddef>

namespace footfall::detail {
namespace {

unsigned byteAt(std::string_view text, std::size_t i) { return static_cast<unsigned char>(text[i]); }

/// The length of the UTF-8 character at `i`, or 0 where there is none (overlong forms, surrogates and what lies beyond
/// Unicode included).
std::size_t characterLength(std::string_view text, std::size_t i) {
  const unsigned first = byteAt(text, i);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xC2 && first < 0xE0 ? 2 : first >= 0xE0 && first < 0xF0 ? 3 : 4;
  if (first < 0xC2 || first > 0xF4 || i + length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((byteAt(text, i + k) & 0xC0U) != 0x80U) return 0;
  const unsigned second = byteAt(text, i + 1);
  if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second >= 0xA0)) return 0;
  if ((first == 0xF0 && second < 0x90) || (first == 0xF4 && second >= 0x90)) return 0;
  return length;
}

bool isUtf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = characterLength(text, i);
    if (length == 0) return false;
    i += length;
  }
  return true;
}

}  // namespace

std::string cleanName(std::string_view name) {
  const bool asItIs = isUtf8(name);
  std::string clean;
  clean.reserve(name.size());
  for (std::size_t i = 0; i < name.size(); ++i) {
    const unsigned c = byteAt(name, i);
    if (c < 0x20 || c == 0x7F) {
      clean += ' ';
    } else if (c < 0x80 || asItIs) {
      clean += name[i];
    } else {
      clean += static_cast<char>(0xC0U | (c >> 6U));
      clean += static_cast<char>(0x80U | (c & 0x3FU));
    }
  }
  return clean;
}

Text partLabel(const EnvironmentPart& part) {
  if (part.mesh.empty() && part.material.empty()) return FOOTFALL_TEXT("(unnamed)");
  if (part.material.empty()) return part.mesh;
  return part.mesh.empty() ? part.material : part.mesh + '/' + part.material;
}

std::vector<std::uint64_t> countPartTriangles(const Environment& environment) {
  std::vector<std::uint64_t> counts(environment.parts.size(), 0);
  for (const std::uint32_t part : environment.partOf) ++counts[part];
  return counts;
}

std::uint32_t PartList::numberOf(std::string_view mesh, std::string_view material) {
  std::pair<std::string, std::string> given(mesh, material);
  if (const auto known = given_.find(given); known != given_.end()) return known->second;
  // Different bytes can be one name after cleaning.
  const auto [entry, isNew] =
      clean_.try_emplace({cleanName(mesh), cleanName(material)}, static_cast<std::uint32_t>(parts_.size()));
  if (isNew) parts_.push_back({entry->first.first, entry->first.second});
  given_.emplace(std::move(given), entry->second);
  return entry->second;
}

void dropUnnamedPart(Environment& environment) {
  if (environment.parts.size() > 1) return;
  if (environment.parts.size() == 1 && environment.parts[0] != EnvironmentPart{}) return;
  environment.parts.clear();
  environment.partOf.clear();
}

}  // namespace footfall::detail
