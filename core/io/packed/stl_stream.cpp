// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "core/environment/part_names.hpp"
#include "core/io/input_file.hpp"
#include "core/io/packed/line_pieces.hpp"
#include "core/io/packed/plain_numbers.hpp"
#include "core/io/packed/streams.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kHeader = 84, kFacet = 50;
constexpr std::uint64_t kFacetsAtOnce = 16384;
constexpr std::size_t kLongestName = 1023;  // the limit of Assimp

bool addFacet(const std::array<std::array<double, 3>, 3>& corners, std::uint32_t part, MeshSink& sink) {
  const auto first = static_cast<std::uint32_t>(sink.vertexCount());
  for (const auto& [x, y, z] : corners) {
    if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) return false;
    sink.addVertex({x, y, z});
  }
  sink.addFace({first, first + 1, first + 2}, part);
  return true;
}

bool streamBinary(const InputFile& file, std::uint64_t facets, MeshSink& sink, RunContext* context) {
  sink.areFloats = true;
  std::vector<char> bytes(kFacetsAtOnce * kFacet);
  for (std::uint64_t first = 0; first < facets; first += kFacetsAtOnce) {
    if (context != nullptr) {
      context->checkCancelled();
      context->progress(0.5 * static_cast<double>(first) / static_cast<double>(facets));
    }
    const auto count = static_cast<std::size_t>(std::min(kFacetsAtOnce, facets - first));
    if (file.read(kHeader + first * kFacet, bytes.data(), count * kFacet) < count * kFacet) return false;
    for (std::size_t f = 0; f < count; ++f) {
      std::array<std::array<float, 3>, 3> stored;
      std::memcpy(&stored, bytes.data() + f * kFacet + 3 * sizeof(float), sizeof stored);  // stands behind the normal
      std::array<std::array<double, 3>, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) std::copy(stored[k].begin(), stored[k].end(), corners[k].begin());
      if (!addFacet(corners, 0, sink)) return false;
    }
  }
  return true;
}

/// Reads ASCII files with one statement in each line, as all programs write them.
class AsciiStl {
 public:
  AsciiStl(const std::string& path, Environment& head, MeshSink& sink, RunContext* context)
      : lines_(path), head_(head), sink_(sink), context_(context), parts_(head.parts) {}

  bool read() {
    while (nextStatement()) {
      if (words_[0] != "solid" || !readSolid()) return false;
    }
    dropUnnamedPart(head_);
    return lines_.isAtEnd();
  }

 private:
  bool nextStatement() {
    constexpr std::size_t kPollEach = 4096;
    if (context_ != nullptr && ++done_ % kPollEach == 0) {
      context_->checkCancelled();
      context_->progress(0.5 * lines_.done());
    }
    do {
      const std::optional<std::string_view> line = lines_.next();
      if (!line || line->find('\0') != std::string_view::npos || line->find('\r') != std::string_view::npos)
        return false;
      splitWords(*line, words_);
    } while (words_.empty());
    return true;
  }
  bool nextIs(std::size_t count, std::string_view first, std::string_view second = {}) {
    return nextStatement() && words_.size() == count && words_[0] == first && (count < 2 || words_[1] == second);
  }

  bool readSolid() {
    if (words_.size() > 1 && words_[1].size() > kLongestName) return false;
    // Assimp takes one word as the name of a node.
    const std::string given(words_.size() > 1 ? words_[1] : std::string_view());
    const bool isMadeUp = given.starts_with('<') && given.ends_with('>');
    const std::uint32_t part = parts_.numberOf(isMadeUp ? std::string_view() : given, {});
    std::uint64_t facets = 0;
    for (; nextStatement(); ++facets) {
      if (words_[0] == "endsolid") return facets > 0;
      if (!readFacet(part)) return false;
    }
    return false;
  }

  bool readFacet(std::uint32_t part) {
    if (words_.size() != 5 || words_[0] != "facet" || words_[1] != "normal") return false;
    if (!nextIs(2, "outer", "loop")) return false;
    std::array<std::array<double, 3>, 3> corners{};
    for (auto& corner : corners) {
      if (!nextStatement() || words_.size() != 4 || words_[0] != "vertex") return false;
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (!readNearest(words_[axis + 1], corner[axis])) return false;
    }
    return nextIs(1, "endloop") && nextIs(1, "endfacet") && addFacet(corners, part, sink_);
  }

  LinePieces lines_;
  Environment& head_;
  MeshSink& sink_;
  RunContext* context_;
  PartList parts_;
  std::vector<std::string_view> words_;
  std::size_t done_ = 0;
};

}  // namespace

bool streamStl(const std::string& path, Environment& head, MeshSink& sink, RunContext* context) {
  const InputFile file(path);
  std::array<char, kHeader> start{};
  if (file.read(0, start.data(), start.size()) == start.size()) {
    std::uint32_t facets = 0;
    std::memcpy(&facets, start.data() + kHeader - sizeof facets, sizeof facets);
    // Assimp compares 32 bits, and misses the largest files.
    const std::uint64_t size = kHeader + kFacet * std::uint64_t{facets};
    if (facets > 0 && size == file.size() && size <= 0xffffffffU) return streamBinary(file, facets, sink, context);
  }
  if (!std::string_view(start.data(), start.size()).starts_with("solid")) return false;
  return AsciiStl(path, head, sink, context).read();
}

}  // namespace footfall::detail
