// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/truncation_check.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <system_error>
#include <vector>

#include "core/io/input_file.hpp"

namespace footfall::detail {
namespace {

constexpr Pattern kTruncated = FOOTFALL_TEXT("it is truncated: copy or export it again");
constexpr Pattern kExportAgain = FOOTFALL_TEXT("correct it or export the file again");

std::string_view takeLine(std::string_view& text) {
  const std::size_t stop = text.find('\n');
  std::string_view line = text.substr(0, stop);
  text.remove_prefix(stop == std::string_view::npos ? text.size() : stop + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

/// Rejects control characters that only Assimp 5.2.5 takes for line ends; it reads far beyond some of them.
bool isText(std::string_view line) {
  return std::all_of(line.begin(), line.end(),
                     [](char c) { return static_cast<unsigned char>(c) >= ' ' || c == '\t'; });
}

/// Ignores the case of the text, as Assimp does.
bool startsWith(std::string_view text, std::string_view lower) {
  return text.size() >= lower.size() && std::equal(lower.begin(), lower.end(), text.begin(), [](char l, char c) {
           return l == (c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c);
         });
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

/// A count that no integer holds is larger than any file.
std::uint64_t toCount(std::string_view word) {
  std::uint64_t count = 0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), count);
  return read.ec == std::errc::result_out_of_range ? std::numeric_limits<std::uint64_t>::max() : count;
}

/// The size of a PLY type; 0 for an unknown type.
std::uint64_t plyTypeSize(std::string_view type) {
  const auto isOneOf = [&](std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), type) != names.end();
  };
  if (isOneOf({"char", "uchar", "int8", "uint8"})) return 1;
  if (isOneOf({"short", "ushort", "int16", "uint16"})) return 2;
  if (isOneOf({"int", "uint", "int32", "uint32", "float", "float32"})) return 4;
  return isOneOf({"double", "float64"}) ? 8 : 0;
}

struct PlyProperty {
  std::uint64_t size = 0;      ///< bytes in a binary file; of a list's count for a list
  std::uint64_t itemSize = 0;  ///< 0: no list
  bool isSigned = false;       ///< whether a list's count has a signed type
};

struct PlyElement {
  std::string_view name;
  std::uint64_t count = 0;
  std::uint64_t leastBytes = 0;  ///< bytes of one element in a binary file
  std::size_t leastWords = 0;    ///< words of one element in an ASCII file
  bool firstIsList = false;
  bool hasLists = false;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  std::size_t lines = 1;
  bool hasFormat = false;
  bool ascii = true;
  bool bigEndian = false;
  bool complete = false;
  std::vector<PlyElement> elements;
};

bool isAssimpElement(std::string_view name) {
  return name == "vertex" || name == "face" || name == "tristrips" || name == "edge" || name == "material";
}

/// Reads one line of the header. Returns false for a line that is invalid, or that Assimp 5.2.5 reads in another way: a
/// second format; an element twice (which leaks memory); an element whose name is read as its number; "comment vertex
/// 9" (read as an element); an empty line or obj_info among the elements (read as the end of their properties).
bool takePlyHeaderLine(const std::vector<std::string_view>& line, PlyHeader& header) {
  if (line.empty()) return header.elements.empty();
  const std::string_view keyword = line[0];
  if (keyword == "comment") return line.size() < 3 || !isAssimpElement(line[1]) || line[2][0] < '0' || line[2][0] > '9';
  if (keyword == "obj_info") return header.elements.empty();
  if (keyword == "end_header") return header.complete = line.size() == 1;
  if (keyword == "format") {
    if (line.size() != 3 || header.hasFormat || !header.elements.empty()) return false;
    header.hasFormat = true;
    header.ascii = line[1] == "ascii";
    header.bigEndian = line[1] == "binary_big_endian";
    return header.ascii || header.bigEndian || line[1] == "binary_little_endian";
  }
  if (keyword == "element") {
    const auto isNamesake = [&](const PlyElement& element) { return element.name == line[1]; };
    if (line.size() != 3 || (line[1][0] >= '0' && line[1][0] <= '9') ||
        line[2].find_first_not_of("0123456789") != std::string_view::npos ||
        std::any_of(header.elements.begin(), header.elements.end(), isNamesake))
      return false;
    PlyElement& element = header.elements.emplace_back();
    element.name = line[1];
    element.count = toCount(line[2]);
    return true;
  }
  const bool list = line.size() == 5 && line[1] == "list";
  if (keyword != "property" || (!list && line.size() != 3) || header.elements.empty()) return false;
  const std::uint64_t size = plyTypeSize(list ? line[2] : line[1]);
  PlyElement& element = header.elements.back();
  if (element.leastWords == 0) element.firstIsList = list;
  element.leastBytes += size;
  ++element.leastWords;
  element.hasLists = element.hasLists || list;
  element.properties.push_back({size, list ? plyTypeSize(line[3]) : 0, list && line[2][0] != 'u'});
  const bool isFraction = list && (line[2][0] == 'f' || line[2][0] == 'd');  // no count
  return size > 0 && !isFraction && (!list || plyTypeSize(line[3]) > 0);
}

/// Removes the header from `text`.
PlyHeader takePlyHeader(const std::string& path, std::string_view& text) {
  PlyHeader header;
  takeLine(text);  // "ply"
  while (!text.empty() && !header.complete) {
    ++header.lines;
    const std::string_view whole = takeLine(text);
    const std::vector<std::string_view> line = words(whole);
    if (isText(whole) && takePlyHeaderLine(line, header)) continue;
    if (text.empty()) break;  // the line is cut off
    failInput(path, 0,
              Text(FOOTFALL_TEXT("line %1 of the PLY header, '%2 ...', is not understood"), header.lines,
                   line.empty() ? "" : line[0].substr(0, 24)),
              kExportAgain);
  }
  return header;
}

[[noreturn]] void failShortPly(const std::string& path) {
  failInput(path, 0, FOOTFALL_TEXT("the file ends before the elements that its header announces"), kTruncated);
}

constexpr Pattern kNegativeList = FOOTFALL_TEXT("a list in the PLY file has a negative length");

std::size_t takeDigits(std::string_view& word) {
  const std::size_t count = std::min(word.find_first_not_of("0123456789"), word.size());
  word.remove_prefix(count);
  return count;
}

/// Returns whether Assimp reads the whole word as one number. It begins another number behind a sign inside the word,
/// or behind more digits than an integer holds, and may take that number for a list's length.
bool isOneNumber(std::string_view word) {
  constexpr std::size_t kMostDigits = 18;
  const auto skip = [&](std::string_view characters) {
    const bool found = !word.empty() && characters.find(word[0]) != std::string_view::npos;
    if (found) word.remove_prefix(1);
    return found;
  };
  skip("+-");
  std::size_t digits = takeDigits(word);
  if (digits > kMostDigits) return false;
  if (skip(".")) digits += takeDigits(word);
  if (digits == 0) return false;
  if (!skip("eE")) return word.empty();
  skip("+-");
  return takeDigits(word) > 0 && word.empty();
}

/// Checks a line of an element that has lists, because Assimp trusts their lengths.
void checkListLine(const std::string& path, std::size_t number, const PlyElement& element, std::string_view line) {
  const std::vector<std::string_view> all = words(line);
  for (const std::string_view word : all) {
    if (isOneNumber(word)) continue;
    failInput(path, number, Text(FOOTFALL_TEXT("'%1' is not a number that can stand here"), word.substr(0, 24)),
              kExportAgain);
  }
  std::size_t at = 0;
  for (const PlyProperty& property : element.properties) {
    if (at >= all.size()) failInput(path, number, FOOTFALL_TEXT("the line ends before its element"), kExportAgain);
    const std::string_view word = all[at++];
    if (property.itemSize == 0) continue;
    if (word[0] == '-') failInput(path, number, kNegativeList, kExportAgain);
    const std::uint64_t length = toCount(word.substr(word[0] == '+' ? 1 : 0));
    if (length > all.size() - at) {
      failInput(path, number, FOOTFALL_TEXT("a list has more entries than its line has numbers"), kExportAgain);
    }
    at += length;
  }
}

/// Each element has a line of its own; the last line may be cut off.
void checkAsciiPly(const std::string& path, const PlyHeader& header, std::string_view text) {
  std::size_t number = header.lines;
  for (const PlyElement& element : header.elements) {
    for (std::uint64_t i = 0; i < element.count; ++i, ++number) {
      const std::string_view line = takeLine(text);
      if (line.find_first_not_of(" \t") == std::string_view::npos) {
        if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) failShortPly(path);
        failInput(path, number + 1, FOOTFALL_TEXT("the line is empty, but an element of the PLY file must stand there"),
                  kExportAgain);
      }
      if (!isText(line)) {
        failInput(path, number + 1,
                  FOOTFALL_TEXT("the PLY file is declared as ASCII, but the line has bytes that are not text"),
                  kExportAgain);
      }
      if (text.empty()) {
        const std::vector<std::string_view> last = words(line);
        const std::uint64_t listed = element.firstIsList && !last.empty() ? toCount(last[0]) : 0;
        if (last.size() < element.leastWords + listed) failShortPly(path);
      }
      if (element.hasLists) checkListLine(path, number + 1, element, line);
    }
  }
}

