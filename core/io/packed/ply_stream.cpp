// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/io/input_file.hpp"
#include "core/io/packed/line_pieces.hpp"
#include "core/io/packed/packer_polygons.hpp"
#include "core/io/packed/plain_numbers.hpp"
#include "core/io/packed/streams.hpp"

namespace footfall::detail {
namespace {

enum class PlyType : std::uint8_t { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float, Double };

std::optional<PlyType> typeOf(std::string_view name) {
  constexpr std::array<std::array<std::string_view, 2>, 8> kNames{{{"char", "int8"},
                                                                   {"uchar", "uint8"},
                                                                   {"short", "int16"},
                                                                   {"ushort", "uint16"},
                                                                   {"int", "int32"},
                                                                   {"uint", "uint32"},
                                                                   {"float", "float32"},
                                                                   {"double", "float64"}}};
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (name == kNames[i][0] || name == kNames[i][1]) return static_cast<PlyType>(i);
  return std::nullopt;
}

std::size_t sizeOf(PlyType type) {
  constexpr std::array<std::size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

bool isFraction(PlyType type) { return type == PlyType::Float || type == PlyType::Double; }

struct PlyProperty {
  std::string name;
  PlyType type{};
  std::optional<PlyType> count = std::nullopt;  ///< type of a list's count
};

struct PlyLayout {
  bool isAscii = false, isBigEndian = false;
  std::uint64_t vertices = 0, faces = 0;
  std::vector<PlyProperty> ofVertex, ofFace;
  std::array<std::size_t, 3> place{};  ///< indices of x, y and z in `ofVertex`
  std::uint64_t dataOffset = 0;
};

/// Reads the headers that nearly all programs write; other headers are left to Assimp.
class PlyHeaderReader {
 public:
  std::optional<PlyLayout> read(const InputFile& file) {
    constexpr std::size_t kLongest = 65536;
    std::string text(kLongest, '\0');
    text.resize(file.read(0, text.data(), text.size()));
    constexpr std::string_view kEnd = "\nend_header\n";
    const std::size_t end = text.find(kEnd);
    if (!text.starts_with("ply\n") || end == std::string::npos) return std::nullopt;
    layout_.dataOffset = end + kEnd.size();
    std::vector<std::string_view> words;
    for (std::size_t at = 4; at < end;) {
      const std::size_t stop = std::min(text.find('\n', at), end);
      const std::string_view line(text.data() + at, stop - at);
      splitWords(line, words);
      const auto isText = [](char c) { return static_cast<unsigned char>(c) >= ' ' || c == '\t'; };
      if (!std::all_of(line.begin(), line.end(), isText) || !take(words)) return std::nullopt;
      at = stop + 1;
    }
    return isComplete() ? std::optional(layout_) : std::nullopt;
  }

 private:
  bool take(const std::vector<std::string_view>& words) {
    if (words.empty()) return false;
    if (words[0] == "comment") return words.size() < 2 || !isElement(words[1]);
    if (words[0] == "format") return takeFormat(words);
    if (words[0] == "element") return takeElement(words);
    return words[0] == "property" && takeProperty(words);
  }
  static bool isElement(std::string_view word) {
    constexpr std::array<std::string_view, 5> kNames{"vertex", "face", "tristrips", "edge", "material"};
    return std::find(kNames.begin(), kNames.end(), word) != kNames.end();
  }
  bool takeFormat(const std::vector<std::string_view>& words) {
    if (words.size() != 3 || words[2] != "1.0" || hasFormat_ || elements_ > 0) return false;
    hasFormat_ = true;
    layout_.isAscii = words[1] == "ascii";
    layout_.isBigEndian = words[1] == "binary_big_endian";
    return layout_.isAscii || layout_.isBigEndian || words[1] == "binary_little_endian";
  }
  bool takeElement(const std::vector<std::string_view>& words) {
    const bool isVertex = elements_ == 0;
    if (!hasFormat_ || words.size() != 3 || ++elements_ > 2 || words[1] != (isVertex ? "vertex" : "face")) return false;
    std::uint64_t& count = isVertex ? layout_.vertices : layout_.faces;
    return readWhole(words[2], count) && count > 0 && count <= 0xffffffffU;
  }
  bool takeProperty(const std::vector<std::string_view>& words) {
    const bool isList = words.size() == 5 && words[1] == "list";
    if (elements_ == 0 || (!isList && words.size() != 3)) return false;
    const std::optional<PlyType> type = typeOf(words[isList ? 3 : 1]);
    PlyProperty property{std::string(words.back()), type.value_or(PlyType::Int8)};
    if (isList) property.count = typeOf(words[2]);
    if (!type || (isList && (!property.count || isFraction(*property.count)))) return false;
    (elements_ == 1 ? layout_.ofVertex : layout_.ofFace).push_back(property);
    return true;
  }
  bool isComplete() {
    if (elements_ != 2) return false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string name(1, static_cast<char>('x' + axis));
      const auto isNamed = [&](const PlyProperty& property) { return property.name == name; };
      if (std::count_if(layout_.ofVertex.begin(), layout_.ofVertex.end(), isNamed) != 1) return false;
      layout_.place[axis] = static_cast<std::size_t>(
          std::find_if(layout_.ofVertex.begin(), layout_.ofVertex.end(), isNamed) - layout_.ofVertex.begin());
    }
    const auto isList = [](const PlyProperty& property) { return property.count.has_value(); };
    if (std::any_of(layout_.ofVertex.begin(), layout_.ofVertex.end(), isList)) return false;
    if (std::count_if(layout_.ofFace.begin(), layout_.ofFace.end(), isList) != 1) return false;
    const PlyProperty& list = *std::find_if(layout_.ofFace.begin(), layout_.ofFace.end(), isList);
    return (list.name == "vertex_indices" || list.name == "vertex_index") && !isFraction(list.type);
  }

  PlyLayout layout_;
  bool hasFormat_ = false;
  int elements_ = 0;
};

/// Shared by binary and ASCII files: vertices, and faces as numbers of vertices.
class PlyTarget {
 public:
  PlyTarget(const PlyLayout& layout, Environment& head, MeshSink& sink, RunContext* context)
      : layout_(layout), head_(head), sink_(sink), context_(context) {}

