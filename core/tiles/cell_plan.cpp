// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/cell_plan.hpp"

#include <algorithm>
#include <array>

#include "core/base/byte_stream.hpp"

namespace footfall::detail {
namespace {

/// Faces that follow each other and weigh the same.
struct Stretch {
  std::uint64_t first = 0, last = 0;
  std::uint64_t bytes = 0;  ///< bytes of one triangle; not 0
};

std::vector<Stretch> stretchesOf(std::span<const PackedBlock> blocks, std::span<const std::uint32_t> floors,
                                 const FaceRange& faces, const CellLimits& limits) {
  std::vector<Stretch> stretches;
  std::uint64_t next = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const std::uint64_t begin = next, count = blocks[i].faces;
    next += count;
    const std::uint64_t first = std::max(begin, faces.first), last = std::min(next, faces.last);
    if (first >= last) continue;
    const auto each = [&](std::uint64_t perFloor) { return (perFloor * floors[i] + count - 1) / count; };
    stretches.push_back({first, last, std::max(limits.perFace + each(limits.perFloor), each(limits.perKeptFloor))});
  }
  return stretches;
}

}  // namespace

void BlockSurvey::add(const BlockSurvey& other) {
  grid.low = std::min(grid.low, other.grid.low);
  grid.top = std::max(grid.top, other.grid.top);
  floors.insert(floors.end(), other.floors.begin(), other.floors.end());
}

BlockSurvey surveyOf(const PackedEnvironment& environment, const CellCollector& collector, std::size_t first,
                     std::size_t last, RunContext& context) {
  constexpr std::size_t kReleased = 256;
  BlockSurvey survey;
  const auto include = [&survey](const std::array<double, 3>& place) {
    for (const double x : place) survey.grid.include(x);
  };
  for (std::size_t i = first; i < last; ++i) {
    context.checkCancelled();
    const BlockArrays block = environment.block(i);
    if (!collector.hasRoles() || block.faces.empty()) {  // vertices of no face are in blocks of their own
      std::for_each(block.places.begin(), block.places.end(), include);
    } else {
      for (std::size_t f = 0; f < block.faces.size(); ++f)
        if (collector.roleOf(block.parts.empty() ? 0 : block.parts[f]) != PartRole::Ignored)
          for (const std::uint16_t corner : block.corners[f]) include(block.places[corner]);
    }
    std::uint32_t& floors = survey.floors.emplace_back(0);
    environment.forFaces(i, [&](const BlockFace& face) { floors += collector.isFloor(face) ? 1U : 0U; });
    if (i % kReleased == kReleased - 1) environment.forgetBlocks();
  }
  environment.forgetBlocks();
  return survey;
}

std::string encodeSurvey(const BlockSurvey& survey) {
  ByteWriter out;
  out.signedNumber(survey.grid.low);
  out.signedNumber(survey.grid.top);
  out.number(survey.floors.size());
  for (const std::uint32_t count : survey.floors) out.number(count);
  return std::move(out.bytes);
}

BlockSurvey decodeSurvey(std::string_view bytes) {
  ByteReader in(bytes);
  BlockSurvey survey;
  survey.grid.low = static_cast<int>(in.signedNumber());
  survey.grid.top = static_cast<int>(in.signedNumber());
  survey.floors.resize(in.count(1));
  for (std::uint32_t& count : survey.floors) count = static_cast<std::uint32_t>(in.number());
  in.expectEnd();
  return survey;
}

std::uint64_t runningBytes(std::span<const PackedBlock> blocks, std::span<const std::uint32_t> floors,
                           const FaceRange& faces, const CellLimits& limits) {
  CellLimits running = limits;
  running.perKeptFloor = 0;
  std::uint64_t bytes = 0;
  for (const Stretch& stretch : stretchesOf(blocks, floors, faces, running))
    bytes += (stretch.last - stretch.first) * stretch.bytes;
  return bytes;
}

std::vector<FaceRange> planCells(std::span<const PackedBlock> blocks, std::span<const std::uint32_t> floors,
                                 const FaceRange& faces, const CellLimits& limits) {
  const std::vector<Stretch> stretches = stretchesOf(blocks, floors, faces, limits);
  std::uint64_t bytes = 0;
  for (const Stretch& stretch : stretches) bytes += (stretch.last - stretch.first) * stretch.bytes;
  const std::uint64_t count = bytes / std::max<std::uint64_t>(limits.bytes, 1) + 1, most = bytes / count + 1;
  std::vector<FaceRange> cells;
  std::uint64_t held = 0;  // bytes that the last one held
  for (const Stretch& stretch : stretches)
    for (std::uint64_t first = stretch.first; first < stretch.last;) {
      if (cells.empty() || held >= most || cells.back().size() >= limits.mostFaces) {
        cells.push_back({first, first});
        held = 0;
      }
      const std::uint64_t fitting = std::max<std::uint64_t>((most - held) / stretch.bytes, 1);
      const std::uint64_t room = std::max<std::uint64_t>(limits.mostFaces - cells.back().size(), 1);
      const std::uint64_t taken = std::min({stretch.last - first, fitting, room});
      first += taken;
      cells.back().last = first;
      held += taken * stretch.bytes;
    }
  return cells;
}

}  // namespace footfall::detail