/// Removes the number of entries of a list from the front of `text` and returns it.
std::uint64_t takeListCount(const std::string& path, const PlyProperty& list, bool bigEndian, std::string_view& text) {
  std::uint64_t count = 0;
  for (std::uint64_t i = 0; i < list.size; ++i) {
    const auto byte = static_cast<unsigned char>(text[bigEndian ? i : list.size - 1 - i]);
    count = count << 8 | byte;
  }
  text.remove_prefix(list.size);
  if (list.isSigned && (count >> (8 * list.size - 1)) != 0) failInput(path, 0, kNegativeList, kExportAgain);
  return count;
}

void checkBinaryPly(const std::string& path, const PlyHeader& header, std::string_view text) {
  for (const PlyElement& element : header.elements) {
    // Assimp also allocates elements without properties.
    if (element.count > text.size() / std::max<std::uint64_t>(element.leastBytes, 1)) failShortPly(path);
    if (!element.hasLists) {
      text.remove_prefix(element.count * element.leastBytes);
      continue;
    }
    for (std::uint64_t i = 0; i < element.count; ++i) {
      for (const PlyProperty& property : element.properties) {
        if (property.size > text.size()) failShortPly(path);
        if (property.itemSize == 0) {
          text.remove_prefix(property.size);
          continue;
        }
        const std::uint64_t count = takeListCount(path, property, header.bigEndian, text);
        if (count > text.size() / property.itemSize) failShortPly(path);
        text.remove_prefix(count * property.itemSize);
      }
    }
  }
}

}  // namespace