  bool addVertex(const std::array<double, 3>& place) {
    poll();
    for (const double x : place)
      if (!std::isfinite(x)) return false;
    sink_.addVertex({place[0], place[1], place[2]});
    return true;
  }
  /// Adds a face whose corners are below the number of vertices.
  bool addFace(const std::vector<std::uint32_t>& corners) {
    poll();
    ++faces_;
    if (corners.size() < 3) return false;
    for (const std::uint32_t corner : corners)
      if (corner >= layout_.vertices) return false;
    triangles_.clear();
    const PackerVertices vertices{sink_};
    if (!triangulatePolygon(corners, vertices, triangles_, Poll(context_))) {
      SkippedPolygon skipped = skippedPolygon(corners, vertices);
      skipped.face = faces_;
      addSkipped(head_.skipped, std::move(skipped));
    }
    for (const Triangle& triangle : triangles_) sink_.addFace(triangle, 0);
    return true;
  }

 private:
  void poll() {
    constexpr std::uint64_t kEach = 4096;
    if (context_ == nullptr || ++done_ % kEach != 0) return;
    context_->checkCancelled();
    context_->progress(0.5 * static_cast<double>(done_) / static_cast<double>(layout_.vertices + layout_.faces));
  }

  const PlyLayout& layout_;
  Environment& head_;
  MeshSink& sink_;
  RunContext* context_;
  std::vector<Triangle> triangles_;
  std::uint64_t faces_ = 0, done_ = 0;
};

/// The bytes behind the header, read in pieces.
class BinaryPieces {
 public:
  BinaryPieces(const InputFile& file, std::uint64_t offset) : file_(file), offset_(offset) {}

  /// Null where the file ends too early.
  const char* take(std::size_t size) {
    constexpr std::size_t kPiece = std::size_t{1} << 20;
    if (bytes_.size() - used_ < size) {
      bytes_.erase(0, used_);
      used_ = 0;
      const std::size_t kept = bytes_.size(), wanted = std::max(kPiece, size);
      bytes_.resize(kept + wanted);
      const std::size_t count = file_.read(offset_, bytes_.data() + kept, wanted);
      bytes_.resize(kept + count);
      offset_ += count;
      if (bytes_.size() < size) return nullptr;
    }
    used_ += size;
    return bytes_.data() + used_ - size;
  }

 private:
  const InputFile& file_;
  std::uint64_t offset_;
  std::string bytes_;
  std::size_t used_ = 0;
};

class BinaryPly {
 public:
  BinaryPly(const InputFile& file, const PlyLayout& layout, PlyTarget& target)
      : layout_(layout), target_(target), pieces_(file, layout.dataOffset) {}

  bool read() {
    for (std::uint64_t v = 0; v < layout_.vertices; ++v)
      if (!readVertex()) return false;
    for (std::uint64_t f = 0; f < layout_.faces; ++f)
      if (!readFace() || !target_.addFace(corners_)) return false;
    return pieces_.take(1) == nullptr;
  }

