// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environment/truncation_check.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <vector>

#include "core/environment/input_file.hpp"

namespace footfall {
namespace {

constexpr const char* kTruncated = "it is truncated: copy or export it again";

std::string_view takeLine(std::string_view& text) {
  const std::size_t stop = text.find('\n');
  std::string_view line = text.substr(0, stop);
  text.remove_prefix(stop == std::string_view::npos ? text.size() : stop + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> result;
  for (std::size_t start = 0; (start = line.find_first_not_of(" \t\r", start)) != std::string_view::npos;) {
    const std::size_t stop = std::min(line.find_first_of(" \t\r", start), line.size());
    result.push_back(line.substr(start, stop - start));
    start = stop;
  }
  return result;
}

std::uint64_t toCount(std::string_view word) {
  std::uint64_t count = 0;
  std::from_chars(word.data(), word.data() + word.size(), count);
  return count;
}

std::uint64_t plyTypeSize(std::string_view type) {
  if (type == "char" || type == "uchar" || type == "int8" || type == "uint8") return 1;
  if (type == "short" || type == "ushort" || type == "int16" || type == "uint16") return 2;
  return type == "double" || type == "float64" ? 8 : 4;
}

struct PlyElement {
  std::uint64_t count = 0;
  std::uint64_t leastBytes = 0;  ///< of one element in a binary file
  std::size_t leastWords = 0;    ///< of one element in an ASCII file
  bool firstIsList = false;
};

struct PlyHeader {
  bool ascii = true;
  bool complete = false;
  std::vector<PlyElement> elements;
};

/// Leaves `text` behind the header.
PlyHeader takePlyHeader(std::string_view& text) {
  PlyHeader header;
  while (!text.empty() && !header.complete) {
    const std::vector<std::string_view> line = words(takeLine(text));
    if (line.empty()) continue;
    if (line[0] == "end_header") header.complete = true;
    if (line[0] == "format" && line.size() > 1) header.ascii = line[1] == "ascii";
    if (line[0] == "element" && line.size() > 2) header.elements.push_back({toCount(line[2]), 0, 0, false});
    if (line[0] == "property" && line.size() > 2 && !header.elements.empty()) {
      PlyElement& element = header.elements.back();
      const bool list = line[1] == "list";
      if (element.leastWords == 0) element.firstIsList = list;
      element.leastBytes += plyTypeSize(list ? line[2] : line[1]);
      ++element.leastWords;
    }
  }
  return header;
}

[[noreturn]] void failShortPly(const std::string& path) {
  failInput(path, 0, "the file ends before the elements that its header announces", kTruncated);
}

/// Each element has a line of its own; the last line may itself be cut.
void checkAsciiPly(const std::string& path, const PlyHeader& header, std::string_view text) {
  for (const PlyElement& element : header.elements) {
    for (std::uint64_t i = 0; i < element.count; ++i) {
      std::string_view line;
      while (line.empty() && !text.empty()) line = takeLine(text);
      if (line.empty()) failShortPly(path);
      if (!text.empty()) continue;
      const std::vector<std::string_view> last = words(line);
      const std::uint64_t listed = element.firstIsList && !last.empty() ? toCount(last[0]) : 0;
      if (last.size() < element.leastWords + listed) failShortPly(path);
    }
  }
}

void checkBinaryPly(const std::string& path, const PlyHeader& header, std::string_view text) {
  std::uint64_t left = text.size();
  for (const PlyElement& element : header.elements) {
    if (element.leastBytes == 0) continue;
    if (element.count > left / element.leastBytes) failShortPly(path);
    left -= element.count * element.leastBytes;
  }
}

}  // namespace

void rejectTruncatedPly(const std::string& path, std::string_view text) {
  if (text.substr(0, 3) != "ply" && text.substr(0, 3) != "PLY") return;  // Assimp says that it is no PLY
  const PlyHeader header = takePlyHeader(text);
  if (!header.complete) failInput(path, 0, "the PLY header has no end_header", kTruncated);
  header.ascii ? checkAsciiPly(path, header, text) : checkBinaryPly(path, header, text);
}

void rejectTruncatedStl(const std::string& path, std::string_view text) {
  constexpr std::size_t kBinaryHeader = 84, kBinaryFacet = 50;
  if (text.substr(0, 5) != "solid") return;
  if (text.size() >= kBinaryHeader) {  // some binary files begin with "solid" too
    std::uint32_t facets = 0;
    std::memcpy(&facets, text.data() + kBinaryHeader - sizeof facets, sizeof facets);
    if (text.size() == kBinaryHeader + kBinaryFacet * std::uint64_t{facets}) return;
  }
  const std::size_t facet = text.rfind("facet"), end = text.rfind("endsolid");
  if (end == std::string_view::npos || (facet != std::string_view::npos && facet > end)) {
    failInput(path, 0, "the ASCII STL file does not end with endsolid", kTruncated);
  }
}

}  // namespace footfall
