// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/partitioning/cut_export.hpp"

#include "core/io/obj_text.hpp"

namespace footfall::detail {

std::string formatCutObj(const CutEnvironment& cut, std::size_t cellCount, const Environment& environment,
                         const ExportHeader& header) {
  // vertices that no triangle uses are not written
  constexpr auto kUnused = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> numbers(cut.places.size(), kUnused);
  std::vector<std::vector<std::size_t>> members(cellCount);
  for (std::size_t i = 0; i < cut.triangles.size(); ++i) {
    members.at(static_cast<std::size_t>(cut.triangles[i].cell)).push_back(i);
    for (const Index v : cut.triangles[i].corners) numbers[static_cast<std::size_t>(v)] = 0;
  }
  std::uint32_t count = 0;
  for (std::uint32_t& number : numbers)
    if (number != kUnused) number = count++;

  std::string content;
  appendNumber(content, count);
  content += " vertices, ";
  appendNumber(content, cut.triangles.size());
  content += " triangles, ";
  appendNumber(content, cellCount);
  std::string text;
  text.reserve(1024 + 64 * std::size_t{count} + 28 * cut.triangles.size());
  appendHeader(text, "Cells", environment.frame(), header, content + " cells");
  for (std::size_t v = 0; v < numbers.size(); ++v)
    if (numbers[v] != kUnused) appendVertex(text, cut.places[v], environment.up);
  for (std::size_t cell = 0; cell < cellCount; ++cell) {
    text += "g cell_";
    appendNumber(text, cell + 1);
    text += '\n';
    for (const std::size_t i : members[cell]) {
      const auto& c = cut.triangles[i].corners;
      appendElement(text, 'f', std::array{numbers[c[0]], numbers[c[1]], numbers[c[2]]});
    }
  }
  return text;
}

void writeCutObj(const std::string& path, const CutEnvironment& cut, std::size_t cellCount,
                 const Environment& environment, const ExportHeader& header) {
  writeFileSafely(path, formatCutObj(cut, cellCount, environment, header));
}

}  // namespace footfall::detail