 private:
  template <class Result>
  Result number(const char* bytes, PlyType type) const {
    std::array<char, 8> ordered{};
    const std::size_t size = sizeOf(type);
    for (std::size_t i = 0; i < size; ++i) ordered[i] = bytes[layout_.isBigEndian ? size - 1 - i : i];
    const auto as = [&]<class Number>(Number value) {
      std::memcpy(&value, ordered.data(), sizeof value);
      return static_cast<Result>(value);
    };
    switch (type) {
      case PlyType::Int8:
        return as(std::int8_t{});
      case PlyType::UInt8:
        return as(std::uint8_t{});
      case PlyType::Int16:
        return as(std::int16_t{});
      case PlyType::UInt16:
        return as(std::uint16_t{});
      case PlyType::Int32:
        return as(std::int32_t{});
      case PlyType::UInt32:
        return as(std::uint32_t{});
      case PlyType::Float:
        if constexpr (std::is_floating_point_v<Result>) return as(float{});
        break;
      case PlyType::Double:
        if constexpr (std::is_floating_point_v<Result>) return as(double{});
        break;
    }
    return Result{-1};
  }

  bool readVertex() {
    std::array<double, 3> place{};
    for (std::size_t p = 0; p < layout_.ofVertex.size(); ++p) {
      const PlyType type = layout_.ofVertex[p].type;
      const char* bytes = pieces_.take(sizeOf(type));
      if (bytes == nullptr) return false;
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (layout_.place[axis] == p) place[axis] = number<double>(bytes, type);
    }
    return target_.addVertex(place);
  }

  bool readFace() {
    constexpr std::int64_t kMostCorners = 1 << 20;
    corners_.clear();
    for (const PlyProperty& property : layout_.ofFace) {
      const char* bytes = pieces_.take(sizeOf(property.count.value_or(property.type)));
      if (bytes == nullptr) return false;
      if (!property.count) continue;
      const auto count = number<std::int64_t>(bytes, *property.count);
      if (count < 3 || count > kMostCorners) return false;
      const std::size_t size = sizeOf(property.type);
      bytes = pieces_.take(static_cast<std::size_t>(count) * size);
      if (bytes == nullptr) return false;
      for (std::int64_t i = 0; i < count; ++i, bytes += size) {
        const auto corner = number<std::int64_t>(bytes, property.type);
        if (corner < 0) return false;
        corners_.push_back(static_cast<std::uint32_t>(corner));
      }
    }
    return true;
  }

  const PlyLayout& layout_;
  PlyTarget& target_;
  BinaryPieces pieces_;
  std::vector<std::uint32_t> corners_;
};

class AsciiPly {
 public:
  AsciiPly(const std::string& path, const PlyLayout& layout, PlyTarget& target)
      : layout_(layout), target_(target), lines_(path, layout.dataOffset) {}

  bool read() {
    for (std::uint64_t v = 0; v < layout_.vertices; ++v)
      if (!readVertex()) return false;
    for (std::uint64_t f = 0; f < layout_.faces; ++f)
      if (!readFace() || !target_.addFace(corners_)) return false;
    return !lines_.next() && lines_.isAtEnd();
  }

 private:
  bool nextLine() {
    const std::optional<std::string_view> line = lines_.next();
    if (!line) return false;
    splitWords(*line, words_);
    return std::all_of(words_.begin(), words_.end(), isPlainNumber);
  }

  static bool readCoordinate(std::string_view word, PlyType type, double& x) {
    if (isFraction(type)) return readNearest(word, x);
    std::int32_t whole = 0;
    if (!readWhole(word, whole)) return false;
    x = whole;
    return true;
  }

  bool readVertex() {
    if (!nextLine() || words_.size() != layout_.ofVertex.size()) return false;
    std::array<double, 3> place{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t p = layout_.place[axis];
      if (!readCoordinate(words_[p], layout_.ofVertex[p].type, place[axis])) return false;
    }
    return target_.addVertex(place);
  }

  bool readFace() {
    if (!nextLine()) return false;
    corners_.clear();
    std::size_t at = 0;
    for (const PlyProperty& property : layout_.ofFace) {
      if (at >= words_.size()) return false;
      const std::string_view word = words_[at++];
      if (!property.count) continue;
      std::uint32_t count = 0;
      if (!readWhole(word, count) || count < 3 || count > words_.size() - at) return false;
      for (std::uint32_t i = 0; i < count; ++i) {
        corners_.emplace_back();
        if (!readWhole(words_[at++], corners_.back())) return false;
      }
    }
    return at == words_.size();
  }

  const PlyLayout& layout_;
  PlyTarget& target_;
  LinePieces lines_;
  std::vector<std::string_view> words_;
  std::vector<std::uint32_t> corners_;
};

}  // namespace

bool streamPly(const std::string& path, Environment& head, MeshSink& sink, RunContext* context) {
  const InputFile file(path);
  const std::optional<PlyLayout> layout = PlyHeaderReader().read(file);
  if (!layout) return false;
  const auto isFloat = [&](std::size_t p) { return layout->ofVertex[p].type == PlyType::Float; };
  sink.areFloats = !layout->isAscii && std::any_of(layout->place.begin(), layout->place.end(), isFloat);
  PlyTarget target(*layout, head, sink, context);
  return layout->isAscii ? AsciiPly(path, *layout, target).read() : BinaryPly(file, *layout, target).read();
}

}  // namespace footfall::detail