void rejectTruncatedPly(const std::string& path, std::string_view text) {
  const auto isSpace = [](char c) { return static_cast<unsigned char>(c) <= ' '; };
  const auto start = static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), isSpace) - text.begin());
  if (!startsWith(text.substr(start), "ply")) return;  // Assimp reports that this is not a PLY file
  if (start > 0) {
    failInput(path, 0, FOOTFALL_TEXT("there is something before the word 'ply' with which a PLY file must begin"),
              kExportAgain);
  }
  const PlyHeader header = takePlyHeader(path, text);
  if (!header.complete) failInput(path, 0, FOOTFALL_TEXT("the PLY header has no end_header"), kTruncated);
  for (const PlyElement& element : header.elements) {
    if (isAssimpElement(element.name) || element.count == 0 || &element == &header.elements.back()) continue;
    failInput(path, 0,
              Text(FOOTFALL_TEXT("the data behind the unknown PLY elements '%1' cannot be read"), element.name),
              FOOTFALL_TEXT("move them behind all others or export the file without them"));
  }
  header.ascii ? checkAsciiPly(path, header, text) : checkBinaryPly(path, header, text);
}

void rejectTruncatedStl(const std::string& path, std::string_view text) {
  constexpr std::size_t kBinaryHeader = 84, kBinaryFacet = 50;
  if (!startsWith(text, "solid")) return;
  if (text.size() >= kBinaryHeader) {  // some binary files also begin with "solid"
    std::uint32_t facets = 0;
    std::memcpy(&facets, text.data() + kBinaryHeader - sizeof facets, sizeof facets);
    if (text.size() == kBinaryHeader + kBinaryFacet * std::uint64_t{facets}) return;
  }
  const std::size_t facet = text.rfind("facet"), end = text.rfind("endsolid");
  if (end == std::string_view::npos || (facet != std::string_view::npos && facet > end)) {
    failInput(path, 0, FOOTFALL_TEXT("the ASCII STL file does not end with endsolid"), kTruncated);
  }
}

void rejectTruncatedGlb(const std::string& path) {
  constexpr std::uint32_t kMagic = 0x46546C67;
  const InputFile file(path);
  std::array<std::uint32_t, 5> start{};  // magic, version, length of the file; length of the chunk, its kind
  if (file.read(0, reinterpret_cast<char*>(start.data()), sizeof start) != sizeof start || start[0] != kMagic) return;
  if (start[3] > file.size() - sizeof start)
    failInput(path, 0, FOOTFALL_TEXT("the binary glTF ends before its first chunk does"), kTruncated);
}

}  // namespace footfall::detail
